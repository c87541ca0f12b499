-- Figure 2 of the paper: the motion of Figure 1 (figure1.lua) for several periods, seen along its tilted plane, and
-- |E| = theta and two components of E over t, "demonstrating the periodicity". As printed: E has the period 4 pi, twice
-- that of the body. theta goes between pi/2 and 3 pi/2, and is greater on one side of the plane than on the other.
--
--   rotor examples/paper/figure2.lua [figure2.csv]     writes theta, n and E to that file

local run = evolve { omega = function() return 0, 0, 1 end, from = rotation({ 1, 0, 0 }, pi/2), to = 12.5*pi,
  accuracy = 1e-12 }

-- theta is known as the rotation is (to its estimate, of first order: a quarter more), n to that over 2 sin(theta/2) >=
-- sqrt(2), E = n theta to less than 3 pi/2 + 1 of it. Closed forms and t are rounded by 1e-14.
local known = 1.25*run.error_estimate + 1e-14
local known_e = (3*pi/2 + 1)*known

run:plot("angle", { title = "theta", height = 12 })
print ""
run:plot({ "euler_vector_x", "euler_vector_y" }, { title = "two components of E", height = 14 })
print "\nE in its plane, along x, and seen from the side\n"
local points = run:strobe(pi/100)
points:plot("euler_vector_x", "euler_vector_y", { height = 14 })
points:plot("euler_vector_y", "euler_vector_z", { height = 10 })
local upward, least, most = run:section { plane = { 1, 0, 0 }, direction = "up" }.times, math.huge, 0
for i = 1, #points do least, most = math.min(least, points[i].angle), math.max(most, points[i].angle) end
print ""
print(("%-30s %-16s %14s %14s"):format("", "paper", "rotor", "exact"))
for _, row in ipairs {
  { "period of E", "4 pi", upward[2] - upward[1], 4*pi },
  { "least |E|", "pi/2", least, pi/2 },
  { "greatest |E|", "3 pi/2", most, 3*pi/2 },
  { "|E| at t = pi", "2 acos(0)", run(pi).angle, pi },
  { "E_x at t = 2 pi", "-3 pi/2", run(2*pi).euler_vector.x, -3*pi/2 },
} do
  print(("%-30s %-16s %14.10g %14.10g"):format(table.unpack(row)))
end
print "paper: the example of section 4\n"
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure2.csv"
if csv then run:csv(csv, { every = pi/100, columns = { "t", "angle", "axis", "euler_vector" } }) end

theorem("Figure 2: the period is 4 pi, that of the body 2 pi", function()
  local once, twice = run:strobe(2*pi), run:strobe(4*pi)
  -- The error of the period, 2 pi k rounded, is 1e-15 of a turn.
  near(1/2, once.rotation_number, once.rotation_number_error + 1e-15, "in 2 pi the quaternion goes on by, turns")
  near(0, (twice.rotation_number + 1/2) % 1 - 1/2, twice.rotation_number_error + 1e-15, "in 4 pi by")
  for_each({ 1, 2, 3, 4, 5, 6 }, function(k)
    near(run.start, once[1 + k].rotation, 2*known, "the body after 2 pi k")
    near(k % 2 == 0 and pi/2 or 3*pi/2, once[1 + k].angle, 2*known, "theta")
  end)
  for_all({ t = any.number(0, 8*pi) }, function(case)
    near(run(case.t).euler_vector, run(case.t + 4*pi).euler_vector, 2*known_e, "E(t + 4 pi) = E(t)")
  end)
end)

theorem("Figure 2: where the curves cross pi and 0", function()
  -- theta' = omega . n is 1/sqrt(2) at pi, E_x' is pi/sqrt(8) there, E_y' = theta/2 >= pi/4 at 2 pi k.
  local odd = { pi, 3*pi, 5*pi, 7*pi, 9*pi, 11*pi }
  near(odd, run:section { f = function(s) return s.angle - pi end }.times, sqrt(2)*known, "theta = pi")
  near(odd, run:section { plane = { 1, 0, 0 } }.times, known_e, "E_x = 0")
  near({ 2*pi, 6*pi, 10*pi }, run:section { plane = { 0, 1, 0 }, direction = "down" }.times, 4/pi*known_e,
    "E_y = 0, downward")
end)

theorem("Figure 2: the heights of the curves", function()
  local right, left, up = -math.huge, math.huge, -math.huge
  for i = 1, #points do
    local e = points[i].euler_vector
    right, left, up = math.max(right, e.x), math.min(left, e.x), math.max(up, e.y)
  end
  -- There is a point at each multiple of pi/100.
  near(pi/2, least, known, "the least theta")
  near(3*pi/2, most, known, "the greatest theta")
  near(pi/2, right, known_e, "the greatest E_x, at 4 pi k")
  near(-3*pi/2, left, known_e, "the least E_x, at 2 pi + 4 pi k")
  -- E_y is greatest only after pi, where n is highest, for theta grows: where theta' n_y = -theta n_y', that is
  -- 2 sin^2(t/2) sqrt(1 + sin^2(t/2)) = -theta cos(t/2), between pi and 2 pi.
  local function theta(t) return 2*acos(cos(t/2)/sqrt(2)) end
  local before, after = pi, 2*pi
  for _ = 1, 60 do
    local t = (before + after)/2
    local s, c = sin(t/2), cos(t/2)
    if 2*s^2*sqrt(1 + s^2) > -theta(t)*c then before = t else after = t end
  end
  local predicted = theta(before)*sin(before/2)/sqrt(1 + sin(before/2)^2)
  local top = run:section { f = function(s) return s.euler_rate.y end, direction = "down" }[1]
  near(predicted, top.euler_vector.y, known_e, "the greatest E_y, where its rate is 0")
  -- A point is pi/200 away from there at most, and E_y'' above -1.
  near(predicted, up, (pi/200)^2/2 + known_e, "the greatest E_y of the points")
  holds(top.t > pi, "after pi")
end)
