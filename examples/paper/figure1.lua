-- Figure 1 of the paper: the body starts turned by 90 degrees about i and spins about omega = k at rate 1; B is a point
-- of it in the plane of x and y, n the axis of the rotation from its first attitude. Pictures at t = 0, pi, 2 pi, 4 pi:
-- while B goes round twice, n goes round once, in a plane tilted relative to the path of B. As printed. It is the plane
-- of i and j + k, tilted by 45 degrees; n is turned by atan2(sqrt(2) sin(t/2), cos(t/2)) from i in it, at the speed
-- 1/sqrt(2) at +-i, half of that where it is highest and lowest.
--
--   rotor examples/paper/figure1.lua [figure1.csv]     writes n and B to that file
--
-- theta and E of the same motion are Figure 2, figure2.lua; its closed form is checked in spinor.lua.

local b0 = vec(1, 0, 0)
local run = evolve { omega = function() return 0, 0, 1 end, from = rotation({ 1, 0, 0 }, pi/2), to = 4*pi,
  points = { b0 }, accuracy = 1e-12 }
local function n(t) return run(t).axis end
local function b(t) return run(t).points[1] end

-- B is known as the rotation is (its estimate is of first order: a quarter more), n to that over 2 sin(theta/2) >=
-- sqrt(2), angles in its plane as n. Closed forms are rounded by 2e-15.
local known = 1.25*run.error_estimate + 2e-15

local i, highest = vec(1, 0, 0), vec(0, 1, 1)/sqrt(2)
local function predicted_angle(t) return atan(sqrt(2)*sin(t/2), cos(t/2)) end
local function in_plane(t) return atan(dot(n(t), highest), dot(n(t), i)) end
local function of_b(t) return atan(b(t).y, b(t).x) end

-- By what an angle goes on from 0 to t, and the least and the greatest of 240 steps.
local function swept(angle, t)
  local sum, least, most = 0, math.huge, -math.huge
  for step = 1, 240 do
    local by = (angle(step*t/240) - angle((step - 1)*t/240) + pi) % (2*pi) - pi
    sum, least, most = sum + by, math.min(least, by), math.max(most, by)
  end
  return sum, least, most
end

local function path(f, to)
  local arcs = {}
  for step = 1, 24 do arcs[step] = { f((step - 1)*to/24), f(step*to/24) } end
  return arcs
end
print "The paths of n, through its places at 0, pi, 2 pi and 3 pi, and of B, level\n"
local both = path(b, 2*pi)
table.move(path(n, 4*pi), 1, 24, 25, both)
draw_sphere { points = { omega = { 0, 0, 1 }, ["0"] = n(0), ["pi"] = n(pi), ["2 pi"] = n(2*pi), ["3 pi"] = n(3*pi) },
  arcs = both, from = { 2, -3, 1.5 }, width = 50 }

print "\nt      B                         n                         n has turned by"
for _, quarter in ipairs { 0, 1, 2, 4 } do
  local at, axis = b(quarter*pi), n(quarter*pi)
  local line = ("%d pi   (%6.3f, %6.3f, %6.3f)  (%6.3f, %6.3f, %6.3f)  %7.3f deg"):format(quarter, at.x, at.y, at.z,
    axis.x, axis.y, axis.z, swept(in_plane, quarter*pi)/deg)
  print((line:gsub("%-(0%.0+)%f[^0-9]", " %1")))
end
print ""
print(("%-30s %-16s %14s %14s"):format("", "paper", "rotor", "exact"))
for _, row in ipairs {
  { "revolutions of B in 4 pi", "2", swept(of_b, 4*pi)/(2*pi), 2 },
  { "revolutions of n in 4 pi", "1", swept(in_plane, 4*pi)/(2*pi), 1 },
  { "n(2 pi) . n(0)", "-1", dot(n(2*pi), n(0)), -1 },
  { "n_z(pi)", "2^(-1/2)", n(pi).z, 1/sqrt(2) },
  { "tilt of the plane of n, deg", "tilted", acos(unit(cross(n(0), n(pi))).z)/deg, 45 },
  { "greatest speed of n, at t = 0", "-", norm(run(0).axis_rate), 1/sqrt(2) },
  { "least, at t = pi", "-", norm(run(pi).axis_rate), 1/sqrt(8) },
} do
  print(("%-30s %-16s %14.10g %14.10g"):format(table.unpack(row)))
end
print "paper: the example of section 4; -: no number in the text\n"
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure1.csv"
if csv then
  local data = { t = {}, n = {}, B = {} }
  for step = 0, 480 do
    local t = step*pi/120
    data.t[step + 1], data.n[step + 1], data.B[step + 1] = t, n(t), b(t)
  end
  write_csv(csv, data, { columns = { "t", "n", "B" } })
end

theorem("Figure 1: n and B at 0, pi, 2 pi, 4 pi", function()
  for_each({ { 0, b0, i }, { pi, -b0, highest }, { 2*pi, b0, -i }, { 4*pi, b0, i } }, function(case)
    near(case[2], b(case[1]), known, "B")
    near(case[3], n(case[1]), known, "n")
  end)
end)

theorem("Figure 1: B goes round twice while n goes round once, both always forward", function()
  local sum, least, most = swept(of_b, 4*pi)
  near(4*pi, sum, 2*known, "B")
  near(pi/60, least, 2*known, "a 240th of it at least")
  near(pi/60, most, 2*known, "and at most")
  sum, least = swept(in_plane, 4*pi)
  near(2*pi, sum, 2*known, "n")
  holds(least > 0, "n, always forward")
  near(pi, swept(in_plane, 2*pi), 2*known, "in one revolution of the body: half a turn")
end)

theorem("Figure 1: the plane of n is tilted by 45 degrees, and how n goes round in it", function()
  for_all({ t = any.number(0, 4*pi) }, function(case)
    local t = case.t
    near(0, dot(n(t), cross(i, highest)), known, "n, out of the plane")
    near(0, (in_plane(t) - predicted_angle(t) + pi) % (2*pi) - pi, known, "its angle, less the predicted")
  end)
  near(pi/4, acos(dot(cross(i, highest), vec(0, 0, 1))), known, "the tilt, k being normal to the path of B")
  for_each({ { 0, 1/sqrt(2) }, { pi, 1/sqrt(8) }, { 2*pi, 1/sqrt(2) }, { 3*pi, 1/sqrt(8) } }, function(case)
    -- By [P5] n' is as well known as n times |cot(theta/2)| <= 1 and theta times 1/(4 sin^2(theta/2)) <= 1/2.
    near(case[2], norm(run(case[1]).axis_rate), 2*known, "the speed of n at " .. case[1]/pi .. " pi")
  end)
end)
