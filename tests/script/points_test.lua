-- run:strobe, run:section and points, as scripts see them; what they compute is tested in tests/dynamics.
local directory = arg[0]:match "^(.*/)" or "./"
package.path = directory .. "?.lua;" .. package.path
local support = require "support"
local equal, contains = support.equal, support.contains

local alpha = 2*pi/40
local run = evolve { omega = function(t) return cos(alpha*t), sin(alpha*t), 0 end, from = rotation({ 1, 1, 1 }, 1),
  to = 4200 }

local function refused(method, ...)
  local ended, message = pcall(run[method], run, ...)
  equal(ended, false, "an error is expected")
  return tostring(message)
end

-- The paper's Figure 3b: 105 points after the first.
local strobe = run:strobe(40)
equal(#strobe, 106)
equal(#strobe.times, 106)
equal(strobe[2].t, 40.0)
equal(strobe[0], nil)
equal(strobe[107], nil)
equal(strobe[1.5], nil)
equal(strobe.period, 40.0)
near(0.7221295, strobe.rotation_number, 5e-8, "the rotation number")
near(vec(-0.298706, -0.508736, 0.807442), strobe.plane.normal, 1e-6, "the plane")
holds(strobe.plane.off < 1e-9, "all of M lies in it")
holds(strobe.rotation_number_error < 1e-10, "its error")
contains(tostring(strobe), "rotation number 0.72212")
local gaps, counts = strobe:return_times(1)
equal(#gaps, #counts)
holds(#gaps <= 3, "three gaps at most")

local wrong = run:strobe(39)
equal(wrong.rotation_number, nil)
equal(wrong.axis, nil)
contains(tostring(wrong), "does not repeat with this period")

-- Periodic orbits are said: alpha = 3/4 has three points, 1/sqrt(3) one of the attitude and two of the quaternion
-- [theory 4.5]; the paper's T = 40 none, nor what is not known to repeat.
local function turning(rate, periods)
  return evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = rate },
    from = rotation({ 1, 1, 1 }, 1), to = periods*2*pi/rate }
end
local three = turning(3/4, 5):strobe(8*pi/3)
equal(three.orbit_period, 3)
equal(three.attitude_period, 3)
contains(tostring(three), "periodic: the attitude repeats after 3 T = 25.13274")
contains(tostring(three), "the quaternion, and E modulo 4 pi, after 3 T = 25.13274")
local two = turning(1/sqrt(3), 5):strobe(2*pi*sqrt(3))
equal(two.orbit_period, 2)
equal(two.attitude_period, 1)
contains(tostring(two), "the attitude repeats after T = 10.88279")
equal(strobe.orbit_period, nil)
equal(strobe.attitude_period, nil)
contains(tostring(strobe), "no multiple of T, to 1000, is a period; after 9 T off by 0.01 rad")
equal(wrong.orbit_period, nil)
local function quarter(t) return cos(3*t/4), sin(3*t/4), 0 end
local seen = evolve { omega = quarter, to = 17 }:strobe(8*pi/3)
equal(seen.orbit_period, 3)
contains(tostring(seen), "if omega goes on as in these 3 points")
local unseen = evolve { omega = quarter, to = 9 }:strobe(8*pi/3)
equal(unseen.orbit_period, nil)
contains(tostring(unseen), "two points do not tell whether omega repeats")
local rough = evolve { omega = quarter, to = 17, method = "rk4", step = 1 }:strobe(8*pi/3)
equal(rough.orbit_period, nil)
contains(tostring(rough), "too inexact to tell a period")
equal(evolve { omega = { 0, 0, 0 }, to = 1 }:strobe(1).orbit_period, 1)
for _, points in ipairs { three, two, strobe, wrong, seen, unseen, rough } do support.fits(tostring(points)) end

-- A section has the states on the surface.
local section = run:section { plane = { 0, 0, 1 }, direction = "up" }
equal(section.period, nil)
equal(section.rotation_number, nil)
equal(section.orbit_period, nil)
for i = 1, #section do
  holds(abs(section[i].euler_vector.z) < 1e-12, "E.z = 0")
  holds(section[i].euler_rate.z > 0, "upward")
end
local by_function = run:section { f = function(s) return s.euler_vector.z end, direction = "up" }
equal(#by_function, #section)
equal(by_function.times[1], section.times[1])
local none = run:section { f = function() return 1 end }
equal(#none, 0)
contains(tostring(none), "points  0  section")
equal(none[1], nil)
contains(select(2, pcall(function() return none.plane end)), "no points")
contains(select(2, pcall(none.return_times, none, 1)), "two points at least are expected, got 0")

-- What is wrong is refused; an error of the script's comes through as it is.
contains(refused("strobe", 0), "the period must be positive, got 0.0")
contains(refused("strobe", 1e9), "longer than the run")
contains(refused("strobe", 1e-9), "the period 1e-09 makes")
contains(refused("strobe"), "number")
contains(refused("section", {}), "give one of f")
contains(refused("section", { f = print, plane = { 0, 0, 1 } }), "give one of f")
contains(refused("section", { f = 1 }), "expected a function of a state")
contains(refused("section", { f = function() end }), "f must return a number, got nil at t = 0.0")
contains(refused("section", { f = function() error "mine" end }), "mine")
contains(refused("section", { plane = { 0, 0, 0 } }), "finite normal other than 0")
contains(refused("section", { f = print, chart = "mrp" }), "chart belongs to plane")
contains(refused("section", { plane = { 0, 0, 1 }, chart = "eular_vector" }), "euler_vector")
contains(refused("section", { plane = { 0, 0, 1 }, n = 1 }), "at least 2, got 1")
contains(select(2, pcall(strobe.return_times, strobe, 0)), "must be positive, got 0.0")
contains(select(2, pcall(strobe.plot, strobe, "axis", "angle")), "expected two components")
contains(select(2, pcall(strobe.plot, strobe, "axes_x", "angle")), "axis_x")

-- A run that stopped early is taken up to there.
local function fails_at_100(t) if t > 100 then error "off" end return 0, 0, 1 end
local ended, stopped = pcall(evolve, { omega = fails_at_100, to = 200 })
equal(ended, false)
holds(#stopped.run:strobe(10) >= 9, "points up to where it stopped")

-- Files.
local file = os.tmpname()
local printed = {}
local print_before = print
_G.print = function(text) printed[#printed + 1] = text end
strobe:csv(file, { columns = { "t", "euler_vector" } })
strobe:table "angle"
strobe:plot("euler_vector_x", "euler_vector_y")
_G.print = print_before
contains(printed[1], "(106 rows)")
local table_read = read_csv(file)
equal(#table_read.t, 106)
equal(table_read.t[106], 4200)
near(strobe[106].euler_vector.x, table_read.euler_vector_x_rad[106], 0, "what was written")
os.remove(file)
os.remove(file .. ".json")

-- At late times one rounding of t is more than 1e-6 of what f does between two looks: 60 rad of theta/2 have 19 zeros
-- of cos(theta/2), the k-th at t0 + pi (k - 1/2).
local late = evolve { omega = { 0, 0, 2 }, t = { 1.7e9, 1.7e9 + 60 } }:section { f = function(s)
  return s.quaternion.w
end }
equal(#late, 19)
-- t has an ulp of 2.4e-7 there, and so has t - t0 as the closed form takes it.
for k = 1, 19 do holds(abs(late.times[k] - (1.7e9 + pi*(k - 1/2))) <= 1e-6, "zero " .. k) end

-- Beside a pole, with it between two looks: n . G = tan(theta/2) = -5, n . p = tan(theta/4) = -10, theta = t.
local spun = evolve { omega = { 1, 0, 0 }, to = 20 }
for _, case in ipairs { { "gibbs", -5, 2*(pi - atan(5)), 2*pi }, { "mrp", -10, 4*(pi - atan(10)), 4*pi } } do
  local chart, offset, first, period = table.unpack(case)
  for _, direction in ipairs { "both", "up" } do
    local found = spun:section { plane = { 1, 0, 0 }, offset = offset, chart = chart, direction = direction }
    equal(#found, 1 + (20 - first)//period//1|0, chart)
    -- Twice an ulp of t = 20.
    for k = 1, #found do near(first + (k - 1)*period, found.times[k], 8e-15, chart) end
  end
  equal(#spun:section { plane = { 1, 0, 0 }, offset = offset, chart = chart, direction = "down" }, 0)
end
contains(refused("section", { plane = { 1, 0, 0 }, offset = 0/0 }), "offset: expected a finite number, got nan")
contains(refused("section", { f = function() return 0/0 end }), "nan at all")
