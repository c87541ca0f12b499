-- run:spectrum, spectrum, run:frequencies: what scripts see of them, and what they refuse.
local directory = arg[0]:match "^(.*/)" or "./"
package.path = directory .. "?.lua;" .. package.path
local support = require "support"
local equal, contains = support.equal, support.contains

local function refused(f)
  local ended, message = pcall(f)
  equal(ended, false, "an error is expected")
  return tostring(message)
end

-- [P15]: the lines of E are (Omega -+ alpha)/(4 pi) and their combinations [theory 4.4].
local alpha = 2*pi/40
local Omega = sqrt(1 + alpha^2)
local p15 = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = alpha }
local run = evolve { omega = p15, from = rotation({ 1, 1, 1 }, 1), to = 4200 }
local found = run:frequencies(3, { of = "euler_vector_x" })
equal(#found, 3)
equal(found.note, nil)
near(1/40, found.drive, 1e-16, "drive")
near((Omega - alpha)/(4*pi), found.floquet, 1e-15, "f_F")  -- a few ulp of 2 pi over 2 pi T
for i, expected in ipairs { { "f_F", (Omega - alpha)/(4*pi) }, { "drive + f_F", (Omega + alpha)/(4*pi) },
  { "drive + 2 f_F", Omega/(2*pi) } } do
  local line = found[i]
  equal(line.name, expected[1])
  holds(line.error < 1e-8, "the error is small")
  near(expected[2], line.frequency, line.error, "line " .. i)
  near(line.frequency, line.predicted + line.difference, 1e-16, "predicted and difference")
end
holds(found[1].amplitude > found[2].amplitude, "the strongest first")
equal(found[4], nil)
local count = 0
for _ in ipairs(found) do count = count + 1 end
equal(count, 3, "ipairs")

-- The sum of the lines is the signal: of the quaternion all two of them.
local two = run:frequencies(2, { of = "quaternion_x" })
for _, t in ipairs { 0, 1.5, 777.7, 4200 } do
  local sum, tolerance = two.mean, run.error_estimate
  for _, line in ipairs(two) do
    sum = sum + line.amplitude*cos(2*pi*line.frequency*t + line.phase)
    tolerance = tolerance + line.amplitude_error + line.amplitude*(line.phase_error + 2*pi*t*line.error)
  end
  near(run(t).quaternion.x, sum, tolerance + 1e-14, "quaternion_x at " .. t)
end

-- A body point has the drive, and twice the Floquet frequency.
local names = {}
for _, line in ipairs(run:frequencies(3, { of = "matrix_11" })) do names[line.name] = line.frequency end
near(0.025, names.drive, 1e-12, "of the matrix")
near(0.136106, names["2 f_F"], 5e-7, "theory 5")
near(0.186106, names["2 drive + 2 f_F"], 5e-7, "theory 5")

-- A period that is given; one that is not known; more lines than there are.
local function omega(t) return cos(0.75*t), sin(0.75*t), 0 end
local scripted = evolve { omega = omega, to = 400 }
equal(scripted:frequencies(1, { of = "quaternion_w", period = 2*pi/0.75 })[1].name, "f_F")
local unnamed = scripted:frequencies(1, { of = "quaternion_w" })
equal(unnamed[1].name, nil)
equal(unnamed.floquet, nil)
equal(unnamed.drive, nil)
local turn = evolve { omega = { 0, 0, 1 }, to = 100 }
local few = turn:frequencies(5, { of = "quaternion_w" })
equal(#few, 1)
near(1/(4*pi), few[1].frequency, few[1].error, "half a turn")
contains(few.note, "1 of the 5 asked for")
contains(tostring(few), "1 of the 5 asked for")
equal(#turn:frequencies(5, { of = "axis_z" }), 0, "a constant")
for line in tostring(found):gmatch "[^\n]+" do holds(#line <= 80, "80 columns") end
contains(tostring(found), "drive + f_F")

-- The density.
local spectrum_of_run = run:spectrum { of = "euler_vector_x", window = "flat_top", detrend = "linear", every = 0.5 }
equal(spectrum_of_run.every, 0.5)
equal(#spectrum_of_run.density, 4201)
equal(#spectrum_of_run.frequencies, 4201)
equal(spectrum_of_run.frequencies[4201], 8400/2/(8401*0.5))
equal(spectrum_of_run.unit, "rad^2/(cycle/t)")
equal(spectrum_of_run.of, "euler_vector_x")
equal(spectrum_of_run.window, "flat_top")
equal(spectrum_of_run.detrend, "linear")
near(0.068053, spectrum_of_run:peaks(1)[1].frequency, 0.141/4200.5, "within the bias of the parabola")
equal(#spectrum_of_run:peaks(3), 3)
equal(run:spectrum { of = "quaternion_w", n = 100 }.unit, "1/(cycle/t)")
local text = tostring(spectrum_of_run)
contains(text, "8401 samples")
for line in text:gmatch "[^\n]+" do holds(#line <= 80, "80 columns") end

-- Parseval, of a list.
local list, square = {}, 0
for i = 1, 101 do
  list[i] = sin(i^2)
  square = square + list[i]^2/101
end
local sum = 0
for _, density in ipairs(spectrum(list, { every = 0.1, window = "none", detrend = "none" }).density) do
  sum = sum + density/(101*0.1)
end
near(square, sum, 1e-14, "the integral is the mean square")

-- Pictures and files.
local picture = support.printed(function() run:spectrum { of = "angle" }:plot { to = 0.3, height = 8 } end)
contains(picture, "frequency, cycles per unit of t")
contains(picture, "angle, rad^2/(cycle/t)")
local file = os.tmpname()
support.printed(function() spectrum(list):csv(file) end)
local columns = read_csv(file)
equal(#columns.density, 51)
equal(columns.frequency[2], 1/101)
local json = assert(io.open(file .. ".json")):read "a"
contains(json, '"window": "hann"')
contains(json, '"every": 1')
os.remove(file)
os.remove(file .. ".json")

-- What is refused.
contains(refused(function() return run:frequencies(0, { of = "angle" }) end), "n must be from 1 to 100, got 0")
contains(refused(function() return run:frequencies(1) end), "say of which column")
contains(refused(function() return run:frequencies(1, { of = "axis" }) end), "expected one column, got 3")
contains(refused(function() return run:frequencies(1, { of = "angel" }) end), "did you mean 'angle'?")
contains(refused(function() return run:frequencies(1, { of = "angle", period = 0 }) end), "must be positive, got 0.0")
contains(refused(function() return run:frequencies(1, { of = "angle", period = 5000 }) end), "longer than the run")
contains(refused(function() return run:frequencies(1, { of = "angle", samples = 1 }) end), "at least 32 samples, got 1")
contains(refused(function() return run:spectrum { of = "angle", n = 1 } end), "at least 4 samples, got 1")
contains(refused(function() return run:spectrum { of = "angle", n = 9, every = 1 } end), "one of n and every")
contains(refused(function() return run:spectrum { of = "angle", every = 5000 } end), "at least 4 samples, got 1")
contains(refused(function() return run:spectrum { of = "angle", window = "han" } end), '"blackman_harris"')
contains(refused(function() return evolve { omega = { 0, 0, 1 }, to = 0 }:spectrum { of = "angle" } end), "no length")
contains(refused(function() return spectrum { 1, 2, 0/0, 4 } end), "got nan as number 3 of 4")
contains(refused(function() return spectrum({ 1, 2, 3, 4 }, { every = 0 }) end), "every must be positive")
contains(refused(function() return spectrum { 1, 1, 1, 1 }:plot {} end), "is the signal constant?")
contains(refused(function() return spectrum_of_run:plot { from = 2 } end), "they go from 0.0 to")
equal(#spectrum { 1, 1, 1, 1 }:peaks(), 0, "a constant has a density of zero")
local gone = evolve { omega = function(t) return t > 2 and 1 or 0, 0, t < 1 and -1 or 0 end,
  from = rotation({ 0, 0, 1 }, 1), to = 3, breaks = { 1, 2 } }
contains(refused(function() return gone:spectrum { of = "axis_x" } end), "axis_x is nan at t = ")

-- What came of a run that stopped.
local _, stop = pcall(evolve, { omega = function(t) return cos(t), sin(t), sqrt(200 - t) end, to = 300 })
equal(stop.run.complete, false)
holds(#stop.run:spectrum { of = "quaternion_w" }.density > 4, "as far as it came")

-- Commensurate frequencies are said: alpha = 3/4 has f_F = (Omega - alpha)/4 pi = 1/3 of the drive alpha/2 pi, T = 40
-- has no fraction.
local function foretold(rate)
  return tostring(evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = rate },
    to = 400 }:frequencies(1, { of = "quaternion_w" }))
end
support.contains(foretold(3/4), " = 1/3 drive, commensurate\n")
support.fits(foretold(3/4))
holds(not foretold(pi/20):find "commensurate", "T = 40")

-- Two lines nearer than two cycles over the run, and a line as near to 0, cannot be told apart: none is listed. Where
-- omega is constant a line needs an error that is small beside f_F to have its name.
local slow = evolve { omega = { 0.3, 0.2, 1 }, from = rotation({ 1, 0, 0 }, 1), to = 10 }
slow = slow:frequencies(5, { of = "angle" })
equal(#slow, 0)
support.contains(tostring(slow), "two cycles over the run")
equal(#evolve { omega = { 0, 0, 1 }, to = 10 }:frequencies(2, { of = "euler_vector_z" }), 0)
-- At late times the rounding of t is in f_F.
local late = evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = 0.75 },
  from = rotation({ 1, 1, 1 }, 1), t = { 1e6, 1e6 + 400 } }:frequencies(2, { of = "quaternion_w" })
equal(late[1].name, "f_F")
support.contains(select(2, pcall(run.frequencies, run, 1, { of = "angle", period = 17 })),
  "does not repeat with the period")
