-- What DOP853 asks for and reaches on P15, omega = (cos at, sin at, 0) with a = 2 pi/40, from E = (1, 1, 1)/sqrt 3 to
-- t = 4200: rotation error against the closed form, at 2001 times. bench/p15_scipy.py measures SciPy's the same way.
local a = 2*pi/40
local start = rotation({ 1, 1, 1 }, 1)

-- Q(t) = exp(k a t/2) exp((i - a k) t/2) Q0.
local function exact(t)
  return rotation({ 0, 0, 1 }, a*t)*rotation({ 1, 0, -a }, sqrt(1 + a^2)*t)*start
end

print "asked     rotation error   estimate    omega calls   seconds"
for _, accuracy in ipairs { 1e-6, 1e-9, 1e-12 } do
  local run = evolve {
    omega = function(t) return cos(a*t), sin(a*t), 0 end,
    from = start, to = 4200, accuracy = accuracy, method = "dop853",
  }
  local worst = 0
  for i = 0, 2000 do
    local t = 4200*i/2000
    worst = math.max(worst, run(t).rotation:distance(exact(t)))
  end
  print(("%.0e     %.2e         %.2e    %8d      %.3f"):format(accuracy, worst, run.error_estimate,
    run.cost.omega_calls, run.cost.seconds))
end
