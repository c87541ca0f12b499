-- theorem, near, holds, fails: what a theorem predicts beside what is measured. An ordinary script prints tables for
-- people; `rotor --test` prints TAP (run, below).
local compare = require "rotor.compare"
local text = require "rotor.text"

local testing = {}

local total = { theorems = 0, failed = 0, checks = 0, failed_checks = 0 }
local current        -- the theorem that runs: { name =, thread =, checks = { check, ... } }
local report         -- what becomes of a theorem that ended; run() puts another in its place

-- A check: { what =, pass =, note = why not, where = in the script }, of near also, as texts, predicted =, measured =
-- (the numbers that differ most), difference =, tolerance =, values = { the whole of both }.

-- Runs the body of a theorem: no tail call, so that as long as the body runs this is on its stack.
local function protected(f)
  local ended, raised = pcall(f)
  return ended, raised
end

-- The theorem from which this is called, or nil. Ctrl-C leaves a theorem without giving it the chance to say so, so the
-- stack is asked: that of the thread in which it began, as its checks may stand in coroutines.
local function theorem_here()
  if not current or coroutine.status(current.thread) == "dead" then return nil end
  for level = 0, math.huge do
    local info = debug.getinfo(current.thread, level, "f")
    if not info then return nil end
    if info.func == protected then return current end
  end
end

--- What was raised, as text.
function testing.message(raised)
  local ended, message = pcall(tostring, raised)
  return ended and message or "(error object whose __tostring fails)"
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

-- Round-trip digits, for reports of failures.
local function exact_text(x)
  if type(x) == "number" then
    return text.number(x)
  elseif type(x) == "table" and not getmetatable(x) then
    local parts = {}
    for i = 1, #x do parts[i] = exact_text(x[i]) end
    return "{" .. table.concat(parts, ", ") .. "}"
  end
  return tostring(x)
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
    local what = check.what
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

local function plural(count, word)
  return count .. " " .. word .. (count == 1 and "" or "s")
end

local function print_theorem(theorem)
  print(text.wrap(theorem.name, "", "  "))
  if #theorem.checks > 0 then print(table_of(theorem.checks)) end
  if theorem.problem then print(text.wrap(theorem.problem, "  ", "    ")) end
  local count = plural(#theorem.checks, "check")
  print((theorem.pass and "PASS  " .. count or theorem.failed > 0 and "FAIL  " .. theorem.failed .. " of " .. count
    or "FAIL") .. "\n")
end

report = print_theorem

-- The checks ----------------------------------------------------------------------------------------------------------

-- The line of the script that called near, holds or fails.
local function caller()
  local info = debug.getinfo(4, "Sl")
  return info and info.currentline > 0 and info.short_src .. ":" .. info.currentline or nil
end

local function sentence(check)
  local parts = { check.what }
  if check.values then
    parts[1] = ("%s: predicted %s, measured %s, difference %s, tolerance %s"):format(check.what, check.values[1],
      check.values[2], check.difference, check.tolerance)
  end
  parts[#parts + 1] = check.note
  return table.concat(parts, ": ")
end

-- Inside a theorem a check is kept for its table. Outside it stands alone: it is printed, or raised if it fails.
local function add(kind, check)
  local theorem = theorem_here()
  if theorem then
    check.where = not check.pass and caller() or nil
    table.insert(theorem.checks, check)
  elseif check.pass then
    print(text.wrap(sentence(check), "PASS  ", "        "))
  else
    error(kind .. ": " .. sentence(check), 3)
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
    check.difference = size_text(found.difference)
    check.values = { exact_text(predicted), exact_text(measured) }
    if found.predicted then
      check.predicted, check.measured = number_text(found.predicted), number_text(found.measured)
      if found.place ~= "" then check.what = check.what .. " " .. found.place end
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
  local message = testing.message(raised)
  local note
  if ended then
    note = "no error was raised"
  elseif pattern and not message:find(pattern) then
    note = ("the error does not match %q: %s"):format(pattern, message)
  end
  add("fails", { what = what or "an error is raised", pass = not note, note = note })
end

--- theorem(name, f)
function testing.theorem(name, f)
  if type(name) ~= "string" then error("theorem: its name must be a string, got a " .. type(name), 2) end
  if type(f) ~= "function" then error("theorem: a function with the checks must follow, got a " .. type(f), 2) end
  if theorem_here() then error(("theorem: %q stands inside %q"):format(name, current.name), 2) end
  local theorem = { name = name, thread = coroutine.running(), checks = {}, failed = 0 }
  current = theorem
  local ended, raised = protected(f)
  current = nil
  if not ended then
    theorem.problem = "it ended in an error: " .. testing.message(raised)
  elseif #theorem.checks == 0 then
    theorem.problem = "it checked nothing"
  end
  for _, check in ipairs(theorem.checks) do
    if not check.pass then theorem.failed = theorem.failed + 1 end
  end
  theorem.pass = theorem.failed == 0 and not theorem.problem
  total.theorems, total.checks = total.theorems + 1, total.checks + #theorem.checks
  total.failed, total.failed_checks = total.failed + (theorem.pass and 0 or 1), total.failed_checks + theorem.failed
  report(theorem)
end

--- At the end of a script: prints the sum of its theorems, if it had any. Returns whether all passed.
function testing.finish()
  if total.theorems > 0 then
    local failed = total.failed > 0 and (": %d failed (%d of %s)"):format(total.failed, total.failed_checks,
      plural(total.checks, "check")) or ": all passed (" .. plural(total.checks, "check") .. ")"
    print(plural(total.theorems, "theorem") .. failed)
  end
  return total.failed == 0
end

--- Runs files for `rotor --test` and prints TAP. Returns whether all passed.
function testing.run(files)
  return require "rotor.tap"(files, function(reporter) report = reporter or print_theorem end)
end

return testing
