-- tradeoff{...}: what accuracy costs, method by method, against the best reference there is.
local names = require "rotor.names"
local scenes = require "rotor.scene"
local text = require "rotor.text"

-- As registered, whatever a script has made of the global names.
local plot, write_csv = names.find("", "plot").value, names.find("", "write_csv").value
local refuse, made, distance = scenes.refuse, scenes.made, scenes.distance

local tradeoff = {}

local kScene = { "omega", "from", "to", "t", "max_step", "max_steps", "breaks", "equation", "f", "restart" }
local kOwn = { "methods", "accuracies", "steps", "reference" }
local kAccuracies = { 1e-4, 1e-6, 1e-8, 1e-10, 1e-12 }
local kTimes = 100          -- at which a run is compared, the end among them
local kBest = 1e-14         -- the accuracy asked of a reference
local kLong, kMost = 0.02, 5  -- a run that takes longer, in seconds, is timed once, others so many times

-- What is asked for --------------------------------------------------------------------------------------------------

-- t0 and t1; evolve says what else is wrong with them.
local function interval_of(options)
  local t0, t1 = 0.0, options.to
  if type(options.t) == "table" then t0, t1 = options.t[1], options.t[2] end
  if math.type(t0) == nil or math.type(t1) == nil then refuse "give to = t1 or t = {t0, t1}" end
  return t0 + 0.0, t1 + 0.0
end

local function positive_numbers(list, what)
  if type(list) ~= "table" or #list == 0 then refuse("%s: expected a list of numbers, {0.1, 0.01}", what) end
  for i, x in ipairs(list) do
    if type(x) ~= "number" or x ~= x or x <= 0 or x == math.huge then
      refuse("%s: item %d: expected a positive number, got %s", what, i, tostring(x))
    end
  end
  return list
end

-- The runs to be made: { label =, options = for evolve }, for each method and each accuracy or step.
local function runs_of(options)
  local methods = options.methods or { "fgl", "dop853", options.steps and "rk4" or nil }
  if type(methods) ~= "table" or #methods == 0 then
    refuse('methods: expected a list as {"fgl", "rk4", {method = "rk4", equation = "euler"}}')
  end
  local runs = {}
  for i, item in ipairs(methods) do
    if type(item) == "string" then item = { method = item } end
    if type(item) ~= "table" or type(item.method) ~= "string" then
      refuse('methods: item %d: expected a name or {method = "rk4", equation = ...}', i)
    end
    local scene = {}
    for _, key in ipairs(kScene) do scene[key] = options[key] end
    for key, value in pairs(item) do scene[key] = value end
    scene.label, scene.accuracies, scene.steps = nil, nil, nil
    local label = item.label or item.method .. (scene.equation and ", " .. scene.equation or "")
    local function add(key, values)
      for _, value in ipairs(values) do
        local whole = { [key] = value }
        for name, given in pairs(scene) do whole[name] = given end
        runs[#runs + 1] = { label = label, options = whole }
      end
    end
    if item.method == "exact" then
      runs[#runs + 1] = { label = label, options = scene }
    elseif item.method == "rk4" then
      local steps = item.steps or options.steps
      if not steps then refuse('steps is missing: method "rk4" takes steps, as {0.1, 0.05}') end
      add("step", positive_numbers(steps, "steps"))
    else
      add("accuracy", positive_numbers(item.accuracies or options.accuracies or kAccuracies, "accuracies"))
    end
  end
  return runs
end

-- Runs ---------------------------------------------------------------------------------------------------------------

local function median(list)
  table.sort(list)
  return (list[(#list + 1)//2] + list[#list//2 + 1])/2
end

local function timed(options)
  local run, stop = made(options)
  if not run then return nil, stop end
  local seconds = { run.cost.seconds }
  while seconds[1] < kLong and #seconds < kMost do seconds[#seconds + 1] = made(options).cost.seconds end
  return run, median(seconds)
end

local function quaternion_of(value, t)
  local kind = names.type_of(value)
  if kind == "quaternion" then return value end
  if kind == "rotation" then return value.quaternion end
  refuse("reference: expected a rotation or a quaternion at t = %s, got %s", text.number(t), kind)
end

-- The greatest distance of a run from the reference at its times.
local function distance_from(reference, run)
  local greatest = 0.0
  for i, t in ipairs(reference.times) do
    greatest = math.max(greatest, distance(reference.quaternions[i], run(t).quaternion))
  end
  return greatest
end

-- References ---------------------------------------------------------------------------------------------------------

-- The quaternions of `at` at the times of comparison; `text` says what it is, `error` how far it may be off.
local function tabulated(at, t0, t1, what, error_of_it)
  local reference = { times = {}, quaternions = {}, text = what, error = error_of_it }
  for i = 1, kTimes do
    local t = i < kTimes and t0 + (t1 - t0)*(i/kTimes) or t1
    reference.times[i], reference.quaternions[i] = t, at(t)
  end
  return reference
end

local function of_run(run, what, error_of_run)
  return tabulated(function(t) return run(t).quaternion end, run.t0, run.t1, what, error_of_run)
end

-- The exact model where there is one; else a run by each of the two best methods, which have nothing in common.
local function best_references(options)
  local scene = {}
  for _, key in ipairs(kScene) do scene[key] = options[key] end
  scene.equation, scene.f, scene.restart = nil, nil, nil
  scene.accuracy = kBest
  local found, stopped = {}, nil
  for _, method in ipairs { "auto", "dop853" } do
    scene.method = method
    local run, stop = made(scene)
    local exact = run and run.method == "exact"
    stopped = stopped or stop
    if run then
      local off = exact and run.error_estimate or run:certify().estimate
      local what = exact and "exact: " .. run.why or ("%s, certified to %.1e rad"):format(run.method, off)
      found[#found + 1] = of_run(run, what, off)
      found[#found].method = run.method
    end
    if exact then break end
  end
  if #found == 0 then refuse("no reference: %s", tostring(stopped):match "evolve: (.*)" or tostring(stopped)) end
  return found
end

local function references_of(options, t0, t1)
  local given = options.reference
  if given == nil then return best_references(options) end
  if names.type_of(given) == "run" then
    if given.t0 ~= t0 or given.t1 ~= t1 then
      refuse("reference: the run given is from %s to %s, the scene from %s to %s", text.number(given.t0),
        text.number(given.t1), text.number(t0), text.number(t1))
    end
    return { of_run(given, "a run given, " .. given.method, given.error_estimate) }
  end
  if type(given) ~= "function" then
    refuse("reference: expected a run, or a function of t that gives a rotation, got %s", names.type_of(given))
  end
  return { tabulated(function(t) return quaternion_of(given(t), t) end, t0, t1, "a function given", 0.0) }
end

local function text_of(references)
  local texts = {}
  for i, reference in ipairs(references) do texts[i] = reference.text end
  return table.concat(texts, "; ") .. (#texts > 1 and "; for each row the one of another method" or "")
end

-- The error of a run, and by what it is known: by the reference, which is of another method unless it was given;
-- where that is not ten times better than the run, by the run's own certificate; or only a bound of it, where the
-- certificate finds nothing above rounding either, and for the exact model, which states its rounding.
local function achieved(run, references)
  if run.method == "exact" then return run.error_estimate, "bound" end
  local most = math.huge
  for _, reference in ipairs(references) do
    if reference.method ~= run.method then
      local apart = distance_from(reference, run)
      if apart >= 10*reference.error then return apart, "reference" end
      most = apart + reference.error
    end
  end
  local certificate = run:certify()
  if certificate.at_rounding or most < certificate.estimate then
    return math.min(most, certificate.estimate), "bound"
  end
  return certificate.estimate, "certificate"
end

-- The value ----------------------------------------------------------------------------------------------------------

local methods = {}
local meta = { __name = "tradeoff", __index = methods }

local kHeader = { "asked", "achieved", "estimate", "omega calls", "steps", "seconds" }

local kSign = { reference = "%.1e ", certificate = "%.1e*", bound = "<%.1e " }

local function cells(row)
  local asked = row.asked and ("%.0e"):format(row.asked) or row.step and "step " .. text.number(row.step) or "-"
  if row.stopped then return { asked, row.stopped } end
  return { asked, kSign[row.by]:format(row.achieved), ("%.1e"):format(row.estimate),
    tostring(row.omega_calls), tostring(row.steps), ("%.2g"):format(row.seconds) }
end

-- The table, for the terminal.
function meta.__tostring(self)
  local first = #"method"
  local widths, rows = {}, {}
  for i, head in ipairs(kHeader) do widths[i] = #head end
  for k, row in ipairs(self.rows) do
    first, rows[k] = math.max(first, text.width(row.method)), cells(row)
    for i, cell in ipairs(rows[k]) do
      if i == 1 or not row.stopped then widths[i] = math.max(widths[i], #cell) end
    end
  end
  local function line(name, row, stopped)
    local parts = { text.pad(name, first) }
    for i, cell in ipairs(row) do
      parts[#parts + 1] = stopped and i > 1 and cell or (" "):rep(widths[i] - #cell) .. cell
    end
    return table.concat(parts, "  ")
  end
  local lines = {
    ("tradeoff  t %s .. %s"):format(text.number(self.t0), text.number(self.t1)),
    text.wrap(self.reference, "  reference  ", "             "),
    line("method", kHeader),
  }
  local by = {}
  for k, row in ipairs(self.rows) do
    lines[#lines + 1] = line(row.method, rows[k], row.stopped)
    by[row.by or ""] = true
  end
  if by.certificate then lines[#lines + 1] = "* by the run's own certificate: the reference is not ten times better" end
  if by.bound then lines[#lines + 1] = "< nothing found above rounding" end
  return table.concat(lines, "\n")
end

--- Draws the achieved error over omega_calls or seconds, a mark for each method.
function methods:plot(options)
  options = options or {}
  if names.type_of(self) ~= "tradeoff" then error("plot: before the colon: expected a tradeoff", 2) end
  local cost = options.over or "omega_calls"
  if cost ~= "omega_calls" and cost ~= "seconds" and cost ~= "steps" then
    error('plot: over: expected "omega_calls", "seconds" or "steps", got "' .. tostring(cost) .. '"', 2)
  end
  local points = {}
  for _, row in ipairs(self.rows) do
    if row.achieved and row.achieved > 0 and row[cost] > 0 then points[#points + 1] = row end
  end
  if #points == 0 then error("plot: no row has an error and a cost to draw", 2) end
  table.sort(points, function(a, b) return a[cost] < b[cost] end)
  local x, y = {}, {}
  for _, row in ipairs(points) do y[row.method] = {} end
  -- Every second x is without a value: the points are not joined.
  for _, row in ipairs(points) do
    for _, achieved_or_gap in ipairs { row.achieved, 0/0 } do
      x[#x + 1] = row[cost]
      for method, list in pairs(y) do list[#x] = method == row.method and achieved_or_gap or 0/0 end
    end
  end
  plot(x, y, { log = "xy", title = options.title, width = options.width, height = options.height,
    x_label = (cost:gsub("_", " ")), y_label = "achieved error, rad" })
end

--- Writes the rows.
function methods:csv(file)
  local columns = { "method", "asked", "step", "achieved", "by", "estimate", "omega_calls", "steps", "seconds",
    "stopped" }
  local data = {}
  for _, name in ipairs(columns) do
    data[name] = {}
    local none = (name == "by" or name == "stopped") and "" or 0/0
    for i, row in ipairs(self.rows) do data[name][i] = row[name] or none end
  end
  write_csv(file, data, { columns = columns })
end

local function measured(options)
  scenes.check_keys(options, kScene, kOwn)
  local t0, t1 = interval_of(options)
  local runs = runs_of(options)
  local references = references_of(options, t0, t1)
  local rows = {}
  for i, one in ipairs(runs) do
    local row = { method = one.label, asked = one.options.accuracy, step = one.options.step }
    local run, seconds = timed(one.options)
    if run then
      row.achieved, row.by = achieved(run, references)
      row.estimate = run.error_estimate
      row.omega_calls, row.steps, row.seconds = run.cost.omega_calls, run.cost.steps, seconds
    else
      row.stopped = ("stopped at t = %s: %s"):format(text.number(seconds.t), seconds.reason)
    end
    rows[i] = row
  end
  return setmetatable({ rows = rows, reference = text_of(references), t0 = t0, t1 = t1 }, meta)
end

--- The global function tradeoff{...}.
function tradeoff.measure(options)
  return scenes.answer("tradeoff", measured, options)
end

return tradeoff
