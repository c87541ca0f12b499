-- Section 7 of the notes: which rotation operators commute?
--
-- The notes: "Rotation operators commute if and only if their axial vectors are parallel. Proof: ??" There is none:
-- half turns about perpendicular axes commute. What has a proof: R S = S R if and only if one of them is the identity,
-- or the axes are parallel, or both are half turns about perpendicular axes. With quaternions (p0, p) and (q0, q) of R
-- and S the operators agree iff the two products are equal or opposite. Their difference is twice p x q: equal means
-- parallel. Opposite means p0 q0 = p.q and p0 q + q0 p = 0: as p and q are not parallel, p0 = q0 = 0, two half turns,
-- and then p.q = 0.
--
--   rotor examples/notes/07_commuting.lua

local x, y = vec(1, 0, 0), vec(0, 1, 0)

-- The distance of R S and S R, without asking `commute`.
local function apart(R, S) return (R*S):distance(S*R) end

-- Two products are rounded, each turns by less than 8e-16 too much.
local rounding = 2*8e-16

theorem("The notes' theorem: two operators commute though their axes are not parallel", function()
  local R, S = rotation(x, pi), rotation(y, pi)
  near(0, apart(R, S), rounding, "half turns about x and y")
  near(1, norm(cross(R.axis, S.axis)), 0, "sine between their axes")
  near(rotation(cross(x, y), pi), R*S, rounding, "R S, a half turn about the third")
  local commutes, why = commute(R, S)
  holds(commutes and why == "perpendicular half turns", "commute says: " .. why)
end)

theorem("Each part of the exception is needed", function()
  -- A half turn about a perpendicular axis inverts S: R S = S^-1 R.
  near(2, apart(rotation(x, pi), rotation(y, 1)), rounding, "a half turn and one of 1 rad")
  near(pi, apart(rotation(x, pi), rotation(x + y, pi)), rounding, "half turns at 45 degrees")
end)

-- 10,000 random pairs, uniform on all rotations, and as many of each kind that should commute.
local n = 10000
local first, second = rotation.random(1, n), rotation.random(2, n)

theorem("They commute in the three cases: 10,000 random pairs of each", function()
  local identity, parallel, half = 0, 0, 0
  for i = 1, n do
    local R, S = first[i], second[i]
    identity = math.max(identity, apart(R, rotation.identity))
    parallel = math.max(parallel, apart(R, rotation(-2*R.axis, S.angle)))
    half = math.max(half, apart(rotation(R.axis, pi), rotation(cross(R.axis, S.axis), pi)))
  end
  near(0, identity, rounding, "with the identity")
  near(0, parallel, rounding, "about parallel axes")
  -- Axes are unit and perpendicular to 1e-16 each; an angle d between axes of half turns turns by 2 d, R S by it and
  -- S R by it the other way.
  near(0, half, rounding + 4*2e-16, "perpendicular half turns")
end)

theorem("And in no other: 10,000 random pairs", function()
  -- The distance is d with sin(d/4) = min(|p q - q p|, |p q + q p|)/2: the half-angle form of the proof above.
  local wrong, different, least = 0, 0, pi
  for i = 1, n do
    local R, S = first[i], second[i]
    local p, q = R.quaternion, S.quaternion
    local pv, qv = vec(p.x, p.y, p.z), vec(q.x, q.y, q.z)
    local minus = norm(cross(pv, qv))
    local plus = sqrt((p.w*q.w - dot(pv, qv))^2 + norm(p.w*qv + q.w*pv)^2)
    wrong = math.max(wrong, abs(apart(R, S) - 4*math.atan(math.min(minus, plus), math.max(minus, plus))))
    least = math.min(least, apart(R, S))
    if not commute(R, S) then different = different + 1 end
  end
  print(("  the pair that comes nearest to commuting: %.2g rad"):format(least))
  near(0, wrong, 4*rounding, "the distance, predicted from p and q")
  near(n, different, 0, "pairs that do not commute")
end)
