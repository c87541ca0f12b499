-- Figure 5 of the paper, the Euler spinor of Theorem 4.1: for constant omega, |omega| = 1, the axis n moves on a unit
-- circle "inscribed in an ellipse, guided by the ray to a point p(t) moving on the ellipse", with the semi-axes 1 along
-- e1 and 1/m along e2, m = sqrt(1 - a^2). As printed, for a start with omega . n0 > 0 and theta0 < pi (for what fails
-- with others see theorem_4_1.lua). Here theta0 = pi/3 and omega . n0 = 1/2: m = sqrt(3)/4, a = sqrt(13)/4,
-- tan b = 1/sqrt(12). More than that: p = M/m, so that the ellipse is that of the modified Gibbs vector M; and p sweeps
-- out equal areas in equal times, by which |n'| = 1/(2 m |p|^2).
--
--   rotor examples/paper/figure5.lua [figure5.csv]     writes n and p along e1 and e2 to that file

local omega, n0, theta0 = vec(0, 0, 1), vec(sqrt(3)/2, 0, 1/2), pi/3
local m, a, b = sqrt(3)/4, sqrt(13)/4, atan(1/sqrt(12))
-- k = omega . n0/a; u is u1 = (omega - n0 omega . n0)/sqrt(3/4) turned by theta0/2 = pi/6 towards u1 x n0.
local k, u1 = 1/(2*a), (omega - n0/2)/sqrt(3/4)
local u = cos(pi/6)*u1 + sin(pi/6)*cross(u1, n0)
local e1, e2 = sqrt(1 - k^2)*n0 - k*u, k*n0 + sqrt(1 - k^2)*u
local function predicted_p(t) return cos(t/2 + b)*e1 + sin(t/2 + b)/m*e2 end

local run = evolve { omega = function() return 0, 0, 1 end, from = rotation(n0, theta0), to = 8*pi, accuracy = 1e-12 }
local function p(state) return sin(state.angle/2)/m*state.axis end
local function speed(state) return norm(state.axis_rate) end

-- M is known to half of what the rotation is (its estimate is of first order: a quarter more), p to that over m, n to
-- that over |p| >= 1 once more. Closed forms are rounded by 2e-15. By [P5] n' has cot(theta/2)/2: 1/m times n's error
-- and 1/(4 m^2) times theta's.
local known = 1.25*run.error_estimate + 2e-15
local known_p = known/m
local known_speed = known_p/m + known/(4*m^2)

-- Columns along e2, rows along e1, in one scale: a column is half a row.
local rows = {}
for line = 1, 15 do
  rows[line] = {}
  for column = 1, 66 do rows[line][column] = " " end
end
local function mark(v, symbol)
  rows[floor(8.5 - 7*dot(v, e1))][floor(33.5 + 14*dot(v, e2))] = symbol
end
for i = 0, 999 do
  local state = run(4*pi*i/1000)
  mark(p(state), ".")
  mark(state.axis, ":")
end
for i = 0, 23 do
  local state = run(4*pi*i/24)
  mark(p(state), "*")
  mark(state.axis, "o")
end
mark(vec(0, 0, 0), "+")
print "Figure 5: p on the ellipse and n on the circle; e2 to the right, e1 upward;\n* p and o n, every pi/6\n"
for _, row in ipairs(rows) do print((table.concat(row):gsub(" +$", ""))) end
print ""
local times, speeds = {}, {}
for i = 0, 400 do times[i + 1], speeds[i + 1] = i*pi/50, speed(run(i*pi/50)) end
plot(times, speeds, { title = "|n'|: fastest at e1 and -e1, slowest at e2 and -e2", x_label = "t", height = 10 })
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure5.csv"
if csv then
  local data = { t = {}, n1 = {}, n2 = {}, p1 = {}, p2 = {} }
  for i = 0, 480 do
    local state = run(i*pi/120)
    local point = p(state)
    data.t[i + 1], data.n1[i + 1], data.n2[i + 1] = state.t, dot(state.axis, e1), dot(state.axis, e2)
    data.p1[i + 1], data.p2[i + 1] = dot(point, e1), dot(point, e2)
  end
  write_csv(csv, data, { columns = { "t", "n1", "n2", "p1", "p2" } })
end
local minor, major = p(run(2*pi - 2*b)), p(run(pi - 2*b))
print ""
print(("%-30s %-16s %14s %14s"):format("", "paper", "rotor", "exact"))
for _, row in ipairs {
  { "semi-axis along e1", "1", abs(dot(minor, e1)), 1 },
  { "semi-axis along e2", "(1 - a^2)^(-1/2)", dot(major, e2), 1/m },
  { "|n'| at -e1", "greatest", speed(run(2*pi - 2*b)), 1/(2*m) },
  { "|n'| at e2", "least", speed(run(pi - 2*b)), m/2 },
  { "n(2 pi) . n(0)", "-1", dot(run(2*pi).axis, n0), -1 },
  { "theta(2 pi)", "2 pi - theta(0)", run(2*pi).angle, 2*pi - theta0 },
} do
  print(("%-30s %-16s %14.10g %14.10g"):format(table.unpack(row)))
end
print "paper: Theorem 4.1; no numbers with the figure\n"

theorem("Figure 5: p(t), and n the ray to it", function()
  -- acos is steeper than its argument by 1/sin(b) < 4.
  near(acos(cos(theta0/2)/a), b, 2e-15, "b, as printed")
  for_all({ t = any.number(0, 8*pi) }, function(case)
    local state, point = run(case.t), predicted_p(case.t)
    near(point, p(state), known_p, "p(t)")
    near(unit(point), state.axis, known_p, "n(t)")
    near(2*acos(a*cos(case.t/2 + b)), state.angle, known, "theta(t)")
  end)
end)

theorem("Figure 5: an ellipse with the circle inside, touching it at e1 and -e1", function()
  -- p(t) = p(0) cos(t/2) + p(pi) sin(t/2): of the conjugate radii p(0), p(pi) the squares add up to those of the
  -- semi-axes, and the parallelogram is theirs.
  local x, y = p(run(0)), p(run(pi))
  near(1 + 1/m^2, dot(x, x) + dot(y, y), 2*(norm(x) + norm(y))*known_p, "sum of the squares of the semi-axes")
  near(1/m, norm(cross(x, y)), (norm(x) + norm(y))*known_p, "product of the semi-axes")
  near(cross(e1, e2), unit(cross(x, y)), (norm(x) + norm(y))*m*known_p, "the normal of its plane")
  local least, most = math.huge, 0
  for i = 0, 4000 do
    local radius = norm(p(run(4*pi*i/4000)))
    least, most = math.min(least, radius), math.max(most, radius)
  end
  -- A look is pi/2000 away from either at most; |p| bends there by (1/m^2 - 1)/4 and (1/m - m)/4, both below 1.1.
  near(1, least, 1.1/2*(pi/2000)^2 + known_p, "the least |p| of 4001")
  near(1/m, most, 1.1/2*(pi/2000)^2 + known_p, "the greatest")
  holds(least >= 1 - known_p, "never inside of the circle")
end)

theorem("Figure 5: n is fastest at e1 and -e1, slowest at e2 and -e2", function()
  -- t/2 + b is a multiple of pi there, or halfway: t = 2 pi k - 2 b, + pi. n passes e1 at 1/(2 m), e2 at m/2.
  local at_e1 = run:section { f = function(s) return dot(s.axis, e2) end }
  near({ 2*pi - 2*b, 4*pi - 2*b, 6*pi - 2*b, 8*pi - 2*b }, at_e1.times, 2*m*known_p + 1e-14, "when at e1, -e1")
  local at_e2 = run:section { f = function(s) return dot(s.axis, e1) end }
  near({ pi - 2*b, 3*pi - 2*b, 5*pi - 2*b, 7*pi - 2*b }, at_e2.times, 2/m*known_p + 1e-14, "when at e2, -e2")
  for_each({ 1, 2, 3, 4 }, function(i)
    near(1/(2*m), speed(at_e1[i]), known_speed, "speed at e1, -e1: 1/(2 m)")
    near(m/2, speed(at_e2[i]), known_speed, "speed at e2, -e2: m/2")
  end)
  for_all({ t = any.number(0, 8*pi) }, function(case)
    local state = run(case.t)
    holds(m/2 - known_speed <= speed(state) and speed(state) <= 1/(2*m) + known_speed, "between them anywhere")
    -- |p|^2 is 1/m^2 at most, and |n'| 2 |p| = 1/(m |p|) is 1/m.
    near(1/(2*m), speed(state)*dot(p(state), p(state)), known_speed/m^2 + known_p/m, "|n'| |p|^2: equal areas")
  end)
end)
