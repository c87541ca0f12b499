-- tradeoff and plot: what is measured, against the closed form of P15; the texts; what is refused.
package.path = arg[0]:match "^(.*)/[^/]*$" .. "/?.lua;" .. package.path
local support = require "support"
local equal, contains, fits = support.equal, support.contains, support.fits

local a = 2*pi/40
local function omega(t) return cos(a*t), sin(a*t), 0 end
-- [theory 4.4]: exp(k a t/2) exp((i - a k) t/2).
local function truth(t)
  return rotation({ 0, 0, 1 }, a*t)*rotation(vec(1, 0, -a), math.sqrt(1 + a^2)*t)
end

local function within(value, low, high, what)
  if not (value >= low and value <= high) then
    error(("%s: %s is not within %s .. %s"):format(what, value, low, high), 2)
  end
end

-- RK4's error is known [theory 4.9]: 2.9747e-3 for h = 0.5 and 4.8801e-6 for 0.1 at t = 100, where it is greatest.
local known = tradeoff { omega = omega, to = 100, methods = { "rk4" }, steps = { 0.5, 0.1 }, reference = truth }
equal(#known.rows, 2)
within(known.rows[1].achieved, 2.97465e-3, 2.97475e-3, "h = 0.5")
within(known.rows[2].achieved, 4.88005e-6, 4.88015e-6, "h = 0.1")
equal(known.rows[1].omega_calls, 401)
equal(known.rows[1].steps, 200)
equal(known.rows[1].step, 0.5)
equal(known.rows[1].asked, nil)
equal(known.reference, "a function given")

-- Without a reference: two methods, certified, give the same, each for the rows of the other.
local own = tradeoff { omega = omega, to = 100, methods = { "dop853", "rk4" }, steps = { 0.5 },
  accuracies = { 1e-4, 1e-8 } }
equal(#own.rows, 3)
within(own.rows[3].achieved, 2.97465e-3, 2.97475e-3, "h = 0.5")
for i = 1, 2 do
  local row = own.rows[i]
  equal(row.method, "dop853")
  within(row.achieved, 0, row.asked, "kept")
  within(row.seconds, 0, 60, "seconds")
end
contains(own.reference, "fgl, certified to ")
contains(own.reference, "dop853, certified to ")
equal(own.rows[3].by, "reference")

-- At the level of rounding, or by the method of a reference, a run is certified: it is not held against itself.
local finest = tradeoff { omega = omega, to = 100, methods = { "fgl", "dop853" }, accuracies = { 1e-12 } }
for _, row in ipairs(finest.rows) do within(row.achieved, 1e-16, 1e-12, row.method) end
equal(finest.rows[1].by, "bound")
contains(tostring(finest), "< nothing found above rounding")
local middle = tradeoff { omega = omega, to = 100, methods = { "dop853" }, accuracies = { 1e-4 } }
equal(middle.rows[1].by, "reference")

-- The exact model, where there is one; a run as the reference; options of a method; backward.
local exact = tradeoff { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = a }, t = { 5, -20 },
  methods = { "exact", { method = "rk4", steps = { 0.1 }, label = "classical" } } }
contains(exact.reference, "exact: ")
equal(exact.t0, 5.0)
equal(exact.t1, -20.0)
within(exact.rows[1].achieved, 1e-16, 1e-13, "the exact motion is certified")
equal(exact.rows[1].by, "bound")
equal(exact.rows[2].method, "classical")
within(exact.rows[2].achieved, 1e-7, 1e-5, "RK4, h = 0.1, a quarter of the way")
local given = tradeoff { omega = { 0, 0, 1 }, to = 3, methods = { "dop853" }, accuracies = { 1e-6 },
  reference = evolve { omega = { 0, 0, 1 }, to = 3 } }
contains(given.reference, "a run given, exact")
within(given.rows[1].achieved, 0, 1e-6, "kept")

-- A method that stops is a row that says so, and no other.
local stopped = tradeoff { omega = omega, to = 1000, methods = { "dop853", "rk4" }, steps = { 5 },
  accuracies = { 1e-12 }, max_steps = 300, reference = truth }
contains(stopped.rows[1].stopped, "step limit")
equal(stopped.rows[1].achieved, nil)
contains(tostring(stopped), "stopped at t = ")
within(stopped.rows[2].achieved, 0, pi, "the other")

-- The texts fit and say what they are.
for _, value in ipairs { known, own, finest, exact, stopped } do
  fits(tostring(value))
  contains(tostring(value), "method")
  contains(tostring(value), "omega calls")
end
contains(tostring(known), "step 0.5")
contains(tostring(own), "1e-08")
local drawn = support.printed(own.plot, own)
fits(drawn)
contains(drawn, "* dop853   + rk4")
contains(drawn, "1e-02 |")
equal(select(2, drawn:gsub("%*", "")), 2 + 1, "two rows and the legend")
contains(support.printed(own.plot, own, { over = "seconds", title = "time" }), "seconds")
local file = os.tmpname()
support.printed(own.csv, own, file)
local data = read_csv(file)
equal(#data.method, 3)
equal(data.achieved[3], own.rows[3].achieved)
equal(data.by[3], "reference")
equal(data.asked[3] ~= data.asked[3], true, "rk4 was not asked for an accuracy")
os.remove(file)

-- plot: lists, by name or alone.
contains(support.printed(plot, { 1, 10, 100 }, { 1, 0.1, 0.01 }, { log = "xy", height = 9 }), "1e-01 |")
contains(support.printed(plot, { 0, 1 }, { b = { 0, 1 }, a = { 1, 0 } }), "* a   + b")
contains(support.printed(plot, { 0, 1 }, { 0, 1 }, { title = "T", x_label = "X", y_label = "Y" }), "Y\n")

-- What is refused.
local function refused(f, pattern)
  local ended, message = pcall(f)
  if ended then error("accepted; expected " .. pattern, 2) end
  contains(tostring(message), pattern)
end
refused(function() tradeoff() end, "tradeoff: expected options in braces, got nil")
refused(function() tradeoff { omega = omega, to = 1, method = "rk4" } end,
  "tradeoff: unknown option 'method'; did you mean 'methods'?")
refused(function() tradeoff { omega = omega, to = 1, methods = { "rk4" } } end,
  'tradeoff: steps is missing: method "rk4" takes steps')
refused(function() tradeoff { omega = omega, to = 1, methods = {} } end, "tradeoff: methods: expected a list")
refused(function() tradeoff { omega = omega, to = 1, methods = { 3 } } end, "methods: item 1: expected a name")
refused(function() tradeoff { omega = omega, to = 1, methods = { "rk5" }, accuracies = { 1e-3 } } end,
  "tradeoff: method: expected one of")
refused(function() tradeoff { omega = omega, to = 1, accuracies = { 1e-3, -1 } } end,
  "accuracies: item 2: expected a positive number, got -1")
refused(function() tradeoff { omega = omega, to = 1, accuracies = {} } end, "accuracies: expected a list of numbers")
refused(function() tradeoff { omega = omega } end, "tradeoff: give to = t1 or t = {t0, t1}")
refused(function() tradeoff { omega = omega, reference = truth } end, "tradeoff: give to = t1 or t = {t0, t1}")
refused(function() tradeoff { to = 1 } end, "tradeoff: omega is missing")
refused(function() tradeoff { omega = function(t) return 1, 0, sqrt(0.5 - t) end, to = 1 } end,
  "tradeoff: no reference: stopped at t = 0.4999")
refused(function() tradeoff { omega = omega, to = 1, reference = 3 } end, "reference: expected a run, or a function")
refused(function() tradeoff { omega = omega, to = 1, reference = function() return 3 end } end,
  "reference: expected a rotation or a quaternion at t = 0.01, got number")
refused(function()
  tradeoff { omega = omega, to = 2, reference = evolve { omega = { 0, 0, 1 }, to = 1 } }
end, "reference: the run given is from 0.0 to 1.0, the scene from 0.0 to 2.0")
refused(function() known:plot { over = "time" } end, "over: expected")
refused(function() known:csv() end, "csv")
refused(function() plot({ 1, 2 }, { 1 }) end, "plot: x has 2 values")
refused(function() plot({ 1, 2 }, { a = 3 }) end, "'a': expected a list, got number 3")
refused(function() plot({ 1, 2 }, { 1, 2 }, { log = "z" }) end, 'log: expected "x", "y" or "xy", got "z"')
refused(function() plot({ 0, 2 }, { 1, 2 }, { log = "x" }) end, "x must be positive on a logarithmic axis")
