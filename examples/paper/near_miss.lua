-- Section 5 of the paper: to go through 2 pi in a non-trivial way "does not seem to occur naturally in our numerical
-- experiments". So it must be: M = n sin(theta/2) has three components, all of which have to be zero at one time. A
-- motion that only comes near 2 pi turns back, and its axis swings round to the opposite, the faster the nearer.
--
-- Here the body turns about k at the rate 1, and at t = 1 it is off from its first attitude by epsilon about i:
--   Q = (M0, M) = exp(k (t - 1)/2) exp(i epsilon/2),
-- so that with h = (t - 1)/2
--   M = sin(epsilon/2) (i cos h + j sin h) + cos(epsilon/2) sin h k,
-- theta = 2 pi - 2 asin |M| comes within epsilon of 2 pi, and n = -M/|M| goes from k over -i to -k.

local k = vec(0, 0, 1)
local function m(epsilon, t)
  local h = (t - 1)/2
  return sin(epsilon/2)*vec(cos(h), sin(h), 0) + cos(epsilon/2)*sin(h)*k
end

local function pass(epsilon, crossing_tolerance)
  local R = rotation(k, -1)*rotation({ 1, 0, 0 }, epsilon)
  return evolve { omega = function() return 0, 0, 1 end, to = 2, from = rotation(-R.axis, 2*pi - R.angle),
    accuracy = 1e-12, crossing_tolerance = crossing_tolerance }
end

-- M is known to half of what the rotation is, which is of first order: a quarter more, and the rounding of the start.
local function known(run) return 1.25/2*run.error_estimate + 1e-15 end

local epsilons = { 1e-3, 1e-8, 1e-12 }

print "(t - 1)/epsilon   (2 pi - theta)/epsilon, and n, for epsilon = 1e-3 and 1e-8:\n"
do
  local runs = { [1e-3] = pass(1e-3), [1e-8] = pass(1e-8) }
  for _, x in ipairs { -100, -3, -1, 0, 1, 3, 100 } do
    local line = ("%5d"):format(x)
    for _, epsilon in ipairs { 1e-3, 1e-8 } do
      local state = runs[epsilon](1 + x*epsilon)
      line = line .. ("  %9.4f  %7.4f %7.4f %7.4f"):format((2*pi - state.angle)/epsilon, state.axis.x, state.axis.y,
        state.axis.z)
    end
    print(line)
  end
end
print ""

theorem("a near miss is no crossing: theta turns back, and the axis swings round", function()
  for_each(epsilons, function(epsilon)
    local run = pass(epsilon)
    near(0, #run.crossings, 0, "crossings")
    near(0, #run.notes, 0, "notes")
    for _, x in ipairs { -1e3, -100, -10, -3, -1, -0.3, 0, 0.3, 1, 3, 10, 100, 1e3 } do
      local t = x == -1e3 and 0 or x == 1e3 and 2 or 1 + x*epsilon
      local exact, state = m(epsilon, t), run(t)
      -- theta is rounded by 1e-15, and off by 2/cos(theta/2) of what M is, sin(theta/2) < 0.5.
      near(2*pi - 2*asin(norm(exact)), state.angle, 2.4*known(run) + 1e-15, "theta")
      near(-unit(exact), state.axis, known(run)/norm(exact), "n")
    end
    -- By [P5], omega being across n; sin(theta/2) is |M|.
    near(1, 2*sin(epsilon/2)*norm(run(1).axis_rate), 3*known(run)/sin(epsilon/2), "2 sin(epsilon/2) |n'| at t = 1")
  end)
end)

theorem("crossing_tolerance: up to it a crossing, from four times it on a near miss, undecided between", function()
  for_each(epsilons, function(epsilon)
    local exact = pass(epsilon)
    for _, case in ipairs { { 100, "through" }, { 1.1, "through" }, { 0.9, "undecided" }, { 0.26, "undecided" },
      { 0.24 }, { 0.01 } } do
      local run = pass(epsilon, case[1]*epsilon)
      local crossing = run.crossings[1]
      near(case[2] and 1 or 0, #run.crossings, 0, "what is listed")
      holds((crossing and crossing.kind) == case[2], "through up to it, then undecided, then nothing")
      holds(not crossing or abs(crossing.distance - epsilon) <= 2.4*known(run) + epsilon^3, "its distance is epsilon")
      -- Taken for a crossing theta goes on beyond 2 pi, and n stays; the motion is the same.
      local through = case[2] == "through"
      local after, side = m(epsilon, 2), through and 1 or -1
      near(2*pi + side*2*asin(norm(after)), run(2).angle, 2.4*known(run) + 1e-15, "theta after")
      near(side*unit(after), run(2).axis, 2.4*known(run), "n after")
      near(exact(2).quaternion, run(2).quaternion, 0, "the quaternion after")
      holds((run.notes[1] ~= nil) == (case[2] == "undecided"), "run.notes says what is undecided")
    end
  end)
end)

theorem("if nothing is given it is twice the error estimate: what cannot be told from a crossing is one", function()
  local run = pass(1e-15)
  near(2*run.error_estimate, run.crossing_tolerance, 0, "crossing_tolerance")
  holds(1e-15 < run.error_estimate, "epsilon is less than the error")
  holds(run.crossings[1].kind == "through", "so it goes through")
end)
