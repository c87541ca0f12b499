-- The names that the Lua library adds to the registry. Their modules are loaded at the first call.
local function help(...)
  return require "rotor.help"(...)
end

local function testing(name)
  return function(...) return require "rotor.testing"[name](...) end
end

local function conventions() return require "rotor.conventions" end

return {
  { owner = "", name = "help", kind = "function", result = "nil", value = help,
    signature = "help(name or value)",
    summary = 'Prints what is known about a name (help "slerp", help "run:csv") or a value (help(R)); help() alone '
      .. "gives an overview. Words that are no name are looked for in names, summaries and conventions().",
    example = 'help "rotation"' },
  { owner = "", name = "theorem", kind = "function", result = "nil", value = testing("theorem"),
    signature = "theorem(name, f)",
    summary = "Runs f and prints the checks that it makes (near, holds, fails) as a table: predicted, measured, "
      .. "difference, tolerance, PASS or FAIL. A script in which a theorem failed ends with status 1; "
      .. "rotor --test prints one TAP line for each theorem. A theorem that checks nothing fails.",
    example = 'theorem("half", function() near(180*deg, pi, 1e-15, "180 degrees") end)' },
  { owner = "", name = "near", kind = "function", result = "nil", value = testing("near"),
    signature = "near(predicted, measured, tolerance, what)",
    summary = "Checks that the difference is at most the tolerance: of two numbers its magnitude, of vectors, "
      .. "quaternions, matrices and arrays the largest of any component, of rotations the distance of their "
      .. "operators in radians. NaN is near nothing; equal infinities are near. "
      .. "Outside a theorem, what is not near raises an error.",
    example = 'near(math.pi, 355/113, 1e-6, "the ratio of Zu Chongzhi")' },
  { owner = "", name = "holds", kind = "function", result = "nil", value = testing("holds"),
    signature = "holds(condition, what)",
    summary = "Checks that the condition is true: no other value passes, so that a forgotten comparison is seen. "
      .. "Outside a theorem, what does not hold raises an error.",
    example = 'holds(2^53 == 2^53 + 1.0, "doubles end")' },
  { owner = "", name = "fails", kind = "function", result = "nil", value = testing("fails"),
    signature = "fails(f, what, pattern)",
    summary = "Checks that f() raises an error, whose message has the Lua pattern in it if one is given. "
      .. "Outside a theorem, an f that does not fail raises an error.",
    example = 'fails(function() return 1 + {} end, "no sum with a table", "arithmetic")' },
  { owner = "", name = "conventions", kind = "function", result = "nil",
    page = function() return conventions().page() end,
    value = function(library) print(conventions().page(library)) end,
    lines = function() return conventions().lines() end,
    signature = "conventions(library)",
    summary = "Prints the conventions: active or passive, frames, order of composition and of components, ranges of "
      .. 'angles; and what SciPy, Eigen, MATLAB, ROS and Basilisk call what rotor does; of one library ("SciPy") that '
      .. "alone.",
    example = 'conventions("Eigen")' },
  { owner = "", name = "tradeoff", kind = "function", result = "tradeoff",
    value = function(options) return require("rotor.tradeoff").measure(options) end,
    signature = "tradeoff{omega=, to=, t=, from=, methods=, accuracies=, steps=, reference=, ...} -> tradeoff",
    summary = "What accuracy costs: runs the scene (as for evolve: max_step, max_steps, breaks, equation, f and "
      .. "restart too) by each of the methods, names or options as {method = \"rk4\", equation = \"euler\"} (label, "
      .. "accuracies and steps too), to each of the accuracies, rk4 with each of the steps, and compares at 100 times "
      .. "with `reference`, a run or a function of t, else with the exact model, else with a tighter run of another "
      .. "method; where that is not ten times better, the run is certified (run:certify). A table: .rows[i] has "
      .. ".method, .asked or .step, .achieved and .estimate (rad), .by (\"reference\", \"certificate\", or "
      .. "\"bound\": at rounding), .omega_calls, .steps, .seconds (the median of five, if short), or .stopped; "
      .. ".reference says with what was compared. "
      .. ":plot{over = \"seconds\"} draws the errors over omega_calls, seconds or steps, "
      .. ":csv(file) writes the rows.",
    example = '#tradeoff{omega = {0, 0, 1}, to = 1, methods = {"dop853"}, accuracies = {1e-4, 1e-8}}.rows --> 2' },
  { owner = "", name = "draw_sphere", kind = "function", result = "nil",
    value = function(options) return require("rotor.sphere").draw(options) end,
    signature = "draw_sphere{points=, arcs=, from=, width=}",
    summary = "Draws the unit sphere in characters, with points {p = vec, ...} under their names and arcs "
      .. "{{a, b}, ...} of great circles, each the shorter way between two points (names or vectors), seen from the "
      .. "direction `from`, in 20 to 80 columns (default 40).",
    example = 'draw_sphere{points = {x = {1, 0, 0}, y = {0, 1, 0}}, arcs = {{"x", "y"}}, width = 30} --> ' },
}
