-- Rotations and rotation operators: Q(u, theta) in three forms (section 2 of the notes on rotation).
local identity = rotation.identity.matrix

-- (4): u (x) u + (I - u (x) u) cos theta + S_u sin theta.
local function form_4(u, theta)
  local uu = outer(u, u)
  return uu + cos(theta)*(identity - uu) + sin(theta)*skew(u)
end

-- (5), the matrix of it, entry by entry.
local function form_5(u, theta)
  local x, y, z = u.x, u.y, u.z
  local c, s = cos(theta), sin(theta)
  local v = 1 - c
  return matrix {
    { x*x*v + c, x*y*v - z*s, x*z*v + y*s },
    { y*x*v + z*s, y*y*v + c, y*z*v - x*s },
    { z*x*v - y*s, z*y*v + x*s, z*z*v + c },
  }
end

-- (6), with any v and w that make (u, v, w) a right-handed orthonormal basis.
local function form_6(u, v, w, theta)
  return cos(theta)*(outer(v, v) + outer(w, w)) + sin(theta)*(outer(w, v) - outer(v, w)) + outer(u, u)
end

local u, theta = unit { 1, 2, 3 }, 1
local _, v, w = orthonormal_basis(u)
print "Q(u, 1) with u along (1, 2, 3), by (4):\n"
print(form_4(u, theta))
print ""

-- The largest difference to R.matrix of 1000 rotations.
local function worst(form)
  local greatest = 0
  for i = 1, 1000 do
    local R = rotation({ sin(i), sin(2.1*i), cos(3.7*i) }, 0.013*i)
    local m, n = form(R), R.matrix
    for j = 1, 3 do
      for k = 1, 3 do greatest = math.max(greatest, abs(m[j][k] - n[j][k])) end
    end
  end
  return greatest
end

theorem("(4), (5), (6) are one operator", function()
  -- Six roundings of numbers of at most 1, and v and w are off by an ulp.
  near(0, worst(function(R) return form_4(R.axis, R.angle) end), 1e-15, "(4), 1000 rotations")
  near(0, worst(function(R) return form_5(R.axis, R.angle) end), 1e-15, "(5)")
  near(0, worst(function(R)
    local first, second, third = orthonormal_basis(R.axis)
    return form_6(first, second, third, R.angle)
  end), 1e-15, "(6)")
  near(form_6(u, v, w, theta), form_6(u, rotation(u, 2)*v, rotation(u, 2)*w, theta), 2e-15, "(6) for any v, w")
end)

theorem("The convention: right-handed", function()
  local R = rotation(u, theta)
  near(cos(theta)*v + sin(theta)*w, R*v, 4e-16, "v goes to v cos + w sin")
  near(-sin(theta)*v + cos(theta)*w, R*w, 4e-16, "w to -v sin + w cos")
  near(u, R*u, 4e-16, "u stays")
  near(-1, orientation(u, w, v), 0, "(u, w, v) would turn the other way")
end)

theorem("S_u x = u x x", function()
  local x = vec(0.3, -2, 5)
  near(cross(u, x), skew(u)*x, 2e-15, "for an x")
  near(u, axial(skew(u)), 0, "and u is its axial vector")
  near(sin(theta)*u, axial(rotation(u, theta).matrix), 3e-16, "of Q(u, theta): u sin theta")
  near(1 + 2*cos(theta), rotation(u, theta).matrix:trace(), 1e-15, "its trace: 1 + 2 cos theta")
end)
