-- Corollary 5.4 of the paper: under the hypotheses of Theorem 5.1 there is an Euler vector E(t) = theta n that is
-- continuous for all time, and differentiable, also where theta is a multiple of 2 pi. It solves
--   (7)  E' = omega - {omega |E|^2 - E (omega . E)} (1 - g)/|E|^2 + omega x E/2,  g = (|E|/2) cot(|E|/2),
-- except where |E| is a positive multiple of 2 pi and the right-hand side is not defined. As printed.
-- The paper's other way on, to restart from -E/3 where |E| = 3 pi/2, leads to the same attitudes.

local function right_hand_side(e, w)
  local angle = norm(e)
  local g = angle == 0 and 1 or angle/2/tan(angle/2)
  local factor = angle == 0 and 1/12 or (1 - g)/angle^2
  return w - factor*(angle^2*w - dot(w, e)*e) + cross(w, e)/2
end

-- theta = 2 pi turns + 2 sin^p t and n on a cone are chosen; omega is made of them. At t = 0, pi, 2 pi theta is 2 pi
-- turns: for p = 1 it goes through, for p = 2 it turns back.
local first, last = -1, 7
local function follow(case)
  local s, c, r, p, turns = sin(case.slope), cos(case.slope), case.rate, case.p, case.turns
  local function angle(t) return 2*pi*turns + 2*sin(t)^p end
  local function angle_rate(t) return 2*p*sin(t)^(p - 1)*cos(t) end
  local function axis(t) return vec(s*cos(r*t), s*sin(r*t), c) end
  local function axis_rate(t) return r*s*vec(-sin(r*t), cos(r*t), 0) end
  local function omega(t)
    local swing, rate, x, y = 2*sin(t)^p, angle_rate(t), s*cos(r*t), s*sin(r*t)
    local across, along = 2*r*sin(swing/2)^2, r*sin(swing)
    return (rate - across*c)*x - along*y, (rate - across*c)*y + along*x, rate*c + across*s^2
  end
  local scene = { omega = omega, t = { first, last }, from = rotation(axis(first), angle(first)) }
  local function with(options)
    for key, value in pairs(scene) do options[key] = value end
    return evolve(options)
  end
  return with { accuracy = 1e-12 }, { angle = angle, omega = function(t) return vec(omega(t)) end, with = with,
    e = function(t) return angle(t)*axis(t) end,
    e_rate = function(t) return angle_rate(t)*axis(t) + angle(t)*axis_rate(t) end }
end

local function for_all_motions(check)
  for_all({ slope = any.number(0, pi), rate = any.number(-1, 1), p = any.integer(1, 2), turns = any.integer(-2, 2) },
    function(case)
      local run, exact = follow(case)
      check(run, exact, case)
    end, { n = 20, seed = 54 })
end

-- E from a run that knows the rotation, and so theta, to e, and n to that over 2 sin(theta/2). e is the estimate, a
-- quarter more as it is of first order, and the rounding of omega and of the start.
local function known(run, angle)
  local e = 1.25*run.error_estimate + 1e-14
  return e*(1 + abs(angle)/(2*abs(sin(angle/2))))
end

-- E' by the difference of fourth order: h^4/30 of the fifth derivative, at most 2 (p + 1)^5 + |2 pi turns|, and 1.5/h
-- of what E is off by, the most where theta is nearest to 2 pi k.
local h = 0.01
local function difference(run, exact, t, p)
  local function e(d) return run(t + d).euler_vector end
  local off = 0
  for _, d in ipairs { -2*h, -h, h, 2*h } do off = math.max(off, known(run, exact.angle(t + d))) end
  return (8*(e(h) - e(-h)) - (e(2*h) - e(-2*h)))/(12*h), h^4/30*(2*(p + 1)^5 + 13) + 1.5/h*off
end

print "E' through 2 pi, at t = 0 and pi (slope 0.8, rate 0.7, p = 1, turns = 1):\n"
print "   t      |E|/2 pi   E', by differences              theta' n + theta n'"
do
  local run, exact = follow { slope = 0.8, rate = 0.7, p = 1, turns = 1 }
  for _, t in ipairs { -0.02, 0, 0.02, 1, pi - 0.02, pi, pi + 0.02 } do
    local d, e = difference(run, exact, t, 1), exact.e_rate(t)
    print(("%6.3f %10.6f  %9.6f %9.6f %9.6f  %9.6f %9.6f %9.6f"):format(t, run(t).angle/(2*pi), d.x, d.y, d.z,
      e.x, e.y, e.z))
  end
end
print ""

theorem("Corollary 5.4: E is continuous, and differentiable, through multiples of 2 pi", function()
  for_all_motions(function(run, exact, case)
    near(3, #run.crossings, 0, "how often theta is 2 pi k")
    for i = 0, 40 do
      local t = first + 0.1 + (last - first - 0.2)*i/40
      local e_rate, tolerance = difference(run, exact, t, case.p)
      near(exact.e(t), run(t).euler_vector, known(run, exact.angle(t)), "E(t)")
      near(exact.e_rate(t), e_rate, tolerance, "E'(t), by differences")
    end
    for k, crossing in ipairs(run.crossings) do
      -- Where M is lost in its error t is known to t_error; n, n' and n'' are at most 1, theta' and theta'' at most 4.
      local t = (k - 1)*pi
      local moved = (abs(exact.angle(t)) + 10)*crossing.t_error + 1e-14
      local e_rate, tolerance = difference(run, exact, t, case.p)
      near(exact.e(t), run(t).euler_vector, moved, "E where theta is 2 pi k")
      near(exact.e_rate(t), e_rate, tolerance, "E' there, by differences")
      near(exact.e_rate(t), run(t).euler_rate, moved, "E' there, by Lemma 5.3")
    end
  end)
end)

theorem("Corollary 5.4: E solves (7), except where |E| is a positive multiple of 2 pi", function()
  for_all_motions(function(run, exact, case)
    for i = 0, 40 do
      local t = first + 0.1 + (last - first - 0.2)*i/40
      local angle = exact.angle(t)
      local sine = abs(sin(angle/2))
      -- (7) has a factor cot(|E|/2): it makes |omega| (1 + |E|)/sin^2 of what E is off by, |omega| < 5.
      if sine > 0.1 or case.turns == 0 and sine > 1e-3 then
        local e_rate, tolerance = difference(run, exact, t, case.p)
        local right = right_hand_side(run(t).euler_vector, exact.omega(t))
        near(right, e_rate, tolerance + 5*(1 + abs(angle))/sine^2*known(run, angle), "E' by differences, and (7)")
      end
    end
  end)
end)

theorem("at |E| = 2 pi the right-hand side has no limit: it depends on the way there", function()
  for_each({ -1, 0, 1, 2 }, function(slope)
    -- With n tilted by slope d from omega at |E| = 2 pi + d, what omega has across n is |omega| slope d, and g =
    -- (pi + d/2) cot(d/2) is 2 pi/d + 1 + O(d); the terms of order d are at most 2 pi |omega| (1 + slope^2) d.
    local d, omega = 1e-6, vec(3, 0, 0)
    local e = (2*pi + d)*unit { 1, slope*d, 0 }
    near(vec(3, -2*pi*3*slope, 0), right_hand_side(e, omega), 2*pi*3*(1 + slope^2)*d, "the right-hand side")
  end)
end)

theorem("runs of (7) that restart from -E/3 lead to the same attitudes, through 2 pi k", function()
  for_all_motions(function(run, exact)
    for _, options in ipairs { { method = "dop853", accuracy = 1e-9 }, { method = "rk4", step = 0.02 } } do
      options.equation, options.restart = "euler", true
      local restarted = exact.with(options)
      local tolerance = 1.25*(restarted.error_estimate + run.error_estimate) + 1e-14
      for i = 0, 80 do
        local t = first + (last - first)*i/80
        near(run(t).rotation, restarted(t).rotation, tolerance, "the operator, by " .. options.method)
      end
    end
  end)
end)
