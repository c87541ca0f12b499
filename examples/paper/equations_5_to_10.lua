-- Equations (5) to (10) of the paper, one motion in five representations:
--   (5)   theta' = omega . n,   n' = (omega - n (omega . n)) cot(theta/2)/2 + omega x n/2
--   (7)   E' = omega - {omega |E|^2 - E (omega . E)} (1 - g)/|E|^2 + omega x E/2,   g = (theta/2) cot(theta/2)
--   (8)   M' = omega cos(theta/2)/2 + omega x M/2
--   (9)   M' = omega M0/2 + omega x M/2,   M0' = -omega . M/2
--   (10)  G' = omega/2 + G (omega . G)/2 + omega x G/2,
-- for E = n theta, M = n sin(theta/2), M0 = cos(theta/2), G = n tan(theta/2). They hold as printed (of (8), the paper
-- says itself that the sign of the cosine is not in M beyond theta = pi). (6) is an example: pathological.lua.

local u = 2^-53  -- one rounding

theorem("(7) to (10) are (5) in other words", function()
  for_all({ n = any.direction, theta = any.number(0.2, 2.9), omega = any.direction }, function(case)
    local n, theta, w = case.n, case.theta, case.omega
    local c, s = cos(theta/2), sin(theta/2)
    local theta_rate = dot(w, n)
    local n_rate = (w - n*theta_rate)*(c/s)/2 + cross(w, n)/2
    -- What n f(theta) does, by the rule of products. All is of size 1 but n' (5 at most), f and f' (14 and 96 for tan);
    -- some ten roundings in each of three terms.
    local function expected(f, slope) return n_rate*f + n*slope*theta_rate end
    local function tolerance(f, slope) return 3*10*u*(5*f + slope) end
    local E, M, G = n*theta, n*s, n*(s/c)
    near(expected(theta, 1), w - (w*theta^2 - E*dot(w, E))*(1 - theta/2*c/s)/theta^2 + cross(w, E)/2,
      tolerance(theta, 1), "E', (7)")
    near(expected(s, c/2), w*c/2 + cross(w, M)/2, tolerance(s, c/2), "M', (8) and (9)")
    near(-s/2*theta_rate, -dot(w, M)/2, tolerance(s, 0), "M0', (9)")
    near(expected(s/c, 1/(2*c^2)), w/2 + G*dot(w, G)/2 + cross(w, G)/2, tolerance(s/c, 1/(2*c^2)), "G', (10)")
    -- And as rotor has them for a state, which it makes of a run.
    local state = evolve { omega = w, from = rotation(n, theta), to = 1 }(0)
    near(theta_rate, state.angle_rate, tolerance(0, 1), "theta', the state's")
    near(n_rate, state.axis_rate, tolerance(1, 0), "n', the state's")
    near(expected(theta, 1), state.euler_rate, tolerance(theta, 1), "E', the state's")
  end)
end)

-- Each by a Runge-Kutta method of order 8 from the same start, and (9) by Fer factors too. ---------------------------

local start = rotation({ 1, 2, -1 }, 1.2)
local omegas = {
  { name = "constant", omega = { 0.3, -0.4, 0.5 } },
  { name = "turning (15)", omega = function(t) return cos(2*t), sin(2*t), 0 end },
  { name = "two waves", omega = function(t) return 0.7*sin(3*t), cos(1.3*t), -0.4*cos(5*t) end },
  { name = "a burst", omega = function(t) return 3*exp(-8*(t - 1)^2), 0.2, t/2 end },
}
local equations = {
  { name = "axis_angle", of = "(5)" }, { name = "euler", of = "(7)" }, { name = "modified_gibbs", of = "(8)" },
  { name = "quaternion", of = "(9)" }, { name = "gibbs", of = "(10)" },
}
local times = { 0.1, 0.7, 1.0, 1.3, 2.0 }

local function follow(omega, equation, method, to)
  return evolve { omega = omega, from = start, to = to or 2, accuracy = 1e-12, equation = equation, method = method }
end

-- What two runs know of the rotation, to first order: a quarter more. Each state is rounded besides.
local function tolerance(a, b) return 1.25*(a.error_estimate + b.error_estimate) + 8*u end

print "theta(2) by  (5)          (7)          (8)          (9)          (10)"
for _, case in ipairs(omegas) do
  local line = { ("%-12s"):format(case.name) }
  for _, equation in ipairs(equations) do
    line[#line + 1] = ("%.10f"):format(follow(case.omega, equation.name, "dop853")(2).angle)
  end
  print(table.concat(line, " "))
end
print ""

theorem("each leads to the same rotation, axis and angle at all times", function()
  for_each(omegas, function(case)
    local fer = follow(case.omega, "quaternion", case.name == "constant" and "exact" or "fgl")
    for _, equation in ipairs(equations) do
      local run = follow(case.omega, equation.name, "dop853")
      for _, t in ipairs(times) do
        local one, other, off = fer(t), run(t), tolerance(fer, run)
        near(one.rotation, other.rotation, off, "the rotation, by " .. equation.of)
        near(one.angle, other.angle, off, "theta, by " .. equation.of)
        -- A rotation's axis is as good as the rotation, over 2 sin(theta/2).
        near(one.axis, other.axis, off/(2*sin(one.angle/2)), "n, by " .. equation.of)
      end
    end
  end)
end)

theorem("(9) keeps its norm, (8) goes on beyond theta = pi with the sign of cos(theta/2)", function()
  local run = follow({ 1, 2, -1 }, "modified_gibbs", "dop853", 2)
  for_each({ 0.5, 1, 1.5, 2 }, function(t)
    near(1.2 + sqrt(6)*t, run(t).angle, 1.25*run.error_estimate + 8*4*u, "theta, about the axis of the start")
    near(1, run(t).quaternion:norm(), 4*u, "|(M0, M)|")
  end)
end)

theorem("where they end: (10) at theta = pi, (5) and (7) at 2 pi, (9) nowhere", function()
  -- Along the start's axis theta = 1.2 + sqrt 6 t. Steps shrink with what is left of the way to the singularity, until
  -- that is some hundred roundings of theta: there each run must end, by what it knows.
  for_each({ { "gibbs", pi }, { "axis_angle", 2*pi }, { "euler", 2*pi } }, function(case)
    local ended, stop = pcall(follow, { 1, 2, -1 }, case[1], "dop853", 5)
    holds(not ended and stop.reason == "singularity", case[1] .. " ends in a singularity")
    near(case[2], 1.2 + sqrt(6)*stop.t, 1.25*stop.run.error_estimate + 400*u*case[2], case[1] .. ": theta there")
  end)
  local run = follow({ 1, 2, -1 }, "quaternion", "dop853", 5)
  near(1.2 + sqrt(6)*5, run(5).angle, 1.25*run.error_estimate + 16*u, "(9): theta at t = 5")
end)
