-- run:recurrence and what it gives.
local directory = arg[0]:match "^(.*/)" or "./"
package.path = directory .. "?.lua;" .. package.path
local support = require "support"
local equal, contains, fits = support.equal, support.contains, support.fits

local function refused(run, options)
  local ended, message = pcall(run.recurrence, run, options)
  equal(ended, false, "an error is expected")
  return tostring(message)
end

local function printed(object, method, ...)
  local lines = {}
  local own = print
  rawset(_G, "print", function(text) lines[#lines + 1] = text end)
  local ended, message = pcall(object[method], object, ...)
  rawset(_G, "print", own)
  if not ended then error(message, 2) end
  return table.concat(lines, "\n")
end

-- Figure 11. A lag is known to half the spacing, and was published to half a digit.
local paper = evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = 2*pi/40 },
  from = rotation.from_euler_vector(vec(1, 1, 1)/sqrt(3)), to = 2500 }
local figure = paper:recurrence { threshold = 0.1, every = 0.1 }
local lines = figure:lags()
equal(#lines, 3)
for i, published in ipairs { 720, 1440, 2160 } do
  near(published, lines[i].lag, 0.05 + 0.05, "lag of line " .. i)
  holds(lines[i].share > 0.5, "the share of it")
end
equal(figure.points, 25001)
fits(tostring(figure))
contains(tostring(figure), "euler_vector within 0.1: " .. figure.pairs .. " pairs")
near(figure.pairs, figure.rate*25001*25000/2, 1e-6, "RR is the share of all pairs")

-- A period of 20 points, 201 of them: diagonals of 181, 161, ... 1.
local turn = evolve { omega = { 0, 0, 1 }, to = 20*pi }
local periodic = turn:recurrence { threshold = 1e-6, norm = "rotation", n = 201 }
near(909/910, periodic.det, 1e-15)
near(log(9), periodic.entropy, 1e-14)
near(101, periodic.mean_length, 1e-13)
equal(math.type(periodic.max_length), "integer")
equal(periodic.max_length, 181)
equal(periodic.laminarity, 0.0)
near(2*pi, periodic:lags()[1].lag, 1e-13, "the period")
equal(#periodic:lags { least = 0.1 }, 9)
local long = turn:recurrence { threshold = 1e-6, norm = "rotation", n = 201, lmin = 100 }
equal(long.det, (101 + 121 + 141 + 161 + 181)/910)
equal(turn:recurrence { threshold = 1e-6, norm = "rotation", n = 201, theiler = 21 }.pairs, 910 - 181)
local backward = evolve { omega = { 0, 0, 1 }, t = { 20*pi, 0 } }
near(2*pi, backward:recurrence { threshold = 0.1, norm = "rotation", n = 1001 }:lags()[1].lag, 1e-9, "backward too")
-- E turns with the count of turns: it does not come back.
equal(#turn:recurrence { threshold = 0.1, n = 201 }:lags(), 0)

-- The rate asked for: the share of the pair of that rank.
local rated = paper:recurrence { rate = 0.01, n = 1001 }
near(0.01, rated.rate, 2/(1001*1000), "rate")
equal(paper:recurrence { threshold = rated.threshold, n = 1001 }.pairs, rated.pairs)

-- Pictures are square, two columns a row, and fit.
local picture = printed(periodic, "plot", { height = 21, title = "a turn" })
fits(picture)
contains(picture, "a turn\nt\n")
contains(picture, "of the share")
contains(printed(turn:recurrence { threshold = 1e-9, n = 11 }, "plot"), "nothing recurs")
for _, size in ipairs { { width = 30 }, { height = 5 }, { width = 200, height = 60 } } do
  for line in printed(periodic, "plot", size):gmatch "[^\n]+" do
    if not line:find "share" then holds(#line <= (size.width or 80), "a picture of that width") end
  end
end

-- The pairs, in a file.
local file = os.tmpname()
contains(printed(periodic, "csv", file), "910 rows")
local rows = 0
for line in io.lines(file) do
  if rows == 1 then equal(line:match "^%d+,%d+,", "1,21,") end
  rows = rows + 1
end
equal(rows, 911)
os.remove(file)
os.remove(file .. ".json")

-- At rest everything recurs.
local rest = evolve { omega = { 0, 0, 0 }, from = rotation({ 0, 0, 1 }, 1), to = 1 }
local still = rest:recurrence { threshold = 0.1, n = 50 }
equal(still.rate, 1.0)
equal(still.max_length, 49)
equal(#still:lags(), 0)
contains(refused(rest, { rate = 0.5 }), "as many pairs are at distance 0.0")
local none = turn:recurrence { threshold = 1e-9, n = 11 }
equal(none.pairs, 0)
equal(none.divergence, 1/0)
holds(none.det ~= none.det, "a share of nothing is nan")

-- A run that was stopped is used as far as it came.
local _, stop = pcall(evolve, { omega = function(t) return 0, 0, t < 3 and 1 or error "enough" end, to = 10 })
equal(stop.run.complete, false)
equal(stop.run:recurrence { threshold = 0.1, n = 30 }.points, 30)

for given, expected in pairs {
  [{}] = "give one of threshold and rate", [{ threshold = 1, rate = 0.1 }] = "give one of threshold and rate",
  [{ threshold = 0 }] = "threshold must be positive and finite, got 0.0", [{ threshold = -1 }] = "got -1.0",
  [{ threshold = 1/0 }] = "got inf", [{ threshold = 0/0 }] = "got nan", [{ rate = 0 }] = "rate must be above 0",
  [{ threshold = 1, n = 1 }] = "two points at least", [{ threshold = 1, every = 100 }] = "two points at least",
  [{ threshold = 1, theiler = 1000 }] = "leaves no pair of 1000 points", [{ threshold = 1, lmin = 0 }] = "at least 1",
  [{ threshold = 1, norm = "euler" }] = "did you mean", [{ treshold = 1 }] = "did you mean 'threshold'",
  [{ threshold = 1, times = { 0, 2, 1 } }] = "rise or fall",
  [{ threshold = 1, times = { 0, 100 } }] = "outside the run",
  [{ threshold = 100, n = 200000 }] = "about 2.0e10 pairs, more than 1e10",
} do
  contains(refused(turn, given), expected)
end
local uneven = turn:recurrence { threshold = 1, times = { 0, 1, 5 } }
contains(select(2, pcall(uneven.lags, uneven)), "evenly spaced")
