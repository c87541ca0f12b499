-- for_each, for_all, given: one function for many cases, given or drawn. What it checks in all of them is one line for
-- each thing that is checked, with the worst case; a drawn case that fails is shrunk to a simple one.
local exact = require "rotor.exact"
local generators = require "rotor.generators"
local names = require "rotor.names"
local scopes = require "rotor.scopes"

local cases = {}

local kTries = 1000  -- for shrinking a case
local kNamed = 10  -- so many of the cases that failed are named
local kLeastPart = 10  -- where the hypothesis holds in less than this part of the cases, little was tested

-- What is wrong with the arguments is raised as { refused = message }; what happened in a case is returned.
local function refuse(...) error({ refused = string.format(...) }, 0) end

-- One case: { checks =, problem = what f raised or nil, left_out = whether the hypothesis does not hold }.
local function outcome_of(f, case, i)
  local outcome = { is_case = true }
  local problem = scopes.run(outcome, f, case, i)
  if outcome.left_out then
    outcome.checks = {}
  else
    outcome.problem = problem
  end
  return outcome
end

--- given(condition)
function cases.given(condition)
  local scope = scopes.here()
  if type(condition) ~= "boolean" then
    error("given: the hypothesis must be true or false, got a " .. type(condition), 2)
  elseif not (scope and scope.is_case) then
    error("given: it stands in the function of for_each or for_all", 2)
  elseif not condition then
    scope.left_out = true
    error("the hypothesis does not hold", 0)
  end
end

-- Folding -------------------------------------------------------------------------------------------------------------

-- Adds the checks of case i: folded[what] = { worst =, count =, failed = { i, ... }, case = text if the worst failed },
-- and folded[1], folded[2], ... are the names in the order in which they came.
local function fold(folded, checks, i, case_text)
  for _, check in ipairs(checks) do
    local line = folded[check.what]
    if not line then
      line = { worst = check, count = 0, failed = {} }
      folded[check.what], folded[#folded + 1] = line, check.what
    end
    if line.last ~= i then line.count, line.last = line.count + (check.count or 1), i end
    if not check.pass and line.failed[#line.failed] ~= i then table.insert(line.failed, i) end
    if check == line.worst or check.ratio > line.worst.ratio then
      line.worst, line.case = check, not check.pass and case_text() or nil
    end
  end
end

-- The folded checks, one of each name, with what is said of the cases that failed.
local function unfold(folded)
  local checks = {}
  for k, what in ipairs(folded) do
    local line = folded[what]
    local check, failed = line.worst, line.failed
    check.count, check.said = line.count, check.said or {}
    if line.case then table.insert(check.said, 1, line.case) end
    if #failed > 1 then
      table.insert(check.said, ("%d cases failed: %s%s"):format(#failed,
        table.concat(failed, ", ", 1, math.min(#failed, kNamed)), #failed > kNamed and ", ..." or ""))
    end
    checks[k] = check
  end
  return checks
end

-- Where the hypothesis holds too seldom, a check that says so.
local function add_hypothesis(checks, kept, n)
  if kLeastPart*kept < n then
    table.insert(checks, { what = ("the hypothesis holds in %d of %d cases"):format(kept, n), pass = false,
      ratio = math.huge })
  end
end

--- for_each(list, f): its checks, and what a case raised, if one did.
function cases.for_each(list, f)
  if type(list) ~= "table" or type(f) ~= "function" then
    refuse("expected a list of cases and a function, got a %s and a %s", names.type_of(list), type(f))
  elseif #list == 0 then
    refuse "there are no cases"
  end
  local folded, kept = {}, 0
  for i = 1, #list do
    local outcome = outcome_of(f, list[i], i)
    fold(folded, outcome.checks, i, function() return ("case %d: %s"):format(i, exact(list[i])) end)
    kept = kept + (outcome.left_out and 0 or 1)
    if outcome.problem then
      return unfold(folded), ("in case %d, %s: %s"):format(i, exact(list[i]), outcome.problem)
    end
  end
  local checks = unfold(folded)
  add_hypothesis(checks, kept, #list)
  return checks
end

-- Drawing -------------------------------------------------------------------------------------------------------------

-- A case as f may change it.
local function copy(value)
  if type(value) ~= "table" or getmetatable(value) then return value end
  local same = {}
  for key, item in next, value do same[key] = copy(item) end
  return same
end

-- The names of the values, sorted, so that they are drawn in the same order everywhere, and their generators.
local function read_values(values)
  local keys, made = {}, {}
  if type(values) ~= "table" then
    refuse("expected a table of generators, {x = any.number(0, 1)}, got a %s", names.type_of(values))
  end
  for key, value in next, values do
    if type(key) ~= "string" then refuse("the values need names, {x = any.number(0, 1)}") end
    local problem
    made[key], problem = generators.made(value)
    if problem then refuse("%s: %s", key, problem) end
    keys[#keys + 1] = key
  end
  if #keys == 0 then refuse "there are no values to draw" end
  table.sort(keys)
  return keys, made
end

-- n and seed.
local function read_options(options)
  local read = { n = 100, seed = 1 }
  if options ~= nil and type(options) ~= "table" then refuse("expected options in braces, got a %s", type(options)) end
  for key, value in next, options or {} do
    if not read[key] then
      local guess = names.suggest(tostring(key), { "n", "seed" })
      refuse("unknown option '%s'%s", key, guess and "; did you mean '" .. guess .. "'?" or ": it has n and seed")
    end
    read[key] = math.tointeger(value) or refuse("%s: expected a whole number, got %s", key, exact(value))
  end
  if read.n < 1 then refuse("n: expected one case at least, got %d", read.n) end
  return read.n, read.seed
end

-- Of the cases that differ from this one in one value, a simpler one, the first that fails, and its outcome.
local function find_simpler(case, keys, made, fails)
  for _, key in ipairs(keys) do
    local values = made[key].shrink(copy(case[key]))
    if type(values) ~= "table" then refuse("%s: shrink must give a list, got a %s", key, names.type_of(values)) end
    for _, value in ipairs(values) do
      local try = {}
      for k, v in next, case do try[k] = v end
      try[key] = value
      local outcome = fails(try)
      if outcome then return try, outcome end
    end
  end
end

local function first_failed(checks, what)
  for k, check in ipairs(checks) do
    if not check.pass and (what == nil or check.what == what) then return check, k end
  end
end

-- The simplest case found that fails as this one does, by the same check or else by an error, and its outcome.
local function shrink(case, outcome, keys, made, f, i)
  local failed, tries = first_failed(outcome.checks), 0
  local function fails(try)
    if tries == kTries then return nil end
    tries = tries + 1
    local tried = outcome_of(f, copy(try), i)
    if failed and first_failed(tried.checks, failed.what) or not failed and tried.problem then return tried end
  end
  local simpler, simpler_outcome = case, outcome
  while simpler do
    case, outcome = simpler, simpler_outcome
    simpler, simpler_outcome = find_simpler(case, keys, made, fails)
  end
  return case, outcome
end

-- Puts the check that fails in the shrunk case in the place of that in the case found, and says of both how they came.
-- Returns what f raised, if it did, with its case.
local function explain(outcome, found, simple, simple_outcome)
  local shrunk = simple and "shrunk to " .. exact(simple) or "nothing simpler fails"
  local failed, k = first_failed(outcome.checks)
  if not failed then return ("in %s, %s: %s"):format(found, shrunk, simple_outcome.problem) end
  local check = first_failed(simple_outcome.checks, failed.what)
  check.said = table.move(check.said or {}, 1, #(check.said or {}), 2, { shrunk })
  check.ratio = math.huge  -- of two failed checks of this name the one that was shrunk is shown
  outcome.checks[k] = check
  return outcome.problem and ("in %s: %s"):format(found, outcome.problem)
end

--- for_all(values, f, options): its checks, and what a case raised, if one did.
function cases.for_all(values, f, options)
  local keys, made = read_values(values)
  if type(f) ~= "function" then refuse("expected a function of a case, got a %s", type(f)) end
  local n, seed = read_options(options)
  local random, folded, kept, problem = generators.random(seed), {}, 0, nil
  for i = 1, n do
    local case = {}
    for _, key in ipairs(keys) do case[key] = made[key].draw(random) end
    local outcome = outcome_of(f, copy(case), i)
    local failed = outcome.problem or first_failed(outcome.checks)
    local found = failed and ("case %d of %d, seed %d: %s"):format(i, n, seed, exact(case))
    if failed then
      local simple, simple_outcome = shrink(case, outcome, keys, made, f, i)
      problem = explain(outcome, found, simple ~= case and simple, simple_outcome)
    end
    fold(folded, outcome.checks, i, function() return found end)
    if failed then return unfold(folded), problem end
    kept = kept + (outcome.left_out and 0 or 1)
  end
  local checks = unfold(folded)
  add_hypothesis(checks, kept, n)
  return checks
end

return cases
