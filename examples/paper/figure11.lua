-- Figure 11 of the paper: the recurrence plot of E for omega = (cos alpha t, sin alpha t, 0), T = 2 pi/alpha = 40: the
-- pairs of times at which E is within 0.1. Printed is that its "unequally spaced bands further confirm" the motion to
-- be quasiperiodic. Where lines are can be said beforehand: attitudes that are a lag tau apart in time are at all times
--   D(tau) = 2 acos |c(tau)|,  c = cos(alpha tau/2) cos(Omega tau/2) + alpha/Omega sin(alpha tau/2) sin(Omega tau/2),
-- from one another, Omega = sqrt(1 + alpha^2), and if c > 0 their E are as far at least. So lines are where D has a
-- minimum below the threshold and c > 0. Corrected: at 0.1, until 2400, these are the multiples of 720.02, equally
-- spaced; at 0.3 there are unequal ones. (At 0.1 the first of those are at 2439.4, where D is 0.097.)
--
--   rotor examples/paper/figure11.lua [figure11.csv]   writes the recurrent pairs for 0.1 to that file, for 0.3 to
--                                                    figure11_0.3.csv

local alpha = 2*pi/40
local omega = sqrt(1 + alpha^2)
local e0, last, every = vec(1, 1, 1)/sqrt(3), 2400, 0.3
local run = evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = alpha },
  from = rotation(e0, 1), to = last }

local q0 = quaternion(0, e0.x/2, e0.y/2, e0.z/2):exp()
local function exact(t)
  local q = (t/2*quaternion(0, 0, 0, alpha)):exp()*(t/2*quaternion(0, 1, 0, -alpha)):exp()*q0
  local m = vec(q.x, q.y, q.z)
  return 2*atan(norm(m), q.w)*unit(m)
end

-- c and D of a lag.
local function apart(lag)
  local c = cos(alpha*lag/2)*cos(omega*lag/2) + alpha/omega*sin(alpha*lag/2)*sin(omega*lag/2)
  return c, 2*acos(math.min(1, abs(c)))
end

-- The lags, to 0.01, at which D has a minimum below a threshold and c > 0.
local function expected(threshold)
  local lags = {}
  for lag = 0.02, last, 0.01 do
    local c, d = apart(lag)
    local _, before = apart(lag - 0.01)
    local _, after = apart(lag + 0.01)
    if c > 0 and d < threshold and d < before and d <= after then lags[#lags + 1] = lag end
  end
  return lags
end

-- What turns slowly is left out: pairs less than 3 apart.
local theiler = 10
local plots = {}
for _, threshold in ipairs { 0.1, 0.3 } do
  local recurrence = run:recurrence { threshold = threshold, every = every, theiler = theiler }
  recurrence:plot { title = "Figure 11: E within " .. threshold, height = 20 }
  plots[#plots + 1] = { threshold = threshold, found = recurrence, lags = recurrence:lags(),
    expected = expected(threshold) }
end
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure11.csv"
if csv then
  plots[1].found:csv(csv)
  plots[2].found:csv((csv:gsub("%.csv$", "")) .. "_0.3.csv")
end

local measures = { "pairs", "rate", "det", "mean_length", "max_length", "entropy", "divergence", "laminarity",
  "trapping_time", "max_vertical" }

-- The same by their definitions, from the lists of the lengths of all diagonals and of all verticals.
local function quantify(n, diagonals, verticals)
  local function lines(lengths)
    local all, on, count, longest, of = 0, 0, 0, 0, {}
    for _, length in ipairs(lengths) do
      all = all + length
      if length >= 2 then
        on, count, longest, of[length] = on + length, count + 1, math.max(longest, length), (of[length] or 0) + 1
      end
    end
    local entropy = 0
    for _, times in pairs(of) do entropy = entropy - times/count*log(times/count) end
    return all, on/all, on/count, longest, entropy
  end
  local pairs_, det, mean, longest, entropy = lines(diagonals)
  local _, laminarity, trapping, tallest = lines(verticals)
  return { pairs = pairs_, rate = pairs_/((n - theiler)*(n - theiler + 1)/2), det = det, mean_length = mean,
    max_length = longest, entropy = entropy, divergence = 1/longest, laminarity = laminarity, trapping_time = trapping,
    max_vertical = tallest }
end

-- The lengths of the lines of a plot of n points: recurs(i, k) says whether i and i + k are a pair.
local function lines(n, recurs)
  local diagonals, verticals, columns = {}, {}, {}
  for i = 1, n do columns[i] = {} end
  for k = theiler, n - 1 do
    local length = 0
    for i = 1, n - k do
      if recurs(i, k) then
        length = length + 1
        columns[i][#columns[i] + 1] = i + k
        columns[i + k][#columns[i + k] + 1] = i
      elseif length > 0 then
        diagonals[#diagonals + 1], length = length, 0
      end
    end
    if length > 0 then diagonals[#diagonals + 1] = length end
  end
  for _, column in ipairs(columns) do
    table.sort(column)
    local length = 0
    for index, i in ipairs(column) do
      length = length + 1
      if column[index + 1] ~= i + 1 then verticals[#verticals + 1], length = length, 0 end
    end
  end
  return diagonals, verticals
end

print "\nwhat the plots measure\n"
print "                  0.1         0.3"
for _, name in ipairs(measures) do
  print(("%-14s  %10.6g  %10.6g"):format(name, plots[1].found[name], plots[2].found[name]))
end
print "\nlines: their lags, and each less the one before\n"
print " at  D          paper     rotor     exact  share     spacing     exact"
for _, plot in ipairs(plots) do
  local before, exactly_before = 0, 0
  for i, line in ipairs(plot.lags) do
    local lag = plot.expected[i] or 0/0
    local _, d = apart(lag)
    print(("%.1f  %.4f  %8s  %8.2f  %8.2f  %.3f  %10.2f  %8.2f"):format(plot.threshold, d,
      plot.threshold == 0.1 and "unequal" or "-", line.lag, lag, line.share, line.lag - before, lag - exactly_before))
    before, exactly_before = line.lag, lag
  end
end
print "paper: \"unequally spaced bands\" at 0.1, no numbers; 0.3 is not the paper's\n"

local printed = { { 720.0, 1440.0, 2160.0 }, { 161.4, 279.3, 440.7, 558.6, 720.0 } }

theorem("Figure 11: lines are where D has its minima", function()
  for_each(plots, function(plot, which)
    local lags = plot.expected
    near(#lags, #plot.lags, 0, "how many lines")
    for i, line in ipairs(plot.lags) do
      near(lags[i] or 0, line.lag, every + 0.01, "the lag, to the spacing of times")
    end
    for i, lag in ipairs(printed[which]) do near(lag, plot.lags[i].lag, every, "the lags known") end
  end)
end)

theorem("Figure 11: they are unequally spaced", function()
  local lags = plots[2].lags
  for_each({ 161.4, 117.9, 161.4, 117.9, 161.4 }, function(spacing, i)
    near(spacing, lags[i].lag - (i > 1 and lags[i - 1].lag or 0), 2*every, "the spacings at 0.3")
  end)
end)

theorem("Figure 11: what the plot at 0.5 measures until 720, by the definitions", function()
  local times, points, distances = {}, {}, {}
  for i = 1, 2401 do
    times[i] = (i - 1)*every
    local e = exact(times[i])
    points[i] = { e.x, e.y, e.z }
    local _, d = apart(times[i])
    distances[i - 1] = d
  end
  local function of_vectors(i, k)
    local a, b = points[i], points[i + k]
    return sqrt((a[1] - b[1])^2 + (a[2] - b[2])^2 + (a[3] - b[3])^2)
  end
  local function of_attitudes(_, k) return distances[k] end
  for_each({ { "euler_vector", of_vectors }, { "rotation", of_attitudes } }, function(case)
    local found = run:recurrence { norm = case[1], threshold = 0.5, theiler = theiler, times = times }
    local nearest = math.huge
    local expect = quantify(#times, lines(#times, function(i, k)
      local d = case[2](i, k)
      nearest = math.min(nearest, abs(d - 0.5))
      return d <= 0.5
    end))
    -- Both know E to 1e-11 until 720: no pair may be so near to the threshold.
    holds(nearest > 1e-10, "no distance is within 1e-10 of the threshold")
    for _, name in ipairs(measures) do
      -- Whole numbers are exact, the others sums of up to 2401 terms, each rounded.
      local tolerance = math.type(expect[name]) == "integer" and 0 or 2401*2^-53*expect[name]
      near(expect[name], found[name], tolerance, name)
    end
  end)
end)

theorem("Figure 11: between attitudes the lines are whole", function()
  for_each(run:recurrence { norm = "rotation", threshold = 0.1, every = every, theiler = theiler }:lags(),
    function(line, i)
      near(1, line.share, 0, "the share of a line")
      near(plots[1].expected[1]/2*i, line.lag, every + 0.01*i, "its lag: also where c < 0")
    end)
end)
