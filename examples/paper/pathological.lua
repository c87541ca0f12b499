-- The pathological example of section 3.2 of the paper: an omega that is continuous, and zero at t = 0, whose rotation
-- has no axis there. For t > 0
--   (6)  omega = 3 t^2 (i sin 1/t + j cos 1/t) + t (-i cos 1/t + j sin 1/t).
-- As printed: int omega = t^3 u, where u = i sin 1/t + j cos 1/t, and n = u + O(t) "spins wildly" as t -> 0. It holds,
-- and more closely: n = u - k t^2/10 + O(t^4), theta = t^3 (1 + t^4/200 + O(t^5)).

local ulp = 2^-52

local function omega(t)
  if t == 0 then return 0, 0, 0 end
  local s, c = sin(1/t), cos(1/t)
  return 3*t^2*s - t*c, 3*t^2*c + t*s, 0
end
local function turning(t) return vec(sin(1/t), cos(1/t), 0) end
local k = vec(0, 0, 1)

-- By (7) E' = omega + omega x E/2 - ..., and omega x int omega = -k t^4 exactly: what E has besides int omega is at
-- first -k t^5/10. To start at t0 from int omega leaves the attitude off by so much for good, for what turns two bodies
-- alike does not change the distance between them.
local t0, t1 = 1e-3, 0.5
local run = evolve {
  omega = omega, t = { t0, t1 }, from = rotation.from_euler_vector(t0^3*turning(t0)), accuracy = 1e-13,
}
local off = t0^5/10 + 1.25*run.error_estimate

-- The rest of E' turns with 1/t, and the integral of t^m sin 1/t is 2 t^(m+2) at most (by parts): omega x (k t^5/10)/2
-- gives t^8/10 and 3 t^9/10, the term of |E|^2 omega/12 gives t^9/6. Over theta = t^3, with what the run is off by:
local function rest(t, error) return t^5/10 + t^6/2 + (error or off)/t^3 end

print "t       theta/t^3     |n - u|       n . k/t^2     turns of u from t to 0.5"
for _, t in ipairs { 0.02, 0.05, 0.1, 0.2, 0.5 } do
  local there = run(t)
  print(("%4.2f  %11.8f  %12.3e  %12.8f  %10.2f"):format(t, there.angle/t^3, norm(there.axis - turning(t)),
    dot(there.axis, k)/t^2, (1/t - 1/t1)/(2*pi)))
end
print ""

theorem("omega is continuous and zero at t = 0, its integral is t^3 u", function()
  near(vec(0, 0, 0), vec(omega(0)), 0, "omega(0)")
  for_each({ 0.001, 0.01, 0.1, 0.5 }, function(t)
    -- Some roundings; 1/t is rounded too, alike on both sides.
    near(sqrt(9*t^4 + t^2), norm(vec(omega(t))), 8*ulp*t, "|omega|, which goes to zero with t")
    local function integral(s) return s^3*sin(1/s), s^3*cos(1/s), 0 end
    local rate = evolve { omega = integral, t = { t, t } }:derivatives(t)[2]
    near(vec(omega(t)), rate, 8*ulp*t, "d/dt (t^3 u)")
    near(-k*t^4, cross(vec(omega(t)), t^3*turning(t)), 8*ulp*t^4, "omega x (t^3 u)")
  end)
end)

theorem("E goes to 0 as t^3: theta/t^3 -> 1", function()
  for_each({ 0.02, 0.05, 0.1, 0.2, 0.5 }, function(t)
    near(1 + t^4/200, run(t).angle/t^3, rest(t), "theta/t^3")
  end)
end)

theorem("n follows u, off by t^2/10 along -k", function()
  for_each({ 0.02, 0.05, 0.1, 0.2, 0.5 }, function(t)
    near(unit(turning(t) - k*t^2/10), run(t).axis, rest(t), "n")
    holds(norm(run(t).axis - turning(t)) < t, "n = u + O(t), as printed")
  end)
end)

theorem("n has no limit: half a turn of 1/t on, it is the opposite", function()
  for_each({ 1, 3, 5, 7 }, function(j)
    local t, later = 1/(2*pi*j), 1/(2*pi*j - pi)
    -- u and -u are gone from the sum, but for t^4/200 of each.
    near(-k*(t^2 + later^2)/10, run(t).axis + run(later).axis, rest(t) + rest(later) + (t^4 + later^4)/200,
      "n(t) + n at half a turn from t")
  end)
end)

theorem("a run that starts at t = 0 has no axis there, and says why; theta and n later are the same", function()
  local from_0 = evolve { omega = omega, to = 0.1, accuracy = 1e-8 }
  local error = 1.25*from_0.error_estimate
  local axis = from_0(0).axis
  holds(axis.x ~= axis.x, "the axis at t = 0 is nan")
  near(0, from_0(0).angle, 0, "theta at t = 0")
  holds(from_0.notes[1]:find("at the start: no derivative of omega is known", 1, true) ~= nil, "run.notes says why")
  for_each({ 0.01, 0.02, 0.05, 0.1 }, function(t)
    near(1 + t^4/200, from_0(t).angle/t^3, rest(t, error), "theta/t^3")
    near(unit(turning(t) - k*t^2/10), from_0(t).axis, rest(t, error), "n")
  end)
end)
