-- Section 5 of the notes, its question: does a straight line (u(t), theta(t)) between two rotations correspond to
-- the obvious minimum path between them? And: omega moves the body along any path that one specifies.
--
-- The length of a path of rotations is the integral of |omega|. From a quarter turn about x to one about y:
local from, to = rotation({ 1, 0, 0 }, pi/2), rotation({ 0, 1, 0 }, pi/2)

-- Integral from 0 to 1 by Gauss-Legendre with five points in each of 20 parts, below 1e-15 for integrands as smooth
-- as these; its 100 additions round by half an ulp of 64 each, 7e-15/40.
local rounding = 2e-14
local function integral(f)
  local nodes = { { 0, 128/225 } }
  for _, sign in ipairs { -1, 1 } do
    nodes[#nodes + 1] = { sign*sqrt(5 - 2*sqrt(10/7))/3, (322 + 13*sqrt(70))/900 }
    nodes[#nodes + 1] = { sign*sqrt(5 + 2*sqrt(10/7))/3, (322 - 13*sqrt(70))/900 }
  end
  local sum, parts = 0, 20
  for i = 1, parts do
    for _, node in ipairs(nodes) do sum = sum + node[2]*f((i - 0.5 + node[1]/2)/parts) end
  end
  return sum/(2*parts)
end

-- 1. Straight in (u, theta): theta stays, and u turns from x to y at a constant rate.
local straight = {}
function straight.at(s) return rotation({ cos(pi/2*s), sin(pi/2*s), 0 }, pi/2) end
function straight.omega(s)
  return angular_velocity { axis = { cos(pi/2*s), sin(pi/2*s), 0 }, angle = pi/2,
    axis_rate = pi/2*vec(-sin(pi/2*s), cos(pi/2*s), 0) }
end

-- 2. Straight in the Euler vector: E' is constant, omega = J_l(E) E'.
local chord = {}
local e0, e1 = from.euler_vector, to.euler_vector
function chord.at(s) return rotation.from_euler_vector(e0 + s*(e1 - e0)) end
function chord.omega(s) return rotation.left_jacobian(e0 + s*(e1 - e0))*(e1 - e0) end

-- 3. The geodesic: omega is constant, the Euler vector of the rotation that leads from the first to the second.
local geodesic = {}
local step = to*from:inverse()
function geodesic.at(s) return slerp(from, to, s) end
function geodesic.omega() return step.euler_vector end

local paths = { { "straight in (u, theta)", straight }, { "straight in E", chord }, { "geodesic", geodesic } }
for _, path in ipairs(paths) do
  path.length = integral(function(s) return norm(path[2].omega(s)) end)
  print(("%-24s length %.6f"):format(path[1], path.length))
end
print ""

-- The three paths as motions, each driven by the omega that it needs.
local function drive(path) return evolve { omega = path.omega, from = from, to = 1, accuracy = 1e-12 } end
drive(chord):plot({ "axis_x", "axis_y", "angle" }, { height = 12, title = "Straight in E: the axis and the angle" })
print ""

theorem("the question: no, neither straight line is the shortest path", function()
  near(pi/sqrt(2), paths[1].length, rounding, "straight in (u, theta): 2 sin(theta/2) |u'|")
  near(2.110554, paths[2].length, 5e-7, "straight in E")
  near(2*pi/3, paths[3].length, rounding, "geodesic: a third of a turn")
  near(from:distance(to), paths[3].length, rounding, "which is the distance")
  holds(paths[3].length < paths[2].length and paths[2].length < paths[1].length, "and the order is as printed")
end)

theorem("straight in E: shortest through the origin, longer elsewhere", function()
  local speed = norm(rotation.left_jacobian({ 1, 2, 2 })*vec(1, 2, 2))
  near(3, speed, 1e-15, "|J_l(E) E| = |E|")
  local ends, shorter = rotation.random(5, 200), 0
  for i = 1, 199, 2 do
    local a, b = ends[i].euler_vector, ends[i + 1].euler_vector
    local length = integral(function(k) return norm(rotation.left_jacobian(a + k*(b - a))*(b - a)) end)
    if length < ends[i]:distance(ends[i + 1]) + 1e-6 then shorter = shorter + 1 end
  end
  near(0, shorter, 0, "of 100 random lines, shortest")
end)

theorem("the omega that a path needs moves the body along it, and it comes back to it", function()
  for _, path in ipairs(paths) do
    local run, worst = drive(path[2]), 0
    for i = 0, 100 do worst = math.max(worst, run(i/100).rotation:distance(path[2].at(i/100))) end
    -- The estimate is of first order: a quarter more for what it leaves out.
    near(0, worst, 1.25*run.error_estimate + 1e-15, path[1] .. ": off the path, 101 times")
    near(to, run(1).rotation, 1.25*run.error_estimate + 1e-15, "its end")
  end
end)

theorem("a spline is a path too: through given rotations, with continuous omega and omega'", function()
  local times = { 0, 1, 1.5, 4 }
  local rotations = { from, to, rotation({ 1, 2, 3 }, 2), rotation({ 0, 0, 1 }, -1) }
  local s = rotation.spline(times, rotations)
  for i, t in ipairs(times) do near(rotations[i], s(t), 2e-15, "rotation " .. i) end
  local run = evolve { omega = s, from = s(0), to = 4, accuracy = 1e-11 }
  local worst = 0
  for i = 0, 100 do worst = math.max(worst, run(i/25).rotation:distance(s(i/25))) end
  near(0, worst, 1.25*run.error_estimate + 1e-15, "driven by its omega, 101 times")
end)
