-- theorem, near, holds, fails, and those of rotor.cases: what a theorem predicts beside what is measured. An ordinary
-- script prints tables for people; `rotor --test` prints TAP (run, below).
local cases = require "rotor.cases"
local compare = require "rotor.compare"
local exact = require "rotor.exact"
local scopes = require "rotor.scopes"
local text = require "rotor.text"

local testing = {}

local clock = os.clock  -- of the processor; a script may change os
local total = { theorems = 0, failed = 0, checks = 0, failed_checks = 0, seconds = 0, left_out = 0 }
local filter  -- what the name of a theorem must have in it, in small letters, to be run; or nil
local report  -- what becomes of a theorem that ended; run() puts another in its place

-- A theorem: a scope with name =, and, when it ended, pass =, failed = so many of its checks, problem = what else,
-- seconds =.
-- A check: { what =, place = in the value, pass =, ratio = the greater the worse, note = why not, where = in the
-- script, count = of the cases folded, said = { of these, ... } }; of near also, as texts, predicted =, measured =
-- (the numbers that differ most), difference =, tolerance =, values = { the whole of both }.

-- The theorem from which this is called, or nil.
local function theorem_here()
  local scope = scopes.here()
  while scope and not scope.name do scope = scope.outer end
  return scope
end

-- Numbers as text ----------------------------------------------------------------------------------------------------

local function number_text(x, format)
  if x ~= x then return "nan" end
  return (format or "%.7g"):format(x)
end

-- A difference or a tolerance: its size is what matters.
local function size_text(x)
  return x == 0 and "0" or number_text(x, "%.1e")
end

local function plural(count, word)
  return count .. " " .. word .. (count == 1 and "" or "s")
end

--- So many seconds, in milliseconds.
function testing.milliseconds(seconds, unit)
  return ("%.1f"):format(1000*seconds) .. unit
end

--- What was checked, where in the value, in how many cases.
function testing.title(check)
  return check.what .. (check.place and " " .. check.place or "")
    .. (check.count and " (" .. plural(check.count, "case") .. ")" or "")
end

-- Tables for people ---------------------------------------------------------------------------------------------------

-- The lines under a check that failed: the whole values where the table shows less of them, why, and where.
local function details(check)
  local lines = {}
  local function say(label, value)
    if value then lines[#lines + 1] = text.wrap(value, "      " .. label, "      " .. (" "):rep(#label)) end
  end
  if check.values and check.values[1] .. check.values[2] ~= (check.predicted or "") .. (check.measured or "") then
    say("predicted  ", check.values[1])
    say("measured   ", check.values[2])
  end
  say("", check.note)
  for _, line in ipairs(check.said or {}) do say("", line) end
  say("at ", check.where)
  return table.concat(lines, "\n")
end

local kColumns = { "predicted", "measured", "difference", "tolerance" }

-- Lines of the checks: what, the four columns as wide as they must be, PASS or FAIL in the last columns.
local function table_of(checks)
  local widths, used = {}, 2 + 2 + 4
  for i, key in ipairs(kColumns) do
    widths[i] = 0
    for _, check in ipairs(checks) do
      if check[key] then widths[i] = math.max(widths[i], text.width(key), text.width(check[key])) end
    end
    if widths[i] > 0 then used = used + 2 + widths[i] end
  end
  local room = text.columns - used
  local function cells(of)
    local line = ""
    for i, key in ipairs(kColumns) do
      local cell = of(key) or ""
      if widths[i] > 0 then line = line .. "  " .. (" "):rep(widths[i] - text.width(cell)) .. cell end
    end
    return line
  end
  local lines = {}
  if used > 8 then lines[1] = (" "):rep(room + 2) .. cells(function(key) return key end) end
  for _, check in ipairs(checks) do
    local what = testing.title(check)
    if text.width(what) > room then
      lines[#lines + 1] = text.wrap(what, "  ", "    ")
      what = ""
    end
    lines[#lines + 1] = "  " .. text.pad(what, room) .. cells(function(key) return check[key] end)
      .. (check.pass and "  PASS" or "  FAIL")
    if not check.pass then lines[#lines + 1] = details(check) end
  end
  return table.concat(lines, "\n")
end

local function print_theorem(theorem)
  print(text.wrap(theorem.name, "", "  "))
  if #theorem.checks > 0 then print(table_of(theorem.checks)) end
  if theorem.problem then print(text.wrap(theorem.problem, "  ", "    ")) end
  local count = plural(#theorem.checks, "check")
  print((theorem.pass and "PASS  " .. count or theorem.failed > 0 and "FAIL  " .. theorem.failed .. " of " .. count
    or "FAIL") .. "  " .. testing.milliseconds(theorem.seconds, " ms") .. "\n")
end

report = print_theorem

-- The checks ----------------------------------------------------------------------------------------------------------

-- The line of the script that called near, holds or fails.
local function caller()
  local info = debug.getinfo(4, "Sl")
  return info and info.currentline > 0 and info.short_src .. ":" .. info.currentline or nil
end

local function sentence(check)
  local parts = { testing.title(check) }
  if check.values then
    parts[1] = ("%s: predicted %s, measured %s, difference %s, tolerance %s"):format(parts[1], check.values[1],
      check.values[2], check.difference, check.tolerance)
  end
  parts[#parts + 1] = check.note
  for _, line in ipairs(check.said or {}) do parts[#parts + 1] = line end
  return table.concat(parts, ": ")
end

-- A check that stands in no theorem and no case: it is printed, or raised if it fails.
local function stand_alone(kind, check)
  if not check.pass then error(kind .. ": " .. sentence(check), 4) end
  print(text.wrap(sentence(check), "PASS  ", "        "))
end

local function add(kind, check)
  local scope = scopes.here()
  check.ratio = check.ratio or check.pass and 0 or math.huge
  if scope then
    check.where = not check.pass and caller() or nil
    table.insert(scope.checks, check)
  else
    stand_alone(kind, check)
  end
end

local function expect_what(kind, what)
  if what ~= nil and type(what) ~= "string" then
    error(("%s: what is checked must be a string, got a %s"):format(kind, type(what)), 3)
  end
end

--- near(predicted, measured, tolerance, what)
function testing.near(predicted, measured, tolerance, what)
  expect_what("near", what)
  if type(tolerance) ~= "number" or not (tolerance >= 0 and tolerance < math.huge) then
    error("near: tolerance must be a finite number, zero or more, got " .. tostring(tolerance), 2)
  end
  local found, reason = compare(predicted, measured)
  local check = { what = what or "the value", pass = false, note = reason, tolerance = size_text(tolerance) }
  if found then
    check.pass = found.difference <= tolerance
    -- More than 1 exactly where the check fails, also rounded: the next double above t is above (1 + 2^-53) t.
    check.ratio = found.difference == 0 and 0 or found.difference/tolerance
    if check.ratio ~= check.ratio then check.ratio = math.huge end
    check.difference = size_text(found.difference)
    check.values = { exact(predicted), exact(measured) }
    if found.predicted then
      check.predicted, check.measured = number_text(found.predicted), number_text(found.measured)
      check.place = found.place ~= "" and found.place or nil
    end
  end
  add("near", check)
end

--- holds(condition, what)
function testing.holds(condition, what)
  expect_what("holds", what)
  local got = condition == nil and "nil" or "a " .. type(condition)
  local note = type(condition) ~= "boolean" and "the condition must be true, got " .. got or nil
  add("holds", { what = what or "the condition", pass = condition == true, note = note })
end

--- fails(f, what, pattern)
function testing.fails(f, what, pattern)
  expect_what("fails", what)
  if pattern ~= nil and type(pattern) ~= "string" then
    error("fails: the pattern must be a string, got a " .. type(pattern), 2)
  end
  local ended, raised = pcall(f)
  local message = scopes.message(raised)
  local note
  if ended then
    note = "no error was raised"
  elseif pattern and not message:find(pattern) then
    note = ("the error does not match %q: %s"):format(pattern, message)
  end
  add("fails", { what = what or "an error is raised", pass = not note, note = note })
end

-- The checks of many cases, folded, go where a single one would go.
local function add_cases(kind, ...)
  local ended, checks, problem = pcall(cases[kind], ...)
  if not ended then
    local refused = type(checks) == "table" and checks.refused
    error(refused and kind .. ": " .. refused or checks, refused and 3 or 0)
  end
  local scope = scopes.here()
  for _, check in ipairs(checks) do
    if scope then
      table.insert(scope.checks, check)
    else
      stand_alone(kind, check)
    end
  end
  if problem then error(kind .. ": " .. problem, 3) end
end

--- for_each(cases, f)
function testing.for_each(list, f) add_cases("for_each", list, f) end

--- for_all(values, f, {n=, seed=})
function testing.for_all(values, f, options) add_cases("for_all", values, f, options) end

testing.given = cases.given

--- theorem(name, f)
function testing.theorem(name, f)
  if type(name) ~= "string" then error("theorem: its name must be a string, got a " .. type(name), 2) end
  if type(f) ~= "function" then error("theorem: a function with the checks must follow, got a " .. type(f), 2) end
  local outer = theorem_here()
  if outer then error(("theorem: %q stands inside %q"):format(name, outer.name), 2) end
  if filter and not name:lower():find(filter, 1, true) then
    total.left_out = total.left_out + 1
    return
  end
  local theorem, begun = { name = name, failed = 0 }, clock()
  local problem = scopes.run(theorem, f)
  theorem.seconds = clock() - begun
  if problem then
    theorem.problem = "it ended in an error: " .. problem
  elseif #theorem.checks == 0 then
    theorem.problem = "it checked nothing"
  end
  for _, check in ipairs(theorem.checks) do
    if not check.pass then theorem.failed = theorem.failed + 1 end
  end
  theorem.pass = theorem.failed == 0 and not theorem.problem
  total.theorems, total.checks = total.theorems + 1, total.checks + #theorem.checks
  total.failed, total.failed_checks = total.failed + (theorem.pass and 0 or 1), total.failed_checks + theorem.failed
  total.seconds = total.seconds + theorem.seconds
  report(theorem)
end

--- At the end of a script: prints the sum of its theorems, if it had any. Returns whether all passed.
function testing.finish()
  if total.theorems > 0 then
    local failed = total.failed > 0 and (": %d failed (%d of %s)"):format(total.failed, total.failed_checks,
      plural(total.checks, "check")) or ": all passed (" .. plural(total.checks, "check") .. ")"
    print(plural(total.theorems, "theorem") .. failed .. "  " .. testing.milliseconds(total.seconds, " ms"))
  end
  return total.failed == 0
end

--- Runs files for `rotor --test` and prints TAP; with a text, only theorems with it in their names, in capitals or not.
--- Returns whether all passed, and why if no theorem has such a name.
function testing.run(files, part)
  filter = part and part:lower()
  local passed = require "rotor.tap"(files, function(reporter) report = reporter or print_theorem end, part)
  local none = part and total.theorems == 0 and ('--test: of %s none has "%s" in its name'):format(
    plural(total.left_out, "theorem"), part)
  return passed, none or nil
end

return testing
