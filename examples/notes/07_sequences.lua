-- Section 7 of the notes: sequences of rotations.
--
-- Axes u1, u2, ... un and angles make one rotation, Q = Q1 Q2 ... Qn with the axes fixed in the body (20). Turned at
-- given rates it has the angular velocity (23), the sum of rate_k v_k, where v_k = Q1 ... Q(k-1) u_k is the k-th axis
-- as it stands now. Equation (22), from which this follows, is printed with Q_i^T missing and with dQ2 in its third
-- line; here it is written out as printed, and corrected.
--
--   rotor examples/notes/07_sequences.lua

local axes = { vec(0, 0, 1), vec(1, 2, 0), vec(-1, 0.5, 3) }
local angles, rates = { 0.4, -1.1, 2.5 }, { 0.3, 0.7, -0.2 }
local body = chain { axes = axes, angles = angles, rates = rates }
print(body)

local Q, dQ = {}, {}  -- the factors Q_k and dQ_k/dtheta_k
for k = 1, 3 do
  local one = chain { axes = { axes[k] }, angles = { angles[k] } }
  Q[k], dQ[k] = one.rotation.matrix, one.derivatives[1]
end

local function transposed(m)
  return { { m[1][1], m[2][1], m[3][1] }, { m[1][2], m[2][2], m[3][2] }, { m[1][3], m[2][3], m[3][3] } }
end
local function product(first, ...)
  local m = first
  for _, f in ipairs { ... } do
    local p = {}
    for i = 1, 3 do
      p[i] = {}
      for j = 1, 3 do p[i][j] = m[i][1]*f[1][j] + m[i][2]*f[2][j] + m[i][3]*f[3][j] end
    end
    m = p
  end
  return m
end
local function sum(...)  -- of rates[k] times the k-th matrix
  local s = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }
  for k, m in ipairs { ... } do
    for i = 1, 3 do
      for j = 1, 3 do s[i][j] = s[i][j] + rates[k]*m[i][j] end
    end
  end
  return s
end
local function axial(m) return 0.5*vec(m[3][2] - m[2][3], m[1][3] - m[3][1], m[2][1] - m[1][2]) end
local function symmetric_part(m)
  local largest = 0
  for i = 1, 3 do
    for j = 1, 3 do largest = math.max(largest, abs(m[i][j] + m[j][i])/2) end
  end
  return largest
end
local T = transposed

-- Three factors of entries at most 1, each rounded (1.1e-16) as are the sums of three that make a product of them:
-- with up to five factors and three terms an entry is off by less than 5e-15.
local tolerance = 5e-15

theorem("(20): body-fixed is space-fixed in the opposite order", function()
  near(product(Q[1], Q[2], Q[3]), body.rotation.matrix, tolerance, "Q1 Q2 Q3")
  local space = chain { axes = { axes[3], axes[2], axes[1] }, angles = { angles[3], angles[2], angles[1] },
    frame = "space" }
  near(body.rotation, space.rotation, tolerance, "the other way round, in space")
  holds(not body.rotation:same_operator(chain { axes = axes, angles = angles, frame = "space" }.rotation),
    "in the same order it is another one")
end)

theorem("(21): derivatives with respect to the angles", function()
  near(product(dQ[1], Q[2], Q[3]), body.derivatives[1], tolerance, "dQ/dtheta1")
  near(product(Q[1], dQ[2], Q[3]), body.derivatives[2], tolerance, "dQ/dtheta2")
  near(product(Q[1], Q[2], dQ[3]), body.derivatives[3], tolerance, "dQ/dtheta3")
end)

theorem("(22) as corrected is skew, and its axial vector is (23)", function()
  local m = sum(product(dQ[1], T(Q[1])), product(Q[1], dQ[2], T(Q[2]), T(Q[1])),
    product(Q[1], Q[2], dQ[3], T(Q[3]), T(Q[2]), T(Q[1])))
  near(0, symmetric_part(m), tolerance, "symmetric part")
  near(axial(m), body.omega, tolerance, "omega")
  local v = body.axes
  near(rates[1]*v[1] + rates[2]*v[2] + rates[3]*v[3], body.omega, tolerance, "sum of rate_k v_k")
end)

theorem("(22) as printed is neither: each of its misprints alone makes it wrong", function()
  local first, second = product(dQ[1], T(Q[1])), product(Q[1], dQ[2], T(Q[2]), T(Q[1]))
  local third = product(Q[1], Q[2], dQ[3], T(Q[3]), T(Q[2]), T(Q[1]))
  for _, misprint in ipairs {
    { "without Q1^T in the first line", sum(dQ[1], second, third) },
    { "without Q2^T in the second", sum(first, product(Q[1], dQ[2], T(Q[1])), third) },
    { "dQ2 for dQ3 in the third", sum(first, second, product(Q[1], Q[2], dQ[2], T(Q[2]), T(Q[1]))) },
  } do
    local name, m = table.unpack(misprint)
    local off = norm(axial(m) - body.omega)
    print(("  %-32s symmetric part %.3f, axial vector off by %.3f"):format(name, symmetric_part(m), off))
    holds(symmetric_part(m) > 0.01 and off > 0.01, name)
  end
end)

theorem("Euler angles: rates, angular velocity, and where that fails", function()
  local yaw, pitch, roll = 0.5, -0.3, 1.2
  local R = rotation.from_euler_angles("zyx", yaw, pitch, roll)
  near({ yaw, pitch, roll }, { R:euler_angles "zyx" }, 1e-15, "the angles come back")
  local omega = vec(0.1, -0.2, 0.3)
  local back = chain { axes = "zyx", angles = { yaw, pitch, roll } }:rates(omega)
  -- The least singular value of J is sqrt(1 - sin |pitch|) > 0.8.
  near(omega, chain { axes = "zyx", angles = { yaw, pitch, roll }, rates = back }.omega, 1e-15, "omega from its rates")
  local locked = chain { axes = "zyx", angles = { yaw, pi/2, roll } }
  holds(locked.rank == 2, "at pitch 90 degrees the axes lie in a plane")
  fails(function() locked:rates(cross(locked.axes[1], locked.axes[2])) end, "about its normal nothing turns",
    "out of reach")
end)

theorem("Euler angles: twelve sequences, two solutions each, and gimbal lock", function()
  local worst, count = 0, 0
  for sequence in ("xyz xzy yxz yzx zxy zyx xyx xzx yxy yzy zxz zyz"):gmatch "%a+" do
    for _, R in ipairs(rotation.random(7, 100)) do
      for solution = 1, 2 do
        local again = rotation.from_euler_angles(sequence, R:euler_angles(sequence, { solution = solution }))
        worst, count = math.max(worst, R:distance(again)), count + 1
      end
    end
  end
  near(0, worst, 4e-15, count .. " times there and back")
  local R = rotation.from_euler_angles("zyx", 0.7, pi/2, 0.4)
  local a, b, c = R:euler_angles("zyx", { singular = "silent" })
  near({ 0.3, pi/2, 0 }, { a, b, c }, 4e-15, "locked: a - c alone counts")
  near(R, rotation.from_euler_angles("zyx", a, b, c), 4e-15, "and makes R")
end)
