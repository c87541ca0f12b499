-- Section 6.3 of the paper asks for omega = (cos alpha t, sin alpha t, 0), T = 2 pi/alpha, whose response frequencies
-- are commensurate with it: "Our experiments with this have all led to incommensurate response frequencies". They are
-- (Omega -+ alpha)/4 pi, Omega = sqrt(1 + alpha^2), and Omega/alpha = p/q exactly for
--   alpha = q/sqrt(p^2 - q^2),  p > q >= 1 without a common divisor.
-- In a period the quaternion goes on by (p + q)/(2 q) turns. So the attitude comes back after q T, from any start, with
-- q points in the strobe; E and the quaternion do then too if p + q is even, else after 2 q T. alpha = 3/4 (p = 5,
-- q = 3) has the period 8 pi and three points. The paper's own are none: for T = 40 alpha^2 = (pi/20)^2 is irrational,
-- for T = pi Omega/alpha = sqrt(5)/2. But T = 40 is 0.0012 from p = 58, q = 9, where E is back after 18 T = 720: hence
-- the clumps of its strobe (figure3.lua).
--
--   rotor examples/paper/commensurate.lua                         near the paper's alpha = pi/20
--   rotor examples/paper/commensurate.lua 0.157 50                near 0.157, with p up to 50 (default 100)
--   rotor examples/paper/commensurate.lua 0.157 50 closed.csv     also writes that table, and E over the 8 pi of
--                                                                 alpha = 3/4 to closed_e.csv

local function alpha_of(p, q) return q/sqrt((p - q)*(p + q)) end

local start = rotation({ 1, 1, 1 }, 1)
local function follow(alpha, periods)
  return evolve { omega = function(t) return cos(alpha*t), sin(alpha*t), 0 end, from = start,
    to = periods*2*pi/alpha, accuracy = 1e-12 }
end

local function periods_of(p, q) return (p + q) % 2 == 0 and q or 2*q end

local near_wish = commensurate(tonumber(arg[1]) or arg[1] or pi/20, { most = tonumber(arg[2]) or arg[2] })
print "Near the wish, ever nearer:\n"
print(near_wish)

print "\nalpha = 3/4: E, and its strobe of three points\n"
local closed = follow(3/4, 3)
closed:strobe(0.02):plot("euler_vector_x", "euler_vector_y", { height = 16 })
print ""
closed:strobe(8*pi/3):table { "euler_vector", "angle" }

print ""
print(closed:strobe(8*pi/3))

if arg[3] then
  local name = arg[3]:gsub("%.csv$", "")
  near_wish:csv(name .. ".csv")
  closed:csv(name .. "_e.csv", { every = 0.02, columns = { "t", "euler_vector" } })
end

print "\nRecognised in four periods\n"
print "  alpha                       attitude      E"
for _, case in ipairs { { "3/4", 3/4 }, { "1/sqrt(3)", 1/sqrt(3) }, { "1/sqrt(8)", 1/sqrt(8) },
  { "pi/20, T = 40", pi/20 }, { "2, T = pi", 2 } } do
  local strobe = follow(case[2], 4):strobe(2*pi/case[2])
  print(("  %-15s %12.9f   %s"):format(case[1], case[2], strobe.orbit_period
    and ("%d T   %4d T"):format(strobe.attitude_period, strobe.orbit_period) or "no period"))
end
print ""

local cases = { { 5, 3 }, { 2, 1 }, { 3, 1 }, { 3, 2 }, { 4, 1 }, { 7, 5 }, { 8, 3 }, { 13, 12 }, { 20, 19 } }

theorem("alpha = q/sqrt(p^2 - q^2): what repeats after q T and 2 q T, and nothing before", function()
  for_each(cases, function(case)
    local p, q = table.unpack(case)
    local alpha, periods = alpha_of(p, q), periods_of(p, q)
    local run = follow(alpha, 4*q)
    local T = 2*pi/alpha
    local strobe = run:strobe(T)
    -- Two states, each known to the estimate, of first order: a quarter more. Their t, up to 186, are rounded by
    -- 1.4e-14 each; alpha and T by 3e-14 over the 47 between them. E = n theta is worse by theta/(2 sin(theta/2)).
    local known = 2*1.25*run.error_estimate + 6e-14
    near(q/p, alpha/sqrt(1 + alpha^2), 3e-16, "alpha/Omega = q/p")
    local least = math.huge
    for i = 1, #strobe do least = math.min(least, 2*abs(sin(strobe[i].angle/2))) end
    for i = 1, 2*q do
      local one = strobe[i]
      near(one.rotation, strobe[i + q].rotation, known, "the attitude after q T")
      near((-1)^(p + q)*one.quaternion, strobe[i + q].quaternion, known, "the quaternion: (-1)^(p + q) of it")
      near(one.euler_vector, strobe[i + periods].euler_vector, known*(1 + 2*pi/least), "E after q T or 2 q T")
    end
    -- The attitudes are 2 pi/q apart along their circle, the quaternions 2 pi over the periods of E.
    local nearest_attitude, nearest_quaternion = math.huge, math.huge
    for i = 2, periods do
      if i <= q then nearest_attitude = math.min(nearest_attitude, strobe[1].rotation:distance(strobe[i].rotation)) end
      nearest_quaternion = math.min(nearest_quaternion, (strobe[1].quaternion - strobe[i].quaternion):norm())
    end
    if q > 1 then near(2*pi/q, nearest_attitude, known, "the nearest attitude before q T") end
    if periods > 1 then near(2*sin(pi/periods), nearest_quaternion, known, "the nearest quaternion before") end
  end)
end)

theorem("alpha = 3/4: the period 8 pi, three points; alpha = 1/sqrt(3): 2 pi sqrt(3) and 4 pi sqrt(3)", function()
  local third = follow(1/sqrt(3), 3)
  -- As above.
  local known = 2*1.25*math.max(closed.error_estimate, third.error_estimate) + 6e-14
  for_all({ start = any.rotation }, function(case)
    local run = closed:from(case.start)
    near(run(0).quaternion, run(8*pi).quaternion, known, "alpha = 3/4: the quaternion at 8 pi, from any start")
    run = third:from(case.start)
    near(case.start, run(2*pi*sqrt(3)).rotation, known, "alpha = 1/sqrt(3): the attitude at 2 pi sqrt(3)")
    near(-run(0).quaternion, run(2*pi*sqrt(3)).quaternion, known, "the quaternion is its opposite there")
    near(run(0).quaternion, run(4*pi*sqrt(3)).quaternion, known, "and itself at 4 pi sqrt(3)")
  end, { n = 20, seed = 45 })
  near(3, closed:strobe(8*pi/3).orbit_period, 0, "points of alpha = 3/4")
end)

theorem("periodic orbits are recognised, by the rotation number (p + q)/(2 q)", function()
  for_each(cases, function(case)
    local p, q = table.unpack(case)
    local alpha = alpha_of(p, q)
    local strobe = follow(alpha, 4):strobe(2*pi/alpha)
    near(periods_of(p, q), strobe.orbit_period, 0, "periods of E")
    near(q, strobe.attitude_period, 0, "of the attitude")
  end)
  for _, alpha in ipairs { pi/20, 2 } do
    holds(follow(alpha, 4):strobe(2*pi/alpha).orbit_period == nil, "the paper's T = 40 and T = pi have none")
  end
end)

theorem("the nearest alpha with p up to a bound", function()
  for_all({ wish = any.number(0.02, 5), most = any.integer(2, 40) }, function(case)
    local list = commensurate(case.wish, { most = case.most })
    local p, q = list[#list].p, list[#list].q
    local nearest = math.huge
    for any_p = 2, case.most do
      for any_q = 1, any_p - 1 do nearest = math.min(nearest, abs(any_q/sqrt(any_p^2 - any_q^2) - case.wish)) end
    end
    -- alpha, 6.2 at most, is rounded by 1e-15 in either form, and so is the difference.
    near(nearest, abs(alpha_of(p, q) - case.wish), 4e-15, "as near as any")
    holds(p <= case.most and 1 <= q and q < p, "1 <= q < p <= the bound")
    local divisors = 0
    for divisor = 2, q do divisors = divisors + (p % divisor == 0 and q % divisor == 0 and 1 or 0) end
    near(0, divisors, 0, "no common divisor")
  end)
  local list = commensurate(0.76, { most = 10 })
  near({ 5, 3 }, { list[#list].p, list[#list].q }, 0, "near 0.76, up to 10: 3/4")
  list = commensurate(pi/20)
  near({ 58, 9 }, { list[#list].p, list[#list].q }, 0, "near the paper's pi/20, up to 100")
  -- From there rho = (Omega/alpha + 1)/2 is off by |alpha - pi/20|/(2 alpha^2) at most; 18 of it from whole turns by 18
  -- times that.
  local off = abs(alpha_of(58, 9) - pi/20)
  local rho = follow(pi/20, 4):strobe(40).rotation_number
  near(0, (18*rho + 1/2) % 1 - 1/2, 18*off/(2*alpha_of(58, 9)^2), "for T = 40, turns of E in 18 T")
end)
