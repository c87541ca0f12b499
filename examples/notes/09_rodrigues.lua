-- Section 9 of the notes: Rodrigues' construction of a product of two rotations, on the sphere.
--
-- A body turns about p by theta, then about q by phi; p and q are fixed in space. Draw l, the great circle
-- through p and q, on a shell around the body. Turn l about p by -theta/2, and turn l about q by +phi/2: the two
-- circles meet at r, the axis of the whole motion, and the exterior angle there is half its angle.
--
--   rotor examples/notes/09_rodrigues.lua

local p, theta = vec(0, 0, 1), 0.9
local q, phi = vec(sin(1), 0, cos(1)), 1.4
local R, S = rotation(p, theta), rotation(q, phi)
local triangle = spherical_triangle(R, S)
print(triangle)
print ""
triangle:plot()
print ""

-- A product is rounded to 4.5e-16 in its angle and 1e-16 in its axis; that, of two, and the rounding in between.
local tolerance = 2e-15

theorem("the triangle gives the product S * R", function()
  near((S*R).angle, triangle.angle, tolerance, "gamma")
  near((S*R).axis, triangle.axis, tolerance, "r")
  near(vec(0.578763, -0.279575, 0.766075), triangle.axis, 5e-7, "r, six digits")
  near(2.007127, triangle.angle, 5e-7, "gamma, six digits")
end)

-- The construction by hand: circles by their normals, l first; where two meet, and the angle between them.
local l = unit(cross(p, q))
local function turned(about, angle) return rotation(about, angle)*l end
local function meet(first, second)
  local normal = cross(first, second)
  return unit(normal), math.atan(norm(normal), dot(first, second))
end

theorem("l turned by the half angles: where the two circles meet", function()
  local r, half = meet(turned(p, -theta/2), turned(q, phi/2))
  near(triangle.axis, r, tolerance, "the axis")
  near(triangle.angle/2, half, tolerance, "half the angle")
end)

theorem("why: the motion takes r first away, then back", function()
  -- The first rotation takes r to its mirror image in l, the second brings it back.
  local r = triangle.axis
  local image = r - 2*dot(r, l)*l
  near(image, R*r, tolerance, "R r")
  near(r, S*(R*r), tolerance, "S R r")
end)

theorem("the notes turn by the whole angles: that is another point", function()
  local r = meet(turned(p, -theta), turned(q, phi))
  holds(norm(r - triangle.axis) > 0.2 and norm(r + triangle.axis) > 0.2, "it is neither r nor -r")
  holds(norm(S*(R*r) - r) > 0.2, "and S * R does not leave it where it is")
end)

theorem("sides and angles are those of a spherical triangle", function()
  local arcs, half = triangle.arcs, triangle.half_angles
  -- The law of sines; at r the sine of the exterior angle is that of the interior one.
  local ratio = sin(half.r)/sin(arcs.pq)
  near(ratio, sin(half.p)/sin(arcs.qr), tolerance, "sin(theta/2) / sin qr")
  near(ratio, sin(half.q)/sin(arcs.rp), tolerance, "sin(phi/2) / sin rp")
end)

theorem("turns are counted: theta + 2 pi takes gamma to 2 pi - gamma", function()
  local further = spherical_triangle(rotation(p, theta + 2*pi), S)
  near(2*pi - triangle.angle, further.angle, tolerance, "the angle")
  near(-triangle.axis, further.axis, tolerance, "the axis, opposite")
end)

theorem("the inverse: one rotation as a sequence of two about chosen axes", function()
  local solution = triangle.rotation:angles_about(q, p)[1]
  near(phi, solution[1], tolerance, "phi, about q")
  near(theta, solution[2], tolerance, "theta, about p")
  -- Two axes reach a rotation iff it takes p to where a turn about q can: q . T p = q . p.
  fails(function() return triangle.rotation:angles_about(q, cross(p, q)) end, "other axes do not reach it",
    "out of reach")
end)

theorem("p and q parallel or opposite: no triangle, and the angles add", function()
  local same, opposite = spherical_triangle(R, rotation(p, phi)), spherical_triangle(R, rotation(-p, phi))
  holds(same.kind == "parallel", "parallel")
  near(theta + phi, same.angle, tolerance, "theta + phi")
  holds(opposite.kind == "opposite", "opposite")
  near(rotation(p, theta - phi), opposite.rotation, tolerance, "theta - phi")
  fails(function() return same.vertices end, "there are no vertices", "no triangle")
end)
