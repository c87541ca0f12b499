-- compare_charts: where each chart ends and how far it is off, against the closed form of P15; the texts; what is
-- refused.
package.path = arg[0]:match "^(.*)/[^/]*$" .. "/?.lua;" .. package.path
local support = require "support"
local equal, contains, fits = support.equal, support.contains, support.fits

local function rows_of(result)
  local rows = {}
  for _, row in ipairs(result.rows) do rows[row.equation] = row end
  return rows
end

local function close(got, expected, tolerance, what)
  if got ~= got or math.abs(got - expected) > tolerance then
    error(("%s: %s is not within %s of %s"):format(what, got, tolerance, expected), 2)
  end
end

-- Turned about its own axis, the angle is 1 + t: [P10] ends where it is pi, [P7] and [P5] where it is 2 pi. They end
-- a little before, by less than ten times the accuracy of 1e-10 (chart_run_test measures it), or after by the error.
local about_k = compare_charts { omega = { 0, 0, 1 }, from = rotation({ 0, 0, 1 }, 1), to = 10 }
local rows = rows_of(about_k)
equal(#about_k.rows, 6)
for equation, stop in pairs { gibbs = { "theta = pi", pi - 1 }, euler = { "|E| = 2 pi", 2*pi - 1 },
  axis_angle = { "theta = 2 pi", 2*pi - 1 } } do
  local row = rows[equation]
  equal(row.complete, false, equation)
  equal(row.singular, stop[1], equation)
  equal(row.stopped, "singular at " .. stop[1], equation)
  close(row.reached, stop[2], 1e-9, equation)
  equal(row.run.t1, row.reached, equation)
end
for _, equation in ipairs { "quaternion", "modified_gibbs", "body_points" } do
  equal(rows[equation].complete, true, equation)
  equal(rows[equation].stopped, nil, equation)
  equal(rows[equation].reached, 10.0, equation)
end
-- cos((1 + t)/2) is 0 at t = pi - 1, found to the rounding of t.
close(about_k.lost_sign, pi - 1, 4e-15, "theta = pi")
contains(tostring(about_k), "t = 2.14159")

-- Each is within its accuracy of the reference, which is exact here, up to where it ends; so two are within twice
-- that. The estimates are of first order: a quarter more.
for _, row in ipairs(about_k.rows) do
  close(row.disagreement, 0, 1e-10, row.equation)
  close(row.disagreement, 0, 1.25*row.estimate + about_k.reference_estimate, row.equation .. ", by its estimate")
  equal(row.disagreement >= 0 and #row.disagreements == 1000, true, row.equation)
end
close(about_k.farthest.disagreement, 0, 2e-10, "any two")
contains(about_k.reference, "exact, constant omega")

-- [P15], from the identity: q = exp(k a t/2) exp((i - a k) t/2) [theory 4.4], its scalar part
-- cos(a t/2) cos(W t/2) + (a/W) sin(a t/2) sin(W t/2), W = sqrt(1 + a^2), is 0 where [P10] ends.
local a = 2*pi/40
local W = sqrt(1 + a^2)
local function omega(t) return cos(a*t), sin(a*t), 0 end
local function scalar(t) return cos(a*t/2)*cos(W*t/2) + a/W*sin(a*t/2)*sin(W*t/2) end
local low, high = 3.0, 3.5  -- of different signs, and monotonic between
for _ = 1, 60 do
  local middle = (low + high)/2
  if scalar(middle) > 0 then low = middle else high = middle end
end
local turning = compare_charts { omega = omega, to = 20, every = 0.5 }
rows = rows_of(turning)
close(rows.gibbs.reached, low, 1e-9, "G is infinite")
-- The section is that of the reference, off by its error over the rate of the angle, 1 about; and as `low` is rounded.
close(turning.lost_sign, low, 2*turning.reference_estimate + 1e-14, "theta = pi")
equal(#turning.times, 41)
equal(rows.axis_angle.stopped, "singular start: theta = 0")
equal(rows.axis_angle.singular, "theta = 0")
equal(rows.axis_angle.complete, false)
equal(rows.axis_angle.disagreement, nil)
equal(rows.axis_angle.run, nil)
equal(rows.axis_angle.reached, 0.0)
-- theta = 2 pi is passed by, not met: the motion never comes back to the identity by t = 20.
equal(rows.euler.complete, true)
for _, row in ipairs(turning.rows) do
  if row.run then
    local truth = rotation({ 0, 0, 1 }, a*row.reached)*rotation(vec(1, 0, -a), W*row.reached)
    close(row.run(row.reached).rotation:distance(truth), 0, 1e-10, row.equation .. " where it ends")
    equal(row.disagreement > 0 and row.disagreement <= 2e-10, true, row.equation)
  end
end
-- The pair is one of different charts, as far apart as its charts are from the reference together at most.
local by_label = {}
for _, row in ipairs(turning.rows) do by_label[row.label] = row.disagreement end
local far = turning.farthest
equal(far[1] ~= far[2], true)
equal(far.disagreement > 0 and far.disagreement <= by_label[far[1]] + by_label[far[2]] + 1e-15, true)

-- A Gibbs vector of pi cannot start; from 3 pi the others can, and go on to 4 pi. Backward to 2 pi.
local from_pi = rows_of(compare_charts { omega = { 1, 0, 0 }, from = rotation({ 1, 0, 0 }, 3*pi), to = 10, n = 11 })
equal(from_pi.gibbs.singular, "theta = pi")
equal(from_pi.gibbs.reached, 0.0)
equal(from_pi.euler.singular, "|E| = 4 pi")
close(from_pi.axis_angle.reached, pi, 1e-9, "4 pi")
local back = rows_of(compare_charts { omega = { 1, 0, 0 }, from = rotation({ 1, 0, 0 }, 2.5*pi), t = { 5, -5 } })
close(back.euler.reached, 5 - pi/2, 1e-9, "2 pi, backward")
equal(back.gibbs.complete, false)
close(back.gibbs.reached, 5 - 1.5*pi, 1e-9, "pi, backward")

-- The modified Gibbs vector without its cosine is [P4] with f = sin(x/2): it ends at pi, as lost_sign says (where
-- f' = 0, f tells the angle to 1e-4 only). restart goes to those that take it.
local half_sine = compare_charts { omega = { 0, 0, 1 }, from = rotation({ 0, 0, 1 }, 1), to = 10, restart = true,
  f = function(x) return sin(x/2) end }
rows = rows_of(half_sine)
equal(#half_sine.rows, 7)
close(rows.generalized.reached, half_sine.lost_sign, 1e-3, "M alone")
contains(rows.generalized.stopped, "singular at theta = 3.14159")
equal(rows.euler.label, "euler, restart")
equal(rows.euler.complete, true)
close(rows.euler.disagreement, 0, 1e-10, "restarted")
equal(rows.axis_angle.complete, false)

-- Straight through 2 pi by fixed steps [P7] is wrong after it, and said to be: it is off by far more than the others.
local ignored = compare_charts { omega = { 0, 0, 1 }, from = rotation({ 1e-3, 0, 1 }, 1), to = 10, method = "rk4",
  step = 0.01, singularity = "ignore", equations = { "quaternion", "euler" } }
equal(#ignored.rows, 2)
equal(ignored.rows[2].label, "euler, ignore")
equal(ignored.rows[2].complete, true)
equal(ignored.rows[2].disagreement > 1e3*ignored.rows[1].disagreement, true)
equal(ignored.lost_sign, nil, "M is not among them")

-- What stops for another reason says it, and where the angle was: half of what is needed is granted.
local short = compare_charts { omega = omega, to = 400, max_steps = 300, equations = { "quaternion" } }
contains(short.rows[1].stopped, "step limit, theta = ")
equal(short.rows[1].singular, nil)
equal(short.rows[1].steps <= 300, true)

-- The texts fit and say what they are.
local all = { about_k, turning, half_sine, ignored, short,
  compare_charts { omega = { 0, 0, 0 }, from = rotation({ 1, 1, 1 }, pi), to = 4, every = 1 },
  compare_charts { omega = omega, to = 0, n = 1, equations = { "axis_angle" } } }
for _, value in ipairs(all) do
  fits(tostring(value))
  contains(tostring(value), "equation")
  contains(tostring(value), "omega calls")
end
contains(tostring(turning), "singular start: theta = 0\n")
contains(tostring(about_k), "singular at |E| = 2 pi\n")
contains(tostring(about_k), "any two agree to ")
equal(tostring(all[7]):find("any two", 1, true), nil, "one chart has nobody to agree with")
local drawn = support.printed(turning.plot, turning, { height = 12, title = "P15" })
fits(drawn)
contains(drawn, "P15")
contains(drawn, "off the reference by, rad")
for _, equation in ipairs { "quaternion", "euler", "modified_gibbs", "gibbs", "body_points" } do
  contains(drawn, " " .. equation)
end
equal(drawn:find("axis_angle", 1, true), nil, "nothing of it can be drawn")
local file = os.tmpname()
support.printed(turning.csv, turning, file)
local data = read_csv(file)
equal(#data.equation, 6)
equal(data.reached[4], rows_of(turning).gibbs.reached)
equal(data.stopped[4], "singular at theta = pi")
equal(data.stopped[1], "")
equal(data.disagreement[5] ~= data.disagreement[5], true, "none of axis_angle")
os.remove(file)

-- What is refused.
local function refused(options, pattern)
  local ended, message = pcall(function() compare_charts(options) end)
  if ended then error("accepted; expected " .. pattern, 2) end
  contains(tostring(message), "charts_test.lua:")
  contains(tostring(message), "compare_charts: " .. pattern)
end
refused(nil, "expected options in braces, got nil")
refused({ omega = omega, to = 1, equation = "gibbs" }, "unknown option 'equation'; did you mean 'equations'?")
refused({ omega = omega, to = 1, equations = "gibbs" }, 'equations: expected a list as {"euler", "gibbs"}, got string')
refused({ omega = omega, to = 1, equations = {} }, "equations: expected a list")
refused({ omega = omega, to = 1, equations = { 3 } }, "equations: item 1: expected a name, got number")
refused({ omega = omega, to = 1, equations = { "euler", "euler" } }, 'equations: item 2: "euler" is there already')
refused({ omega = omega, to = 1, equations = { "gibs" } }, "equation: expected one of")
refused({ omega = omega, to = 1, equations = { "gibbs" }, restart = true }, "restart: none of the equations takes it")
refused({ omega = omega, to = 1, equations = { "generalized" } }, 'equation = "generalized" needs f')
refused({ omega = omega, to = 1, n = 3, every = 1 }, "give one of n, every and times")
refused({ omega = omega, to = 1, times = { 2 } }, "t = 2.0 is outside the run, 0.0 .. 1.0")
refused({ omega = omega, to = 1, method = "fgl" }, 'method "fgl" follows the quaternion only')
refused({ omega = omega }, "give to = t1 or t = {t0, t1}")
refused({ to = 1 }, "omega is missing")
refused({ omega = function(t) return 1, 0, sqrt(0.5 - t) end, to = 1 }, "no reference: stopped at t = 0.4999")
local ended, message = pcall(function() turning.plot {} end)
equal(ended, false)
contains(message, "plot: before the colon: expected charts")
ended, message = pcall(function() all[7]:plot() end)
equal(ended, false)
contains(message, "plot: no chart is off by more than 0")
