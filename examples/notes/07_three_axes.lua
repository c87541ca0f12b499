-- Section 7 of the notes: do three axes reach every rotation?
--
-- The notes: "If the unit vectors u_i span E3, then a set of angles exists for which the composite rotation equals any
-- rotation operator. Proof: ??" For three axes, spanning is neither sufficient nor necessary. In R = Q(u1, a) Q(u2, b)
-- Q(u3, c) the outer two do not change u1.R u3, and b moves it between cos(alpha + beta) and cos(alpha - beta), where
-- alpha and beta are the angles from u2 to u1 and u3. That is all of -1 ... 1 iff both are right angles: every rotation
-- is in reach if and only if u2 is perpendicular to u1 and to u3 (Davenport).
--
--   rotor examples/notes/07_three_axes.lua

local x, y, z = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)
local n = 10000
local rotations = rotation.random(3, n)

-- How many of the random rotations the axes reach, and how well the angles make them again.
local function reached(u1, u2, u3)
  local count, worst = 0, 0
  for _, R in ipairs(rotations) do
    local possible, solutions = pcall(R.angles_about, R, u1, u2, u3)
    if possible then
      count = count + 1
      for _, s in ipairs(solutions) do
        local again = chain { axes = { u1, u2, u3 }, angles = s }.rotation
        worst = math.max(worst, R:distance(again))
      end
    end
  end
  return count, worst
end

-- The part of all rotations: u1.R u3 is uniform in -1 ... 1 if R is.
local function predicted(u1, u2, u3)
  local alpha, beta = acos(dot(unit(u1), unit(u2))), acos(dot(unit(u2), unit(u3)))
  return (cos(alpha - beta) - cos(alpha + beta))/2
end

local function spans(u1, u2, u3) return abs(dot(cross(u1, u2), u3)) > 1e-9 end

local cases = {
  { "x, y, z", x, y, z },
  { "x, y, x", x, y, x },
  { "x, (x+y)/sqrt 2, z", x, x + y, z },
  { "x, x + y/2, z", x, x + 0.5*y, z },
  { "three at 60 degrees", x + y, y + z, z + x },
  { "x, y, x + z", x, y, x + z },
}

print "axes                  span   predicted   of 10,000   error of the angles"
for _, case in ipairs(cases) do
  local name, u1, u2, u3 = table.unpack(case)
  local count, worst = reached(u1, u2, u3)
  case.part, case.count, case.worst = predicted(u1, u2, u3), count, worst
  print(("%-20s  %-4s  %9.1f %%  %10d   %.1e"):format(name, spans(u1, u2, u3) and "yes" or "no", 100*case.part,
    count, worst))
end
print ""

theorem("The part that three axes reach is half of cos(alpha - beta) - cos(alpha + beta)", function()
  for _, case in ipairs(cases) do
    -- Five standard deviations of the count.
    near(n*case.part, case.count, 5*sqrt(n*case.part*(1 - case.part)) + 1e-9, case[1])
    near(0, case.worst, 4e-15, "the angles make the rotation again")
  end
end)

theorem("Spanning is not sufficient", function()
  holds(spans(x, x + y, z), "x, (x+y)/sqrt 2 and z span")
  local R = rotation(y, pi/2)  -- takes z to x
  fails(function() R:angles_about(x, x + y, z) end, "but a quarter turn about y is out of reach", "out of reach")
end)

theorem("Spanning is not necessary", function()
  holds(not spans(x, y, x), "x, y, x lie in a plane")
  near(n, reached(x, y, x), 0, "and reach all 10,000")
end)

theorem("Davenport: u2 perpendicular to both is enough, whatever the angle of u1 and u3", function()
  local count, worst = 0, 0
  for i, R in ipairs(rotations) do
    local function axis(k) return rotations[(i + k) % n + 1].axis end
    local u2 = axis(2)
    local u1, u3 = cross(u2, axis(0)), cross(u2, axis(1))
    local again = chain { axes = { u1, u2, u3 }, angles = R:angles_about(u1, u2, u3)[1] }.rotation
    count, worst = count + 1, math.max(worst, R:distance(again))
  end
  near(n, count, 0, "of 10,000 with random axes")
  local tilted = reached(x + 0.1*y, y, z)
  holds(tilted < n, "not all of them when u1 is tilted to u2, by 0.1")
  near(0, worst, 4e-15, "the angles make the rotation again")
end)
