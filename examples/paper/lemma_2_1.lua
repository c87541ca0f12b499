-- Lemma 2.1 of the paper, existence of angular velocity: for any motion of a rigid body about a fixed point there is
-- one vector omega(t), and only one, such that for every point of the body
--   (1)  r' = omega x r.
-- It holds as printed. The motions here are given in other ways than by their omega: as products of turns, whose
-- velocities jets give exactly, and as paths of points, of which only positions are read.

local u = 2^-53  -- one rounding

-- r turned about n by theta, any of which may be jets.
local function turned(n, theta, r)
  local c, s = cos(theta), sin(theta)
  local d = (n[1]*r[1] + n[2]*r[2] + n[3]*r[3])*(1 - c)
  return { r[1]*c + n[1]*d + (n[2]*r[3] - n[3]*r[2])*s, r[2]*c + n[2]*d + (n[3]*r[1] - n[1]*r[3])*s,
    r[3]*c + n[3]*d + (n[1]*r[2] - n[2]*r[1])*s }
end

-- Value and first derivative at t of a path: a function of t that takes jets.
local function position_and_velocity(path, t)
  local derivatives = evolve { omega = path, t = { t, t } }:derivatives(t)
  return derivatives[1], derivatives[2]
end

-- The omega of a body whose orthonormal axes r[i] move at v[i]: the sum of r x (omega x r) over them is 2 omega.
local function omega_of_axes(r, v)
  return (cross(r[1], v[1]) + cross(r[2], v[2]) + cross(r[3], v[3]))/2
end

local body_axes = { vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1) }

theorem("existence: a product of three turns, about any axes at any rates", function()
  local motion = { n1 = any.direction, n2 = any.direction, n3 = any.direction, a = any.number(-3, 3),
    b = any.number(-3, 3), c = any.number(-3, 3), t = any.number(-1, 1) }
  for_all(motion, function(m)
    local function path(r)
      return function(t)
        return turned(m.n1, m.a*t, turned(m.n2, 1 + m.b*t^2, turned(m.n3, m.c*t - 2, r)))
      end
    end
    local r, v = {}, {}
    for i, axis in ipairs(body_axes) do r[i], v[i] = position_and_velocity(path(axis), m.t) end
    -- Each turn adds its rate about its axis, as the turns after it have carried that.
    local Q1, Q2 = rotation(m.n1, m.a*m.t), rotation(m.n2, 1 + m.b*m.t^2)
    local predicted = m.a*m.n1 + 2*m.b*m.t*(Q1*m.n2) + m.c*(Q1*(Q2*m.n3))
    local omega = omega_of_axes(r, v)
    -- A turn is some ten roundings, of its angle (up to 5) and of products of what is 1 at most; all of them are
    -- multiplied by rates that sum to 12 at most. The sum of three cross products is twice omega: 3/2 of an error.
    local tolerance = 1.5*3*(10 + 5)*12*u
    near(predicted, omega, tolerance, "omega of the three axes")
    -- Nine equations for three unknowns: what is left over is the claim.
    for i = 1, 3 do near(cross(omega, r[i]), v[i], 2*tolerance, "omega x r = r', body axis " .. i) end
  end)
end)

theorem("existence: from the positions of a body's points, by differences", function()
  local function omega(t) return cos(t), sin(2*t), 0.5*t end
  local points = { vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1), vec(0.3, -0.5, 0.8) }
  local run = evolve { omega = omega, from = rotation({ 1, 2, 3 }, 1), to = 5, accuracy = 1e-12, points = points }
  -- The difference of fourth order: h^4/30 of the fifth derivative of r, and 3/2 of the error of a position, over h;
  -- the estimate is of first order: a quarter more. Here |omega| < 2.9 and its derivatives are below 2.3, 4.1, 8.1 and
  -- 16; differentiating omega x r bounds those of r one by one: 2.9, 10.7, 48.4, 258, 1.6e3.
  local h = 5e-4
  local off = h^4/30*1.6e3 + 1.5/h*(1.25*run.error_estimate + u)
  for_each({ 0.5, 1.5, 2.5, 3.5, 4.5 }, function(t)
    local here, r, v = run(t).points, {}, {}
    for i = 1, #points do
      local function difference(d) return run(t + d).points[i] - run(t - d).points[i] end
      r[i], v[i] = here[i], (8*difference(h) - difference(2*h))/(12*h)
    end
    local measured = omega_of_axes(r, v)
    -- A component adds four of the products r v, and halves them.
    near(vec(omega(t)), measured, 2*off, "omega")
    near(cross(measured, r[4]), v[4], 2*2*norm(r[4])*off + off, "omega x r = r' for a fourth point")
  end)
end)

theorem("uniqueness: another omega moves one point of two otherwise", function()
  -- Of points at unit distance, an angle phi apart as seen from the fixed one, omega + d takes the velocities by
  -- d x r elsewhere: |d x r1|^2 + |d x r2|^2 is (1 - |cos phi|) |d|^2 at least, and so much along the line that
  -- halves the (acute) angle between the lines of the two points. Cross products of unit vectors: 4 u, twice, squared.
  for_all({ r1 = any.direction, r2 = any.direction, d = any.direction }, function(case)
    local r1, r2 = case.r1, case.r2
    local function moved(d) return norm(cross(d, r1))^2 + norm(cross(d, r2))^2 end
    local least = 1 - abs(dot(r1, r2))
    holds(moved(case.d) >= least - 16*u, "it is moved by (1 - |cos phi|) |d|^2 or more")
    local halving = unit(dot(r1, r2) < 0 and r1 - r2 or r1 + r2)
    near(least, moved(halving), 16*u, "the least, along the line that halves phi")
  end)
  -- Why the paper asks for three points that are not on a line (here with the fixed point as one of them).
  local omega, r = vec(1, -2, 0.5), vec(2, 4, -4)
  near(cross(omega, r), cross(omega + r/4, r), 0, "points on one line: omega + r/4 does as well")
end)
