-- Lemma 3.1 of the paper, Rodrigues' rotation formula: for any point r,
--   (3)  Rot(n, theta) r = r cos theta + n (n . r)(1 - cos theta) + (n x r) sin theta,
-- where Rot(n, theta) turns counterclockwise about the unit vector n; a multiple of 2 pi is the identity, whatever n.
-- It holds as printed. It is held here against rotor's rotations, against two reflections, and against what it is to
-- turn by an angle.

local u = 2^-53  -- one rounding

local function rodrigues(n, theta, r)
  return r*cos(theta) + n*dot(n, r)*(1 - cos(theta)) + cross(n, r)*sin(theta)
end

local function mirrored(r, normal) return r - 2*dot(r, normal)*normal end

local turn = { n = any.direction, theta = any.number(-7, 7), r = any.direction, size = any.number(0, 100) }

theorem("(3) is what rotor's rotations do", function()
  -- The vector is the sum of three, of some ten roundings; so is that of rotor.
  for_all(turn, function(case)
    local n, theta, r = case.n, case.theta, case.size*case.r
    near(rodrigues(n, theta, r), rotation(n, theta)*r, 20*u*norm(r), "R*r")
    near(rodrigues(n, theta, r), rotation(n, theta).matrix*r, 20*u*norm(r), "R.matrix*r")
  end)
end)

theorem("(3) is two reflections in planes through n, theta/2 apart", function()
  for_all(turn, function(case)
    local n, theta, r = case.n, case.theta, case.size*case.r
    local _, first, across = orthonormal_basis(n)
    local second = cos(theta/2)*first + sin(theta/2)*across
    -- Each reflection takes twice a projection away: ten roundings each, and five of the second normal, doubled.
    near(mirrored(mirrored(r, first), second), rodrigues(n, theta, r), (10 + 30)*u*norm(r), "two reflections")
  end)
end)

theorem("(3) turns: n rests, lengths stay, and across n all turns by theta", function()
  for_all(turn, function(case)
    local n, theta, r = case.n, case.theta, case.r
    local there = rodrigues(n, theta, r)
    local across, turned = r - dot(n, r)*n, there - dot(n, there)*n
    near(n, rodrigues(n, theta, n), 10*u, "n rests")
    near(dot(n, r), dot(n, there), 20*u, "the height along n stays")
    near(norm(across), norm(turned), 20*u, "the distance from the axis stays")
    -- Cosine and sine of the angle from one to the other, counterclockwise about n, times the square of the distance.
    near(cos(theta)*dot(across, across), dot(across, turned), 40*u, "the cosine of theta")
    near(sin(theta)*dot(across, across), dot(n, cross(across, turned)), 40*u, "the sine of theta, counterclockwise")
  end)
end)

theorem("-n by -theta is the same, and a multiple of 2 pi the identity", function()
  for_all({ n = any.direction, theta = any.number(-7, 7), r = any.direction, k = any.integer(-3, 3) }, function(case)
    local n, theta, r = case.n, case.theta, case.r
    near(rodrigues(n, theta, r), rodrigues(-n, -theta, r), 0, "(-n, -theta)")
    -- 2 pi k is rounded, by half an ulp of 32 at most: 16 u.
    near(r, rodrigues(n, 2*pi*case.k, r), (16 + 10)*u, "theta = 2 pi k")
  end)
end)
