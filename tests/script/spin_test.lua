-- The module spin: what its functions give, and what they refuse.
local directory = arg[0]:match "^(.*/)" or "./"
package.path = directory .. "?.lua;" .. package.path
local support = require "support"
local equal, contains = support.equal, support.contains

local function refused(f, ...)
  local ended, message = pcall(f, ...)
  equal(ended, false, "an error is expected")
  return tostring(message)
end

-- Values at times, and what they are.
local turning = spin.turning{ vector = { 1, 0, 2 }, about = { 0, 0, 3 }, rate = 0.5 }
equal(turning(0), vec(1, 0, 2))
near(vec(0, 1, 2), turning(pi), 4e-16, "a quarter of the way round")
equal(turning.frame, "space")
equal(turning.times, nil)
equal(turning.gaps, nil)
equal(tostring(spin.body(turning)), "spin  " .. turning.description .. ", in the body frame")
equal(spin.body(spin.body(turning)).frame, "body")

equal(spin.along({ 0, 2, 0 }, -3)(7), vec(0, -3, 0))
equal(spin.along(vec(0, 2, 0), function(t) return t^3 end)(2), vec(0, 8, 0))
equal(spin.periodic(2, function(t) return t, 0, 0 end)(-0.5), vec(1.5, 0, 0))
local pieces = spin.piecewise{ { 1, 0, 0 }, 1, function(t) return 0, t, 0 end, 2.5, turning }
equal(pieces(-10), vec(1, 0, 0))
equal(pieces(1), vec(0, 1, 0), "a piece owns its first instant")
equal(pieces(2.5), turning(2.5))
equal(spin.piecewise{ { 1, 0, 0 } }(5), vec(1, 0, 0))
equal(evolve{ omega = spin.along({ 0, 0, 1 }, 2), to = 3 }(3).angle, 6.0)

contains(refused(spin.turning, { vector = { 1, 0, 0 }, about = { 0, 0, 1 } }), "rate: expected")
contains(refused(spin.turning, { vector = { 1, 0, 0 }, axis = { 0, 0, 1 } }), "unknown option 'axis'")
contains(refused(spin.turning, { vector = { 1, 0, 0 }, about = { 0, 0, 0 }, rate = 1 }), "about: expected a finite")
contains(refused(spin.along, { 0, 0, 0 }, 1), "direction: expected a finite vector that is not zero")
contains(refused(spin.along, { 0, 0, 1 }, 1/0), "s: expected a finite number, got inf")
contains(refused(spin.along, { 0, 0, 1 }, "fast"), 'expected a number or a function of t, got string "fast"')
contains(refused(spin.periodic, 0, { 0, 0, 1 }), "period: expected a positive number")
contains(refused(spin.periodic, 1, 2), "expected a function of t, a vec, {x, y, z}, a spline or a spin, got number 2")
contains(refused(spin.periodic, 1, spin.body{ 0, 0, 1 }), "the frame is said of the whole")
contains(refused(spin.piecewise, {}), "one omega more than times, got 0 items")
contains(refused(spin.piecewise, { { 1, 0, 0 }, 2 }), "got 2 items")
contains(refused(spin.piecewise, { { 1, 0, 0 }, 2, { 1, 0, 0 }, 1, { 0, 0, 1 } }), "rise, got 1.0 after 2.0")
contains(refused(spin.piecewise, { { 1, 0, 0 }, { 1, 0, 0 }, 2 }), "item 2: expected a number")
contains(refused(spin.piecewise, { { 1, 0, 0 }, 0/0, { 1, 0, 0 } }), "expected finite times, got nan")
contains(refused(spin.body), "got nothing")
contains(refused(function() return spin.turnin end), "did you mean 'turning'?")
contains(refused(turning, "x"), "expected a number")
contains(refused(spin.along({ 0, 0, 1 }, function() return "x" end), 1), "x")
contains(refused(spin.along({ 0, 0, 1 }, function() error "own words" end), 1), "own words")

-- Samples from tables.
local rows = { { 0, 0, 0, 1 }, { 1, 0, 0, 3 }, { 4, 6, 0, 0 } }
local columns = { t = { 0, 1, 4 }, x = { 0, 0, 6 }, y = { 0, 0, 0 }, z = { 1, 3, 0 }, note = { "a", "b", "c" } }
for _, w in ipairs{ spin.sampled(rows), spin.sampled(columns) } do
  equal(w(0.5), vec(0, 0, 2))
  equal(w(2.5), vec(3, 0, 1.5))
  equal(w.description, "samples (3 rows, linear)")
  equal(#w.times, 3)
  equal(w.times[3], 4.0)
end
equal(spin.sampled(rows, { unit = "deg/s" })(1), vec(0, 0, 3*deg))
equal(spin.sampled(rows, { bias = { 0, 0, 1 }, scale = 2 })(1), vec(0, 0, 4))
equal(spin.sampled(rows, { bias = { 0, 0, 1 }, scale = { 1, 1, 0.5 } })(1), vec(0, 0, 1))
equal(spin.sampled(rows, { time_unit = "ms" })(0.001), vec(0, 0, 3))
equal(spin.sampled(rows, { extrapolate = true })(100), vec(6, 0, 0))
-- The parabola through 1, 3, 0 at 0, 1, 4 is 1 + 2 t - 3/4 t (t - 1): exact in doubles at 2.
equal(spin.sampled(rows, { interpolation = "cubic" })(2), vec(1, 0, 3.5))
equal(spin.sampled({ a = { 0, 1 }, b = { 1, 2 } }, { columns = { "a", "b", "b", "b" } })(1), vec(2, 2, 2))
equal(spin.sampled({ a = { 0, 1 }, b = { 1, 2 } }, { columns = { t = "a", x = "b", y = "b", z = "a" } })(1),
  vec(2, 2, 1))

contains(refused(spin.sampled(rows), 4.5), "t = 4.5 is outside the samples (3 rows, linear), 0.0 .. 4.0; extrapolate")
contains(refused(spin.sampled, { { 1, 2, 3 } }), "item 1: expected {t, x, y, z}, got a list of 3")
contains(refused(spin.sampled, { { 1, 2, 3, 4 } }), "at least two rows, got 1")
contains(refused(spin.sampled, {}), "is not plain from no columns")
contains(refused(spin.sampled, 3), "expected a file name, rows")
contains(refused(spin.sampled, { t = { 0, "1" } }), "'t': item 2: expected a number")
contains(refused(spin.sampled, columns, { columns = { t = "t", x = "x", y = "y" } }), "columns: z is missing")
contains(refused(spin.sampled, columns, { columns = { t = "t", x = "x", y = "y", z = "note" } }),
  "unknown column 'note'")
contains(refused(spin.sampled, columns, { columns = { t = "t", x = "x", y = "y", w = "z" } }), "unknown option 'w'")
contains(refused(spin.sampled, rows, { scale = "a" }), "scale: expected a vec")
contains(refused(spin.sampled, rows, { interpolation = "cubical" }), 'expected "linear" or "cubic"')
contains(refused(spin.sampled, rows, { units = "deg/s" }), "did you mean 'unit'?")

-- What is wrong with a log, and what accepts it.
local bad = { { 0, 0, 0, 1 }, { 2, 0, 0, 1 }, { 1, 0, 0, 2 }, { 2, 0, 0, 3 }, { 3, 0/0, 0, 1 }, { 4, 0, 0, 4 } }
local message = refused(spin.sampled, bad)
for _, words in ipairs{ "row 5 t = 3.0", 'missing = "skip"', "row 3 t = 1.0 after 2.0", 'order = "sort"',
  "row 4 t = 2.0 as row 2", 'duplicates = "first"' } do
  contains(message, words)
end
local accepted = spin.sampled(bad, { missing = "skip", order = "sort", duplicates = "mean" })
equal(#accepted.times, 4)
equal(accepted(2), vec(0, 0, 2))
equal(spin.sampled(bad, { missing = "skip", order = "sort", duplicates = "first" })(2), vec(0, 0, 1))
contains(refused(spin.sampled, bad, { duplicates = "last" }), 'expected one of "error", "first", "mean", got "last"')

local gappy = { { 0, 0, 0, 1 }, { 1, 0, 0, 1 }, { 2, 0, 0, 1 }, { 5, 0, 0, 1 } }
local quiet = spin.sampled(gappy, { gap = 2, gaps = "silent" })
equal(#spin.sampled(gappy).gaps, 0, "three times the usual is no gap yet")
equal(#quiet.gaps, 1)
equal(quiet.gaps[1].row, 3)
equal(quiet.gaps[1].from, 2.0)
equal(quiet.gaps[1].to, 5.0)
equal(#spin.body(quiet).gaps, 1)
contains(refused(spin.sampled, gappy, { gap = 2, gaps = "error" }), "1 interval longer than 2.0 times the usual 1.0")
contains(refused(spin.sampled, gappy, { gap = 0 }), "gap: expected")

-- Rows of a file are named by their lines too.
local name = os.tmpname()
write_csv(name, { t = { 0, 1, 1 }, x = { 1, 2, 3 }, y = { 0, 0, 0 }, z = { 0, 0, 0 } })
contains(refused(spin.sampled, name), name .. ": 1 row with the time of another: row 3 (line 4) t = 1.0 as row 2")
contains(refused(spin.sampled, name, { columns = { "t", "x", "y", "zz" } }), "unknown column 'zz'; did you mean 'z'?")
local semicolons = assert(io.open(name, "w"))
semicolons:write("t;x;y;z\n0;1;0;0\n2;3;0;4\n")
semicolons:close()
contains(refused(spin.sampled, name), "separator")
equal(spin.sampled(name, { separator = ";" })(1), vec(2, 0, 2))
contains(refused(spin.sampled, name, { separator = ";;" }), 'separator: expected one character, as ";"')
os.remove(name)
contains(refused(spin.sampled, name), "No such file or directory")

theorem("samples turn the body in either frame, forward and backward, as the closed form does", function()
  -- A fixed axis: the angle is the integral of the straight lines, 0.5 (1 + 3) + 3/2 (3 + 0) = 6.5.
  local w = spin.sampled{ { 0, 0, 0, 1 }, { 1, 0, 0, 3 }, { 4, 0, 0, 0 } }
  for _, omega in ipairs{ w, spin.body(w) } do
    local run = evolve{ omega = omega, to = 4, method = "dop853" }
    near(6.5, run(4).euler_vector.z, run.error_estimate, "angle forward, " .. omega.frame)
    local back = evolve{ omega = omega, t = { 4, 0 }, method = "dop853" }
    near(-6.5, back(0).euler_vector.z, back.error_estimate, "angle backward, " .. omega.frame)
  end
end)

theorem("the omega of attitudes leads through them all", function()
  local times, rotations = {}, {}
  for i = 1, 12 do
    times[i] = i/3 + 0.1*sin(5*i)
    rotations[i] = rotation({ sin(i), cos(2*i), 0.5 }, 0.4*i)*rotation({ 0, 0, 1 }, 0.3*i)
  end
  local spline = rotation.spline(times, rotations)
  local file = os.tmpname()
  rotation.csv(file, rotations, { times = times, columns = "quaternion" })
  for what, log in pairs{ list = { times = times, rotations = rotations }, spline = spline, file = file } do
    local w = spin.from_attitudes(log)
    equal(#w.times, 12)
    local run = evolve{ omega = w, from = rotations[1], t = { times[1], times[12] }, method = "dop853" }
    local farthest = 0
    for i = 1, 12 do farthest = math.max(farthest, run(times[i]).rotation:distance(rotations[i])) end
    -- Attitudes of the run and of the log are each rounded by some 1e-15.
    near(0, farthest, run.error_estimate + 2e-15, "distance at the times, " .. what)
    -- The digits of a file's quaternions are rounded: 1e-16 over intervals of 0.2 and more, a few times.
    near(spline:omega(2), w(2), what == "file" and 1e-14 or 0, "omega, " .. what)
  end
  os.remove(file)
  os.remove(file .. ".json")
  fails(function() spin.from_attitudes{ times = times } end, "no rotations", "rotations: expected a list")
  fails(function() spin.from_attitudes{ times = { 0 }, rotations = { rotations[1] } } end, "one", "at least two")
  fails(function() spin.from_attitudes(1) end, "a number", "expected {times")
  fails(function() return spin.from_attitudes(spline)(100) end, "outside", "outside the spline")
end)

-- A gyroscope's log that is no part of the project.
local real = directory .. "../../../shared/data/gyro/sensor_data.csv"
local there = io.open(real)
if not there then
  print "skipped: there is no shared/data/gyro/sensor_data.csv beside the project"
else
  there:close()
  theorem("a real log: rows, units, and the same attitude by two ways of going", function()
    local w = spin.sampled(real)
    holds(#w.times == 13514 and #w.gaps == 0, "rows and gaps")
    local data = read_csv(real)
    local i = 5000
    near(data["Gyroscope X (deg/s)"][i]*deg, w(data["Time (s)"][i]).x, 0, "a sample, in rad/s")
    local times = w.times
    local last = times[#times]
    local run = evolve{ omega = spin.body(w), t = { 0, last }, method = "dop853" }
    -- Piece by piece, by Magnus' series in the body frame: a1 = h (w0 + w1)/2 and a2 = h (w1 - w0) turn by
    -- a1 + a1 x a2/12 and, in the next order, at most |a1| |a2|^2/240 + |a1|^3 |a2|/720 more; with as much again for
    -- all that follows, and 1e-15 for the rounding of each piece.
    local q, bound = rotation.identity, run.error_estimate
    for k = 2, #times do
      local h = times[k] - times[k - 1]
      local w0, w1 = w(times[k - 1]), w(times[k])
      local a1, a2 = h/2*(w0 + w1), h*(w1 - w0)
      q = q*rotation.from_euler_vector(a1 + cross(a1, a2)/12)
      bound = bound + 2*(norm(a1)*norm(a2)^2/240 + norm(a1)^3*norm(a2)/720) + 1e-15
    end
    near(0, run(last).rotation:distance(q), bound, "distance of the two")
    fails(function() evolve{ omega = w, to = last + 1, method = "dop853" } end, "past the end", "outside the samples")
  end)
end
