-- Work and precision: the time that each solver takes with a Lua omega, by the error that it reaches.
--
--   rotor bench/picture.lua races.csv [PROBLEM]   (default P1), of the rows that bench/run leaves behind

assert(arg[1], "usage: rotor bench/picture.lua races.csv [PROBLEM]")
local races, problem = read_csv(arg[1]), arg[2] or "P1"

local points, solvers = {}, {}
for i, name in ipairs(races.problem) do
  if name == problem and races.omega[i] == "Lua" then
    points[#points + 1] = { ms = races.ms[i], error = races.error[i], solver = races.solver[i] }
    solvers[races.solver[i]] = true
  end
end
table.sort(points, function(p, q) return p.ms < q.ms end)

local ms, errors = {}, {}
for solver in pairs(solvers) do errors[solver] = {} end
for i, point in ipairs(points) do
  ms[i] = point.ms
  for solver, list in pairs(errors) do list[i] = point.solver == solver and point.error or 0/0 end
end
plot(ms, errors, { log = "xy", x_label = "CPU ms", y_label = "achieved error (quaternions)",
  title = problem .. ", omega in Lua" })
