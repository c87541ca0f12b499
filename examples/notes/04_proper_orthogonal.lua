-- Rotation operators are the proper orthogonal operators; their axis and angle from eigenvalues and eigenvectors
-- (section 4 of the notes on rotation).
local identity = rotation.identity.matrix

-- The largest |entry| of a matrix.
local function largest(m)
  local greatest = 0
  for i = 1, 3 do
    for j = 1, 3 do greatest = math.max(greatest, abs(m[i][j])) end
  end
  return greatest
end

local R = rotation({ 1, 2, 3 }, 1)
local Q = R.matrix
for _, case in ipairs { { "A rotation", Q }, { "Stretched", 1.25*Q }, { "A reflection", -Q } } do
  local proper, measured = proper_orthogonal(case[2])
  print(("%s: %s,\n  %s"):format(case[1], proper, measured))
end
print ""

theorem("Every rotation operator is proper orthogonal", function()
  near(0, largest(Q:transpose()*Q - identity), 4e-16, "Q^T Q = I")
  near(1, det(Q), 4e-16, "det Q")
  -- (8): the images of a right-handed orthonormal basis, (9), are another one.
  local u, v, w = orthonormal_basis(R.axis)
  near(Q, outer(Q*u, u) + outer(Q*v, v) + outer(Q*w, w), 1e-15, "(8)")
  near(1, orientation(Q*u, Q*v, Q*w), 0, "(9) is right-handed")
end)

theorem("Every proper orthogonal operator is a rotation operator", function()
  -- (10): det(Q - I) = -det(Q - I), so 1 is an eigenvalue and Q has an axis.
  near(0, det(Q - identity), 1e-16, "(10): det(Q - I)")
  local axis = rotation.from_matrix(Q).axis
  near(axis, Q*axis, 4e-16, "the axis stays")
  -- (12) has the sign of theta reversed: in (v, w) the operator turns v towards w.
  local _, v, w = orthonormal_basis(axis)
  near(sin(1), dot(w, Q*v), 4e-16, "w . Q v = sin theta")
  fails(function() return rotation.from_matrix(-Q) end, "a reflection is none", "a reflection")
end)

-- (11) has the labels of sin phi and cos phi interchanged, and with them the parity of n: phi + theta = n pi.
theorem("(11) and (14) as printed", function()
  local u1, u2, u3 = orthonormal_basis(R.axis)
  local theta = math.atan(dot(u2, Q*u3), dot(u2, Q*u2))  -- cos theta = Q22, sin theta = Q23
  local phi = math.atan(dot(u3, Q*u2), dot(u3, Q*u3))    -- sin phi = Q32, cos phi = Q33
  near(0, (theta + phi)/pi, 4e-16, "of a proper Q, n is even, not odd")
  local first = outer(u1, u1) + cos(theta)*(outer(u2, u2) - outer(u3, u3))
    + sin(theta)*(outer(u2, u3) + outer(u3, u2))
  near(-1, det(first), 1e-15, "(11) with n = 0 is improper")
  near(Q, outer(u1, u1) + cos(theta)*(outer(u2, u2) + outer(u3, u3)) + sin(theta)*(outer(u2, u3) - outer(u3, u2)),
    1e-15, "(12) is right: theta = -1")
  near(-sin(theta)*u2 - cos(theta)*u3, -(Q*u3), 1e-15, "but of (12) u2 - i u3 has e^(-i theta)")
  holds(norm(sin(theta)*u2 - cos(theta)*u3 + Q*u3) > 1, "and not e^(i theta) as (14) says")
end)

-- (14) belongs to the theta of (6): Q (u2 - i u3) = e^(i theta) (u2 - i u3), with (u1, u2, u3) right-handed.
theorem("(14): eigenvalues and eigenvectors", function()
  local u1, u2, u3 = orthonormal_basis(R.axis)
  near(cos(1)*u2 + sin(1)*u3, Q*u2, 4e-16, "the real part of (14)")
  near(sin(1)*u2 - cos(1)*u3, -(Q*u3), 4e-16, "the imaginary part")
  near(-1, orientation(u2, -u3, u1), 0, "(Re a1, Im a1, u1): left")
  near(R, rotation.from_eigenvectors(Q), 1e-15, "the rotation from them")
  near(R, rotation.from_matrix(Q), 1e-15, "and from_matrix")
end)

-- eigMtoR.m as it is printed. A value is { re, im }, a vector likewise; `index` is mod(., 3) there.
local function printed(values, vectors, index)
  local i1
  for i, value in ipairs(values) do
    if abs(value.re - 1) + abs(value.im) < 1e-10 then i1 = i end
  end
  local i2, i3 = index(i1 + 1), index(i1 + 2)
  if i2 == 0 or i3 == 0 then error "Index exceeds matrix dimensions: 0" end
  if values[i2].im < 0 then i2 = i3 end
  local u, a = vectors[i1].re, vectors[i2]
  return orientation(u, a.re, a.im) > 0 and -u or u, acos(values[i2].re)
end

theorem("The program as printed", function()
  local u1, u2, u3 = orthonormal_basis(R.axis)
  local values = { { re = 1, im = 0 }, { re = cos(1), im = sin(1) }, { re = cos(1), im = -sin(1) } }
  local vectors = { { re = -u1 }, { re = u2, im = -u3 }, { re = u2, im = u3 } }
  for place = 1, 3 do
    local function run(index) return printed(values, vectors, index) end
    local what = "1 in place " .. place .. ": the index 0"
    if place < 3 then
      fails(function() run(function(i) return i % 3 end) end, what, "Index exceeds")
    end
    local u, theta = run(function(i) return (i - 1) % 3 + 1 end)
    near(R, rotation(u, theta), 1e-15, "with the right index")
    table.insert(values, 1, table.remove(values))
    table.insert(vectors, 1, table.remove(vectors))
  end
  -- The trace is 1 + lambda1 + lambda2: of a half turn the two are -1, not i as printed.
  near(-2, rotation({ 1, 2, 3 }, pi).matrix:trace() - 1, 1e-15, "lambda1 + lambda2, half turn")
  near(rotation({ 1, 2, 3 }, pi), rotation.from_eigenvectors(rotation({ -1, -2, -3 }, pi).matrix), 1e-15,
    "rotor solves half turns")
  -- 1e-11 from the identity all three eigenvalues are within 1e-10 of 1.
  local small = rotation({ 1, 2, 3 }, 1e-11)
  near(1e-11, rotation.from_eigenvectors(small.matrix).angle, 1e-16, "and 1e-11 from the identity,")
  near(small.axis, rotation.from_matrix(small.matrix).axis, 5e-16, "where from_matrix is exact")
end)
