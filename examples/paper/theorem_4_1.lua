-- Theorem 4.1 of the paper, the Euler spinor. A body that was turned about n0 by theta0, 0 < theta0 < 2 pi, turns with
-- a constant omega, |omega| = 1, not parallel to n0. With c = omega . n0:
--   theta(t) = 2 acos(a cos(t/2 + b)),  1 - a^2 = (1 - c^2) sin^2(theta0/2),
--   n(t) = p/|p|,  p(t) = e1 cos(t/2 + b) + e2 (1 - a^2)^(-1/2) sin(t/2 + b),
--   theta(t + 2 pi) = 2 pi - theta(t),  n(t + 2 pi) = -n(t),
-- and |n'| is greatest at +-e1 and least at +-e2. Printed are, with k = c/a,
--   b = Cos^-1(cos(theta0/2)/a),  e1 = n0 sqrt(1 - k^2) - u k,  e2 = n0 k + u sqrt(1 - k^2),  0 < |c| < a < 1.
-- Corrected: b = atan2(c sin(theta0/2), cos(theta0/2)), which has the sign of c; sqrt(1 - k^2) has that of
-- cos(theta0/2); 0 <= |c| <= a < 1.

-- The closed form for a start; as_printed leaves b, e1 and e2 as they are in the paper.
local function spinor(omega, n0, theta0, as_printed)
  local c, s, half = dot(omega, n0), norm(cross(omega, n0)), theta0/2        -- s = sqrt(1 - c^2)
  local a, m = sqrt(cos(half)^2 + (c*sin(half))^2), s*sin(half)              -- m = sqrt(1 - a^2)
  local b = as_printed and acos(cos(half)/a) or atan(c*sin(half), cos(half))
  local u1 = (omega - c*n0)/s
  local u = cos(half)*u1 + sin(half)*cross(u1, n0)
  -- sqrt(1 - k^2) with its sign, and without cancellation: in the proof a e2 = c n0 + s cos(theta0/2) u.
  local k, root = c/a, s*cos(half)/a
  if as_printed then root = abs(root) end
  local e1, e2 = root*n0 - k*u, k*n0 + root*u
  return { m = m, e1 = e1, e2 = e2, root = root, to_e1 = (-2*b) % (4*pi),
    angle = function(t) return 2*acos(a*cos(t/2 + b)) end,
    axis = function(t) return unit(cos(t/2 + b)*e1 + sin(t/2 + b)/m*e2) end }
end

-- The measurement: a run that takes omega for a function like any other. It knows the rotation, and so theta, to its
-- estimate (of first order: a quarter more), and n to that over 2 sin(theta/2) >= 2 m. In the closed form t/2 + b, at
-- most 16, is rounded by 9e-16, a and b by 2e-16; theta gets twice that over sin(theta/2) >= m, n that over m.
local function follow(omega, n0, theta0)
  local run = evolve { omega = function() return omega.x, omega.y, omega.z end, from = rotation(n0, theta0), to = 8*pi,
    accuracy = 1e-12 }
  return run, 1.25*run.error_estimate + 4e-15, spinor(omega, n0, theta0), spinor(omega, n0, theta0, true)
end

-- The greatest of a difference at 121 times, or nan, which math.max passes over.
local function worst(difference)
  local greatest = 0
  for i = 0, 120 do
    local found = difference(6*pi*i/120)
    if found ~= found then return found end
    greatest = math.max(greatest, found)
  end
  return greatest
end
local function worst_angle(run, exact) return worst(function(t) return abs(run(t).angle - exact.angle(t)) end) end
local function worst_axis(run, exact) return worst(function(t) return norm(run(t).axis - exact.axis(t)) end) end

-- Starts in all quadrants of (c, theta0) and on their borders; w and v are perpendicular. c = 0, which the printed
-- 0 < |c| leaves out, is the paper's own example.
local w, v = vec(1, -2, 2)/3, vec(2, 2, 1)/3
local quadrants = {}
for _, c in ipairs { 0.6, 0, -0.6 } do
  for _, theta0 in ipairs { 1, c == 0 and 3 or pi, 5 } do table.insert(quadrants, { c = c, theta0 = theta0 }) end
end
local function for_each_quadrant(check)
  for_each(quadrants, function(case) check(case, follow(w, case.c*w + sqrt(1 - case.c^2)*v, case.theta0)) end)
end
local function for_all_starts(check)
  for_all({ omega = any.direction, n0 = any.direction, theta0 = any.number(0.05, 6.2) }, function(case)
    given(norm(cross(case.omega, case.n0)) > 1e-3)
    check(case, follow(case.omega, case.n0, case.theta0))
  end, { n = 40, seed = 41 })
end

theorem("Theorem 4.1, corrected: theta(t) and n(t)", function()
  for _, for_these in ipairs { for_each_quadrant, for_all_starts } do
    for_these(function(_, run, known, exact)
      near(0, worst_angle(run, exact), known/exact.m, "theta(t), 121 times")
      near(0, worst_axis(run, exact), known/exact.m, "n(t), 121 times")
    end)
  end
end)

theorem("as printed: b fails for c < 0, e1 and e2 for theta0 > pi, |c| < a for theta0 = pi, and only there", function()
  for_each_quadrant(function(case, run, known, exact, printed)
    local c, sine, tolerance = case.c, case.c*sin(case.theta0/2), known/exact.m
    -- cos(theta(pi)/2) = -a sin b = -c sin(theta0/2), but with the printed b, in [0, pi], it is -|c| sin(theta0/2).
    local difference = printed.angle(pi) - run(pi).angle
    near(2*asin(abs(sine)) - 2*asin(sine), difference, tolerance, "by this theta(pi) differs")
    holds((difference > tolerance) == (c < 0), "as printed: theta(pi) fails if c < 0, else holds")
    -- Where t/2 + b = 0, n is e1, and pi later e2: the print has another sign of root n0, and of root u.
    for i, e in ipairs { "e1", "e2" } do
      local distance = norm(printed[e] - run(exact.to_e1 + (i - 1)*pi).axis)
      near(abs(exact.root) - exact.root, distance, tolerance, "by this " .. e .. " differs")
      holds((distance > tolerance) == (case.theta0 > pi), "as printed: " .. e .. " fails if theta0 > pi, else holds")
    end
    local a = cos(run(exact.to_e1).angle/2)
    holds(abs(c) <= a + known and a < 1, "|c| <= a < 1, a from the least theta")
    holds((a - abs(c) <= known) == (case.theta0 == pi), "as printed: |c| < a fails at pi, else holds")
  end)
end)

theorem("Theorem 4.1: n(t + 2 pi) = -n(t), the extreme speeds, and the ellipse", function()
  for_all_starts(function(_, run, known, exact)
    local m, t1 = exact.m, exact.to_e1
    near(run(0).rotation, run(2*pi).rotation, 2*known, "after one revolution the body is back")
    local function sum(t) return run(t + 2*pi).angle + run(t).angle end
    near(0, worst(function(t) return abs(sum(t) - 2*pi) end), 2*known, "theta(t + 2 pi) = 2 pi - theta(t)")
    near(0, worst(function(t) return norm(run(t + 2*pi).axis + run(t).axis) end), known/m, "n(t + 2 pi) = -n(t)")
    near(m, sin(run(t1).angle/2), known, "theta at e1: sin(theta/2) = sqrt(1 - a^2)")
    holds(worst(function(t) return m - sin(run(t).angle/2) end) <= known, "it is never less")
    -- By [P5] n' has a factor cot(theta/2)/2: the error of n times 1/m, that of theta times 1/(4 m^2).
    local function speed(t) return norm(run(t).axis_rate) end
    near(1/(2*m), speed(t1), known/m^2, "n is fastest at e1")
    near(m/2, speed(t1 + pi), known/m^2, "slowest at e2")
    holds(worst(function(t) return math.max(speed(t) - 1/(2*m), m/2 - speed(t)) end) <= known/m^2, "none beyond them")
    -- M = n sin(theta/2) is known to half of what the rotation is, e1 and e2 to their rounding over m.
    local function along(e) return function(t) return sin(run(t).angle/2)*dot(run(t).axis, e) end end
    local x, y, z = along(exact.e1), along(exact.e2), along(cross(exact.e1, exact.e2))
    near(0, worst(function(t) return abs(z(t)) end), known/m, "M stays in the plane of e1 and e2")
    near(0, worst(function(t) return abs((x(t)/m)^2 + y(t)^2 - 1) end), 2*known/m^2, "on the ellipse m e1, e2")
  end)
end)

theorem("c = 0, theta0 = pi: theta stays pi, n turns uniformly; omega along n0: n stays", function()
  local run, known = follow(w, v, pi)
  near(0, worst(function(t) return abs(run(t).angle - pi) end), known, "theta = pi, 121 times")
  near(0, worst(function(t) return norm(run(t).axis - cos(t/2)*v - sin(t/2)*cross(w, v)) end), known,
    "n = n0 cos(t/2) + omega x n0 sin(t/2)")
  for_each({ 1, -1 }, function(sign)
    local along = run:from(rotation(sign*w, 1))
    near(0, worst(function(t) return abs(along(t).angle - 1 - sign*t) end), known, "theta = 1 +- t, 121 times")
    near(0, worst(function(t) return abs(2*sin(along(t).angle/2))*norm(along(t).axis - sign*w) end), known,
      "2 sin(theta/2) times n - n0")
    near(4, #along.crossings, 0, "multiples of 2 pi that it passes")
  end)
end)
