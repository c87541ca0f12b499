-- Figure 9 of the paper: E for omega = (cos alpha t, sin alpha t, 0) with the period T = 2 pi/alpha = pi. T was chosen
-- as 4 pi is the period of n where omega is constant; "we still end up with incommensurate response frequencies". So
-- it must be: they are (Omega -+ alpha)/(4 pi), Omega = sqrt(1 + alpha^2), and (sqrt 5 + 2)/(sqrt 5 - 2) is irrational.
-- Printed are periods of |E| "of roughly 3 and 53": 4 pi/(sqrt 5 +- 2), 2.9665 and 53.23.
-- The strobe points, at multiples of T, are (-exp(u Omega T/2))^k Q(0), u = (i - alpha k)/Omega: they go round a
-- circle, by sqrt 5/4 + 1/2 turns each, and their M lie in a plane.
--
--   rotor examples/paper/figure9.lua [figure9.csv]     writes E over t to that file, the strobe points to
--                                                    figure9_strobe.csv

local alpha = 2
local e0, last = vec(1, 1, 1)/sqrt(3), 4200
local omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = alpha }
local run = evolve { omega = omega, from = rotation(e0, 1), to = last }
local strobe = run:strobe(pi)

local q0 = quaternion(0, e0.x/2, e0.y/2, e0.z/2):exp()
local function exact(t)
  local q = (t/2*quaternion(0, 0, 0, alpha)):exp()*(t/2*quaternion(0, 1, 0, -alpha)):exp()*q0
  local m = vec(q.x, q.y, q.z)
  return 2*atan(norm(m), q.w)*unit(m)
end

-- alpha t/2 and Omega t/2 are rounded by 3 units each here, and in the run; what is shown is twice that, the angle, and
-- E's by s = (theta/2)/sin(theta/2) < 8 more. The run's own estimate is of first order: a quarter more.
local function known(t) return 1.25*run.error_estimate + 4*3*2^-53*(alpha + sqrt(5))*t/2 + 4e-15 end

-- cos(theta/2) = A cos(2 pi f1 t - a) + B cos(2 pi f2 t - b): the scalar part of the product, by products of cos and
-- sin of alpha t/2 and Omega t/2, then by sums of the two.
local A, a, B, b
local u, k, m0 = unit { 1, 0, -alpha }, vec(0, 0, 1), sin(1/2)*e0
do
  local cc, cs, sc, ss = cos(1/2), -dot(u, m0), -dot(k, m0), -dot(k, u)*cos(1/2) - dot(cross(k, u), m0)
  A, a = sqrt((cc + ss)^2 + (cs - sc)^2)/2, atan(cs - sc, cc + ss)
  B, b = sqrt((cc - ss)^2 + (cs + sc)^2)/2, atan(cs + sc, cc - ss)
end
local f1, f2 = (sqrt(5) - alpha)/(4*pi), (sqrt(5) + alpha)/(4*pi)
local least, most = 2*acos(A + B), 2*acos(-A - B)

run:strobe(0.1):plot("euler_vector_x", "euler_vector_y", { title = "Figure 9a: E, to t = 4200", height = 16 })
strobe:plot("euler_vector_x", "euler_vector_y", { title = "Figure 9c: strobe points", height = 14 })
for _, case in ipairs { { "9e", last }, { "9f", 200 } } do
  local shown = {}
  for i = 0, 400 do shown[i + 1] = i*case[2]/400 end
  run:plot("angle", { times = shown, title = ("Figure %s: |E| to t = %d"):format(case[1], case[2]), height = 12 })
end
local found = run:frequencies(2, { of = "angle" })
local periods = { 1/found[1].frequency, 1/found[2].frequency }
local low, high = math.huge, 0
for i = 0, 10*last do
  local theta = run(i/10).angle
  low, high = math.min(low, theta), math.max(high, theta)
end
print ""
print(("%-30s %-16s %14s %14s"):format("", "paper", "rotor", "exact"))
for _, row in ipairs {
  { "slow period of |E|", "roughly 53", periods[1], 4*pi/(sqrt(5) - 2) },
  { "fast period of |E|", "roughly 3", periods[2], 4*pi/(sqrt(5) + 2) },
  { "their ratio, irrational", "53/3 = 17.67", periods[1]/periods[2], (sqrt(5) + 2)^2 },
  { "least |E| to 4200, its bound", "-", low, least },
  { "greatest |E|, its bound", "-", high, most },
} do
  print(("%-30s %-16s %14.10g %14.10g"):format(table.unpack(row)))
end
print "-: no number in the text of the paper\n"
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure9.csv"
if csv then
  run:csv(csv, { every = 0.1, columns = { "t", "angle", "euler_vector" } })
  strobe:csv((csv:gsub("%.csv$", "")) .. "_strobe.csv", { columns = { "t", "euler_vector", "quaternion" } })
end

local times = {}
for t = 0, last do times[t + 1] = t end

theorem("Figure 9: E(t) is that of the closed form, and its numbers", function()
  -- From 40 digits, rounded to 10 decimals.
  for_each({ { 10, vec(1.8446923032, -0.0890832420, -1.5802434991) },
    { 400, vec(-3.3264353962, -2.9577275102, -1.1164568471) } }, function(case)
    near(case[2], run(case[1]).euler_vector, 0.5e-10*sqrt(3) + 8*known(case[1]), "E(10), E(400)")
  end)
  for_each(times, function(t)
    near(exact(t), run(t).euler_vector, 8*known(t), "E(t)")
    near(A*cos(2*pi*f1*t - a) + B*cos(2*pi*f2*t - b), cos(run(t).angle/2), known(t), "cos(theta/2), by two cosines")
  end)
end)

theorem("Figure 9: |E| stays between bounds", function()
  near(0.766051, least, 0.5e-6, "the lower bound")
  near(5.517134, most, 0.5e-6, "the upper bound")
  holds(low > least and high < most, "all samples are between them, 0.1 apart")
  for_each({ 1, -1 }, function(sign)
    -- Of the times at which the slow cosine is sign, that at which the fast one is nearest to it. theta is known to
    -- 1/sin(theta/2) < 3 of what its cosine is.
    local best, when = -1, nil
    for i = 1, floor(f1*last) - 1 do
      local t = (a/(2*pi) + (sign > 0 and 0 or 0.5) + i)/f1
      local fast = sign*cos(2*pi*f2*t - b)
      if fast > best then best, when = fast, t end
    end
    near(2*acos(sign*(A + B*best)), run(when).angle, 3*known(when), "the nearest to either")
  end)
end)

theorem("Figure 9: the periods of the fast and the slow oscillations of |E|", function()
  near(53.23, 1/f1, 0.005, "slow, 4 pi/(sqrt 5 - 2)")
  near(2.9665, 1/f2, 0.5e-4, "fast, 4 pi/(sqrt 5 + 2)")
  -- To 1e-8 as frequencies.
  for i, name in ipairs { "slow", "fast" } do
    local f = ({ f1, f2 })[i]
    near(1/f, 1/found[i].frequency, 1e-8/f^2, name .. ", the refined line " .. found[i].name)
  end
  -- As read off the plot: theta' is 0 downward once in each fast period, as B f2 > A f1, and off by less than one.
  holds(B*f2 > A*f1, "the fast cosine decides where theta has its maxima")
  local maxima = run:section { f = function(s) return s.angle_rate end, direction = "down" }.times
  near(1/f2, (maxima[#maxima] - maxima[1])/(#maxima - 1), 1/f2/(#maxima - 1), "fast, by the maxima of |E|")
end)

theorem("Figure 9: the strobe points lie on a circle, and never come back", function()
  near(floor(last/pi) + 1, #strobe, 0, "how many there are")
  -- M(0) and what follows it at right angles span the plane.
  local normal = unit(cross(m0, cos(1/2)*u + cross(u, m0)))
  near(0, norm(cross(normal, strobe.plane.normal)), known(last), "the normal of the plane of M, across the predicted")
  near(0, strobe.plane.off, known(last), "the greatest distance from it")
  -- Until 400: until 4200 the rounding of T adds up to more than the error of the run, and rotor says nothing.
  local few = evolve { omega = omega, from = run.start, to = 400 }:strobe(pi)
  near((sqrt(5) - 2)/4, few.rotation_number, few.rotation_number_error + 2^-53, "the rotation number, (sqrt 5 - 2)/4")
end)
