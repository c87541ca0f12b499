-- Notes, section 10: quaternions.
--
-- Quadruples (q0, q1, q2, q3) with the product [N24]. As complex numbers do, they have a polar form,
--   q = a (cos theta/2, u sin theta/2),
-- and the product multiplies the norms a and composes the rotations (u, theta).

local one, i, j, k = quaternion(1, 0, 0, 0), quaternion(0, 1, 0, 0), quaternion(0, 0, 1, 0), quaternion(0, 0, 0, 1)
local u = 2^-53  -- what rounding does to a number, relatively

theorem("[N25] i i = j j = k k = -1, i j = k, j i = -k", function()
  holds(i*i == -one and j*j == -one and k*k == -one, "ii = jj = kk = -1")
  holds(i*j == k and j*k == i and k*i == j, "ij = k, jk = i, ki = j")
  holds(j*i == -k, "ji = -k")
  holds(i*j*k == -one, "ijk = -1")
end)

local p, q = quaternion(0.5, -1, 2, 0.25), quaternion(-3, 1, 0.5, 2)

theorem("[N24] and [N26] are the same product", function()
  local function n24(a, b)
    return quaternion(a.w*b.w - a.x*b.x - a.y*b.y - a.z*b.z,
      a.w*b.x + b.w*a.x + a.y*b.z - a.z*b.y,
      a.w*b.y + b.w*a.y + a.z*b.x - a.x*b.z,
      a.w*b.z + b.w*a.z + a.x*b.y - a.y*b.x)
  end
  local function n26(a, b)
    local v, w = vec(a.x, a.y, a.z), vec(b.x, b.y, b.z)
    local s = a.w*w + b.w*v + cross(v, w)
    return quaternion(a.w*b.w - dot(v, w), s.x, s.y, s.z)
  end
  -- All numbers here are multiples of 1/16 and small: no rounding.
  near(p*q, n24(p, q), 0, "[N24]")
  near(p*q, n26(p, q), 0, "[N26]")
end)

theorem("The product of polar forms: norms multiply, rotations compose", function()
  local a, R = p:polar()
  local b, S = q:polar()
  local ab, RS = (p*q):polar()
  print("p: norm " .. a .. "\n" .. tostring(R))
  print("q: norm " .. b .. "\n" .. tostring(S))
  print("p*q: norm " .. ab .. "\n" .. tostring(RS) .. "\n")
  near(a*b, ab, 4*u*a*b, "norm")
  near((R*S).quaternion, RS.quaternion, 8*u, "rotation, q first, then p")
  near(p, quaternion.from_polar(a, R), 4*u*a, "p from its polar form")
end)

theorem("theta counts modulo 4 pi; the printed (-pi, pi] is not enough", function()
  -- There cos theta/2 >= 0, so a (cos theta/2, u sin theta/2) has q0 >= 0, but q0 = -3 above.
  local least = math.huge
  for step = -999, 1000 do
    least = math.min(least, quaternion.from_polar(1, rotation({ 1, 2, 3 }, step*pi/1000)).w)
  end
  holds(least >= 0, ("the least q0 for theta in (-pi, pi] is %.1g"):format(least))
  local _, S = q:polar()
  holds(S.angle > pi, ("q0 = -3 has theta = %.4f"):format(S.angle))
  local function at(theta) return quaternion.from_polar(2, rotation({ 1, 2, 3 }, theta)) end
  -- Angles up to 14 are rounded by 8u; half of that, times the norm 2.
  near(-at(1), at(1 + 2*pi), 16*u, "theta + 2 pi: -q")
  near(at(1), at(1 + 4*pi), 16*u, "theta + 4 pi: q")
  holds(rotation({ 1, 2, 3 }, 1):same_operator(rotation({ 1, 2, 3 }, 1 + 2*pi)), "q and -q: one operator")
end)

theorem("A quaternion turns and scales: q v q* = a^2 R v", function()
  local a, S = q:polar()
  local v = vec(1, -2, 0.5)
  local turned = q*quaternion(0, v.x, v.y, v.z)*q:conj()
  near(a^2*(S*v), vec(turned.x, turned.y, turned.z), 16*u*a^2*norm(v), "the vector part")
  near(0, turned.w, 4*u*a^2*norm(v), "the scalar part")
end)

theorem("Powers, exp and log go along the polar form", function()
  local a, R = p:polar()
  near(p*p*p, p^3, 8*u*a^3, "p^3 = p p p")
  near(p, (p^0.5)^2, 8*u*a, "the square of the root")
  near(one, p*p^-1, 4*u, "p p^-1 = 1")
  near(quaternion.from_polar(a^0.25, R^0.25), p^0.25, 8*u, "p^x: norm^x, angle times x")
  near(p, p:log():exp(), 4*u*a, "exp log p = p")
  near((p*p):log(), 2*p:log(), 16*u, "log p^2 = 2 log p, while the angle is below pi")
  fails(function() return quaternion(0, 0, 0, 0):log() end, "zero has no logarithm", "other than zero")
end)
