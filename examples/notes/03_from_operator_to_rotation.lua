-- From rotation operators to rotations: one rotation for each operator (section 3 of the notes on rotation), and the
-- errors in the program printed there.

local function sign(x) return x > 0 and 1 or x < 0 and -1 or 0 end
local function printed_index(i) return i % 3 end
local function right_index(i) return (i - 1) % 3 + 1 end

-- QtoRotation.m as it is printed, after its first test for the identity; sums of moduli below 1e-10 are zero to it.
local function printed(Q, index)
  local c = (Q:trace() - 1)/2
  local S = axial(Q)
  if abs(S.x) + abs(S.y) + abs(S.z) < 1e-10 then
    local u = {}
    for i = 1, 3 do u[i] = sqrt((Q[i][i] + 1)/2) end
    local i1 = Q[1][1] ~= 0 and 1 or Q[2][1] ~= 0 and 2 or 3
    for _, i in ipairs { index(i1 + 1), index(i1 + 2) } do
      if i == 0 then error "Index exceeds matrix dimensions: 0" end
      u[i] = u[i]*sign(Q[i][i1])*sign(u[i1])
    end
    if u[3] < 0 or (u[3] == 0 and (u[2] < 0 or (u[1] == 0 and u[1] < 0))) then
      u = { -u[1], -u[2], -u[3] }
    end
    return vec(u[1], u[2], u[3]), pi
  end
  return S/sin(c), acos(c)  -- sin(c): the sine of a cosine
end

local function printed_with_sin_theta(Q)
  local theta = acos((Q:trace() - 1)/2)
  return axial(Q)/sin(theta), theta
end

local n = unit { 1, -2, 2 }
print "Angle of Q(n, theta), n = (1, -2, 2)/3: by acos as printed, and by rotor\n"
print "theta          acos           rotor          error of acos, of rotor"
for _, theta in ipairs { 1e-9, 1e-7, 1e-4, 1, pi - 1e-4, pi - 1e-7 } do
  local Q = rotation(n, theta).matrix
  local _, by_acos = printed_with_sin_theta(Q)
  local by_rotor = rotation.from_matrix(Q).angle
  print(("%-13.9g  %-13.9g  %-13.9g  %.1e  %.1e"):format(theta, by_acos, by_rotor, abs(by_acos - theta),
    abs(by_rotor - theta)))
end
print ""

theorem("theta in (0, pi): the axis from the skew part", function()
  local Q = rotation(n, 1).matrix
  near(n, rotation.from_matrix(Q).axis, 5e-16, "rotor's axis")
  near(n, (printed_with_sin_theta(Q)), 1e-15, "by S/sin(theta)")
  near(sin(1)/sin(cos(1)), norm((printed(Q))), 1e-15, "as printed: |S/sin(c)|, no unit vector")
end)

theorem("Close to 0 and to pi acos loses half the digits, or all", function()
  near(1e-9, rotation.from_matrix(rotation(n, 1e-9).matrix).angle, 1e-24, "rotor at 1e-9")
  local _, by_acos = printed_with_sin_theta(rotation(n, 1e-9).matrix)
  near(0, by_acos, 0, "by acos: 0")
  local almost = rotation(n, pi - 1e-9)
  near(almost.angle, rotation.from_matrix(almost.matrix).angle, 1.5e-15, "rotor 1e-9 short of pi")
  _, by_acos = printed_with_sin_theta(almost.matrix)
  holds(abs(by_acos - almost.angle) > 1e-10, "acos is off there, too")
end)

theorem("theta = 0 and theta = pi: the rule that makes it one rotation", function()
  holds(rotation.from_matrix(rotation({ 1, 2, 3 }, 0).matrix) == rotation.identity, "0: the axis is e1")
  near(unit { -1, 2, 3 }, rotation.from_matrix(rotation({ 1, -2, -3 }, pi).matrix).axis, 4e-16, "pi: u3 > 0")
  near(unit { -1, 2, 0 }, rotation.from_matrix(rotation({ 1, -2, 0 }, pi).matrix).axis, 4e-16, "else u2 > 0")
  near(vec(1, 0, 0), rotation.from_matrix(rotation({ -1, 0, 0 }, pi).matrix).axis, 0, "else e1")
end)

theorem("The program as printed, where theta = pi", function()
  local diagonal = matrix { { -1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 } }  -- about (0, 1, 1)
  for _, Q in ipairs { diagonal, rotation({ 1, 1, 1 }, pi).matrix } do
    fails(function() printed(Q, printed_index) end, "mod(i1 + 2, 3) is the index 0", "Index exceeds")
  end
  near(vec(0, 0, 0), printed(diagonal, right_index), 0, "right index: sign(0) makes the axis 0")
  near(unit { 0, 1, 1 }, rotation.from_matrix(diagonal).axis, 2e-16, "rotor's axis")
  local function last_test(u) return u[1] == 0 and u[1] < 0 end
  holds(not last_test { -1, 0, 0 }, "its last test is never true: -e1 would stay -e1")
  local almost = rotation({ 1, 0, 0 }, pi - 0.75e-10)
  local axis, angle = printed(almost.matrix, right_index)
  near(pi, angle, 0, "0.75e-10 short of pi: pi")
  near(vec(1, 0, 0), axis, 0, "taken for a half turn")
  near(almost.angle, rotation.from_matrix(almost.matrix).angle, 5e-16, "rotor's angle")
end)
