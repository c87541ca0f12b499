-- Rodrigues's composition of two rotations, as the proof of Theorem 4.1 of the paper states it: for R3 = R2 R1 (R1
-- first), Ri about Ai by alpha_i,
--   (11)  cos(alpha3/2) = cos(alpha2/2) cos(alpha1/2) - A2 . A1 sin(alpha2/2) sin(alpha1/2)
--   (12)  A3 sin(alpha3/2) = A2 sin(alpha2/2) cos(alpha1/2) + A1 cos(alpha2/2) sin(alpha1/2)
--                            + A2 x A1 sin(alpha2/2) sin(alpha1/2).
-- Both hold as printed, for angles of any size; they give alpha3 in [0, 2 pi]. The construction on the sphere that they
-- come from is in examples/notes/09_rodrigues.lua.

local u = 2^-53  -- one rounding

-- The right sides of (11) and (12).
local function composed(A2, alpha2, A1, alpha1)
  local c1, s1, c2, s2 = cos(alpha1/2), sin(alpha1/2), cos(alpha2/2), sin(alpha2/2)
  return c2*c1 - dot(A2, A1)*s2*s1, A2*(s2*c1) + A1*(c2*s1) + cross(A2, A1)*(s2*s1)
end

-- Three terms of five roundings each, of 1 at most, twice: by (11) and (12) and by what they are held against.
local tolerance = 2*3*5*u

local two = { A1 = any.direction, alpha1 = any.number(-7, 7), A2 = any.direction, alpha2 = any.number(-7, 7),
  r = any.direction }

theorem("(11) and (12) are rotor's product", function()
  for_all(two, function(case)
    local c, v = composed(case.A2, case.alpha2, case.A1, case.alpha1)
    local product = rotation(case.A2, case.alpha2)*rotation(case.A1, case.alpha1)
    near(c, cos(product.angle/2), tolerance, "cos(alpha3/2)")
    near(v, product.axis*sin(product.angle/2), tolerance, "A3 sin(alpha3/2)")
    holds(product.angle >= 0 and product.angle <= 2*pi, "alpha3 in [0, 2 pi]")
    near(1, c^2 + dot(v, v), 2*tolerance, "cos^2 + sin^2 = 1")
  end)
end)

theorem("they are the product of the operators: R1 first, then R2", function()
  for_all(two, function(case)
    local c, v = composed(case.A2, case.alpha2, case.A1, case.alpha1)
    local R1, R2 = rotation(case.A1, case.alpha1), rotation(case.A2, case.alpha2)
    -- atan2 keeps the error of c and v, and a point moves by it, twice for the half angle.
    local R3 = rotation(v, 2*atan(norm(v), c))
    near(R2*(R1*case.r), R3*case.r, 3*tolerance, "R2 (R1 r) = R3 r")
    near(R2.matrix*R1.matrix, R3.matrix, 3*tolerance, "the matrices")
  end)
end)

theorem("they are the product of the unit quaternions", function()
  for_all(two, function(case)
    local c, v = composed(case.A2, case.alpha2, case.A1, case.alpha1)
    local function q(A, alpha)
      local s = sin(alpha/2)
      return quaternion(cos(alpha/2), A.x*s, A.y*s, A.z*s)
    end
    near(q(case.A2, case.alpha2)*q(case.A1, case.alpha1), quaternion(c, v.x, v.y, v.z), tolerance, "q2 q1")
  end)
end)

theorem("the other order changes the sign of the cross product alone", function()
  for_all(two, function(case)
    local c, v = composed(case.A2, case.alpha2, case.A1, case.alpha1)
    local c_other, v_other = composed(case.A1, case.alpha1, case.A2, case.alpha2)
    near(c, c_other, tolerance, "the angle is the same")
    near(2*sin(case.alpha2/2)*sin(case.alpha1/2)*cross(case.A2, case.A1), v - v_other, 2*tolerance, "v21 - v12")
  end)
end)

theorem("half angles count turns: alpha1 + 2 pi takes alpha3 to 2 pi - alpha3, A3 to -A3", function()
  for_all(two, function(case)
    local c, v = composed(case.A2, case.alpha2, case.A1, case.alpha1)
    -- alpha1 + 2 pi is rounded, and 2 pi: half an ulp of 16, each, of which half is in the half angle.
    local c_further, v_further = composed(case.A2, case.alpha2, case.A1, case.alpha1 + 2*pi)
    near(-c, c_further, tolerance + 16*u, "cos(alpha3/2)")
    near(-v, v_further, tolerance + 16*u, "A3 sin(alpha3/2)")
  end)
end)

-- About k by 0.9, then about (sin 1, 0, cos 1) by 1.4. k, and the second axis with it, are in the plane y = 0, so that
-- the cross product is along j: three products of sines and cosines for the components, and one of the angle.
theorem("two turns in numbers", function()
  local c, v = composed(vec(sin(1), 0, cos(1)), 1.4, vec(0, 0, 1), 0.9)
  local half = acos(cos(0.7)*cos(0.45) - cos(1)*sin(0.7)*sin(0.45))
  near(2*half, 2*atan(norm(v), c), tolerance, "the angle")
  near(vec(sin(1)*sin(0.7)*cos(0.45), -sin(1)*sin(0.7)*sin(0.45),
    cos(1)*sin(0.7)*cos(0.45) + cos(0.7)*sin(0.45)), v, tolerance, "A3 sin(alpha3/2)")
  near(2.007127, 2*atan(norm(v), c), 5e-7, "the angle, six digits")
  near(vec(0.578763, -0.279575, 0.766075), unit(v), 5e-7, "the axis, six digits")
end)
