-- Section 6.1 of the paper: the divergence of the field by which the Gibbs vector G = n tan(theta/2) moves, [P10], is
--   [P13]  2 omega . G  =  [P14]  2 tan(theta/2) theta'.
-- As printed. It takes both signs; "we are thus not able to classify this dynamical system as being conservative or
-- dissipative". But that is the chart: with the density (1 + |G|^2)^-2, volumes are kept by every omega(t), as a motion
-- only turns the sphere of unit quaternions, whose field has the divergence 0. In the modified Gibbs vector M the same
-- motion has the divergence -tan(theta/2) theta'/2, of the opposite sign.

local function omega(t) return vec(cos(0.5*t), sin(0.5*t), 0.3) end
local run = evolve { omega = omega, from = rotation({ 1, 1, 1 }, 1), to = 40, accuracy = 1e-12 }

-- The fields: n f(theta) moves as axis and angle do, [P5]; the scale f and its derivative.
local gibbs = { from = rotation.from_gibbs, face = "gibbs",
  f = function(angle) return tan(angle/2) end, slope = function(angle) return (1 + tan(angle/2)^2)/2 end }
local modified = { from = rotation.from_modified_gibbs, face = "modified_gibbs",
  f = function(angle) return sin(angle/2) end, slope = function(angle) return cos(angle/2)/2 end }
local function field(chart, x, w)
  local R = chart.from(x)
  local rates = rotation_rates(R, w)
  return chart.f(R.angle)*rates.axis_rate + chart.slope(R.angle)*rates.angle_rate*R.axis
end

-- By differences of fourth order in each direction.
local basis = { vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1) }
local function divergence(chart, R, w, h)
  local x, sum = R[chart.face], 0
  for _, e in ipairs(basis) do
    local function along(d) return dot(e, field(chart, x + d*e, w) - field(chart, x - d*e, w)) end
    sum = sum + (8*along(h) - along(2*h))/(12*h)
  end
  return sum
end

-- Times at which 0.2 < theta < 2: M reaches to theta = pi only, and G to infinity there.
local times = {}
for i = 0, 400 do
  local angle = run(i/10).angle
  if 0.2 < angle and angle < 2 then times[#times + 1] = i/10 end
end

-- G's field is of second degree, and the differences are exact for any h. |G| is 1.6 at most, 2.6 with the steps; the
-- field is rounded by 1e-15 times |G| (1 + |G|^2), 2e-14, and nine times that with 1.5/h = 3 for each direction.
local function in_gibbs(state) return divergence(gibbs, state.rotation, state.omega, 0.5) end
local exact = 2e-13
-- M's field has the fifth derivatives of cos(theta/2)/2 = sqrt(1 - |M|^2)/2, 15 |M| (3 + 4 |M|^2)/(2 cos(theta/2)^9),
-- 1e4 at most: three times h^4/30 of it, 6e-11, and 4.5/h times the rounding of 1e-15.
local function in_modified(state) return divergence(modified, state.rotation, state.omega, 5e-4) end
local cut = 8e-11

-- Q' = omega Q/2 is linear: the trace, each term of which is exactly 0.
local function in_quaternion(state)
  local w, sum = quaternion(0, state.omega.x, state.omega.y, state.omega.z), 0
  local one, i, j, k = quaternion(1, 0, 0, 0), quaternion(0, 1, 0, 0), quaternion(0, 0, 1, 0), quaternion(0, 0, 0, 1)
  for _, e in ipairs { one, i, j, k } do
    sum = sum + (w*e):dot(e)/2
  end
  return sum
end

print "The divergence of the same motion in three charts:\n"
print "   t     theta    theta'           G          M    quaternion"
for i = 1, #times, 9 do
  local state = run(times[i])
  print(("%5.1f %8.4f %8.4f  %11.6f%11.6f%9.1f"):format(state.t, state.angle, state.angle_rate, in_gibbs(state),
    in_modified(state), in_quaternion(state)))
end
print ""

theorem("[P13], [P14]: in G it is 2 omega . G = 2 tan(theta/2) theta'", function()
  local greatest, least = 0, 0
  for_each(times, function(t)
    local state = run(t)
    local found = in_gibbs(state)
    near(2*dot(omega(t), state.rotation.gibbs), found, exact, "[P13]")
    near(2*tan(state.angle/2)*state.angle_rate, found, exact, "[P14]")
    greatest, least = math.max(greatest, found), math.min(least, found)
  end)
  holds(least < -exact and greatest > exact, "it takes both signs")
end)

theorem("in M it is -tan(theta/2) theta'/2: volumes that grow in G shrink; in the quaternion it is 0", function()
  for_each(times, function(t)
    local state = run(t)
    near(-tan(state.angle/2)*state.angle_rate/2, in_modified(state), cut, "the divergence in M")
    near(0, in_quaternion(state), 0, "the divergence in Q")
  end)
end)

-- Four starts about G0 are carried by the motion. What their Gibbs vectors span, from 0 on at the times at which theta
-- = pi, where G is infinite, is not between them.
local function carried(size)
  local corners, simplices = { run }, {}
  for i, e in ipairs(basis) do corners[i + 1] = run:from(rotation.from_gibbs(run.start.gibbs + size*e)) end
  for i = 0, 400 do
    local t, g, product, together = i/10, {}, 1, true
    for n, corner in ipairs(corners) do
      local state = corner(t)
      together = together and state.quaternion.w*run(t).quaternion.w > 0
      g[n] = state.rotation.gibbs
      product = product*sqrt(1 + norm(g[n])^2)
    end
    local a, b, c = g[2] - g[1], g[3] - g[1], g[4] - g[1]
    if together then
      table.insert(simplices, { t = t, volume = box(a, b, c)/6, product = product, weight = 1 + norm(g[1])^2,
        size = math.max(norm(a), norm(b), norm(c)) })
    end
  end
  return simplices
end

theorem("a simplex keeps its volume over the product of sqrt(1 + |G|^2) of its corners", function()
  -- 6 V over this product is the determinant of the four unit quaternions, at most 1. Rounding of a corner by 1e-15
  -- changes it by as much; that of the edges from G1 is 1 + |G1|^2 times as large: 20 such.
  local simplices = carried(0.4)
  local start = simplices[1]
  for_each(simplices, function(now)
    near(start.volume/start.product, now.volume/now.product, 20/6*1e-15*now.weight, "volume/product")
  end)
  holds(#simplices > 200, "at more than half of 401 times")
end)

theorem("so (1 + |G|^2)^-2 is an invariant density", function()
  local simplices = carried(1e-3)
  local start = simplices[1]
  for_each(simplices, function(now)
    -- log sqrt(1 + |G|^2) has the slope 1/2 at most: three corners differ from the first by half the edges. Rounding
    -- as above, of a determinant of 6 volume/product.
    local tolerance = 1.5*(start.size + now.size) + 20e-15*now.weight*start.product/(6*start.volume)
    near(log(start.volume/start.weight^2), log(now.volume/now.weight^2), tolerance, "log(volume density)")
  end)
end)
