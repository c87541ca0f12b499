-- Figures 1 and 2 and the example of section 4 of the paper: the body starts turned by 90 degrees about i and spins
-- about k at rate 1. In Theorem 4.1 then a = 1/sqrt(2), b = 0, e1 = i, e2 = (j + k)/sqrt(2), and
--   theta(t) = 2 acos(cos(t/2)/sqrt(2)),  n(t) = (cos(t/2), sin(t/2), sin(t/2))/sqrt(1 + sin^2(t/2)).
-- A point B of the body that is in the plane of x and y goes round in 2 pi; n goes round in 4 pi, in a plane tilted by
-- 45 degrees. As printed. The pictures are drawn by examples/euler_spinor.lua.

local run = evolve { omega = function() return 0, 0, 1 end, from = rotation({ 1, 0, 0 }, pi/2), to = 8*pi,
  accuracy = 1e-12 }
-- theta is as well known as the rotation (to the estimate, of first order: a quarter more), n to that over
-- 2 sin(theta/2) >= sqrt(2), E = n theta to less than 3 pi/2 + 1 of it. Closed forms are rounded by 2e-15.
local known = 1.25*run.error_estimate + 2e-15
local known_e = (3*pi/2 + 1)*known

-- The greatest of a difference at 201 times, or nan, which math.max passes over.
local function worst(difference)
  local greatest = 0
  for i = 0, 200 do
    local found = difference(4*pi*i/200)
    if found ~= found then return found end
    greatest = math.max(greatest, found)
  end
  return greatest
end

theorem("the example of section 4: theta(t) and n(t)", function()
  local function theta(t) return 2*acos(cos(t/2)/sqrt(2)) end
  local function n(t) return vec(cos(t/2), sin(t/2), sin(t/2))/sqrt(1 + sin(t/2)^2) end
  near(0, worst(function(t) return abs(run(t).angle - theta(t)) end), known, "theta(t), 201 times")
  near(0, worst(function(t) return norm(run(t).axis - n(t)) end), known, "n(t), 201 times")
end)

theorem("Figure 1: n at 0, pi, 2 pi, 4 pi, and the body", function()
  near(vec(1, 0, 0), run(0).axis, known, "n(0) = e1 = i")
  near(vec(0, 1, 1)/sqrt(2), run(pi).axis, known, "n(pi) = e2 = (j + k)/sqrt(2)")
  near(vec(-1, 0, 0), run(2*pi).axis, known, "n(2 pi) = -i, after one revolution of the body")
  near(vec(1, 0, 0), run(4*pi).axis, known, "n(4 pi) = i, after two")
  -- B is at x at first: its place in the body is Q(0)^-1 x.
  local b = run.start:inverse()*vec(1, 0, 0)
  near(0, worst(function(t) return norm(run(t).rotation*b - vec(cos(t), sin(t), 0)) end), known,
    "B(t) = (cos t, sin t, 0), 201 times")
  near(0, worst(function(t) return abs(dot(run(t).axis, vec(0, 1, -1)/sqrt(2))) end), known,
    "n keeps to the plane of i and j + k, tilted by 45 degrees")
end)

theorem("Figure 2: E has the period 4 pi, and |E| goes from pi/2 to 3 pi/2 and back", function()
  near(vec(pi/2, 0, 0), run(0).euler_vector, known_e, "E(0) = (pi/2) i")
  near(pi*vec(0, 1, 1)/sqrt(2), run(pi).euler_vector, known_e, "E(pi) = pi (0, 1, 1)/sqrt(2)")
  near(vec(-3*pi/2, 0, 0), run(2*pi).euler_vector, known_e, "E(2 pi) = -(3 pi/2) i")
  near(0, worst(function(t) return norm(run(t + 4*pi).euler_vector - run(t).euler_vector) end), 2*known_e,
    "E(t + 4 pi) = E(t), 201 times")
  holds(worst(function(t) return abs(run(t).angle - pi) end) <= pi/2 + known, "pi/2 <= |E| <= 3 pi/2, 201 times")
end)
