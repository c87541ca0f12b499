-- Figure 4 of the paper: where the half angle comes from. The body is turned by theta about n; omega is perpendicular
-- to n, u = omega/|omega|, v = u x n. (a) In dt the point r = n goes to r'' = n + omega x n dt = n + v |omega| dt.
-- (b) A rotation by theta about n + dn brings r there if, in the plane at n,
--   dn = u |dn| cos(theta/2) + v |dn| sin(theta/2),  |dn| = |omega| dt/(2 sin(theta/2)),
-- by an isosceles triangle. As printed. More than that: by a finite angle d = |omega| dt the axis tilts exactly in
-- that direction, by gamma with tan gamma = tan(d/2)/sin(theta/2). That theta stays, and all other points of the body
-- go along ("We omit showing that"), is short of the finite rotation by d^2 |cot(theta/2)|/4.
--
--   rotor examples/paper/figure4.lua [figure4.csv]     writes to that file r on its arc, about the tilted axis

local function dn_of(n, u, theta, d)
  return d/(2*sin(theta/2))*(cos(theta/2)*u + sin(theta/2)*cross(u, n))
end

-- (b), theta = 2: r at 0, r'' at 1 along v, all in |omega| dt. Counter-clockwise about n is from v to u.
local theta = 2
local top, radius = 1/(2*tan(theta/2)), 1/(2*sin(theta/2))
local along, arc, legs = {}, {}, {}
for i = 0, 100 do
  local x = i/100
  along[i + 1] = x
  arc[i + 1] = top - sqrt(radius^2 - (x - 1/2)^2)
  legs[i + 1] = top*(1 - abs(2*x - 1))
end
print "Figure 4b, in |omega| dt: r (left) goes round n + dn (top) to r'' (right)\n"
plot(along, { arc = arc, ["|dn|"] = legs }, { x_label = "v", y_label = "u", height = 16, width = 66 })

-- (a), with d = 0.6.
local n, u, d = vec(0, 0, 1), vec(1, 0, 0), 0.6
local turned = rotation(u, d)*rotation(n, theta)
local tilted = turned.axis
local steps, places = {}, {}
for i = 0, 40 do places[i + 1] = rotation(tilted, turned.angle*i/40)*n end
for i = 1, 40 do steps[i] = { places[i], places[i + 1] } end
print "\nFigure 4a: the same on the sphere for |omega| dt = 0.6\n"
draw_sphere { points = { ["r = n"] = n, ["n~"] = tilted, ["r''"] = places[41], omega = u }, arcs = steps,
  from = { 1, -1.5, 2 }, width = 50 }
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure4.csv"
if csv then
  local data = { angle = {}, r = places, axis = {} }
  for i = 0, 40 do data.angle[i + 1], data.axis[i + 1] = turned.angle*i/40, tilted end
  write_csv(csv, data, { columns = { "angle", "r", "axis" } })
end

print "\nFor d = |omega| dt the paper's |dn| (a formula, no numbers), d/(2 sin(theta/2)),"
print "the tilt, and how far off n + dn and theta put the body: d^2 cot(theta/2)/4\n"
print "                 paper          rotor          exact         rotor    d -> 0"
print "d                 |dn|           tilt           tilt      body off  body off"
for k = 0, 4 do
  local h = 10^-k
  local finite, dn = rotation(u, h)*rotation(n, theta), dn_of(n, u, theta, h)
  local gamma = atan(norm(cross(n, finite.axis)), dot(n, finite.axis))
  print(("%-7g %14.12f %14.12f %14.12f %13.6e %10.4e"):format(h, norm(dn), gamma,
    atan(tan(h/2), sin(theta/2)), rotation(n + dn, theta):distance(finite), h^2/(4*tan(theta/2))))
end
print ""

-- omega made perpendicular to n; theta away from 0 and 2 pi: |cot(theta/2)| < 2.
local drawn = { n = any.direction, w = any.direction, size = any.number(0.1, 3), theta = any.number(1, 2*pi - 1) }
local function for_all_tilts(check)
  for_all(drawn, function(case)
    given(norm(cross(case.n, case.w)) > 0.1)
    check(case.n, unit(case.w - dot(case.w, case.n)*case.n), case.theta, case.size)
  end)
end

theorem("Figure 4b: about n + dn, by theta, r comes to r''", function()
  for_all_tilts(function(axis, along_omega, angle, size)
    -- |dn| is 3.2 at most, rounded to 1e-15 some times.
    local dn = dn_of(axis, along_omega, angle, size)
    near(size*cross(along_omega, axis), dn + rotation(axis, angle)*-dn, 1e-14, "r'' - r = omega x n dt")
  end)
end)

theorem("[P5] is Figure 4b: n' = dn/dt, theta' = 0, where omega is perpendicular to n", function()
  for_all_tilts(function(axis, along_omega, angle, size)
    local state = evolve { omega = size*along_omega, from = rotation(axis, angle), to = 1 }(0)
    -- As above.
    near(dn_of(axis, along_omega, angle, size), state.axis_rate, 1e-14, "n'")
    near(0, state.angle_rate, 1e-14, "theta'")
  end)
end)

theorem("for a finite |omega| dt: the same direction, tan gamma = tan(d/2)/sin(theta/2)", function()
  for_all_tilts(function(axis, along_omega, angle, size)
    local finite = rotation(along_omega, size)*rotation(axis, angle)
    local ends = finite.axis
    -- The direction has the roundings of the axis, 5e-15, over sin gamma > 0.04.
    local direction = unit(ends - dot(ends, axis)*axis)
    near(cos(angle/2)*along_omega + sin(angle/2)*cross(along_omega, axis), direction, 2e-13, "direction of the tilt")
    near(atan(tan(size/2), sin(angle/2)), atan(norm(cross(axis, ends)), dot(axis, ends)), 2e-14, "gamma")
    near(cos(size/2)*cos(angle/2), cos(finite.angle/2), 1e-14, "cos(half the angle): cos(d/2) cos(theta/2)")
  end)
end)

theorem("for all points of the body: theta about n + dn is off by d^2 |cot(theta/2)|/4", function()
  for_all_tilts(function(axis, along_omega, angle)
    local h = 1e-3
    local finite = rotation(along_omega, h)*rotation(axis, angle)
    local off = rotation(axis + dn_of(axis, along_omega, angle, h), angle):distance(finite)
    -- Across, by the tilt, tan(h/2) - h/2 = h^3/24 twice; the angle by h^4 (cot + cot^3)/64 more; 1e-15 of rounding.
    near(abs(1/tan(angle/2))/4, off/h^2, h/12 + h^2 + 1e-15/h^2, "over d^2")
  end)
end)
