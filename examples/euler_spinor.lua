-- The Euler spinor: Figures 1, 2 and 5 and the example of section 4 of
--   J. H. Elton, J. R. Elton, Evolving the Euler rotation axis as a dynamical system.
--
-- A body has been turned by 90 degrees about x and from then on spins about the vertical at one radian per
-- second. While it makes two revolutions, the axis of the rotation that leads from its first attitude to
-- its present one goes round once, in a tilted plane: after one revolution of the body the axis is reversed.
--
--   rotor examples/euler_spinor.lua          writes euler_spinor.csv

local k = vec(0, 0, 1)
local n0, theta0 = vec(1, 0, 0), pi/2

-- The angular velocity is a script's function, so that the run integrates it as it would any other.
local run = evolve {
  omega = function() return 0, 0, 1 end,
  from = rotation(n0, theta0),
  to = 6*pi,
  accuracy = 1e-12,
}

-- Theorem 4.1 in closed form, for constant omega of length 1 that is not parallel to n0.
local function theorem_4_1(omega)
  local c, half = dot(omega, n0), theta0/2
  local a = sqrt(1 - (1 - c^2)*sin(half)^2)
  local b = math.atan(c*sin(half), cos(half))
  local u1 = (omega - c*n0)/sqrt(1 - c^2)
  local u = cos(half)*u1 + sin(half)*cross(u1, n0)
  local kappa, s = c/a, cos(half) < 0 and -1 or 1
  local e1 = s*sqrt(1 - kappa^2)*n0 - kappa*u
  local e2 = kappa*n0 + s*sqrt(1 - kappa^2)*u
  local function p(t) return cos(t/2 + b)*e1 + sin(t/2 + b)/sqrt(1 - a^2)*e2 end
  return { a = a, b = b, e1 = e1, e2 = e2, p = p,
    angle = function(t) return 2*acos(a*cos(t/2 + b)) end,
    axis = function(t) return unit(p(t)) end }
end
local exact = theorem_4_1(k)

print(run)
print(("\nTheorem 4.1: a = %.6f  b = %.6f"):format(exact.a, exact.b))
print(("  e1 = (%.4f, %.4f, %.4f)  e2 = (%.4f, %.4f, %.4f)\n"):format(exact.e1.x, exact.e1.y, exact.e1.z,
  exact.e2.x, exact.e2.y, exact.e2.z))

-- The example of section 4: run and theorem ---------------------------------------------------------------------

-- As string.format, but what rounds to zero has no sign.
local function write(format, ...)
  print((format:format(...):gsub("%-(0%.0+)%f[^0-9]", " %1")))
end

local function row(t, label, angle, n)
  local e = angle*n
  write("%-5s %-8s %8.5f  %8.5f %8.5f %8.5f  %8.5f %8.5f %8.5f", t, label, angle, n.x, n.y, n.z, e.x, e.y, e.z)
end
print "t              theta         n                            E"
for quarter, label in ipairs { "0", "pi", "2 pi", "3 pi", "4 pi" } do
  local t = (quarter - 1)*pi
  local state, angle, n = run(t), exact.angle(t), exact.axis(t)
  row(label, "run", state.angle, state.axis)
  row("", "theorem", angle, n)
  local dn, de = state.axis - n, state.euler_vector - angle*n
  print(("      differ   %8.1e  %8.1e %8.1e %8.1e  %8.1e %8.1e %8.1e"):format(state.angle - angle,
    dn.x, dn.y, dn.z, de.x, de.y, de.z))
end

-- Figure 1: the body's point B and the axis at the times of its four pictures -----------------------------------

print "\nFigure 1: a point B of the body, and the axis\n"
print "t        B                              axis"
for quarter, label in ipairs { "0", "pi", "2 pi", "4 pi" } do
  local t = ({ 0, pi, 2*pi, 4*pi })[quarter]
  -- B stands in the body so that it starts at x.
  local b = run(t).rotation*(rotation(n0, theta0):inverse()*vec(1, 0, 0))
  local n = run(t).axis
  write("%-6s  (%8.5f, %8.5f, %8.5f)  (%8.5f, %8.5f, %8.5f)", label, b.x, b.y, b.z, n.x, n.y, n.z)
end

-- Figure 2: |E| and two components of E -------------------------------------------------------------------------

print ""
run:plot("angle", { title = "Figure 2: |E| = theta", height = 12 })
print ""
run:plot({ "euler_vector_x", "euler_vector_y" }, { title = "Figure 2: two components of E", height = 16 })

-- Figure 5: in the plane of e1 and e2 the axis n is where the ray to a point p of an ellipse meets the unit
-- circle ---------------------------------------------------------------------------------------------------------

local function draw_plane(curves, width, height, radius)
  local rows = {}
  for i = 1, height do rows[i] = {} end
  local function mark(x, y, symbol)
    local column = math.floor((x/radius + 1)/2*(width - 1) + 1.5)
    local line = math.floor((1 - y/radius)/2*(height - 1) + 1.5)
    if rows[line] then rows[line][column] = symbol end
  end
  for _, curve in ipairs(curves) do
    for i = 0, 999 do
      local v = curve[2](4*pi*i/1000)
      mark(dot(v, exact.e1), dot(v, exact.e2), curve[1])
    end
  end
  mark(0, 0, "+")
  for i = 1, height do
    local line = {}
    for j = 1, width do line[j] = rows[i][j] or " " end
    print((table.concat(line):gsub("%s+$", "")))
  end
end
print "\nFigure 5: o the axis n of the run, . the ellipse p; e1 to the right, e2 upward\n"
draw_plane({ { ".", exact.p }, { "o", function(t) return run(t).axis end } }, 62, 27, 1.5)

run:csv("euler_spinor.csv", { n = 1000, columns = { "t", "angle", "axis", "euler_vector" } })

-- The claims ------------------------------------------------------------------------------------------------------

-- The run says how well it knows the rotation. The angle is as good as that; the axis of a rotation by
-- theta is worse by 1/(2 sin(theta/2)), here at most 1/sqrt(2): sin(theta/2) >= 1/sqrt(2). Differences of two states
-- have both errors. The estimate is of first order: a quarter more for what it leaves out.
local tolerance = 2*1.25*run.error_estimate

-- The greatest difference at 401 times from 0 to the end.
local function worst(to, difference)
  local greatest = 0
  for i = 0, 400 do greatest = math.max(greatest, difference(to*i/400)) end
  return greatest
end

theorem("Theorem 4.1: the angle and axis in closed form", function()
  near(0, worst(4*pi, function(t) return abs(run(t).angle - exact.angle(t)) end), tolerance, "theta(t), 401 times")
  near(0, worst(4*pi, function(t) return norm(run(t).axis - exact.axis(t)) end), tolerance, "n(t), 401 times")
end)

theorem("Theorem 4.1: period 4 pi, and what half of it does", function()
  -- The Euler vector is theta times the axis: theta <= 3 pi/2 times its error, and that of theta.
  near(0, worst(2*pi, function(t) return norm(run(t + 4*pi).euler_vector - run(t).euler_vector) end),
    (3*pi/2 + 1)*tolerance, "E(t + 4 pi) = E(t)")
  near(0, worst(4*pi, function(t) return norm(run(t + 2*pi).axis + run(t).axis) end), tolerance, "n(t + 2 pi) = -n(t)")
  near(0, worst(4*pi, function(t) return abs(run(t + 2*pi).angle + run(t).angle - 2*pi) end), tolerance,
    "theta(t + 2 pi) = 2 pi - theta(t)")
  near(rotation(n0, theta0), run(2*pi).rotation, tolerance, "the body itself is back at 2 pi")
end)

theorem("Theorem 4.1: n goes round a plane unit circle", function()
  local normal = cross(exact.e1, exact.e2)
  near(0, worst(4*pi, function(t) return abs(dot(run(t).axis, normal)) end), tolerance, "n . (e1 x e2)")
  near(0, worst(4*pi, function(t) return abs(norm(run(t).axis) - 1) end), 4.5e-16, "|n| = 1")
end)

theorem("Theorem 4.1: n is fastest at e1, slowest at e2", function()
  local function speed(t) return norm(run(t).axis_rate) end
  -- The rate is the axis times the rate 1 of the body and cot(theta/2) <= 1: the same error, twice.
  local a = exact.a
  near(exact.e1, run(0).axis, tolerance, "n(0) = e1")
  near(0.5/sqrt(1 - a^2), speed(0), 2*tolerance, "the speed there")
  near(exact.e2, run(pi).axis, tolerance, "n(pi) = e2")
  near(0.5*sqrt(1 - a^2), speed(pi), 2*tolerance, "the speed there")
  local fastest, slowest = 0, math.huge
  for i = 0, 400 do
    local v = speed(4*pi*i/400)
    fastest, slowest = math.max(fastest, v), math.min(slowest, v)
  end
  near(speed(0), fastest, 2*tolerance, "the greatest speed of 401")
  near(speed(pi), slowest, 2*tolerance, "the least speed of 401")
end)
