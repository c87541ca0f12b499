-- The log of a gyroscope, evolved: where the body has got to, how far it has turned, and what it cost.
--
--   rotor examples/gyroscope.lua FILE [DRIFT]  a CSV file with columns of t and of the rates of x, y and z, which may
--                                              be wrong by up to DRIFT, deg/s (default 0.01)
--   rotor examples/gyroscope.lua               a log made of a known motion, checked against that motion
--
-- A gyroscope measures omega in the body frame. The columns and their units are found by their names; where a log
-- has others, name them: spin.sampled(file, {columns = {t = ..., x = ..., y = ..., z = ...}, unit = "deg/s"}).

local here = arg[0]:match "^(.*/)" or "./"

-- The motion under the rates w of a log from its first time to its last.
local function follow(w, from)
  local times = w.times
  return evolve{ omega = spin.body(w), from = from, t = { times[1], times[#times] } }
end

-- The integral of |omega|: Simpson's rule in each interval.
local function total_turn(w)
  local sum, times = 0, w.times
  for i = 1, #times - 1 do
    local a, b = times[i], times[i + 1]
    sum = sum + (b - a)/6*(norm(w(a)) + 4*norm(w((a + b)/2)) + norm(w(b)))
  end
  return sum
end

-- drift: by how much the rates may be wrong, rad/s.
local function report(w, run, drift)
  local times = w.times
  local first, last = times[1], times[#times]
  local attitude = run(last).rotation:canonical()
  local q = attitude.quaternion
  print(w)
  print(("rows         %d, t %.4f .. %.4f s, %d gaps"):format(#times, first, last, #w.gaps))
  for _, gap in ipairs(w.gaps) do print(("  after row %d  %.4f .. %.4f s"):format(gap.row, gap.from, gap.to)) end
  print(("turned       %.2f deg in all (the integral of |omega|)"):format(total_turn(w)/deg))
  print(("net          %.4f deg about (%.4f, %.4f, %.4f)"):format(attitude.angle/deg, attitude.axis.x,
    attitude.axis.y, attitude.axis.z))
  print(("quaternion   %.6f, %.6f, %.6f, %.6f"):format(q.w, q.x, q.y, q.z))
  local yaw, pitch, roll = attitude:euler_angles "zyx"
  print(("euler zyx    %.4f, %.4f, %.4f deg"):format(yaw/deg, pitch/deg, roll/deg))
  print(("error        about %.1e rad, of the integration"):format(run.error_estimate))
  print(("bound        %.2f deg, were the rates wrong by up to %g deg/s all the way"):format(
    run:certify{ bias = drift }.bound/deg, drift/deg))
  print(("cost         %d omega calls, %d steps, %.3f s"):format(run.cost.omega_calls, run.cost.steps,
    run.cost.seconds))
  run:plot("angle", { height = 16 })
end

if arg[1] then
  local read, w = pcall(spin.sampled, arg[1])
  if not read then
    io.stderr:write("gyroscope.lua: ", w, "\n")
    os.exit(1)
  end
  report(w, follow(w), (tonumber(arg[2]) or 0.01)*deg)
  return
end

-- Coning (data/make_coning_gyro.py): tilted by theta about an axis that goes round at alpha in the x-y plane, the body
-- is back after each second. The bias that the log has is taken away. What is left of the rates about z is
-- constant and not zero, though nothing turns in the end: rates alone do not add up to an attitude.
local alpha, theta, bias = 2*pi, 0.2, { 0.5, -0.25, 0.125 }
local start = rotation({ 1, 0, 0 }, theta)
local w = spin.sampled(here .. "data/coning_gyro.csv", { bias = bias })
local run = follow(w, start)
report(w, run, 0.01*deg)

theorem("a coning body is back where it began", function()
  local times = w.times
  local duration = times[#times]
  -- In an interval h the straight line is within x (h - x)/2 max |omega''| of omega, in the mean h^2/12 of it; and the
  -- integral of the difference bounds the error of the attitude. |omega''| = alpha^3 sin theta. The digits of the log
  -- (half of 1e-9 deg/s, three components) add a little.
  local bound = run.error_estimate + sqrt(3)*0.5e-9*deg*duration
  for i = 2, #times do bound = bound + (times[i] - times[i - 1])^3/12*alpha^3*sin(theta) end
  local function off(motion) return motion(duration).rotation:distance(start) end
  near(0, off(run), bound, "distance from the start, straight lines")
  -- For |omega| differs from its model by no more than the vectors do.
  near(2*alpha*sin(theta/2)*duration, total_turn(w), bound, "integral of |omega|")
  -- A cubic spline is of fourth order: (alpha h)^2, some 1/200, times nearer, and its constant 5/384 is below 1/12.
  local cubic = follow(spin.sampled(here .. "data/coning_gyro.csv", { bias = bias, interpolation = "cubic" }), start)
  near(0, off(cubic), off(run)/100, "distance from the start, cubic spline")
end)

theorem("rates wrong by at most b rotate the end by at most the certified bound", function()
  local drift = 0.01*deg
  local bound = run:certify{ bias = drift }.bound
  local last = w.times[#w.times]
  for _, wrong in ipairs{ vec(1, 0, 0), vec(0, 0, -1), vec(1, -1, 1)/sqrt(3) } do
    local other = spin.sampled(here .. "data/coning_gyro.csv", { bias = vec(bias) - wrong*(drift/deg) })
    local off = follow(other, start)(last).rotation:distance(run(last).rotation)
    holds(off <= bound, ("off by %.4f of %.4f deg"):format(off/deg, bound/deg))
  end
end)
