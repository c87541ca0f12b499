-- run.crossings, run.notes, run.crossing_tolerance: what scripts see of them, and what evolve refuses.
local directory = arg[0]:match "^(.*/)" or "./"
package.path = directory .. "?.lua;" .. package.path
local support = require "support"
local equal, contains = support.equal, support.contains

local function refused(options)
  local ended, message = pcall(evolve, options)
  equal(ended, false, "an error is expected")
  return tostring(message)
end

-- Figure 6: through 2 pi at t = 1, where omega = -i.
local function omega(t) return -1, t - 1, 0 end
local there = evolve { omega = function(t) return 1, t, 0 end, to = 1, accuracy = 1e-13 }(1)
local start = rotation(-there.axis, 2*pi - there.angle)
local run = evolve { omega = omega, from = start, to = 2 }
equal(#run.crossings, 1)
equal(#run.notes, 0)
local crossing = run.crossings[1]
equal(crossing.kind, "through")
equal(crossing.order, 0)
equal(crossing.order_by, "jets")
equal(math.type(crossing.turn_before), "integer")
equal(crossing.turn_before, 0)
equal(crossing.turn_after, 1)
equal(crossing.angle, 2*pi)
equal(crossing.note, nil)
equal(crossing.derivative, vec(omega(crossing.t)))
equal(run.crossing_tolerance, 2*run.error_estimate)
-- The start is good to 1e-13, and |omega| = 1.
near(1, crossing.t, 2e-13 + crossing.t_error, "t of the crossing")
near(vec(-1, 0, 0), crossing.axis, 1e-12, "axis there: -omega/|omega| M0")
near(vec(0, 0.5, 0), crossing.axis_rate, 1e-12, "its rate: omega'/2 across omega, likewise")
near(crossing.axis, run(crossing.t).axis, 1e-15, "the state there has it")
near(crossing.axis_rate, run(crossing.t).axis_rate, 1e-12, "and its rate")
-- E' = n theta' + n' theta.
near(vec(-1, pi, 0), run(crossing.t).euler_rate, 1e-11, "and the Euler vector's")
contains(tostring(crossing), "through  angle 2 pi")
contains(tostring(crossing), "order 0")
contains(tostring(crossing), "turn 0 to 1")

-- By differences, where a vec takes no jets.
local of_vec = evolve { omega = function(t) return vec(omega(t)) end, from = start, to = 2 }.crossings[1]
equal(of_vec.order_by, "differences")
holds(of_vec.derivative_error < 1e-12, "the error of omega by differences")
near(vec(0, 0.5, 0), of_vec.axis_rate, 1e-9, "axis rate by differences")

-- Where there is no axis.
local rest = evolve { omega = function(t) return 0, 0, t < 1 and -1 or 0 end, from = rotation({ 0, 0, 1 }, 1), to = 3,
  breaks = { 1 } }
equal(#rest.crossings, 0, "a run that ends at rest has passed nothing")
local gone = evolve { omega = function(t) return t > 2 and 1 or 0, 0, t < 1 and -1 or 0 end,
  from = rotation({ 0, 0, 1 }, 1), to = 3, breaks = { 1, 2 } }
equal(gone.crossings[1].kind, "undecided")
equal(gone.crossings[1].axis, nil)
equal(gone.crossings[1].order, nil)
equal(gone.crossings[1].derivative, nil)
contains(gone.notes[1], "no limit")
contains(tostring(gone(1.5)), "no axis")
contains(tostring(gone.crossings[1]), "no axis")
holds(gone(1.5).axis.x ~= gone(1.5).axis.x, "the axis is nan")
equal(gone(1.5).rotation.angle, gone(1.5).angle)

-- Options.
for _, wrong in ipairs { 0, -1, 1, 3, 1/0, 0/0 } do
  contains(refused { omega = { 0, 0, 1 }, to = 1, crossing_tolerance = wrong }, "must be positive and below 1 rad")
end
contains(refused { omega = { 0, 0, 1 }, to = 1, crossing_tolerance = "small" }, "crossing_tolerance")
contains(refused { omega = { 0, 0, 1 }, to = 1, singularity = "ignore" }, 'is for equation = "euler"')
contains(refused { omega = { 0, 0, 1 }, to = 1, singularity = "no" }, "singularity")
equal(evolve { omega = omega, from = start, to = 2, crossing_tolerance = 1e-3 }.crossing_tolerance, 1e-3)
equal(evolve { omega = omega, from = start, to = 2, crossing_tolerance = 1e-3 }:from(start).crossing_tolerance, 1e-3)

-- Straight through 2 pi: how wrong depends on where the nodes fall.
local function straight(node)
  local t0 = node - 0.9
  local r = evolve { omega = omega, from = run(t0).rotation, t = { t0, t0 + 1.8 }, equation = "euler", method = "rk4",
    step = 0.01, singularity = "ignore" }
  return r(r.t1).rotation:distance(run(r.t1).rotation)
end
holds(straight(0.9975) < 1e-7, "nodes and middles of steps 2.5 ms from the crossing: nearly as if it were not there")
holds(straight(1 - 1e-7) > 1e-2, "a node 1e-7 from it: all is lost")
