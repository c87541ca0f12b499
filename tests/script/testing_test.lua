-- rotor.testing and its TAP: what passes, what fails, what is said.
package.path = (arg[0]:match "^(.*/)" or "./") .. "?.lua;" .. package.path
local support = require "support"
local equal, contains, fits, printed = support.equal, support.contains, support.fits, support.printed

support.use()
local testing

-- Fresh counts, and the names as globals.
local function begin()
  support.use()
  testing = require "rotor.testing"
  for _, row in ipairs(require "rotor.rows") do
    if row.owner == "" then rawset(_G, row.name, row.value) end
  end
end

-- Times are as they are: that there is one is tested, and then it is X.
local function without_times(output)
  return (output:gsub("%d+%.%d ?ms", "X ms"))
end

-- What a check does inside a theorem: "PASS" or "FAIL", and all that is printed.
local function inside(check)
  begin()
  local output = without_times(printed(testing.theorem, "t", check))
  fits(output)
  local passed = testing.finish and select(2, output:gsub("\nPASS  ", "")) == 1
  local ended_well
  printed(function() ended_well = testing.finish() end)
  equal(ended_well, passed, "finish() tells what was printed")
  return passed and "PASS" or "FAIL", output
end

local function near_is(expected, predicted, measured, tolerance, piece)
  local verdict, output = inside(function() testing.near(predicted, measured, tolerance, "it") end)
  equal(verdict, expected, output)
  if piece then contains(output, piece) end
end

-- A vector, a quaternion, a rotation as C++ makes them: no plain tables, no length operator.
local function made(kind, fields)
  local value = setmetatable({}, { __name = kind, __index = fields, __len = function() error "no length" end,
    __tostring = function() return kind .. " as text" end })
  return value
end
local function turn(angle)
  return made("rotation", { axis = { 1, 0, 0 }, angle = angle,
    distance = function(_, S) return math.abs(angle - S.angle) end })
end

-- Numbers. The tolerance itself is near; the next double is not.
near_is("PASS", 1, 1, 0)
near_is("PASS", 1, 1.0, 0)
near_is("PASS", 0.0, -0.0, 0)
near_is("PASS", 1, 1.5, 0.5)
near_is("FAIL", 1, 1.5, 0.49999999999999994, "5.0e-01")
near_is("FAIL", 0, 5e-324, 0)
near_is("FAIL", 2^53 | 0, (2^53 | 0) + 1, 0.5)
near_is("FAIL", math.mininteger, math.maxinteger, 1e18)
near_is("FAIL", 0/0, 1, 1e300, "nan")
near_is("FAIL", 0/0, 0/0, 1e300, "nan")
near_is("FAIL", 1, 0/0, 1e300, "nan")
near_is("PASS", math.huge, math.huge, 0)
near_is("FAIL", math.huge, -math.huge, 1e300)
near_is("FAIL", 1e308, math.huge, 1e308)
near_is("FAIL", -1e308, 1e308, 1.7e308)

-- Arrays, vectors, quaternions, matrices: the worst component, and where it stands.
near_is("PASS", { 1, 2 }, { 1, 2.25 }, 0.25)
near_is("FAIL", { 1, 2, 3 }, { 1.1, 2.5, 3 }, 0.2, "it [2]")
near_is("FAIL", { 1, 0/0, 3 }, { 1, 0/0, 99 }, 1000, "it [2]")
near_is("FAIL", { 1, 2 }, { 1, 2, 3 }, 10, "2 numbers were predicted and 3 measured")
near_is("FAIL", { { 1 }, { 2 } }, { 1, 2 }, 10, "in another shape")
near_is("FAIL", {}, {}, 10, "there are no numbers in it")
near_is("FAIL", { 1, "2" }, { 1, 2 }, 10, "a table was predicted and a table measured")
local v = made("vec", { 1, 2, 3 })
near_is("PASS", v, { 1, 2, 3 }, 0)
near_is("FAIL", v, made("vec", { 1, 2, 4 }), 0.5, "vec(1, 2, 4)")
near_is("FAIL", turn(1/3), turn(1.5), 0.25, "rotation({1, 0, 0}, 0.3333333333333333)")
near_is("FAIL", v, { 1, 2 }, 10)
near_is("PASS", made("quaternion", { 1, 0, 0, 0 }), made("quaternion", { 1, 0, 0, 0.125 }), 0.125)
near_is("FAIL", made("quaternion", { 1, 0, 0, 0 }), made("quaternion", { 1, 0, 0, 0.125 }), 0.1, "it [4]")
near_is("FAIL", made("quaternion", { 1, 0, 0, 0 }), made("quaternion", { -1, 0, 0, 0 }), 1)
local m = made("matrix", { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } })
near_is("PASS", m, { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, 0)
near_is("FAIL", m, made("matrix", { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 2 } }), 0,
  "matrix{{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}")
near_is("FAIL", m, { { 1, 0, 0 }, { 0, 1, 0.5 }, { 0, 0, 1 } }, 0.25, "it [2][3]")

-- Rotations as operators, by their distance; with nothing else.
near_is("PASS", turn(1), turn(1.5), 0.5)
near_is("FAIL", turn(1), turn(1.5), 0.25, "5.0e-01")
near_is("FAIL", turn(1), turn(0/0), 1e300)
near_is("FAIL", turn(1), 1, 10, "a rotation was predicted and a number measured")
near_is("FAIL", 1, nil, 10, "a number was predicted and a nil measured")
near_is("FAIL", "1", "1", 10)
near_is("FAIL", true, true, 10)

-- What is no test at all raises, in the line of the script.
local function raises(piece, f, ...)
  local ended, message = pcall(f, ...)
  equal(ended, false, "must raise: " .. piece)
  contains(tostring(message), piece)
end
begin()
for _, tolerance in ipairs { -1, 0/0, math.huge, "1", false } do
  raises("tolerance must be a finite number, zero or more, got " .. tostring(tolerance), function()
    testing.near(1, 1, tolerance)
  end)
end
raises("testing_test.lua", function() testing.near(1, 1) end)
raises("must be a string, got a number", function() testing.holds(true, 1) end)
-- Also through the globals of a script, which load this library when they are called first.
for _, call in ipairs { "near(1, 2, 0.5)", "near(1, 1)", "near(1, 1, 0, 0)", "holds(false)", "holds(true, 1)",
  "fails(print)", "fails(error, 1)", "fails(error, 'w', 1)", "theorem()", "theorem 'x'" } do
  local _, message = pcall(assert(load("\n" .. call, "=script")))
  equal(message:match "^%S+", "script:2:", call)
end
raises("its name must be a string, got a function", function() testing.theorem(print) end)
raises("must follow, got a nil", function() testing.theorem "x" end)

-- holds: true and nothing else.
equal(inside(function() testing.holds(true) end), "PASS")
equal(inside(function() testing.holds(false) end), "FAIL")
for _, condition in ipairs { 1, "x", {} } do
  local verdict, output = inside(function() testing.holds(condition) end)
  equal(verdict, "FAIL")
  contains(output, "must be true, got a " .. type(condition))
end
contains(select(2, inside(function() testing.holds() end)), "must be true, got nil")

-- fails
equal(inside(function() testing.fails(function() error "x" end) end), "PASS")
equal(inside(function() testing.fails(function() error() end) end), "PASS")
equal(inside(function() testing.fails(function() error "too far" end, "w", "too %a+$") end), "PASS")
contains(select(2, inside(function() testing.fails(function() error "x" end, "w", "y") end)), 'does not match "y"')
contains(select(2, inside(function() testing.fails(function() end) end)), "no error was raised")
equal(inside(function()
  testing.fails(function() error(setmetatable({}, { __tostring = function() return "stop at t" end })) end, "w", "stop")
end), "PASS")

-- Theorems: an error, no check, one inside another; checks in a coroutine belong to the theorem around it.
contains(select(2, inside(function() testing.holds(true) error "oops" end)), "oops")
contains(select(2, inside(function() end)), "it checked nothing")
contains(select(2, inside(function() testing.theorem("u", print) end)), '"u" stands inside "t"')
contains(select(2, inside(coroutine.wrap(function() testing.holds(true) end))), "1 check")

-- An error object that cannot say what it is.
local kSpeechless = 'setmetatable({}, { __tostring = function() error "x" end })'
local speechless = load("return " .. kSpeechless)()
contains(select(2, inside(function() error(speechless) end)), "in an error: (error object whose __tostring fails)")
equal(inside(function() testing.fails(function() error(speechless) end) end), "PASS")
contains(select(2, inside(function() testing.fails(function() error(speechless) end, "w", "y") end)),
  "whose __tostring")

-- The table that people read.
local _, shown = inside(function()
  testing.near(math.pi, 355/113, 1e-6, "ratio")
  testing.near(0, 1e-3, 1e-6, "a claim whose statement is so long that it has to stand on a line of its own")
  testing.holds(true, "convex")
end)
equal(shown:gsub("at %S+:%d+", "at PLACE"), [[
t
                                predicted  measured  difference  tolerance
  ratio                          3.141593  3.141593     2.7e-07    1.0e-06  PASS
  a claim whose statement is so long that it has to stand on a line of its own
                                        0     0.001     1.0e-03    1.0e-06  FAIL
      at PLACE
  convex                                                                    PASS
FAIL  1 of 3 checks  X ms

]])

-- Outside a theorem: a line, or an error that a script ends with.
begin()
contains(printed(testing.near, 1, 1.25, 0.5, "alone"),
  "PASS  alone: predicted 1, measured 1.25, difference 2.5e-01, tolerance")
raises("near: alone: predicted 1, measured 2, difference 1.0e+00, tolerance 5.0e-01", testing.near, 1, 2, 0.5, "alone")
raises("holds: alone", testing.holds, false, "alone")
raises("fails: alone: no error was raised", testing.fails, print, "alone")
raises("testing_test.lua:", function() testing.holds(false, "alone") end)
local good
equal(printed(function() good = testing.finish() end), "", "no theorem, no sum")
equal(good, true, "checks outside theorems do not count")

-- Ctrl-C leaves a theorem through a hook that goes on raising after the pcall; the next check stands alone again.
local function interrupted()
  testing.theorem("interrupted", function()
    debug.sethook(function()
      for level = 2, math.huge do
        local info = debug.getinfo(level, "f")
        if not info then return end
        if info.func == testing.theorem then error "interrupted!" end
      end
    end, "", 1)
    while true do end
  end)
end
for _, run in ipairs { pcall, function(f) coroutine.resume(coroutine.create(f)) end } do
  equal(printed(run, interrupted), "", "nothing can be said of an interrupted theorem")
  debug.sethook()
  contains(printed(testing.holds, true, "later"), "PASS  later")
  contains(printed(testing.theorem, "later", function() testing.holds(true) end), "PASS  1 check")
end

-- The sum.
begin()
printed(function()
  testing.theorem("a", function() testing.holds(true) testing.holds(true) end)
  testing.theorem("b", function() testing.holds(true) testing.holds(false) end)
end)
equal(without_times(printed(function() testing.finish() end)), "2 theorems: 1 failed (1 of 4 checks)  X ms\n")

-- TAP -----------------------------------------------------------------------------------------------------------------

local files = {}
local function script(source)
  local name = os.tmpname()
  local file = assert(io.open(name, "w"))
  assert(file:write(source))
  file:close()
  files[#files + 1] = name
  return name
end

local part  -- of the names, for --filter

-- Runs scripts as --test does; returns the verdict, what went to standard output, with FILE for the files' names and
-- without the times, which each theorem and the end must have, and why nothing was run.
local function tap(...)
  begin()
  local names, lines, methods = {}, {}, debug.getmetatable(io.stdout).__index
  for i, source in ipairs { ... } do names[i] = script(source) end
  local write = methods.write
  methods.write = function(file, ...)
    if file ~= io.stdout then return write(file, ...) end
    lines[#lines + 1] = table.concat { ... }
  end
  local ended, ok, none = pcall(testing.run, names, part)
  methods.write = write
  if not ended then error(ok, 0) end
  local text, sums = table.concat(lines):gsub("\n# time=%d+%.%dms\n$", "\n")
  equal(sums, 1, "the sum of the times")
  for line in text:gmatch "[^\n]+" do
    if line:find "^n?o?t? ?ok" then equal(line:find " # time=%d+%.%dms$" ~= nil, not line:find ": runs$", line) end
  end
  text = text:gsub(" # time=%d+%.%dms\n", "\n")
  for _, name in ipairs(names) do
    text = text:gsub(name:gsub("%p", "%%%0"), "FILE")
  end
  return ok, text, none
end

local function tap_is(expected_ok, expected, ...)
  local ok, text = tap(...)
  equal(text, expected, "TAP")
  equal(ok, expected_ok, "TAP verdict")
end

tap_is(true, [[
TAP version 13
# begins
# a	1
# raw
ok 1 - FILE: one \# two
ok 2 - FILE: three
# no line end
1..2
]], [[
io.write("beg") print("ins") print("a", 1)
theorem("one # two", function() near(1, 1, 0, "x") io.stdout:write("raw\n") end)
theorem("three", function() holds(true) end)
io.write("no line end")]])

tap_is(false, [[
TAP version 13
not ok 1 - FILE: bad
  ---
  failed:
    - what: "pair [2]"
      predicted: "{1, 2}"
      measured: "{1, 3.5}"
      difference: "1.5e+00"
      tolerance: "5.0e-01"
      at: "FILE:2"
    - what: "a \"quoted\" \\ thing"
      reason: "the condition must be true, got nil"
      at: "FILE:3"
  ...
ok 2 - FILE: good
1..2
]], [[
theorem("bad", function()
  near({1, 2}, {1, 3.5}, 0.5, "pair")
  holds(nil, 'a "quoted" \\ thing')
end)
theorem("good", function() holds(true) end)]])

-- A failing case of for_each and for_all.
tap_is(false, [[
TAP version 13
not ok 1 - FILE: cases
  ---
  failed:
    - what: "even (3 cases)"
      cases:
        - "case 1: {\"a\", 1}"
        - "2 cases failed: 1, 3"
      at: "FILE:2"
    - what: "small (1 case)"
      cases:
        - "case 1 of 100, seed 1: {x = 7}"
        - "shrunk to {x = 5}"
      at: "FILE:4"
  ...
1..1
]], [[
theorem("cases", function() for_each({ { "a", 1 }, { "b", 2 }, { "c", 3 } }, function(case)
  holds(case[2] % 2 == 0, "even") end)
  for_all({ x = { draw = function() return 7 end, shrink = function(x) return { x - 1 } end } }, function(case)
    holds(case.x < 5, "small")
  end)
end)]])

-- Only theorems with a text in their names: plain, in capitals or not. A file with none of them is not mentioned, but
-- one that cannot be run is.
local three = [[
theorem("Of (a) lemma", function() holds(true) end)
theorem("other", function() print "not run" end)
theorem("THE (A) END", function() holds(true) end)]]
part = "(A)"
tap_is(true, "TAP version 13\nok 1 - FILE: Of (a) lemma\nok 2 - FILE: THE (A) END\n1..2\n", three, "x = 1",
  "theorem('none', function() end)")
tap_is(false, [[
TAP version 13
ok 1 - FILE: Of (a) lemma
ok 2 - FILE: THE (A) END
not ok 3 - FILE: runs
  ---
  problem: "broken"
  ...
1..3
]], three, "error('broken', 0)")
local passed, _, none = tap(three)
equal(passed, true)
equal(none, nil)
part = "(a"
passed, _, none = tap("theorem('(b', function() end)")
equal(passed, false)
equal(none, '--test: of 1 theorem none has "(a" in its name')
part = "."
passed, shown, none = tap(three, three)
equal(passed, false)
equal(shown, "TAP version 13\n1..0\n")
equal(none, '--test: of 6 theorems none has "." in its name')
part = nil

-- A script without theorems is one test; one that raises is not ok, also after its theorems.
tap_is(true, "TAP version 13\nok 1 - FILE: runs\n1..1\n", "local x = 1")
tap_is(false, [[
TAP version 13
ok 1 - FILE: t
not ok 2 - FILE: runs
  ---
  problem: "FILE:2: later"
  ...
1..2
]], 'theorem("t", function() holds(true) end)\nerror "later"')
local ok, text = tap "x = = 1"
equal(ok, false)
contains(text, "unexpected symbol near '='")
contains(text, "1..1\n")

-- Each file has its own globals; os.exit ends its script alone; print is itself again afterwards.
local saved_print, saved_exit = print, os.exit
tap_is(true, "TAP version 13\nok 1 - FILE: runs\nok 2 - FILE: runs\nok 3 - FILE: runs\n1..3\n",
  "left_over = 1 _G.left_over_too = 1", "assert(left_over == nil and left_over_too == nil and _G.print and arg[0])",
  "os.exit(0) error 'not reached'")
ok, text = tap("theorem('t', function() os.exit(1) end)", "x = 1")
equal(ok, false)
contains(text, "status that means failure")
contains(text, "ok 3 - FILE: runs\n1..3\n")
equal(print, saved_print)
equal(os.exit, saved_exit)
equal(rawget(_G, "left_over_too"), nil)

-- A theorem that os.exit leaves, with any status, is not finished; those before it are. That holds also where the
-- script catches what os.exit raises here: run by itself it would have ended there.
for _, leave in ipairs { "os.exit(true)", "os.exit()", "pcall(os.exit, 0)", "coroutine.wrap(os.exit)(0)",
  "fails(os.exit)" } do
  ok, text = tap("theorem('a', function() holds(true) end) theorem('b', function() holds(true) " .. leave ..
    " end) theorem('c', function() holds(true) end)", "theorem('d', function() holds(true) end)")
  equal(text, [[
TAP version 13
ok 1 - FILE: a
not ok 2 - FILE: b
  ---
  problem: "os.exit ended the script before the theorem was finished"
  ...
ok 3 - FILE: d
1..3
]], leave)
  equal(ok, false, leave)
end
ok, text = tap("theorem('t', function() near(1, 2, 0, 'seen') os.exit(true) end)")
equal(ok, false)
contains(text, 'what: "seen"')
for status, verdict in pairs { ["1"] = false, ["false"] = false, ["true"] = true } do
  for _, leave in ipairs { "os.exit(%s)", "pcall(os.exit, %s)", "for_each({ %s }, os.exit)" } do
    equal(tap(leave:format(status)), verdict, leave:format(status))
  end
end

-- An error object that cannot say what it is fails its file, and no other.
tap_is(false, [[
TAP version 13
not ok 1 - FILE: t
  ---
  problem: "it ended in an error: (error object whose __tostring fails)"
  ...
not ok 2 - FILE: runs
  ---
  problem: "(error object whose __tostring fails)"
  ...
ok 3 - FILE: runs
1..3
]], "local e = " .. kSpeechless .. " theorem('t', function() error(e) end) error(e)", "x = 1")

-- What a script changes in the libraries is as it was for the next one; until then it is changed for all.
for _, damage in ipairs { "math.abs = nil", "string.format = nil string.gsub = nil",
  "for k in pairs(table) do table[k] = nil end", "io.output(io.tmpfile())", "io.stdout = nil",
  "getmetatable(io.stdout).__index.write = nil", "load 'next, rawset, pcall, type, print = nil'()",
  "package.path = ''", "package.searchers[2] = nil", "package.loaded.math = nil" } do
  ok, text = tap(damage, "io.write 'x' theorem('t', function() near(1, 1.5, 1, 'it') end) require 'support'")
  equal(text, "TAP version 13\nok 1 - FILE: runs\n# x\nok 2 - FILE: t\n1..2\n", damage)
  equal(ok, true, damage)
end
tap_is(true, "TAP version 13\nok 1 - FILE: runs\nok 2 - FILE: runs\n1..2\n", [[
function string.twice(s) return s .. s end
assert(("x"):twice() == "xx" and require "string" == string and _G.string == string)
package.preload.once = function() common = 1 return {} end
require "once"]], "assert(not string.twice and not package.loaded.once and common == nil)")
equal(rawget(string, "twice"), nil)

-- What other programs print comes behind what stands before it, also in a pipe.
local program = script(([[
package.path, arg[0] = %q, %q
require "support".use()
require "rotor.testing".run { %q }]]):format(package.path, arg[0],
  script "print 'before' os.execute 'echo from the shell' print 'after'"))
local pipe = assert(io.popen(("'%s' '%s'"):format(arg[-1], program)))
equal(pipe:read "a":match "^(.-)ok 1", "TAP version 13\n# before\nfrom the shell\n# after\n")
pipe:close()

-- What goes to other files goes there.
tap_is(true, "TAP version 13\nok 1 - FILE: runs\n1..1\n",
  "local f = io.tmpfile() f:write('x', 1) f:seek 'set' assert(f:read 'a' == 'x1')")

-- Nothing to run is no success.
tap_is(false, "TAP version 13\n1..0\n")

-- The examples in the rows run.
begin()
for _, row in ipairs(require "rotor.rows") do
  if row.name ~= "theorem" and not row.example:find "%-%-> %S" then printed(assert(load(row.example))) end
end

for _, name in ipairs(files) do os.remove(name) end
