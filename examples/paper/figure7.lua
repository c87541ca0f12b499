-- Figure 7 of the paper: |E| over t, for two lengths of time. The body turns by [P15],
--   omega = (cos alpha t, sin alpha t, 0),  T = 2 pi/alpha = 40,
-- from E(0) = (1, 1, 1)/sqrt 3. Printed is that from such plots alone "it is certainly not clear whether the motion is
-- periodic, chaotic, or quasiperiodic".
-- It is quasiperiodic, from the closed form: with Omega = sqrt(1 + alpha^2)
--   Q(t) = exp(k alpha t/2) exp((i - alpha k) t/2) Q(0),
--   cos(theta/2) = A cos(2 pi f1 t - a) + B cos(2 pi f2 t - b),  f1, f2 = (Omega -+ alpha)/(4 pi),
-- so that |E| = theta comes ever nearer to 2 acos(A + B), and to 2 pi less that: f2/f1 is rational only where alpha^2
-- is, and here it is pi^2/400.
--
--   rotor examples/paper/figure7.lua [figure7.csv]     writes |E| and E to that file

local alpha = 2*pi/40
local e0, last = vec(1, 1, 1)/sqrt(3), 4200
local run = evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = alpha },
  from = rotation(e0, 1), to = last }

local q0 = quaternion(0, e0.x/2, e0.y/2, e0.z/2):exp()
local function exact(t)
  local q = (t/2*quaternion(0, 0, 0, alpha)):exp()*(t/2*quaternion(0, 1, 0, -alpha)):exp()*q0
  local m = vec(q.x, q.y, q.z)
  return 2*atan(norm(m), q.w)*unit(m)
end

-- alpha t/2 and Omega t/2 are rounded by 3 units each here, and in the run; what is shown is twice that, the angle, and
-- E's by s = (theta/2)/sin(theta/2) < 8 more. The run's own estimate is of first order: a quarter more.
local function known(t) return 1.25*run.error_estimate + 4*3*2^-53*(alpha + sqrt(1 + alpha^2))*abs(t)/2 + 4e-15 end

-- The scalar part of the product, by products of cos and sin of alpha t/2 and Omega t/2, then by sums of the two.
local A, a, B, b
do
  local m0 = sin(1/2)*e0
  local u, k = unit { 1, 0, -alpha }, vec(0, 0, 1)
  local cc, cs, sc, ss = cos(1/2), -dot(u, m0), -dot(k, m0), -dot(k, u)*cos(1/2) - dot(cross(k, u), m0)
  A, a = sqrt((cc + ss)^2 + (cs - sc)^2)/2, atan(cs - sc, cc + ss)
  B, b = sqrt((cc - ss)^2 + (cs + sc)^2)/2, atan(cs + sc, cc - ss)
end
local f1, f2 = (sqrt(1 + alpha^2) - alpha)/(4*pi), (sqrt(1 + alpha^2) + alpha)/(4*pi)
local least, most = 2*acos(A + B), 2*acos(-A - B)

-- Of the times in a window at which the slower cosine is sign, that at which the other is nearest to it, and
-- cos(theta/2) then.
local function nearest(sign, window)
  local best, when = -1, nil
  for i = 0, floor(f1*window) do
    local t = (a/(2*pi) + (sign > 0 and 0 or 0.5) + i)/f1
    local other = sign*cos(2*pi*f2*t - b)
    if t >= 0 and t <= window and other > best then best, when = other, t end
  end
  return when, sign*(A + B*best)
end

for _, case in ipairs { { "7a", 200 }, { "7b", last } } do
  local shown = {}
  for i = 0, 400 do shown[i + 1] = i*case[2]/400 end
  run:plot("angle", { times = shown, title = ("Figure %s: |E| to t = %d"):format(case[1], case[2]), height = 14 })
end
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure7.csv"
if csv then run:csv(csv, { every = 0.1, columns = { "t", "angle", "euler_vector" } }) end

local found = run:frequencies(2, { of = "quaternion_w" })
local lines = { [found[1].name] = found[1], [found[2].name] = found[2] }
-- The least and the greatest |E| until then, 0.1 apart.
local function range(window)
  local low, high = math.huge, 0
  for i = 0, 10*window do
    local theta = run(i/10).angle
    low, high = math.min(low, theta), math.max(high, theta)
  end
  return low, high
end
local lowest, highest = range(last)
print ""
print(("%-30s %-16s %14s %14s"):format("", "paper", "rotor", "exact"))
for _, row in ipairs {
  { "frequency (Omega - alpha)/4 pi", "0.068 (Fig. 10)", lines.f_F.frequency, f1 },
  { "frequency (Omega + alpha)/4 pi", "0.0925 (Fig. 10)", lines["drive + f_F"].frequency, f2 },
  { "least |E| to 4200, its bound", "-", lowest, least },
  { "greatest |E|, its bound", "-", highest, most },
} do
  print(("%-30s %-16s %14.10g %14.10g"):format(table.unpack(row)))
end
print "-: no number in the text of the paper; the figure plots |E|\n"
print "how near |E| comes to its bounds, when the slower cosine is 1 or -1\n"
print "until t    lower, 2 acos(A + B)          upper, 2 acos(-A - B)"
for _, window in ipairs { 200, last } do
  local t1, c1 = nearest(1, window)
  local t2, c2 = nearest(-1, window)
  print(("%7d    %.1e at t = %8.3f       %.1e at t = %8.3f"):format(window, 2*acos(c1) - least, t1, most - 2*acos(c2),
    t2))
end
print ""

local times = {}
for t = 0, last do times[t + 1] = t end

theorem("Figure 7: E(t) is that of the closed form, and its numbers", function()
  -- From 40 digits, rounded to 10 decimals.
  for_each({ { 10, vec(-2.0714505365, -0.6623446028, 0.8668860171) },
    { 40, vec(-2.8341103375, 0.7904096874, -0.5504492928) },
    { 4200, vec(-1.6030497286, 0.9435684906, 0.0014697065) } }, function(case)
    near(case[2], run(case[1]).euler_vector, 0.5e-10*sqrt(3) + 8*known(case[1]), "E(10), E(40), E(4200)")
  end)
  for_each(times, function(t) near(exact(t), run(t).euler_vector, 8*known(t), "E(t)") end)
end)

theorem("Figure 7: |E| is two frequencies that are incommensurate", function()
  for_each(times, function(t)
    near(A*cos(2*pi*f1*t - a) + B*cos(2*pi*f2*t - b), cos(run(t).angle/2), known(t), "cos(theta/2)")
  end)
  -- What refined frequencies shall be good to.
  for_each({ { "f_F", f1, A }, { "drive + f_F", f2, B } }, function(case)
    local line = lines[case[1]]
    near(case[2], line.frequency, 1e-8, case[1] .. ": frequency")
    near(case[3], line.amplitude, 1e-8, case[1] .. ": amplitude")
  end)
end)

theorem("Figure 7: |E| stays between bounds that it comes ever nearer to", function()
  near(0.706988, least, 0.5e-6, "the lower bound")
  near(5.576197, most, 0.5e-6, "the upper bound")
  for_each({ 200, last }, function(window)
    local low, high = range(window)
    holds(low > least and high < most, "all samples are between them, 0.1 apart")
    for _, sign in ipairs { 1, -1 } do
      local t, cosine = nearest(sign, window)
      -- theta is known to 1/sin(theta/2) < 3 of what its cosine is.
      near(2*acos(cosine), run(t).angle, 3*known(t), "the nearest to the " .. (sign > 0 and "lower" or "upper"))
    end
  end)
end)
