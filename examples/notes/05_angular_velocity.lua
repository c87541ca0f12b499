-- Section 5 of the notes: angular velocity.
--
-- If Q is a rotation operator that depends on t, then Q' Q^T is skew, so that there is one vector omega with
-- Q' Q^T x = omega x x. While axis u and angle theta move,
--   (15)  omega = theta' u + (1 - cos theta) u x u' + sin theta u'.

-- A motion with its rates: u nods while it goes round, theta grows through 2 pi.
local function axis(t) return vec(sin(1 + 0.3*t)*cos(2*t), sin(1 + 0.3*t)*sin(2*t), cos(1 + 0.3*t)) end
local function angle(t) return 0.5 + t + 0.2*t^2 end
local function axis_rate(t)
  local s, c = sin(1 + 0.3*t), cos(1 + 0.3*t)
  return 0.3*vec(c*cos(2*t), c*sin(2*t), -s) + 2*s*vec(-sin(2*t), cos(2*t), 0)
end
local function angle_rate(t) return 1 + 0.4*t end
local function motion(t) return rotation(axis(t), angle(t)) end
local function omega(t)
  return angular_velocity { axis = axis(t), axis_rate = axis_rate(t), angle = angle(t), angle_rate = angle_rate(t) }
end

-- Q' by the difference of fourth order: h^4/30 of the fifth derivative (|omega|^5, some 2e3 here), 9e-12 at h = 6e-4,
-- and 1.5/h times the rounding of 1e-16, 3e-13. Products of three such entries with those of Q are added.
local h, tolerance = 6e-4, 1e-10
local function matrix_rate(t)
  local function difference(d, i, j) return motion(t + d).matrix[i][j] - motion(t - d).matrix[i][j] end
  local m = {}
  for i = 1, 3 do
    m[i] = {}
    for j = 1, 3 do m[i][j] = (8*difference(h, i, j) - difference(2*h, i, j))/(12*h) end
  end
  return m
end

-- Q' Q^T.
local function spin_matrix(t)
  local rate, q, m = matrix_rate(t), motion(t).matrix, {}
  for i = 1, 3 do
    m[i] = {}
    for j = 1, 3 do m[i][j] = dot(rate[i], q[j]) end
  end
  return m
end

print "t      theta      omega by (15)"
for t = 0, 4 do
  local w = omega(t)
  print(("%d  %9.5f      %9.6f %9.6f %9.6f"):format(t, angle(t), w.x, w.y, w.z))
end
print ""

theorem("Q' Q^T is skew, and (15) is its vector", function()
  for t = 0, 4 do
    local m = spin_matrix(t)
    local worst = 0
    for i = 1, 3 do
      for j = 1, 3 do worst = math.max(worst, abs(m[i][j] + m[j][i])) end
    end
    near(0, worst, tolerance, "m + m^T at t = " .. t)
    near(vec(m[3][2], m[1][3], m[2][1]), omega(t), tolerance, "omega at t = " .. t)
  end
end)

theorem("any rates of axis and angle can be had, if theta is no multiple of 2 pi", function()
  -- The inverse of (15). omega is rounded, by half an ulp of 4 (4e-16), twice with its length; what is across the
  -- axis is then divided by 2 sin(theta/2), 0.15 at least here.
  for t = 0, 4 do
    local rates = rotation_rates(motion(t), omega(t))
    near(angle_rate(t), rates.angle_rate, 3e-15, "theta' at t = " .. t)
    near(axis_rate(t), rates.axis_rate, 1e-14, "u' at t = " .. t)
  end
end)

theorem("at theta = 2 pi n the axis jumps to the direction of omega", function()
  for n = -1, 1 do
    local turned = rotation({ 0, 0, 1 }, 2*pi*n)
    local jumped = rotation_rates(turned, { 3, 4, 0 })
    holds(jumped.jump, "n = " .. n .. ": it jumps")
    near(vec(0.6, 0.8, 0), jumped.axis, 1.2e-16, "to omega/|omega|")
    near(5, jumped.angle_rate, 0, "and theta grows at |omega|")
    holds(not rotation_rates(turned, { 0, 0, -2 }).jump, "but not if omega is along it")
  end
end)

theorem("and so it does in a run that starts there", function()
  local run = evolve { omega = { 3, 4, 0 }, from = rotation({ 0, 0, 1 }, 0), to = 1 }
  near(vec(0.6, 0.8, 0), run(1e-9).axis, 1.2e-16, "the axis after 1e-9")
  near(5e-9, run(1e-9).angle, 1e-24, "the angle")
end)

theorem("driven by (15), through 2 pi and 4 pi, the body keeps to (u(t), theta(t))", function()
  local run = evolve { omega = omega, from = motion(0), to = 6, accuracy = 1e-12 }
  -- The estimate is of first order: a quarter more; the axis of a rotation is off by 1/(2 sin(theta/2)) of it.
  local worst_angle, worst_axis = 0, 0
  for i = 0, 600 do
    local t, state = i/100, run(i/100)
    worst_angle = math.max(worst_angle, abs(state.angle - angle(t)))
    worst_axis = math.max(worst_axis, 2*abs(sin(angle(t)/2))*norm(state.axis - axis(t)))
  end
  near(0, worst_angle, 1.25*run.error_estimate + 4e-15, "theta(t), 601 times")
  near(0, worst_axis, 1.25*run.error_estimate + 4e-15, "2 sin(theta/2) times u(t)")
  near(2, #run.crossings, 0, "crossings of 2 pi n")
end)

theorem("|omega|^2 = theta'^2 + 4 sin^2(theta/2) |u'|^2", function()
  for t = 0, 4 do
    local speed = sqrt(angle_rate(t)^2 + 4*sin(angle(t)/2)^2*norm(axis_rate(t))^2)
    near(speed, norm(omega(t)), 4e-15, "t = " .. t)
  end
end)
