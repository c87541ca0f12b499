-- What evolve takes besides omega and an interval: equations, f, restart, breaks, points, and an omega that fails.
local directory = arg[0]:match "^(.*/)" or "./"
package.path = directory .. "?.lua;" .. package.path
local support = require "support"
local equal, contains = support.equal, support.contains

local function refused(options)
  local ended, message = pcall(evolve, options)
  equal(ended, false, "an error is expected")
  return message
end

-- [P15], whose motion is known.
local a = 2*pi/40
local function turning(t) return cos(a*t), sin(a*t), 0 end
local from = rotation({ 1, 1, 1 }, 1)
local truth = evolve{ omega = spin.turning{ vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = a }, from = from,
  to = 30 }

local function off(run, t) return run(t).rotation:distance(truth(t).rotation) end

-- Every equation follows the same motion, to what was asked. [P10] up to theta = pi, some t = 2.5.
for _, name in ipairs{ "quaternion", "euler", "modified_gibbs", "gibbs", "axis_angle", "body_points" } do
  local run = evolve{ omega = turning, from = from, to = 2.4, equation = name, accuracy = 1e-9 }
  holds(off(run, 2.4) <= 1e-9, name)
  equal(run.method, name == "quaternion" and "fgl" or "dop853", name)
  local steps = evolve{ omega = turning, from = from, to = 2.4, equation = name, method = "rk4", step = 0.01 }
  holds(off(steps, 2.4) <= 2*steps.error_estimate, name .. " by rk4")
end

-- [P4] with an f of the user's: odd; its derivatives are found by jets, and where its domain ends.
local function by_f(f, to)
  return evolve{ omega = turning, from = from, to = to, equation = "generalized", f = f }
end
for name, f in pairs{
  ["2 tan(x/4)"] = function(x) return 2*tan(x/4) end,
  ["x + x^3/50"] = function(x) return x + x^3/50 end,
  ["sin(x/2)"] = function(x) return sin(x/2) end } do
  holds(off(by_f(f, 2.4), 2.4) <= 1e-10, "f = " .. name)
end
local stop = refused{ omega = turning, from = from, to = 30, equation = "generalized",
  f = function(x) return sin(x/2) end }
equal(stop.reason, "singularity")
-- f' is some (pi - x)/4 there: f, known to an ulp, tells x to the 1e-10 that is asked down to pi - x = 4e-6.
near(pi, stop.run(stop.t).angle, 1e-3, "sin(x/2) has an inverse up to pi")
contains(tostring(stop), "singular at theta = 3.14159")
contains(tostring(stop), "where the domain of f ends")

-- Each stops at its own singularity and keeps the part done.
stop = refused{ omega = turning, from = from, to = 30, equation = "gibbs" }
equal(stop.reason, "singularity")
contains(tostring(stop), "[P10] is singular at theta = pi")
near(pi, stop.run(stop.t).angle, 1e-4, "the end reached")
holds(not stop.run.complete, "incomplete")
local along_k = { omega = { 0, 0, 1 }, to = 10, equation = "euler" }
stop = refused(along_k)
equal(stop.reason, "singularity")
near(2*pi, stop.t, 1e-4, "[P7] at 2 pi")
contains(tostring(stop), "restart = true")

-- The restart rule, E (1 - 2 pi/|E|): the same operator all the way, past 2 pi three times.
along_k.restart, along_k.to = true, 20
local restarted = evolve(along_k)
for t = 0, 20, 0.5 do
  holds(restarted(t).rotation:distance(rotation({ 0, 0, 1 }, t)) <= 1e-10, "restarted, t = " .. t)
end
local through = evolve{ omega = turning, from = from, to = 30, equation = "euler", restart = true, method = "rk4",
  step = 0.01 }
holds(off(through, 30) <= 2*through.error_estimate, "restarted by rk4")
local by_tangent = evolve{ omega = { 0, 0, 1 }, to = 20, equation = "generalized", restart = true,
  f = function(x) return 4*tan(x/4) end }
holds(by_tangent(20).rotation:distance(rotation({ 0, 0, 1 }, 20)) <= 1e-10, "[P4] restarted")
-- Also where the domain of f ends before 3 pi/2, 1.25 pi here, and from a start beyond it.
for _, start in ipairs{ 0, 4 } do
  local early = evolve{ omega = { 0, 0, 1 }, to = 20, equation = "generalized", restart = true,
    from = rotation({ 0, 0, 1 }, start), f = function(theta) return tan(theta/2.5) end }
  holds(early(20).rotation:distance(rotation({ 0, 0, 1 }, 20 + start)) <= 1e-10, "restarted early, from " .. start)
end

-- Breaks: steps end there. omega jumps at 1 and at 2: unknown, that costs calls; known, none.
local function jumping(t)
  if t < 1 then return 0, 0, 1 end
  if t < 2 then return 0, 2, 0 end
  return 0, 4 - t, 0
end
local turned = rotation({ 0, 1, 0 }, 2 + 1.5)*rotation({ 0, 0, 1 }, 1)  -- the integrals of the pieces
local plain = evolve{ omega = jumping, to = 3 }
local broken = evolve{ omega = jumping, to = 3, breaks = { 2, 1, 7 } }
holds(plain(3).rotation:distance(turned) <= 1e-10, "without breaks")
-- Three pieces, on each of which omega has one direction: a few roundings in all.
holds(broken(3).rotation:distance(turned) <= 1e-14, "with breaks")
holds(broken.cost.omega_calls < plain.cost.omega_calls, "breaks save calls")
local backward = evolve{ omega = jumping, from = broken(3).rotation, t = { 3, 0 }, breaks = { 1, 2 } }
holds(backward(0).rotation:distance(rotation({ 0, 0, 1 }, 0)) <= 1e-14, "backward in t")

-- Points of the body, by their places at the start [P1].
local pointed = evolve{ omega = { 0, 0, pi }, to = 1, points = { { 1, 0, 0 }, vec(0, 0, 2) } }
near(vec(-1, 0, 0), pointed(1).points[1], 2e-16, "half a turn about k")
equal(pointed(0.3).points[2], vec(0, 0, 2))
equal(pointed(0).points[1], vec(1, 0, 0))
equal(#evolve{ omega = { 0, 0, 1 }, to = 1 }(1).points, 0)

-- What is refused, and how.
contains(tostring(refused{ omega = turning, to = 1, equation = "quaternoin" }), 'expected one of "quaternion", "euler"')
contains(tostring(refused{ omega = turning, to = 1, equation = "generalized" }), "needs f")
contains(tostring(refused{ omega = turning, to = 1, f = sin }), 'f is for equation = "generalized"')
contains(tostring(refused{ omega = turning, to = 1, restart = true }), 'restart is for equation = "euler"')
contains(tostring(refused{ omega = turning, to = 1, equation = "euler", method = "fgl" }), "follows the quaternion")
contains(tostring(refused{ omega = turning, to = 1, equation = "generalized", f = cos }), "odd function")
contains(tostring(refused{ omega = turning, to = 1, breaks = { 0/0 } }), "breaks must be finite, got nan")
contains(tostring(refused{ omega = turning, to = 1, breaks = 1 }), "breaks: expected a list, got number 1")
contains(tostring(refused{ omega = turning, to = 1, points = { 1, 0, 0 } }), "points: item 1: expected a vec")

-- omega that raises at its nth call: by every method the reason is its own, and the part done is kept and true.
for _, method in ipairs{ "fgl", "dop853", "rk4" } do
  for n = 1, 100 do
    local calls = 0
    local function failing(t)
      calls = calls + 1
      if calls == n then error "no more" end
      return turning(t)
    end
    local what = method .. ", call " .. n
    local options = { omega = failing, from = from, to = 30, method = method }
    if method == "rk4" then options.step = 0.05 end
    local failure = refused(options)
    equal(failure.reason, "omega failed", what)
    contains(tostring(failure), "no more")
    equal(calls, n, what .. ": not called again")
    equal(failure.run.t1, failure.t, what)
    holds(failure.t >= 0 and failure.t < 30, what)
    if failure.t > 0 then
      holds(off(failure.run, failure.t) <= math.max(1e-10, 2*failure.run.error_estimate), what)
    end
  end
end

-- A pole is not passed, and a motion that doubles cannot tell is not told: by name.
for _, hopeless in ipairs{
  function(t) return 1/(2 - t), 0, 1 end,
  function(t) return 1/(2 - t)^2, 0, 1 end,
  function() return 1e308, 0, 0 end,
  function(t) return 1e200, t, 0 end } do
  local failure = refused{ omega = hopeless, to = 1e10 }
  equal(failure.reason, "accuracy lost")
  holds(failure.t < 2, "before the pole")
  holds(failure.run.error_estimate < pi, "the part done is known")
end

-- Breaks nearer to one another than steps may be, and intervals as short as that, far from t = 0.
for _, method in ipairs{ "fgl", "dop853" } do
  local near_breaks = evolve{ omega = function(t) return t, 0, 0 end, to = 1, breaks = { 0.3, 0.1*3 }, method = method }
  near(0.5, near_breaks(1).angle, 1e-14, method .. ", the integral of t")
  local log = {}
  for i = 0, 99 do log[i + 1] = { 1.7e9 + i*0.01, 1, i % 3, 0 } end
  log[50][1] = log[49][1] + 2e-5
  -- omega is (1, y, 0), y of size 2: the motion of the log without that row differs by 0.02 s times 2 at most.
  local jittered = evolve{ omega = spin.sampled(log), t = { 1.7e9, 1.7e9 + 0.98 }, method = method, accuracy = 1e-5 }
  table.remove(log, 50)
  local without = evolve{ omega = spin.sampled(log), t = { 1.7e9, 1.7e9 + 0.98 }, method = method, accuracy = 1e-5 }
  holds(jittered(1.7e9 + 0.98).rotation:distance(without(1.7e9 + 0.98).rotation) < 0.04, method .. ", a jittered log")
end
for k = 1, 40 do
  local t1 = 1e9 + k*2^-23
  local short = evolve{ omega = function(t) return cos(t), sin(t), 0.5 end, t = { 1e9, t1 } }
  -- omega turns by k 2^-23 < 5e-6 rad meanwhile: that is what the length of its integral may lack, relatively.
  near(sqrt(1.25)*k*2^-23, short(t1).angle, k*2^-23*1e-5, "the turn of " .. k .. " ulps")
end

-- A jump at an end of the run is on the far side of it: the methods keep their order.
local jump = spin.piecewise{ { 1, 0, 0 }, 1, { 0, 0, 20 } }
for _, interval in ipairs{ { 0, 1 }, { 1, 2 }, { 1, 0 }, { 2, 1 } } do
  local exact = evolve{ omega = jump, t = interval }
  local stepped = evolve{ omega = jump, t = interval, method = "rk4", step = 0.01 }
  local last = interval[2]
  holds(stepped(last).rotation:distance(exact(last).rotation) <= 2*stepped.error_estimate, "from " .. interval[1])
  holds(stepped.error_estimate < 1e-4, "RK4 of 20 rad by 0.2: 20*0.2^4/1920 at a time step of 0.01")
end

-- A start far beyond 2 pi restarts at once, and one on a singularity is refused at once.
local far = evolve{ omega = turning, to = 3, equation = "euler", restart = true, from = rotation({ 1, 0, 0 }, 1e15) }
local same = evolve{ omega = turning, to = 3, from = rotation({ 1, 0, 0 }, 1e15) }
holds(far(3).rotation:distance(same(3).rotation) <= 2e-10, "from 1e15 rad: each as accurate as asked")
contains(tostring(refused{ omega = turning, to = 3, equation = "gibbs", from = rotation({ 1, 0, 0 }, pi) }),
  "the start's angle is 3.14")

-- The certificate of a run over a known jump is that of its pieces.
holds(evolve{ omega = spin.piecewise{ { 1, 0, 0 }, 0.5, { 0, 2, 0 } }, to = 10 }:certify().at_rounding, "exact pieces")

-- A part of a run: t = {from, to}, either way round.
local whole = evolve{ omega = { 0, 0, 1 }, t = { 0, 10 } }
local part = whole:sample{ t = { 4, 2 }, n = 3 }
for i, t in ipairs{ 4.0, 3.0, 2.0 } do equal(part[i].t, t, "time " .. i) end
equal(#whole:sample{ t = { 2, 4 }, every = 0.5 }, 5)
for _, case in ipairs{ { { t = { 2, 14 } }, "times of the run, 0.0 .. 10.0, got 14.0" },
  { { t = { 2 } }, "expected {from, to}, got a list of 1" }, { { t = { 0/0, 1 } }, "got nan" },
  { { t = { 1, 2 }, times = { 1 } }, "t or times, not both" } } do
  local ended, message = pcall(whole.sample, whole, case[1])
  equal(ended, false)
  contains(message, case[2])
end
