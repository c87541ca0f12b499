-- Theorem 5.1 of the paper: if at every time some derivative of omega, omega itself counted, is not zero, then n and
-- theta can be defined with n continuous and theta differentiable for all time; if the next derivative exists there,
-- n is differentiable too. As printed.
--
-- Axis and angle are chosen, and omega is made of them, so that what the run must find is known exactly: n goes round a
-- cone, theta comes to 2 pi times `multiple` at t = 0, every, 2 every, ..., where omega^(order) is the first derivative
-- of omega that is not zero; its length is that of the next derivative of theta.
local motions = {
  { text = "4 pi sin^2(t/2)", every = pi/2, multiple = { 0, 1, 2, 1, 0, 1 }, order = { 1, 0, 1, 0, 1, 0 }, turns = 0,
    length = { 2*pi, 2*pi, 2*pi, 2*pi, 2*pi, 2*pi },
    swing = function(t) return 4*pi*sin(t/2)^2 end, rate = function(t) return 2*pi*sin(t) end },
  { text = "2 pi + 2 sin t sin^2(t/2)", every = pi, multiple = { 1, 1, 1 }, order = { 2, 0, 2 }, turns = 1,
    length = { 3, 2, 3 }, swing = function(t) return 2*sin(t)*sin(t/2)^2 end,
    rate = function(t) return 2*cos(t)*sin(t/2)^2 + sin(t)^2 end },
  { text = "-2 pi + 2 sin^2 t sin^2(t/2)", every = pi, multiple = { -1, -1, -1 }, order = { 3, 1, 3 }, turns = -1,
    length = { 12, 4, 12 }, swing = function(t) return 2*sin(t)^2*sin(t/2)^2 end,
    rate = function(t) return 4*sin(t)*cos(t)*sin(t/2)^2 + sin(t)^3 end },
}

local first, last = -1, 8
local function follow(case)
  local motion, s, c, r = case.motion, sin(case.slope), cos(case.slope), case.rate
  local function axis(t) return vec(s*cos(r*t), s*sin(r*t), c) end
  local function axis_rate(t) return r*s*vec(-sin(r*t), cos(r*t), 0) end
  local function angle(t) return 2*pi*motion.turns + motion.swing(t) end
  local function omega(t)
    -- theta' n + (1 - cos theta) n x n' + sin theta n', by components, which lets rotor differentiate it exactly, and
    -- with sines of what is small only, so that it keeps its digits where it is.
    local swing, rate, x, y = motion.swing(t), motion.rate(t), s*cos(r*t), s*sin(r*t)
    local across, along = 2*r*sin(swing/2)^2, r*sin(swing)
    return (rate - across*c)*x - along*y, (rate - across*c)*y + along*x, rate*c + across*s^2
  end
  local run = evolve { omega = omega, t = { first, last }, from = rotation(axis(first), angle(first)),
    method = "dop853", accuracy = case.accuracy }
  -- A run knows the rotation, and theta, to its estimate, which is of first order: a quarter more. Start and omega are
  -- rounded, by some 1e-15.
  return run, { angle = angle, axis = axis, axis_rate = axis_rate, known = 1.25*run.error_estimate + 1e-14 }
end

local function for_all_motions(check)
  for_all({ motion = any.one_of(motions), slope = any.number(0, pi), rate = any.number(-1, 1),
    accuracy = any.one_of { 1e-4, 1e-6, 1e-8, 1e-10 } }, function(case)
    local run, exact = follow(case)
    check(run, exact, case)
  end, { n = 25, seed = 51 })
end

local function greatest(f)
  local value = 0
  for k = 0, 300 do
    local found = f(first + (last - first)*k/300)
    if found ~= found then return found end
    value = math.max(value, found)
  end
  return value
end

print "Where theta comes to 2 pi k, by a run of accuracy 1e-8:\n"
print "     t, exact         measured   may be off by   i  kind      theta     |n - exact|"
for _, motion in ipairs(motions) do
  print(" theta = " .. motion.text)
  local run, exact = follow { motion = motion, slope = 1, rate = 1, accuracy = 1e-8 }
  for k, crossing in ipairs(run.crossings) do
    print(("%14.10f %16.10f %15.1e %3d  %-8s %6.3f %13.1e"):format((k - 1)*motion.every, crossing.t, crossing.t_error,
      crossing.order, crossing.kind, crossing.angle, norm(crossing.axis - exact.axis((k - 1)*motion.every))))
  end
end
print ""

theorem("Theorem 5.1: theta(t) and n(t) are the ones that omega was made of, and n'(t)", function()
  for_all_motions(function(run, exact)
    near(0, greatest(function(t) return abs(run(t).angle - exact.angle(t)) end), exact.known,
      "theta(t), 301 times")
    -- Where M = n sin(theta/2) is small n is known as well as the rotation is over 2 sin(theta/2), and n' by [P5],
    -- with cot(theta/2), to |omega| < 7 times that of the rotation over sin^2(theta/2).
    local function sine(t) return abs(sin(exact.angle(t)/2)) end
    near(0, greatest(function(t) return 2*sine(t)*norm(run(t).axis - exact.axis(t)) end), exact.known,
      "2 sin(theta/2) times n(t)")
    near(0, greatest(function(t) return sine(t)^2*norm(run(t).axis_rate - exact.axis_rate(t)) end), 7*exact.known,
      "sin^2(theta/2) times n'(t)")
  end)
end)

theorem("where theta comes to 2 pi k, and how it goes on; t_error is right, and no greater than it must be", function()
  for_all_motions(function(run, _, case)
    local motion = case.motion
    near(#motion.order, #run.crossings, 0, "how often")
    for k, crossing in ipairs(run.crossings) do
      local t, i, factorial = (k - 1)*motion.every, motion.order[k], ({ 1, 2, 6, 24 })[motion.order[k] + 1]
      near(i, crossing.order, 0, "i")
      near(2*pi*motion.multiple[k], crossing.angle, 0, "theta there")
      holds(crossing.kind == (i % 2 == 0 and "through" or "back"), "through for even i, back for odd i")
      -- |M| = length h^(i+1)/(2 (i+1)!) comes out of its error, half that of the rotation. t is rounded.
      local by_m = (factorial*run.error_estimate/motion.length[k])^(1/(i + 1))
      near(t, crossing.t, crossing.t_error, "t")
      near(by_m, crossing.t_error, 0.01*by_m + 1e-14, "t_error")
    end
  end)
end)

theorem("n and n' go on at 2 pi k, also where M is lost in its error", function()
  for_all_motions(function(run, exact, case)
    for k, crossing in ipairs(run.crossings) do
      -- The direction of omega^(i) moves by (i + 2) n', and what gives n' by (i + 3)/2 n''; on the cone both are at
      -- most 1.
      local t = (k - 1)*case.motion.every
      local known = (crossing.order + 2)*crossing.t_error
      near(exact.axis(t), crossing.axis, known, "n there")
      near(exact.axis_rate(t), crossing.axis_rate, known, "n' there")
      for _, beside in ipairs { t - known, t - known/2, t, t + known/2, t + known } do
        near(exact.axis(beside), run(beside).axis, known, "n beside it")
        near(exact.axis_rate(beside), run(beside).axis_rate, known, "n' beside it")
      end
    end
  end)
end)

-- What the hypothesis excludes: the body comes back to its first attitude at t = 1, turning about i, and turns on about
-- j. All derivatives of omega are zero there: for an instant, as it grows like exp(-0.1/(t - 1)^2), or for a while.
local excluded = {
  { last = 1, omega = function(t)
    local size = t == 1 and 0 or exp(-0.1/(t - 1)^2)
    if t < 1 then return size, 0, 0 else return 0, size, 0 end
  end },
  { last = 2, omega = spin.piecewise { { 1, 0, 0 }, 1, { 0, 0, 0 }, 2, { 0, 1, 0 } } },
}

theorem("where all derivatives of omega are zero, n may jump: then it has no value, and the run says so", function()
  for_each(excluded, function(case)
    local there = evolve { omega = case.omega, t = { 1, 0 }, accuracy = 1e-12 }
    local run = evolve { omega = case.omega, from = there(0).rotation, to = 3, accuracy = 1e-12 }
    -- 0.25 on |M| is 4e-3 at least: n is known as well as two rotations, over that.
    local known = 1.25*(run.error_estimate + there.error_estimate)/8e-3 + 1e-15
    near(vec(-1, 0, 0), run(0.75).axis, known, "n before")
    near(1, abs(run(case.last + 0.25).axis.y), known, "|n . j| after")
    near(1, #run.crossings, 0, "times at which M = 0, one interval")
    local crossing, axis = run.crossings[1], run(1).axis
    holds(crossing.t - crossing.t_error <= 1 and crossing.t + crossing.t_error >= case.last, "all within t_error of t")
    holds(crossing.kind == "undecided", "it is undecided how theta goes on")
    holds(crossing.axis == nil and axis.x ~= axis.x, "there is no axis: nan in the state")
    holds(run.notes[1]:find("omega and its derivatives are zero", 1, true) ~= nil, "run.notes says why")
  end)
end)
