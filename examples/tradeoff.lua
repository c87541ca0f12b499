-- What accuracy costs: [P15] with T = 40 to t = 4200, the motion of Figures 3 to 9 of
--   J. H. Elton, J. R. Elton, Evolving the Euler rotation axis as a dynamical system,
-- by the methods of rotor, and as the paper has it: the classical Runge-Kutta method (RK4) on the equation of the
-- Euler vector [P7].
--
--   rotor examples/tradeoff.lua

local alpha = 2*pi/40
local from = rotation.from_euler_vector(vec(1, 1, 1)/sqrt(3))

-- The closed form, which the general methods are not told of: Q(t) = exp(k alpha t/2) exp((i - alpha k) t/2) Q(0).
local function exact(t)
  return rotation({ 0, 0, 1 }, alpha*t)*rotation({ 1, 0, -alpha }, sqrt(1 + alpha^2)*t)*from
end

local accuracies = { 1e-4, 1e-6, 1e-8, 1e-10, 1e-12 }
local work = tradeoff {
  omega = function(t) return cos(alpha*t), sin(alpha*t), 0 end,
  from = from,
  to = 4200,
  methods = { "fgl", "dop853", "rk4",
    { method = "rk4", equation = "euler", label = "rk4 on E [P7]" } },
  accuracies = accuracies,
  steps = { 0.1, 0.05, 0.01 },
  reference = exact,
}

print(work)
print ""
work:plot { title = "The greatest error on the way, by calls of omega" }
print ""

local rows = {}
for _, row in ipairs(work.rows) do
  rows[row.method] = rows[row.method] or {}
  rows[row.method][row.asked or row.step] = row
end

theorem("the paper's RK4 on [P7]: its error at t = 4200", function()
  -- It is greatest at the end. Half a unit of the last digit given.
  local paper = rows["rk4 on E [P7]"]
  near(4.82e-3, paper[0.1].achieved, 5e-6, "h = 0.1")
  near(3.23e-4, paper[0.05].achieved, 5e-7, "h = 0.05")
  -- Order 4; with h of the next order.
  near(625, paper[0.05].achieved/paper[0.01].achieved, 625*0.05, "h = 0.01, 625 times better")
end)

theorem("the quaternion is better with the same steps", function()
  for _, step in ipairs { 0.1, 0.05 } do
    holds(rows.rk4[step].achieved < rows["rk4 on E [P7]"][step].achieved/20, "20 times, h = " .. step)
  end
  -- Order 4; with h/2 of the next order.
  near(16, rows.rk4[0.1].achieved/rows.rk4[0.05].achieved, 16*0.05, "half the step, a sixteenth of the error")
end)

theorem("what is asked for is kept, or what the run reports", function()
  for _, method in ipairs { "fgl", "dop853" } do
    for _, asked in ipairs(accuracies) do
      local row = rows[method][asked]
      holds(row.achieved <= math.max(asked, row.estimate), ("%s to %.0e"):format(method, asked))
    end
  end
end)

theorem("fgl asks omega least", function()
  -- At 1e-8, by calls: what is measured is a count, not a time.
  holds(rows.fgl[1e-8].omega_calls < rows.dop853[1e-8].omega_calls/20, "20 times less than dop853")
  holds(rows.fgl[1e-8].omega_calls < rows.rk4[0.01].omega_calls/100, "100 times less than rk4, and better")
  holds(rows.fgl[1e-8].achieved < rows.rk4[0.01].achieved, "better")
end)
