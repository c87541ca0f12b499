-- Counting turns: rotations are the vectors theta u, rotation operators a ball of radius pi whose antipodal boundary
-- points are one (section 8 of the notes on rotation).
local n = unit { 1, 2, 2 }

print "Turning on about (1, 2, 2)/3: the rotation counts, the operator does not\n"
print " angle    |theta u|   operator: angle  axis                  quaternion's w"
for quarter = 0, 8 do
  local R = rotation(n, quarter*pi/2 + 0.1)
  local C = R:canonical()
  print((" %6.3f   %6.3f      %6.3f           (%5.2f, %5.2f, %5.2f)  %6.3f"):format(R.angle, norm(R.euler_vector),
    C.angle, C.axis.x, C.axis.y, C.axis.z, R.quaternion.w))
end
print ""

theorem("Rotations that differ by a turn are different, their operators are not", function()
  local R, S = rotation(n, 1), rotation(n, 1 + 2*pi)
  holds(R ~= S, "two rotations")
  holds(R:same_operator(S, 1e-15), "one operator")
  -- Each entry of a matrix is off by 1e-15 at most, the angle 1 + 2 pi by half an ulp, 4.4e-16.
  near(R.matrix, S.matrix, 2e-15, "one matrix")
  near(1 + 2*pi, norm(S.euler_vector), 1e-15, "theta u keeps the turn")
  local all = true
  for k = -3, 3 do
    all = all and R:same_operator(rotation(n, 1 + 2*pi*k), 4e-15) and R:same_operator(rotation(-n, 2*pi*k - 1), 4e-15)
  end
  holds(all, "(7): (u, theta + 2 pi k), (-u, -theta + 2 pi k)")
  holds(rotation(n, 1) ~= rotation(-n, -1), "(u, theta), (-u, -theta): two pairs,")
  near(R.euler_vector, rotation(-n, -1).euler_vector, 0, "one vector theta u")
end)

theorem("Every operator is in the ball of radius pi; antipodes are one", function()
  local farthest, inside = 0, true
  for i = 1, 500 do
    local R = rotation({ sin(i), sin(2.1*i), cos(3.7*i) }, 0.1*i)
    local C = R:canonical()
    farthest = math.max(farthest, R:distance(C))
    inside = inside and norm(C.euler_vector) <= pi + 5e-16  -- an ulp for the rounding of n
  end
  holds(inside, "in the ball: 500 rotations")
  near(0, farthest, 1e-15, "R and R:canonical()")
  near(rotation(n, pi), rotation(-n, pi), 3e-16, "pi n and -pi n")
  near(n, rotation(-n, pi):canonical().axis, 1e-16, "the rule: n3 > 0, of -n")
  near(n, rotation(n, pi):canonical().axis, 1e-16, "and of n")
end)

theorem("A path through the boundary comes in again at the antipode", function()
  local out, back = rotation(n, pi - 0.01):canonical(), rotation(n, pi + 0.01):canonical()
  near(2*pi - 0.02, norm(out.euler_vector - back.euler_vector), 4e-15, "a jump through the ball,")
  near(-unit(out.euler_vector), unit(back.euler_vector), 3e-16, "to the opposite side,")
  near(0.02, out:distance(back), 2e-15, "of operators 0.02 apart")
end)

theorem("A list of quaternions of operators, made continuous, counts the turns again", function()
  local list = {}
  for i = 0, 40 do list[i + 1] = rotation(n, 0.1 + pi*i/10):canonical().quaternion end
  local last = continuous_quaternions(list)[41]
  near(rotation(n, 0.1 + 4*pi).quaternion, last, 1e-15, "after two turns")
  near(-rotation(n, 0.1 + 2*pi).quaternion, continuous_quaternions(list)[1], 1e-15, "and one: the opposite")
end)

theorem("The belt: one turn is not undone, two turns are", function()
  near(quaternion(-1, 0, 0, 0), rotation(n, 2*pi).quaternion, 2e-16, "one turn's quaternion")
  near(quaternion(1, 0, 0, 0), rotation(n, 4*pi).quaternion, 3e-16, "two turns'")
  -- Tilting the axis of the second of two turns from n to -n shrinks the double turn to no turn at all. All the way
  -- the path begins and ends at the identity.
  local function path(tilt, s)
    local m = rotation({ 2, -1, 0 }, tilt)*n
    return rotation(m, s)*rotation(n, s)
  end
  local ends, longest = 0, 0
  for i = 0, 50 do
    ends = math.max(ends, path(pi*i/50, 2*pi):distance(rotation.identity))
    longest = math.max(longest, path(pi, 2*pi*i/50):distance(rotation.identity))
  end
  near(0, ends, 1.5e-15, "51 paths close")
  near(0, longest, 1.5e-15, "the last one stays at 1")
  near(pi, path(0, pi/2):distance(rotation.identity), 2e-15, "the first one does not")
end)
