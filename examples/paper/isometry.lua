-- Section 6.3 of the paper asks whether motions depend sensitively on their start, and finds Lyapunov exponents that
-- converge to 0, "about 10^-5" after 10^5 steps. They are exactly 0, for every omega(t): two bodies that it moves stay
-- as far apart as they were, as Q(t) = U(t) Q(0), and a product with a unit quaternion keeps distances. What is left is
-- E's own measure of distance: if the bodies are d apart and theta + d < 2 pi,
--   d <= |E1 - E2| <= d s(theta + d),  s(theta) = (theta/2)/sin(theta/2),
-- so that the exponent which is found in E is log(s)/t at most: it dies away as 1/t.

local function stretch(angle) return angle/2/sin(angle/2) end

local omegas = {
  { what = "constant", omega = { 1, 2, 2 } },
  { what = "[P15], T = 40", omega = function(t) return cos(2*pi/40*t), sin(2*pi/40*t), 0 end },
  { what = "ever faster", omega = function(t) return cos(t^2/20), sin(t^2/20), t/20 end },
  { what = "jumps", omega = spin.piecewise { { 1, 0, 0 }, 20, function(t) return 0, cos(t), 1 end, 35, { 0, 0, 2 } } },
  { what = "in the body", omega = spin.body(function(t) return sin(t), 0.3, cos(2*t) end) },
}

theorem("two bodies stay as far apart as they were", function()
  for_all({ first = any.rotation, second = any.rotation }, function(case)
    for _, scene in ipairs(omegas) do
      -- Each by Runge-Kutta on [P7], which knows of no U(t); known to its estimate, of first order: a quarter more.
      local function follow(start)
        return evolve { omega = scene.omega, from = start, to = 50, accuracy = 1e-10, method = "dop853",
          equation = "euler", restart = true }
      end
      local one, two = follow(case.first), follow(case.second)
      for t = 0, 50 do
        near(case.first:distance(case.second), one(t).rotation:distance(two(t).rotation),
          1.25*(one.error_estimate + two.error_estimate), scene.what)
      end
    end
  end, { n = 3, seed = 63 })
end)

-- The paper's scene, in closed form, and bodies that start a little apart from it.
local run = evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = 2*pi/40 },
  from = rotation({ 1, 1, 1 }, 1), to = 1e5 }
local d = 1e-3
local function apart(direction) return run:from(rotation(direction, d)*run.start) end

print "T = 40, two bodies 1e-3 apart: what E makes of the distance, and of the exponent\n"
print "       t     theta    distance   |E1 - E2|    log(|E1 - E2|/d)/t    log(s)/t"
local other = apart { 0, 0, 1 }
for _, t in ipairs { 1, 10, 100, 1e3, 1e4, 1e5 } do
  local a, b = run(t), other(t)
  local length = norm(a.euler_vector - b.euler_vector)
  print(("%8.0f  %8.4f  %.8f  %.8f  %20.2e  %10.2e"):format(t, a.angle, a.rotation:distance(b.rotation), length,
    log(length/d)/t, log(stretch(a.angle + d))/t))
end
print ""

theorem("in E the distance is from d to d s(theta + d), and the exponent dies away", function()
  for_all({ direction = any.direction, t = any.number(0, 1e5) }, function(case)
    local a, b = run(case.t), apart(case.direction)(case.t)
    local length, most = norm(a.euler_vector - b.euler_vector), stretch(a.angle + d)
    -- Both have the same U(t): the rotations are rounded by 1e-15, E by s of that.
    local rounding = 2e-15*most
    near(d, a.rotation:distance(b.rotation), 2e-15, "the distance of the bodies")
    holds(length >= d - rounding and length <= d*most + rounding, "that of their Euler vectors")
  end, { n = 2000, seed = 63 })
end)
