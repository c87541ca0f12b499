-- Figure 3 of the paper: omega = (cos alpha t, sin alpha t, 0) [P15], T = 2 pi/alpha = 40, E(0) = (1, 1, 1)/sqrt(3):
-- (a) the trajectory of E to t = 4200, (b) E at multiples of T until then, 105 points, (c) ten times as many, (d) n.
-- Printed: the strobe "appears to be densely filling in a closed curve", the points "jump around" and fill it "in a
-- rather clumpy way". As printed, and exactly, with Omega = sqrt(1 + alpha^2), a = (i - alpha k)/Omega:
--   Q(t) = exp(k alpha t/2) exp(a Omega t/2) Q0.
-- At multiples of T that is +-exp(a Omega t/2) Q0, a great circle of the unit quaternions. So the curve is plane, the
-- points go on along it by Omega/(2 alpha) + 1/2 turns, and clump by the three-gap theorem. The rest is two circles,
-- of k and of a: a torus. On it theta and the angle of n with k have least values, the one twice the other.
--
--   rotor examples/paper/figure3.lua [figure3.csv]   writes E and n there; the strobes to figure3_b, figure3_c

local T = 40
local alpha = 2*pi/T
local Omega = sqrt(1 + alpha^2)
local start = rotation({ 1, 1, 1 }, 1)
local function omega(t) return cos(alpha*t), sin(alpha*t), 0 end

local long = evolve { omega = omega, from = start, to = 1050*T, accuracy = 1e-10 }
local short = evolve { omega = omega, from = start, to = 105*T, accuracy = 1e-10 }
local strobe, few = long:strobe(T), short:strobe(T)

-- The rotation is known to the estimate, of first order: a quarter more. The closed form turns by t Omega/2 <= 21258,
-- with three roundings 8e-12, which the attitude has twice.
local known = 1.25*long.error_estimate + 2*8e-12

-- Q0 and a Q0 span the plane of the strobe. Seen from a Q in it, exp(k psi) turns (M0, M3) and (M1, M2) by psi each, so
-- r^2 = M1^2 + M2^2 is that of the strobe point, and M0^2 + M3^2 = 1 - r^2: cos(theta/2) and cos of the angle from k
-- are sqrt(1 - r^2) at most, for the least r of the circle. That is the least singular value of (M1, M2) on the basis.
local q0 = start.quaternion
local a = quaternion(0, 1, 0, -alpha)/Omega
local aq0 = a*q0
local square, determinant = q0.x^2 + q0.y^2 + aq0.x^2 + aq0.y^2, q0.x*aq0.y - q0.y*aq0.x
local least_r = (sqrt(square + 2*abs(determinant)) - sqrt(square - 2*abs(determinant)))/2
local least_angle = 2*asin(least_r)
-- n is known to what the rotation is, over 2 sin(theta/2), E = n theta to theta times that and what theta is.
local known_n = known/(2*least_r)
local known_e = known + 2*pi*known_n

-- E of the closed form; theta/2 in (0, pi) by atan2.
local function exact(t)
  local function turn(axis, angle) return quaternion(cos(angle), 0, 0, 0) + sin(angle)*axis end
  local q = turn(quaternion(0, 0, 0, 1), alpha*t/2)*turn(a, Omega*t/2)*q0
  local m = vec(q.x, q.y, q.z)
  return 2*atan(norm(m), q.w)*unit(m)
end

local rho = (Omega/(2*alpha) + 1/2) % 1
local normal = unit(cross(vec(aq0.x, aq0.y, aq0.z), vec(q0.x, q0.y, q0.z)))
-- M0 on the circle is at most (q0.w^2 + aq0.w^2)^(1/2).
local strobe_least = 2*acos(sqrt(q0.w^2 + aq0.w^2))

-- Return times by the rotation number alone. E of the circle at phi turns from Q0; the arc around E1 with
-- |E - E1| <= distance ends on either side where that is reached; point k is at k rho.
local function arc_end(distance, side)
  local function beyond(phi)
    local q = cos(2*pi*phi)*q0 + sin(2*pi*phi)*aq0
    local m = vec(q.x, q.y, q.z)
    return norm(2*atan(norm(m), q.w)*unit(m) - start.euler_vector) > distance
  end
  local inside, outside = 0, side/4
  for _ = 1, 60 do
    local middle = (inside + outside)/2
    if beyond(middle) then outside = middle else inside = middle end
  end
  return inside
end
local function circle_returns(distance, last)
  local after, before = arc_end(distance, 1), arc_end(distance, -1)
  local counts, previous = {}, 0
  for k = 1, last do
    local phi = (k*rho + 1/2) % 1 - 1/2
    if before <= phi and phi <= after then
      counts[k - previous] = (counts[k - previous] or 0) + 1
      previous = k
    end
  end
  return counts
end

-- The greatest gap between 1050 points k rho of a circle, in turns.
local function greatest_gap()
  local places = {}
  for k = 1, 1050 do places[k] = k*rho % 1 end
  table.sort(places)
  local gap = places[1] + 1 - places[1050]
  for k = 2, 1050 do gap = math.max(gap, places[k] - places[k - 1]) end
  return gap
end

-- A strobe at any period is a list of points to draw.
local trajectory = short:strobe(0.1)
print "Figure 3a: E to t = 4200\n"
trajectory:plot("euler_vector_x", "euler_vector_y", { height = 16 })
print "\nFigure 3b: E at 0, T ... 105 T\n"
few:plot("euler_vector_x", "euler_vector_y", { height = 14 })
print "\nFigure 3c: E at 0, T ... 1050 T\n"
strobe:plot("euler_vector_x", "euler_vector_y", { height = 14 })
print "\nFigure 3d: n to t = 4200, from the side; empty round k and -k\n"
trajectory:plot("axis_x", "axis_z", { height = 16 })
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure3.csv"
if csv then
  local name = csv:gsub("%.csv$", "")
  short:csv(name .. ".csv", { every = 0.1, columns = { "t", "euler_vector", "axis" } })
  few:csv(name .. "_b.csv", { columns = { "t", "euler_vector" } })
  strobe:csv(name .. "_c.csv", { columns = { "t", "euler_vector" } })
end

local function range(points)
  local least, most = math.huge, 0
  for i = 1, #points do
    local theta = points[i].angle
    least, most = math.min(least, theta), math.max(most, theta)
  end
  return least, most
end
print "\n                          paper          rotor, to t =                  exact"
print "                                              4200        42000"
local few_least, few_most = range(few)
local least, most = range(strobe)
for _, row in ipairs {
  { "strobe points after t = 0", "4200/40, 10x", "%12d", #few - 1, #strobe - 1 },
  { "M off one plane", "a closed curve", "%12.1e", few.plane.off, strobe.plane.off, 0 },
  { "greatest theta of a point", "-", "%12.6f", few_most, most, 2*pi - strobe_least },
  { "least", "-", "%12.6f", few_least, least, strobe_least },
  { "turns of the curve per T", "-", "%12.9f", few.rotation_number, strobe.rotation_number, rho },
} do
  local line = ("%-25s %-14s"):format(row[1], row[2])
  for i = 4, #row do line = line .. " " .. row[3]:format(row[i]) end
  print(line .. (#row == 5 and "    105, 1050" or ""))
end
print "-: no number in the text of the paper\n"

theorem("Figure 3a: E by the closed form, and to t = 42000", function()
  for_each({ { 10, vec(-2.0714505365, -0.6623446028, 0.8668860171) },
    { 40, vec(-2.8341103375, 0.7904096874, -0.5504492928) },
    { 4200, vec(-1.6030497286, 0.9435684906, 0.0014697065) },
    { 42000, vec(3.2463931764, -1.0141401422, 0.5620063052) } }, function(case)
    near(case[2], long(case[1]).euler_vector, known_e + 5e-11, "E, of 50 digits, at t = " .. case[1])
  end)
  for_all({ t = any.number(0, 42000) }, function(case)
    near(exact(case.t), long(case.t).euler_vector, known_e, "E(t)")
  end)
end)

theorem("Figures 3b, 3c: 105 and 1050 points after the first, of a plane closed curve", function()
  near(105, #few - 1, 0, "points to t = 4200")
  near(1050, #strobe - 1, 0, "to t = 42000")
  -- Two of M's are known to known/2 each, and the circle's short radius in M is least_r at least.
  local off = strobe.plane.normal
  near(0, math.min(norm(off - normal), norm(off + normal)), known/least_r, "the normal of the plane")
  near(vec(-0.298706, -0.508736, 0.807442), normal, 5e-7, "of 50 digits")
  near(0, strobe.plane.off, known/2, "M at the points, off the plane")
  near(vec(a.x, a.y, a.z), strobe.axis, known, "the axis of a period, (i - alpha k)/Omega")
end)

theorem("Figures 3b, 3c: the rotation number, irrational: quasiperiodic", function()
  -- One rounding of Omega T and of 2 pi each, over 2 pi.
  near(rho, strobe.rotation_number, strobe.rotation_number_error + 1e-15, "Omega/(2 alpha) + 1/2, less whole turns")
  near(0.7221295, strobe.rotation_number, 5e-8, "of 50 digits")
end)

theorem("Figures 3b, 3c: theta at the points", function()
  -- The points come to within half a gap of where theta is least. M0 bends by 1 at most there: it is off by half the
  -- square of that; theta by twice that over sin(theta/2).
  local near_end = (pi*greatest_gap())^2/sin(strobe_least/2) + known
  near(strobe_least, least, near_end, "least")
  near(2*pi - strobe_least, most, near_end, "greatest")
  holds(least >= strobe_least - known and most <= 2*pi - strobe_least + known, "never beyond")
  near(0.867737, strobe_least, 5e-7, "least, of 50 digits")
  near(5.415448, 2*pi - strobe_least, 5e-7, "greatest, of 50 digits")
end)

theorem("Figures 3b, 3c: clumpy, for three return times, of which one is the sum of the others", function()
  for_each({ 0.1, 0.3, 0.5, 1 }, function(distance)
    local times, counts = strobe:return_times(distance)
    local predicted, missed = circle_returns(distance, 1050), 0
    for i, time in ipairs(times) do
      missed = missed + abs((predicted[time] or 0) - counts[i])
      predicted[time] = nil
    end
    holds(missed == 0 and next(predicted) == nil, "as a circle by rho, within " .. distance)
    holds(#times <= 3, "three at most, within " .. distance)
    if #times == 3 then near(times[1] + times[2], times[3], 0, "the greatest, within " .. distance) end
  end)
  local times = strobe:return_times(0.3)
  near({ 18, 115, 133 }, times, 0, "within 0.3")
end)

theorem("Figures 3a, 3d: a torus, and n keeps half of the least theta away from k and -k", function()
  local every, steepest = 0.2, 0
  local points = long:strobe(every)
  local theta_least, theta_most = range(points)
  for i = 1, #points do steepest = math.max(steepest, abs(points[i].axis.z)) end
  -- Once each T it comes to where theta is least on the circle of k, half a gap away on that of a at most, and by half
  -- the time between looks on both. M0 (M3) bends by 1 at most in the sum of the two.
  local off = pi*greatest_gap() + every/2*(Omega + alpha)/2
  local near_end = off^2/sin(least_angle/2) + known
  near(least_angle, theta_least, near_end, "the least theta")
  near(2*pi - least_angle, theta_most, near_end, "the greatest")
  near(cos(least_angle/2), steepest, off^2/2 + known_n, "the greatest |n . k|, cos(half the least theta)")
  holds(theta_least >= least_angle - known and theta_most <= 2*pi - least_angle + known
    and steepest <= cos(least_angle/2) + known_n, "never beyond")
  near(0.706988, least_angle, 5e-7, "the least theta, of 50 digits")
  near(5.576197, 2*pi - least_angle, 5e-7, "the greatest, of 50 digits")
end)
