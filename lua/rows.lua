-- The names that the Lua library adds to the registry. Their modules are loaded at the first call.
local function help(...)
  return require "rotor.help"(...)
end

local function testing(name)
  return function(...) return require "rotor.testing"[name](...) end
end

-- Of any, as a table whose functions are looked up when they are called.
local function generator(name)
  local function calls(key)
    return function(...) return require "rotor.generators".any[name][key](...) end
  end
  return { draw = calls "draw", shrink = calls "shrink" }
end

local function maker(name)
  return function(...) return require "rotor.generators".any[name](...) end
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
      .. "difference, tolerance, PASS or FAIL, and the processor time. A script in which a theorem failed ends with "
      .. "status 1; rotor --test prints one TAP line for each theorem, rotor --test --filter TEXT only runs those with "
      .. "TEXT in their names, plain text, in capitals or not. A theorem that checks nothing fails.",
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
  { owner = "", name = "for_each", kind = "function", result = "nil", value = testing("for_each"),
    signature = "for_each(cases, f)",
    summary = "Calls f(case, i) for each of a list of cases. What is checked in the same words in several cases is "
      .. "one line of the theorem's table: the worst, by difference over tolerance, and the number of cases; a case "
      .. "that fails is printed in digits that read back. An error in a case fails the theorem, which says in which. "
      .. "Outside a theorem the lines are printed, and one that fails is raised.",
    example = 'for_each({0, 1, -1}, function(x) near(sin(x), -sin(-x), 0, "sine is odd") end)' },
  { owner = "", name = "for_all", kind = "function", result = "nil", value = testing("for_all"),
    signature = "for_all(values, f, {n=, seed=})",
    summary = "Calls f(case, i) for n random cases (default 100), folded as for_each does: a case has a value under "
      .. "each name in `values`, drawn by the generator there (help \"any\"). The same seed (default 1) gives the same "
      .. "cases everywhere; math.random is left alone. A case that fails ends it and is shrunk: simpler values are "
      .. "tried as long as the same check fails, or an error is raised again, 1000 tries at most; both are printed.",
    example = "for_all({R = any.rotation, v = any.vector(1)}, function(case)\n"
      .. '  near(norm(case.v), norm(case.R*case.v), 2e-15, "a rotation keeps lengths")\nend)' },
  { owner = "", name = "given", kind = "function", result = "nil", value = testing("given"),
    signature = "given(condition)",
    summary = "The hypothesis, in the function of for_all or for_each: where it is false the case is left out. A "
      .. "hypothesis that holds in less than a tenth of the cases fails.",
    example = "for_all({x = any.number(-1, 1)}, function(case)\n  given(case.x >= 0)\n"
      .. '  near(case.x, sqrt(case.x)^2, 4e-16, "the root squared")\nend)' },
  { owner = "any", name = "number", kind = "function", result = "table", value = maker "number",
    signature = "any.number(low, high) -> table",
    summary = "Draws a number, uniform in [low, high], for for_all. It shrinks towards small whole numbers, halves, "
      .. "quarters.",
    example = "any.number(-1, 4).shrink(3.25)[1] --> 0.0" },
  { owner = "any", name = "integer", kind = "function", result = "table", value = maker "integer",
    signature = "any.integer(low, high) -> table",
    summary = "Draws a whole number from low to high, each as likely, for for_all. It shrinks towards 0, or the "
      .. "end nearest to it.",
    example = "any.integer(3, 9).shrink(8)[1] --> 3" },
  { owner = "any", name = "direction", kind = "value", result = "table", value = generator "direction",
    signature = "any.direction",
    summary = "Draws a unit vector, uniform on the sphere, for for_all. It shrinks towards the axes and the diagonals "
      .. "between them.",
    example = "any.direction.shrink(vec(0, 0, 1))[1] --> vec(1.0, 0.0, 0.0)" },
  { owner = "any", name = "vector", kind = "function", result = "table", value = maker "vector",
    signature = "any.vector(size) -> table",
    summary = "Draws a vector, each component uniform in [-size, size], for for_all. It shrinks as its components "
      .. "do, towards 0.",
    example = "any.vector(2).shrink(vec(1, 2, 0))[1] --> vec(0.0, 0.0, 0.0)" },
  { owner = "any", name = "rotation", kind = "value", result = "table", value = generator "rotation",
    signature = "any.rotation",
    summary = "Draws a rotation, uniform on all attitudes (Haar measure), its angle in [0, pi], for for_all. It "
      .. "shrinks towards the identity, quarter and half turns about the axes, then simple axes and angles.",
    example = "any.rotation.shrink(rotation({0, 0, 1}, 1))[2].angle/deg --> 90.0" },
  { owner = "any", name = "one_of", kind = "function", result = "table", value = maker "one_of",
    signature = "any.one_of(choices) -> table",
    summary = "Draws one of the values in a list, each as likely, for for_all. It shrinks towards the first.",
    example = 'any.one_of{"rk4", "dop853", "fgl"}.shrink("dop853")[1] --> "rk4"' },
  { owner = "any", name = "list", kind = "function", result = "table", value = maker "list",
    signature = "any.list(generator, n) -> table",
    summary = "Draws a list of n values of a generator, for for_all: one of any's, or your own, {draw = f, "
      .. "shrink = g} or f alone. f(random) makes a value: random() is uniform in [0, 1), random(m, n) a whole number. "
      .. "g(value) lists simpler values, simplest first.",
    example = "#any.list(any.integer(0, 5), 2).shrink{0, 1} --> 1" },
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
  { owner = "", name = "commensurate", kind = "function", result = "commensurate",
    value = function(...) return require("rotor.commensurate").find(...) end,
    signature = "commensurate(wish, {most=}) -> commensurate",
    summary = "The alpha = q/sqrt(p^2 - q^2) for which the motion under (cos alpha t, sin alpha t, 0) is periodic, "
      .. "ever nearer to a wish, with p up to `most` (default 100, 1e6 at most): the last is the nearest. A list of "
      .. "{p=, q=, alpha=, T=, off=, attitude_period=, orbit_period=}: T = 2 pi/alpha, off = alpha - wish; after so "
      .. "many T the attitude, and the quaternion with E, are where they were. Where |omega| is not 1 alpha is the "
      .. "rate over |omega|. :csv(file) writes the rows.",
    example = "commensurate(0.76, {most = 10})[3].alpha --> 0.75" },
  { owner = "", name = "compare_charts", kind = "function", result = "charts",
    value = function(options) return require("rotor.charts").compare(options) end,
    signature = "compare_charts{omega=, to=, t=, from=, equations=, n=, every=, times=, ...} -> charts",
    summary = "One motion by the equations of several charts (as evolve's equation=; all by default, \"generalized\" "
      .. "if there is f), each with evolve's other options (method is \"dop853\" if not given; restart and "
      .. "singularity for the equations that take them) as far as it goes, and how far it is from evolve's own "
      .. "method, which is the reference, at the times (as run:sample) and where it stops: the angle between the "
      .. "attitudes. A table: .rows[i] has .equation, .disagreement (rad, the greatest; .at a time; .disagreements at "
      .. ".times), .steps, .omega_calls, .estimate, .reached, .complete, .run, and if it stopped, .stopped and "
      .. ".singular (\"theta = pi\"); .farthest is {one, other, disagreement=, at=}; .reference says what it is, "
      .. ".reference_estimate its error, .lost_sign when theta = pi first, where M [P8] without its cosine goes "
      .. "wrong. :plot{} draws the disagreements over t, :csv(file) writes the rows.",
    example = 'compare_charts{omega = {0, 0, 1}, to = 7, equations = {"gibbs"}}.rows[1].singular --> "theta = pi"' },
  { owner = "", name = "draw_sphere", kind = "function", result = "nil",
    value = function(options) return require("rotor.sphere").draw(options) end,
    signature = "draw_sphere{points=, arcs=, paths=, dots=, from=, width=}",
    summary = "Draws the unit sphere in characters, with points {p = vec, ...} under their names, arcs "
      .. "{{a, b}, ...} of great circles, each the shorter way between two points (names or vectors), paths, a list of "
      .. "lists of vectors, joined where they follow each other by less than 0.5 rad, and dots, a list of vectors that "
      .. "are not joined; nan and 0 are gaps in these. Seen from the direction `from`, in 20 to 80 columns (default "
      .. "40).",
    example = 'draw_sphere{points = {x = {1, 0, 0}, y = {0, 1, 0}}, arcs = {{"x", "y"}}, width = 30} --> ' },
}
