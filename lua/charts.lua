-- compare_charts{...}: one motion by the equations of several charts, each as far as it goes.
local names = require "rotor.names"
local scenes = require "rotor.scene"
local text = require "rotor.text"

-- As registered, whatever a script has made of the global names.
local plot, write_csv = names.find("", "plot").value, names.find("", "write_csv").value
local refuse, distance = scenes.refuse, scenes.distance

local charts = {}

local kScene = { "omega", "from", "to", "t", "max_step", "max_steps", "breaks" }
local kHow = { "accuracy", "method", "step" }
local kTimes = { "n", "every", "times" }
local kOwn = { "equations" }
local kEquations = { "quaternion", "euler", "modified_gibbs", "gibbs", "axis_angle", "body_points" }
-- The equations that take an option of evolve's.
local kTakenBy = { f = { generalized = true }, restart = { euler = true, generalized = true },
  singularity = { euler = true } }
local kBest = 1e-14  -- the accuracy asked of the reference

-- What is asked for --------------------------------------------------------------------------------------------------

local function copied(options, ...)
  local copy = {}
  for _, keys in ipairs { ... } do
    for _, key in ipairs(keys) do copy[key] = options[key] end
  end
  return copy
end

-- Without repetition; evolve says which names there are.
local function equations_of(options)
  local list = options.equations
  if list == nil then
    list = { table.unpack(kEquations) }
    if options.f ~= nil then list[#list + 1] = "generalized" end
  end
  if type(list) ~= "table" or names.type_of(list) ~= "table" or #list == 0 then
    refuse('equations: expected a list as {"euler", "gibbs"}, got %s', names.type_of(list))
  end
  local seen = {}
  for i, equation in ipairs(list) do
    if type(equation) ~= "string" then
      refuse("equations: item %d: expected a name, got %s", i, names.type_of(equation))
    end
    if seen[equation] then refuse('equations: item %d: "%s" is there already', i, equation) end
    seen[equation] = true
  end
  for key, takers in pairs(kTakenBy) do
    local taken = options[key] == nil
    for equation in pairs(takers) do taken = taken or seen[equation] end
    if not taken then refuse("%s: none of the equations takes it", key) end
  end
  return list
end

local function label_of(options)
  return options.equation .. (options.restart and ", restart" or options.singularity == "ignore" and ", ignore" or "")
end

-- Runs ---------------------------------------------------------------------------------------------------------------

-- A run as far as it goes, or nil; and what ended it.
local function followed(options)
  local ended, run, stop = pcall(scenes.made, options)
  if not ended then
    local where = type(run) == "table" and #run == 1 and run[1]:match "is singular at ([^;,]+).*; the start's angle is"
    if not where then error(run, 0) end
    return nil, "singular start: " .. where, where
  end
  if run then return run end
  local where = stop.reason == "singularity" and stop.message:match "is singular at ([^;,]+)" or nil
  local what = where and "singular at " .. where or ("%s, theta = %.4g"):format(stop.reason, stop.run(stop.t).angle)
  return stop.run, what, where
end

-- The greatest distance of two runs at those of the times that both reach, and where the first of them to stop did;
-- the time of it, and the distances at the times. at(i) gives the quaternions there, more(t) those of the end.
local function compared(times, from, reached, at, more)
  local distances, greatest, when = {}, 0.0, from
  local function look(t, p, q)
    local apart = distance(p, q)
    if apart > greatest then greatest, when = apart, t end
    return apart
  end
  for i, t in ipairs(times) do
    distances[i] = math.abs(t - from) <= math.abs(reached - from) and look(t, at(i)) or 0/0
  end
  look(reached, more(reached))
  return greatest, when, distances
end

local function row_of(options, reference, times, quaternions)
  local run, stopped, singular = followed(options)
  local row = { equation = options.equation, label = label_of(options), run = run, stopped = stopped,
    singular = singular, complete = run ~= nil and run.complete, reached = run and run.t1 or reference.t0 }
  if not run then return row end
  row.steps, row.omega_calls, row.estimate = run.cost.steps, run.cost.omega_calls, run.error_estimate
  local own = {}
  row.disagreement, row.at, row.disagreements = compared(times, run.t0, run.t1, function(i)
    own[i] = run(times[i]).quaternion
    return own[i], quaternions[i]
  end, function(t) return run(t).quaternion, reference(t).quaternion end)
  return row, own
end

-- The two that are farthest apart.
local function farthest(rows, quaternions, times)
  local result
  for i, a in ipairs(rows) do
    for j = i + 1, #rows do
      local b = rows[j]
      if a.run and b.run then
        local first = math.abs(a.reached - a.run.t0) < math.abs(b.reached - b.run.t0) and a or b
        local greatest, when = compared(times, a.run.t0, first.reached, function(k)
          return quaternions[i][k], quaternions[j][k]
        end, function(t) return a.run(t).quaternion, b.run(t).quaternion end)
        if not result or greatest > result.disagreement then
          result = { disagreement = greatest, at = when, a.label, b.label }
        end
      end
    end
  end
  return result
end

-- Where cos(theta/2), whose sign is not in M, first changes sign.
local function lost_sign(reference)
  return reference:section { f = function(state) return state.quaternion.w end }.times[1]
end

-- The value ----------------------------------------------------------------------------------------------------------

local methods = {}
local meta = { __name = "charts", __index = methods }

local kHeader = { "equation", "off by", "steps", "omega calls", "to t", "" }

local function number(x, form) return x and form:format(x) or "-" end

local function cells(row)
  return { row.label, number(row.disagreement, "%.1e"), number(row.steps, "%d"), number(row.omega_calls, "%d"),
    ("%.8g"):format(row.reached), row.stopped or "the end" }
end

--- The table, for the terminal.
function meta.__tostring(self)
  local rows, widths = { kHeader }, {}
  for i, row in ipairs(self.rows) do rows[i + 1] = cells(row) end
  for i = 1, #kHeader - 1 do
    widths[i] = 0
    for _, row in ipairs(rows) do widths[i] = math.max(widths[i], #row[i]) end
  end
  local lines = {
    ("charts  t %s .. %s"):format(text.number(self.t0), text.number(self.t1)),
    text.wrap(self.reference, "  reference  ", "             "),
  }
  for _, row in ipairs(rows) do
    local line = text.pad(row[1], widths[1])
    for i = 2, #widths do line = line .. "  " .. (" "):rep(widths[i] - #row[i]) .. row[i] end
    lines[#lines + 1] = text.wrap(row[#row], line .. "  ", (" "):rep(#line + 2)):gsub("%s+$", "")
  end
  local far = self.farthest
  if far then
    local apart = "any two agree to %.1e rad; farthest apart are %s and %s, at t = %.8g"
    lines[#lines + 1] = text.wrap(apart:format(far.disagreement, far[1], far[2], far.at), "", "  ")
  end
  if self.lost_sign then
    local alone = "M alone, without cos(theta/2), loses the sign of it at theta = pi, t = %.8g"
    lines[#lines + 1] = text.wrap(alone:format(self.lost_sign), "", "  ")
  end
  return table.concat(lines, "\n")
end

local function checked(self, method)
  if names.type_of(self) ~= "charts" then error(method .. ": before the colon: expected charts", 3) end
end

--- Draws how far each chart is from the reference over t.
function methods:plot(options)
  checked(self, "plot")
  options = options or {}
  local curves = {}
  for _, row in ipairs(self.rows) do
    local curve, drawn = {}, false
    for i, apart in ipairs(row.disagreements or {}) do
      curve[i] = apart > 0 and apart or 0/0  -- 0 has no place on the axis
      drawn = drawn or apart > 0
    end
    if drawn then curves[row.label] = curve end
  end
  if not next(curves) then error("plot: no chart is off by more than 0", 2) end
  local look = { log = "y", x_label = "t", y_label = "off the reference by, rad" }
  for key, value in pairs(options) do look[key] = value end
  plot(self.times, curves, look)
end

--- Writes the rows.
function methods:csv(file)
  checked(self, "csv")
  local columns = { "equation", "disagreement", "at", "estimate", "steps", "omega_calls", "reached", "stopped" }
  local data = {}
  for _, name in ipairs(columns) do
    data[name] = {}
    local key = name == "equation" and "label" or name
    for i, row in ipairs(self.rows) do data[name][i] = row[key] or name == "stopped" and "" or 0/0 end
  end
  write_csv(file, data, { columns = columns })
end

local function measured(options)
  scenes.check_keys(options, kScene, kHow, kTimes, kOwn, { "f", "restart", "singularity" })
  local equations = equations_of(options)
  local best = copied(options, kScene)
  best.accuracy = kBest
  local reference, stop = scenes.made(best)
  if not reference then refuse("no reference: %s", tostring(stop):match "evolve: (.*)") end
  local given, states = pcall(reference.sample, reference, copied(options, kTimes))
  if not given then
    local wrong = type(states) == "string" and states:match "sample: (.*)"
    if wrong then refuse("%s", wrong) end
    error(states, 0)
  end
  local times, quaternions, rows, all = {}, {}, {}, {}
  for i, state in ipairs(states) do times[i], quaternions[i] = state.t, state.quaternion end
  local lost
  for i, equation in ipairs(equations) do
    local scene = copied(options, kScene, kHow)
    scene.equation, scene.method = equation, options.method or "dop853"
    for key, takers in pairs(kTakenBy) do
      if takers[equation] then scene[key] = options[key] end
    end
    rows[i], all[i] = row_of(scene, reference, times, quaternions)
    if equation == "modified_gibbs" then lost = lost_sign(reference) end
  end
  return setmetatable({ rows = rows, times = times, t0 = reference.t0, t1 = reference.t1,
    reference = ("%s, %s; error about %.1e rad"):format(reference.method, reference.why, reference.error_estimate),
    reference_estimate = reference.error_estimate, farthest = farthest(rows, all, times), lost_sign = lost }, meta)
end

--- The global function compare_charts{...}.
function charts.compare(options)
  return scenes.answer("compare_charts", measured, options)
end

return charts
