-- Sections 3, 3.1 and 3.2 of the paper: an infinitesimal motion after a rotation leaves a rotation. From (n, theta),
-- omega dt leads to (n + dn, theta + dtheta), with
--   (5)  theta' = omega . n,   n' = (omega - n (omega . n)) cot(theta/2)/2 + omega x n/2,
-- and so F = n f(theta), f odd with f'(0) > 0, to F + dF, with
--   (4)  F' = omega f' - {omega f^2 - F (omega . F)} (f' - f cot(theta/2)/2)/f^2 + omega x F/2.
-- Both hold as printed; what the paper says of (4) as theta -> 0 is in p4_limit.lua. The paper shows them for a
-- single point, r = n, in a picture, and omits the others. Here time is a jet: its derivatives at 0 are exact.

local u = 2^-53  -- one rounding

-- f with its derivative, as functions of an angle.
local representations = {
  { name = "theta", f = function(a) return a end, slope = function() return 1 end },
  { name = "sin(theta/2)", f = function(a) return sin(a/2) end, slope = function(a) return cos(a/2)/2 end },
  { name = "tan(theta/2)", f = function(a) return tan(a/2) end, slope = function(a) return 1/(2*cos(a/2)^2) end },
  { name = "theta + theta^3/5", f = function(a) return a + a^3/5 end, slope = function(a) return 1 + 3*a^2/5 end },
}

local function rates(n, theta, w)
  local along = dot(w, n)
  return along, (w - n*along)/tan(theta/2)/2 + cross(w, n)/2
end

-- The derivative, at h = 0, of a function of h that takes jets.
local function derivative(path) return evolve { omega = path, t = { 0, 0 } }:derivatives(0)[2] end

-- The angle stays away from 2 pi k, where cot(theta/2) is infinite, and from pi, where tan(theta/2) is.
local state = { n = any.direction, theta = any.number(0.3, 2.8), omega = any.direction, r = any.direction }

-- All lengths are 1, cot(theta/2)/2 < 3.4: a rate n' of that size, by some ten roundings, enters three products.
local tolerance = 3*10*3.4*u

theorem("after omega dt every point is where Rot(n + dn, theta + dtheta) has it", function()
  -- (3) for (n + n' h, theta + theta' h), h a jet: its derivative is the velocity that the rotation gives to r.
  local function velocity(n, theta, w, r)
    local theta_rate, n_rate = rates(n, theta, w)
    return derivative(function(h)
      local a = { n.x + n_rate.x*h, n.y + n_rate.y*h, n.z + n_rate.z*h }
      local c, s = cos(theta + theta_rate*h), sin(theta + theta_rate*h)
      local d = (a[1]*r.x + a[2]*r.y + a[3]*r.z)*(1 - c)
      return r.x*c + a[1]*d + (a[2]*r.z - a[3]*r.y)*s, r.y*c + a[2]*d + (a[3]*r.x - a[1]*r.z)*s,
        r.z*c + a[3]*d + (a[1]*r.y - a[2]*r.x)*s
    end)
  end
  for_all(state, function(case)
    local n, theta, w = case.n, case.theta, case.omega
    local R = rotation(n, theta)
    near(cross(w, R*n), velocity(n, theta, w, n), 2*tolerance, "r = n, the paper's point")
    near(cross(w, R*w), velocity(n, theta, w, w), 2*tolerance, "r = omega, which it omits")
    near(cross(w, R*case.r), velocity(n, theta, w, case.r), 2*tolerance, "any r")
  end)
end)

theorem("omega along n turns theta alone; omega across n tilts n alone, as in Figure 4", function()
  for_all(state, function(case)
    local n, theta = case.n, case.theta
    -- A direction is of length 1 to within 2 u: its square to 4 u, and to as much again by the sum of three products.
    local theta_rate, n_rate = rates(n, theta, n)
    near(1, theta_rate, 8*u, "along: theta' = |omega|")
    near(vec(0, 0, 0), n_rate, tolerance, "along: n' = 0")
    local _, w = orthonormal_basis(n)
    local v = cross(w, n)
    theta_rate, n_rate = rates(n, theta, w)
    near(0, theta_rate, 8*u, "across: theta' = 0")
    near(1/(2*sin(theta/2)), norm(n_rate), tolerance, "across: |n'| = |omega|/(2 sin(theta/2))")
    near((w*cos(theta/2) + v*sin(theta/2))/(2*sin(theta/2)), n_rate, tolerance,
      "across: n' half the angle from omega to omega x n")
  end)
end)

theorem("(5) is what rotor says of a body turned by (n, theta)", function()
  for_all(state, function(case)
    local theta_rate, n_rate = rates(case.n, case.theta, case.omega)
    local said = rotation_rates(rotation(case.n, case.theta), case.omega)
    near(theta_rate, said.angle_rate, 8*u, "theta'")
    near(n_rate, said.axis_rate, 2*tolerance, "n'")
  end)
end)

theorem("(4) is what (5) makes of n f(theta)", function()
  for_all(state, function(case)
    local n, theta, w = case.n, case.theta, case.omega
    local theta_rate, n_rate = rates(n, theta, w)
    for _, representation in ipairs(representations) do
      local f, slope = representation.f(theta), representation.slope(theta)
      local F = n*f
      local rate = derivative(function(h)
        local value = representation.f(theta + theta_rate*h)
        return (n.x + n_rate.x*h)*value, (n.y + n_rate.y*h)*value, (n.z + n_rate.z*h)*value
      end)
      local right = w*slope - (w*f^2 - F*dot(w, F))*(slope - f/tan(theta/2)/2)/f^2 + cross(w, F)/2
      -- slope and f are 18 and 8 at most, and f cot(theta/2) no more than they.
      near(right, rate, 10*(2*slope + f)*u + f*tolerance, "f = " .. representation.name)
    end
  end)
end)

theorem("from F = 0: rotations that are small add up, F = f'(0) int omega + O(t^2)", function()
  -- For omega = a + b t the Magnus series is E = int omega - a x b t^3/12 + O(t^5), without an O(t^4), and f(theta) n =
  -- f'(0) E + f'''(0) |E|^2 E/6 + ...: no term of t^2, and the one of t^3 in closed form.
  local a, b = vec(1, -0.5, 0.3), vec(0.2, 1, -0.7)
  local function omega(t) return a.x + b.x*t, a.y + b.y*t, a.z + b.z*t end
  local third = { ["theta"] = 0, ["sin(theta/2)"] = -1/8, ["tan(theta/2)"] = 1/4, ["theta + theta^3/5"] = 6/5 }
  local t = 5e-3
  for _, representation in ipairs(representations) do
    local run = evolve { omega = omega, to = t, equation = "generalized", f = representation.f, method = "dop853",
      accuracy = 1e-14 }
    local first, cubic = representation.slope(0), third[representation.name]
    local function left(h)
      local there = run(h)
      return (representation.f(there.angle)*there.axis - first*(a*h + b*h^2/2))/h^3
    end
    -- left is c0 + c1 t + c2 t^2 + ..., what is measured c0 - c2 t^2/2 (c2 twice, for the rest). With these a and
    -- b, f''' has (|b|^2 a/4 + (a . b) b/2 - |a|^2 a x b/12)/6 in c2, < 0.16; f' has the Magnus terms of t^5, triple
    -- products over 240 and 720, < 0.02; f^(5), 1/2 at most, has |a|^4 a/120, < 0.02.
    -- The run's error, and the rounding of what is subtracted, enter three times, by (2/t)^3.
    local truncated = t^2*(0.16*abs(cubic) + 0.02*first + 0.01)
    local rounded = 3*(2/t)^3*first*(1.25*run.error_estimate + 4*u*t)
    near(cubic*dot(a, a)*a/6 - first*cross(a, b)/12, 2*left(t/2) - left(t), truncated + rounded,
      "the term of t^3, f = " .. representation.name)
  end
end)
