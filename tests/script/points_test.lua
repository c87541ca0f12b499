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

-- A section has the states on the surface.
local section = run:section { plane = { 0, 0, 1 }, direction = "up" }
equal(section.period, nil)
equal(section.rotation_number, nil)
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
contains(refused("strobe"), "number")
contains(refused("section", {}), "give one of f")
contains(refused("section", { f = print, plane = { 0, 0, 1 } }), "give one of f")
contains(refused("section", { f = 1 }), "expected a function of a state")
contains(refused("section", { f = function() end }), "f must return a number, got nil at t = 0.0")
contains(refused("section", { f = function() error "mine" end }), "mine")
contains(refused("section", { plane = { 0, 0, 0 } }), "normal of any length but zero")
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
