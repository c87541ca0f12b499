-- The "trivial example" after Theorem 5.1 of the paper: theta must be let take any value, negative ones too. The body
-- starts unrotated and turns by omega = s(t) k, where s is positive, decreases through zero and stays negative. Then
-- n = k for all time, and theta, the integral of s, grows as far as one likes, comes back to zero and goes below.
-- To keep theta positive n would have to jump to -k there; the Euler vector n theta is the same for both. As printed.

local k, last = vec(0, 0, 1), 14
local function s(t) return 6 - t end
local function theta(t) return t*(6 - t/2) end        -- up to 18 at t = 6, 0 at t = 12, -14 at the end

local runs = {
  { what = "any function", run = evolve { omega = function(t) return 0, 0, s(t) end, to = last, accuracy = 1e-12 } },
  { what = "spin.along", run = evolve { omega = spin.along(k, s), to = last, accuracy = 1e-12 } },
}
-- A run knows the rotation, and so theta, to its estimate, which is of first order: a quarter more. theta, up to 18, is
-- rounded twice here and once in the run, by 2e-15 each.
local function known(run) return 1.25*run.error_estimate + 6e-15 end

runs[1].run:plot({ "angle", "axis_z" }, { height = 16, title = "theta and n.k" })
print ""

-- The greatest of a difference at 1000 times, or nan, which math.max passes over.
local function worst(difference)
  local greatest = 0
  for i = 1, 1000 do
    local found = difference(last*i/1000)
    if found ~= found then return found end
    greatest = math.max(greatest, found)
  end
  return greatest
end

theorem("theta goes up, comes back and goes negative; n is k for all time", function()
  for_each(runs, function(case)
    local run, tolerance = case.run, known(case.run)
    near(0, worst(function(t) return abs(run(t).angle - theta(t)) end), tolerance, "theta(t), 1000 times")
    -- M = n sin(theta/2) is known to half of what the rotation is.
    near(0, worst(function(t) return 2*abs(sin(theta(t)/2))*norm(run(t).axis - k) end), tolerance,
      "2 sin(theta/2) times n - k")
    near(-14, run(last).angle, tolerance, "theta at the end")
  end)
end)

theorem("it passes 2 pi and 4 pi up and down, then 0, -2 pi and -4 pi", function()
  for_each(runs, function(case)
    local crossings = case.run.crossings
    near(7, #crossings, 0, "multiples of 2 pi that it passes")
    -- theta = c at t = 6 -+ sqrt(36 - 2 c).
    for i, c in ipairs { 2*pi, 4*pi, 4*pi, 2*pi, 0, -2*pi, -4*pi } do
      local crossing, up = crossings[i], i <= 2
      -- theta is off by what is known of it, s is 3.2 at least; t is rounded to 2e-15.
      near(6 + (up and -1 or 1)*sqrt(36 - 2*c), crossing.t, known(case.run)/3.2 + 2e-15, "when")
      holds(crossing.kind == "through" and crossing.turn_after - crossing.turn_before == (up and 1 or -1),
        "through, a turn up or down")
    end
  end)
end)

theorem("where theta > 0 is kept instead, the axis jumps to -k; n theta is the same", function()
  for_each(runs, function(case)
    for _, t in ipairs { 11.999, 12.001 } do
      local e = case.run(t).euler_vector
      local kept = rotation.from_euler_vector(e)
      -- theta is 6e-3 here, and its relative error is that of the axis.
      near(t < 12 and k or -k, kept.axis, known(case.run)/6e-3, "the axis of E, before and after t = 12")
      near(abs(theta(t)), kept.angle, known(case.run), "|E|")
      near(theta(t)*k, e, known(case.run), "E")
    end
  end)
end)
