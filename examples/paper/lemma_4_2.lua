-- Lemma 4.2 of the paper, the change of time. Where |omega(t)| > 0 let tau(t) be the integral of |omega| from t0 to t:
-- E as a function of tau then satisfies [P7] with omega/|omega| in place of omega. The magnitude of omega tells when
-- the body is somewhere, not where it goes. If omega has a fixed direction, that one scalar integral is the whole
-- solution, and Theorem 4.1 holds in tau. As printed.

-- A magnitude whose integral is known with its inverse, for 0 <= t <= 5.
local last = 5
local function magnitude(t) return 1 + t end
local function tau(t) return t + t^2/2 end
local function time(s) return 2*s/(1 + sqrt(1 + 2*s)) end

-- Two runs agree to the sum of their estimates, which are of first order: a quarter more. tau, up to 17.5, and the
-- angles made of it are rounded by 2e-15 each; t by 4e-16 twice, while the body turns by 6 of that. What is rounded in
-- the hundreds of calls of omega averages out.
local function known(first, second) return 1.25*(first.error_estimate + second.error_estimate) + 1e-14 end

-- The greatest of a difference at 101 times, or nan, which math.max passes over.
local function worst(difference)
  local greatest = 0
  for i = 0, 100 do
    local found = difference(last*i/100)
    if found ~= found then return found end
    greatest = math.max(greatest, found)
  end
  return greatest
end

-- theta is as well known as the rotation, n worse by 1/(2 sin(theta/2)).
local function agree(first, second, tolerance, what)
  near(0, worst(function(t) return abs(first(t).angle - second(tau(t)).angle) end), tolerance, "theta: " .. what)
  near(0, worst(function(t)
    return 2*abs(sin(first(t).angle/2))*norm(first(t).axis - second(tau(t)).axis)
  end), tolerance, "2 sin(theta/2) n: " .. what)
end

theorem("Lemma 4.2: E(t) is the E of omega/|omega| at tau(t)", function()
  local function direction(t) return cos(t)*cos(3*t), cos(t)*sin(3*t), sin(t) end
  local function omega(t)
    local x, y, z = direction(t)
    return magnitude(t)*x, magnitude(t)*y, magnitude(t)*z
  end
  local in_t = evolve { omega = omega, to = last, accuracy = 1e-12 }
  local in_tau = evolve { omega = function(s) return direction(time(s)) end, to = tau(last), accuracy = 1e-12 }
  for_all({ start = any.rotation }, function(case)
    agree(in_t:from(case.start), in_tau:from(case.start), known(in_t, in_tau), "101 times")
  end, { n = 20, seed = 42 })
end)

-- A fixed direction: the model with one integral, any function, and the constant omega in tau.
local axis, start = vec(2, 3, 6)/7, rotation({ 1, 0, 0 }, 2)
local function omega(t)
  local w = magnitude(t)*axis
  return w.x, w.y, w.z
end
local along = evolve { omega = spin.along(axis, magnitude), from = start, to = last, accuracy = 1e-12 }
local scripted = evolve { omega = omega, from = start, to = last, accuracy = 1e-12 }
local constant = evolve { omega = axis, from = start, to = tau(last) }

print(along)
print ""
print "t        tau        theta, one integral   any function   constant at tau"
for t = 0, last do
  print(("%d  %10.6f  %20.12f %14.12f %17.12f"):format(t, tau(t), along(t).angle, scripted(t).angle,
    constant(tau(t)).angle))
end
print ""

theorem("a fixed direction: one integral, any function and the constant omega at tau(t) agree", function()
  agree(along, constant, known(along, constant), "one integral")
  agree(scripted, constant, known(scripted, constant), "any function")
  near(0, worst(function(t) return along(t).rotation:distance(rotation(axis, tau(t))*start) end),
    known(along, constant), "and so does a turn by tau(t) after the start")
end)

theorem("Theorem 4.1 in tau: when tau has grown by 2 pi, n is reversed", function()
  -- sin(theta/2) is |axis x n0| sin(theta0/2) at least.
  local least, tolerance = norm(cross(axis, start.axis))*sin(start.angle/2), known(along, along)
  for_all({ t = any.number(0, time(tau(last) - 2*pi)) }, function(case)
    local before, after = along(case.t), along(time(tau(case.t) + 2*pi))
    near(2*pi - before.angle, after.angle, tolerance, "theta is 2 pi - theta")
    near(-before.axis, after.axis, tolerance/(2*least), "n is -n")
  end, { n = 60, seed = 42 })
end)

theorem("the hypothesis |omega| > 0: where omega turns back, tau must count backward", function()
  local turned = evolve { omega = spin.along(axis, cos), from = start, to = pi, accuracy = 1e-12 }
  local tolerance = known(turned, turned)
  -- At pi the integral of |cos t| is 2, that of cos t is 0.
  near(2, turned(pi).rotation:distance(rotation(axis, 2)*start), tolerance, "the integral of |omega| is off by")
  near(0, turned(pi).rotation:distance(start), tolerance, "the integral with its sign is not")
end)
