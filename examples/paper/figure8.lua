-- Figure 8 of the paper: the Lyapunov exponents of E over t, for omega = (cos alpha t, sin alpha t, 0), T = 2 pi/alpha
-- = 40. They fall, to "about 10^-5" after 10^5 steps; from this it concludes that they converge to 0. They are 0 for
-- every omega(t): Q(t) = U(t) Q(0) is an isometry. What is plotted is E's measure of distance, across n by
-- s = (theta/2)/sin(theta/2) longer than that of the attitudes. With S = n n^T + s (1 - n n^T), and R a rotation,
--   dE(t)/dE(0) = S(t) R S(0)^-1,
-- of which the largest singular value is from s(t)/s(0) to s(t), the least from 1/s(0) to 1, and the product
-- (s(t)/s(0))^2: the exponents, their logarithms over t, fall as 1/t.
--
--   rotor examples/paper/figure8.lua [figure8.csv]     writes t and the three exponents to that file

local alpha = 2*pi/40
local e0, last = vec(1, 1, 1)/sqrt(3), 1e5
local run = evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = alpha },
  from = rotation(e0, 1), to = last }

-- [P15] in closed form, from any E(0).
local function exact(e, t)
  local q0 = quaternion(0, e.x/2, e.y/2, e.z/2):exp()
  local q = (t/2*quaternion(0, 0, 0, alpha)):exp()*(t/2*quaternion(0, 1, 0, -alpha)):exp()*q0
  local m = vec(q.x, q.y, q.z)
  return 2*atan(norm(m), q.w)*unit(m)
end

-- Its derivative with respect to E(0), columns, by differences of fourth order: they know of no isometry.
local function derivative(t, h)
  local d = {}
  for i, direction in ipairs { vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1) } do
    local function e(x) return exact(e0 + x*direction, t) end
    d[i] = (8*(e(h) - e(-h)) - (e(2*h) - e(-2*h)))/(12*h)
  end
  return d
end

-- By singular values, largest first: the squares are the eigenvalues of D^T D, by the cosine of a third.
local function by_singular_values(d, t)
  local trace = dot(d[1], d[1]) + dot(d[2], d[2]) + dot(d[3], d[3])
  local rows, p = { {}, {}, {} }, 0
  for i = 1, 3 do
    for j = 1, 3 do
      rows[i][j] = dot(d[i], d[j]) - (i == j and trace/3 or 0)
      p = p + rows[i][j]^2/6
    end
  end
  local third, list = acos(det(rows)/(2*p^1.5))/3, {}
  for i, turn in ipairs { 0, -2*pi/3, 2*pi/3 } do list[i] = log(trace/3 + 2*sqrt(p)*cos(third + turn))/(2*t) end
  return list
end

-- By QR: of the lengths of the columns, each less what it has of those before.
local function by_qr(d, t)
  local area, volume = norm(cross(d[1], d[2])), abs(box(d[1], d[2], d[3]))
  local list = { log(norm(d[1]))/t, log(area/norm(d[1]))/t, log(volume/area)/t }
  table.sort(list, function(a, b) return a > b end)
  return list
end

-- The exponents, and what they may be off by: a 15th of what half the step changes, doubled; and 1.5/h of the rounding
-- of E, 8 s < 10 units of theta, over a singular value > 0.95. The run knows them as well as E(t), 1e-15 t.
local h = 0.002
local function expected(t, by)
  local fine, coarse = by(derivative(t, h), t), by(derivative(t, 2*h), t)
  local off = 0
  for i = 1, 3 do off = math.max(off, abs(fine[i] - coarse[i])) end
  return fine, 2*off/15 + 1.5/h*1e-14/t + 1e-15
end

local function times(t)
  local list = {}
  for i = 1, floor(t) do list[i] = i end
  return list
end
local lyapunov = run:lyapunov { times = times(last) }
local shown = run:lyapunov {}
shown:plot { title = "Figure 8: Lyapunov exponents of E, T = 40", height = 14 }
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure8.csv"
if csv then shown:csv(csv) end

local s0 = 1/2/sin(1/2)
local function stretch(t) return run(t).angle/2/sin(run(t).angle/2) end

print "the largest exponent; its bounds, log(s(t)/s(0))/t and log(s(t))/t; and what a"
print "weighted average of t local rates makes of it\n"
print "      t       paper       rotor       exact       lower       upper    weighted"
for _, t in ipairs { 1e3, 2e3, 1e4, 1e5 } do
  local part, s = run:lyapunov { times = times(t) }, stretch(t)
  print(("%7d  %10s  %10.2e  %10.2e  %10.2e  %10.2e  %10.1e"):format(t, t == last and "about 1e-5" or "-",
    part.exponents[1], expected(t, by_singular_values)[1], log(s/s0)/t, log(s)/t, part.weighted))
end
print "  limit           0                       0"
print "-: no number in the text of the paper; its 1e-5 is after 1e5 steps\n"

theorem("Figure 8: the exponents at finite times, in closed form", function()
  -- Known beforehand, rounded to a unit of 1e-6.
  for_each({ { 1e3, 5.8e-5 }, { 2e3, 7.4e-5 }, { 1e4, 1.43e-4 }, { 1e5, 1.0e-5 } }, function(case)
    local t = case[1]
    local found, list, off = lyapunov.history[floor(t)], expected(t, by_singular_values)
    near(case[2], found[1], 5e-7, "the largest at 1e3, 2e3, 1e4, 1e5")
    for i = 1, 3 do near(list[i], found[i], off, "all three, by differences of the closed form") end
  end)
  local qr = run:lyapunov { method = "qr", times = { 10, 100, 1000 } }
  for_each(qr.times, function(t, k)
    local list, off = expected(t, by_qr)
    -- Up to 10 steps per unit of t, good to 1e-12 each.
    for i = 1, 3 do near(list[i], qr.history[k][i], off + 1e-11, "those by QR, from the axes at the start") end
  end)
end)

theorem("Figure 8: they fall as 1/t, to 0, as s(t) allows", function()
  for_each(shown.times, function(t, k)
    -- s, whose logarithm changes by less than 10 theta, and E are known as well as above.
    local found, s, off = shown.history[k], stretch(t), (1e-13 + 1e-14*t)/t
    near(2*log(s/s0)/t, found[1] + found[2] + found[3], off, "their sum is 2 log(s(t)/s(0))/t")
    holds(log(s/s0)/t - off <= found[1] and found[1] <= log(s)/t + off, "the largest: log s(t)/s(0) to log s(t)")
    holds(-log(s0)/t - off <= found[3] and found[3] <= off, "the least: -log s(0) to 0")
  end)
end)

theorem("Figure 8: they are 0: the flow is an isometry", function()
  local d = 1e-3
  local other = run:from(rotation({ 0, 0, 1 }, d)*run.start)
  for_each(shown.times, function(t)
    -- Both have the same U(t); four roundings of components.
    near(d, run(t).rotation:distance(other(t).rotation), 4*2^-53*4, "two bodies 1e-3 apart stay so")
  end)
  near(0, lyapunov.isometry, 1e-13, "by how much distances change until 1e5")
  local attitude = run:lyapunov { chart = "rotation" }
  for_each(attitude.history, function(exponents)
    for i = 1, 3 do near(0, exponents[i], 1e-15, "the exponents of the attitude, at all times") end
  end)
  -- A weighted average errs by less than any power of 1/n, the plain one by log(s)/t: 1e-10 is what is asked for.
  near(0, lyapunov.weighted, 1e-10, "in E, by a weighted average of 1e5 rates")
  holds(lyapunov.exponents[1] > 1e4*1e-10, "which the plain one does not reach")
end)
