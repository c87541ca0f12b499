-- Theorem 3.2 of the paper, which yields Euler's theorem from infinitesimal motions alone: let E solve
--   (7)  E' = omega - {omega |E|^2 - E (omega . E)} (1 - g)/|E|^2 + omega x E/2,   g = (|E|/2) cot(|E|/2),
-- away from |E| = 2 pi k, k > 0, or (M0, M), of norm 1,
--   (9)  M' = omega M0/2 + omega x M/2,   M0' = -omega . M/2.
-- If the position of the body is Rot(n, theta) at the start, theta = |E| and n = E/theta, or theta = 2 acos M0 by any
-- branch and n = M/sin(theta/2), then it is Rot(n, theta) later. After it: where |E| = 3 pi/2, go on from -E/3.
-- Theorem and rule hold as printed. What they are held against is (1), r' = omega x r for each point of the body, and a
-- closed form.

local u = 2^-53  -- one rounding
local start = rotation({ 1, 1, 1 }, 1)

-- The paper's turning omega (15), and two more. Until t = 3 theta stays below 2 pi.
local alpha = 2*pi/5
local omegas = {
  { name = "(15), T = 5", omega = function(t) return cos(alpha*t), sin(alpha*t), 0 end },
  { name = "a chirp", omega = function(t) return sin(t*t), 0.5*cos(3*t), 0.8 end },
  { name = "one that vanishes at t = 1", omega = function(t) return (t - 1)*exp(-t), 2*(t - 1)^3, 0 end },
}

-- Every run says how well it knows the rotation, to first order: a quarter more for what that leaves out. A distance of
-- two operators is itself rounded to some 4 u.
local function tolerance(...)
  local sum = 4*u
  for _, run in ipairs { ... } do sum = sum + 1.25*run.error_estimate end
  return sum
end

local function follow(omega, options)
  local scene = { omega = omega, from = start, to = 3, accuracy = 1e-12, method = "dop853" }
  for key, value in pairs(options) do scene[key] = value end
  return evolve(scene)
end

local times = { 0.3, 0.9, 1, 1.1, 1.7, 2.4, 3 }

theorem("(7), (9) and (4) with f's own lead every point where r' = omega x r does", function()
  for_each(omegas, function(case)
    local points = follow(case.omega, { equation = "body_points" })
    for _, way in ipairs {
      { "E of (7)", { equation = "euler" } },
      { "(M0, M) of (9)", { method = "fgl" } },
      { "F of (4), f = 2 sinh theta", { equation = "generalized", f = function(a) return exp(a) - exp(-a) end } },
      { "F of (4), f = tan(theta/4)", { equation = "generalized", f = function(a) return tan(a/4) end } },
    } do
      local run = follow(case.omega, way[2])
      for _, t in ipairs(times) do near(points(t).rotation, run(t).rotation, tolerance(points, run), way[1]) end
    end
  end)
end)

theorem("the closed form of (15): exp(k alpha t/2) exp((i - alpha k) t/2) Q0", function()
  -- In the frame that turns with omega the rest of the motion has a constant one. Two products of rotations: 2e-15.
  for _, equation in ipairs { "euler", "body_points" } do
    local run = follow(omegas[1].omega, { equation = equation })
    for_each(times, function(t)
      local turned = rotation({ 0, 0, 1 }, alpha*t)*rotation({ 1, 0, -alpha }, sqrt(1 + alpha^2)*t)*start
      near(turned, run(t).rotation, tolerance(run) + 2e-15, 'equation = "' .. equation .. '"')
    end)
  end
end)

theorem("through E = 0, the case that the proof treats apart", function()
  -- Backward from the identity, so that forward the body comes through it; omega does not vanish there, then does.
  for_each({ omegas[1], omegas[3] }, function(case)
    local before = evolve { omega = case.omega, t = { 1, 0 }, accuracy = 1e-13 }
    local run = follow(case.omega, { equation = "euler", from = before(0).rotation, accuracy = 1e-13 })
    local points = follow(case.omega, { equation = "body_points", from = before(0).rotation, accuracy = 1e-13 })
    near(rotation.identity, run(1).rotation, tolerance(run, before), "it is there at t = 1")
    for _, t in ipairs(times) do
      near(points(t).rotation, run(t).rotation, tolerance(points, run), "E of (7)")
    end
  end)
end)

theorem("2 acos M0 by any branch: the same operator", function()
  local run = follow(omegas[1].omega, {})
  for_each(times, function(t)
    local q = run(t).quaternion
    local M = vec(q.x, q.y, q.z)
    for k = -1, 1 do
      for _, sign in ipairs { 1, -1 } do
        local theta = 2*(sign*acos(q.w) + 2*pi*k)
        -- acos loses 1/sin(theta/2) = 1/|M| of the rounding of M0; 4 pi has its own.
        near(run(t).rotation, rotation(M/sin(theta/2), theta), (4/norm(M) + 16)*u, "2 (+-acos M0 + 2 pi k)")
      end
    end
  end)
end)

-- Restarts ----------------------------------------------------------------------------------------------------------

-- One that winds, and one of fixed direction that the start is along: theta goes through 2 pi three times.
local direction = vec(1, 1, 1)/sqrt(3)
local windings = {
  { name = "winding", omega = function(t) return 0.3*sin(t), 0.2*cos(2*t), 1.5 + 0.5*sin(0.7*t) end },
  { name = "along the start", omega = function(t) return direction*(1 + 0.4*cos(t)) end },
}

theorem("-E/3 is the operator of E where |E| = 3 pi/2, and E (1 - 2 pi/|E|) anywhere", function()
  for_all({ n = any.direction, theta = any.number(0.1, 20) }, function(case)
    -- Half an ulp of an angle of 16 or more is 16 u: E rounds, its length twice, and what becomes of it.
    local E, F = case.n*(3*pi/2), case.n*case.theta
    near(rotation.from_euler_vector(E), rotation.from_euler_vector(-E/3), 4*16*u, "-E/3")
    near(rotation.from_euler_vector(F), rotation.from_euler_vector(F*(1 - 2*pi/norm(F))), 4*16*u, "E (1 - 2 pi/|E|)")
  end)
end)

theorem("with the rule (7) goes on past 2 pi, forward and backward", function()
  for_each(windings, function(case)
    for _, way in ipairs { 20, -20 } do
      local restarted = follow(case.omega, { equation = "euler", restart = true, to = way })
      local continuous = follow(case.omega, { method = "fgl", to = way })
      for i = 1, 40 do
        local t = way*i/40
        near(continuous(t).rotation, restarted(t).rotation, tolerance(continuous, restarted), "the operator of (9)")
        -- The run counts turns, which the restarts forget. theta is as good as the rotation.
        near(continuous(t).angle, restarted(t).angle, tolerance(continuous, restarted) + 16*u, "theta, continuous")
      end
    end
  end)
end)

theorem("without it (7) ends where |E| = 2 pi", function()
  -- omega is along the start: theta is 1 and the integral of its length. The run must not end before, by what it knows.
  local ended, stop = pcall(follow, windings[2].omega, { equation = "euler", to = 20 })
  holds(not ended and stop.reason == "singularity", "it ends in a singularity")
  near(2*pi, 1 + stop.t + 0.4*sin(stop.t), tolerance(stop.run), "theta there")
end)
