-- for_each, for_all, given and any: what is folded, what a failing case says, what it shrinks to, what is drawn.
package.path = (arg[0]:match "^(.*/)" or "./") .. "?.lua;" .. package.path
local support = require "support"
local equal, contains, fits, printed = support.equal, support.contains, support.fits, support.printed

-- The verdict on a theorem with this function, and what it prints, without the time.
local function inside(f)
  local output = printed(theorem, "t", f):gsub("  %d+%.%d ms\n", "\n")
  fits(output)
  return output:match "\n(%u+)[^\n]*\n\n$", output
end

local function raises(piece, f, ...)
  local ended, message = pcall(f, ...)
  equal(ended, false, "must raise: " .. piece)
  contains(tostring(message), piece)
  contains(tostring(message), "cases_test.lua:", "in the line of the script")
end

-- The cases that for_all draws.
local function drawn(values, options)
  local list = {}
  printed(for_all, values, function(case) list[#list + 1] = case end, options)
  return list
end

-- Folding -------------------------------------------------------------------------------------------------------------

-- One line for each name, with its worst case by difference over tolerance: 0.2/1, 0.3/2, 0.1/0.25.
local verdict, output = inside(function()
  for_each({ { 0.2, 1 }, { 0.3, 2 }, { 0.1, 0.25 } }, function(case, i)
    near(0, case[1], case[2], "it")
    if i > 1 then holds(true, "later") end
  end)
  near(1, 1, 0, "it")
end)
equal(verdict, "PASS")
equal(output, [[
t
                                predicted  measured  difference  tolerance
  it (3 cases)                          0       0.1     1.0e-01    2.5e-01  PASS
  later (2 cases)                                                           PASS
  it                                    1         1           0          0  PASS
PASS  3 checks

]])

-- A difference of nothing is best also where the tolerance is nothing; NaN, and what cannot be compared, is worst.
for _, measured in ipairs { 1.0, 0/0, "1" } do
  verdict, output = inside(function()
    for_each({ 0, measured, 5e-324, 0 }, function(x) near(0, x, 0, "it") end)
  end)
  equal(verdict, "FAIL")
  contains(output, "case 2: " .. (type(measured) == "string" and '"1"' or measured == 1 and "1.0" or "nan"))
  contains(output, "2 cases failed: 2, 3")
end
-- The least that fails is worse than the most that passes.
verdict, output = inside(function()
  for_each({ { 1, 1 }, { 2, 2 - 2^-52 }, { 3, 3 } }, function(case) near(0, case[1], case[2], "it") end)
end)
equal(verdict, "FAIL")
contains(output, "case 2: {2, 1.9999999999999998}")
-- The places of what is farthest apart do not make different checks.
contains(select(2, inside(function()
  for_each({ { 1, 2 }, { 4, 0 } }, function(case) near({ 0, 0 }, case, 9, "pair") end)
end)), "pair [1] (2 cases)")

-- All cases that failed are counted, the first ten named.
local many = {}
for i = 1, 30 do many[i] = i end
contains(select(2, inside(function() for_each(many, function(x) holds(x % 2 == 0, "even") end) end)),
  "case 1: 1 15 cases failed: 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, ...")

-- An error says in which case; what was checked until then is shown.
verdict, output = inside(function()
  for_each({ 0.5, { 1/3, at = vec(1, 2, 1/3), name = "x" }, 7 }, function(case)
    holds(true, "seen")
    if type(case) == "table" then error "oops" end
  end)
end)
equal(verdict, "FAIL")
contains(output, "seen (2 cases)")
contains(output, 'for_each: in case 2, {0.3333333333333333, at = vec(1.0, 2.0, 0.3333333333333333), name = "x"}: ')
contains(output, "oops")

-- A case inside a case, and a check in a coroutine.
verdict, output = inside(function()
  for_each({ 1, 2 }, function(x)
    for_each({ 10, 20, 30 }, function(y) coroutine.wrap(function() holds(x*y ~= 40, "product") end)() end)
  end)
end)
equal(verdict, "FAIL")
contains(output, "product (6 cases)")
contains(output, "case 2: 2 case 2: 20 at")

-- Outside a theorem each line stands alone, and a failing one raises; theorems may stand in the cases.
contains(printed(for_each, { 1, 2 }, function(x) near(x, x, 0, "it") end), "PASS it (2 cases): predicted 1, measured 1")
raises("for_each: it (2 cases): predicted 2, measured 3, difference 1.0e+00, tolerance 5.0e-01: case 2: 2", function()
  for_each({ 1, 2 }, function(x) near(x, x == 1 and 1 or 3, 0.5, "it") end)
end)
raises("for_each: in case 2, 2: ", function() for_each({ 1, 2 }, function(x) if x == 2 then error "oops" end end) end)
contains(printed(for_each, { "a", "b" }, function(x) theorem(x, function() holds(true) end) end), "b\n")
contains(select(2, inside(function() for_each({ 1 }, function() theorem("u", print) end) end)), '"u" stands inside "t"')

raises("for_each: there are no cases", function() for_each({}, print) end)
raises("expected a list of cases and a function, got a nil and a function", function() for_each(nil, print) end)
raises("expected a list of cases and a function, got a table and a nil", function() for_each { 1 } end)

-- given ---------------------------------------------------------------------------------------------------------------

verdict, output = inside(function()
  for_each({ -1, 0, 1, 4 }, function(x)
    holds(x > -2, "made before the hypothesis")
    given(x >= 0)
    near(x, sqrt(x)^2, 0, "root")
  end)
end)
equal(verdict, "PASS")
contains(output, "made before the hypothesis (3 cases)")
contains(output, "root (3 cases)")
-- Also where the function itself catches what given raises.
contains(select(2, inside(function()
  for_each({ 1, 2 }, function(x) fails(function() given(x == 2) end, "caught") end)
end)), "caught (1 case)")

local function in_tenths(n)
  return function() for_all({ x = any.number(0, 1) }, function(_, i) given(i <= n) holds(true) end) end
end
equal(inside(in_tenths(10)), "PASS", "a tenth is enough")
verdict, output = inside(in_tenths(9))
equal(verdict, "FAIL")
contains(output, "the hypothesis holds in 9 of 100 cases FAIL")
equal(inside(in_tenths(0)), "FAIL")
equal(inside(function() for_each({ 1 }, function() given(false) end) end), "FAIL")
raises("for_all: the hypothesis holds in 9 of 100 cases", printed, in_tenths(9))
raises("given: it stands in the function of for_each or for_all", function() given(true) end)
raises("the hypothesis must be true or false, got a nil", function() for_each({ 1 }, function() given() end) end)
contains(select(2, inside(function() given(true) end)), "given: it stands in the function")

-- Drawing -------------------------------------------------------------------------------------------------------------

-- SplitMix64 from the state 1234567: the upper 53 bits of 6457827717110365317, 3203168211198807973,
-- 9817491932198370423, 4593380528125082431, 16408922859458223821, as Vigna's C program and Python's integers give them.
local generators = require "rotor.generators"
local random = generators.random(1234567)
for _, bits in ipairs { 3153236189995295, 1564046978124417, 4793697232518735, 2242861585998575, 8012169364969835 } do
  equal(random(), bits*0x1p-53, "SplitMix64")
end

-- Whole numbers, to the ends of their range; 40 standard deviations at least from missing one of six in 10^4.
local counts = {}
for _ = 1, 10000 do
  local x = random(-2, 3)
  equal(math.type(x), "integer")
  counts[x] = (counts[x] or 0) + 1
end
-- Each is binomial, mean 1666.7 and deviation sqrt(10^4 5/36) = 37.3: within 5 of those.
for x = -2, 3 do equal(math.abs(counts[x] - 10000/6) < 5*37.3, true, "of " .. x .. " there are " .. counts[x]) end
equal(random(7, 7), 7)
equal(random(1), 1)
local spread = { 0, 0 }
for _ = 1, 100 do
  local x = random(math.mininteger, math.maxinteger)
  spread[x < 0 and 1 or 2] = spread[x < 0 and 1 or 2] + 1
end
equal(spread[1] > 25 and spread[2] > 25, true, "5 deviations of sqrt(100/4) from 50")
for _, range in ipairs { { 2, 1 }, { 0 }, { 1.5, 2 }, { "x" } } do
  raises("random: expected whole numbers", function() random(range[1], range[2]) end)
end

-- The same seed, the same cases; another seed, others; math.random is neither used nor changed.
local values = { x = any.number(-1, 3), k = any.integer(-5, 5), n = any.direction, v = any.vector(2), R = any.rotation,
  word = any.one_of { "a", "b", "c" }, list = any.list(any.integer(1, 6), 3), mine = function(r) return r() end }
local exact = require "rotor.exact"
math.randomseed(42)
local first, after = exact(drawn(values, { n = 20, seed = 7 })), math.random()
math.randomseed(42)
equal(after, math.random(), "math.random is as it was")
equal(exact(drawn(values, { seed = 7, n = 20 })), first)
equal(exact(drawn(values, { seed = 8, n = 20 })) ~= first, true)
equal(#drawn(values), 100)
-- Whatever the order in which the table holds the names, they are drawn by the alphabet.
local names, sorted = {}, {}
for word in ("jackdaws love my big sphinx of black quartz"):gmatch "%a+" do
  names[word], sorted[#sorted + 1] = function(r) return r() end, word
end
table.sort(sorted)
random = generators.random(1)
local case = drawn(names, { n = 1 })[1]
for _, word in ipairs(sorted) do equal(case[word], random(), word) end

-- What is drawn is where it should be, and uniform: of n samples a mean has the deviation sigma/sqrt(n), and 5 of them
-- are allowed. x in [-1, 3]: mean 1, sigma 4/sqrt(12). A direction's and a rotated vector's components: mean 0, sigma
-- sqrt(1/3); their squares: mean 1/3, sigma sqrt(1/5 - 1/9). The angle of a rotation has the density (1 - cos)/pi:
-- mean pi/2 + 2/pi, and pi^2/3 + 2 is the mean of its square.
local n = 4000
local sums = {}
local function add(key, x) sums[key] = (sums[key] or 0) + x end
for _, c in ipairs(drawn(values, { n = n })) do
  add("x", c.x)
  equal(c.x >= -1 and c.x <= 3 and math.type(c.x) == "float", true)
  equal(c.k >= -5 and c.k <= 5 and math.type(c.k) == "integer", true)
  equal(math.abs(norm(c.n) - 1) <= 2^-52, true, "unit to an ulp")
  for i = 1, 3 do
    equal(math.abs(c.v[i]) <= 2, true)
    add("n" .. i, c.n[i])
    add("square" .. i, c.n[i]^2)
    add("turned" .. i, (c.R*vec(0.6, 0, 0.8))[i])
    add("turned square" .. i, (c.R*vec(0.6, 0, 0.8))[i]^2)
  end
  add("angle", c.R.angle)
  equal(c.R.angle <= math.pi, true)
  equal(c.word:match "^[abc]$" ~= nil and #c.list == 3, true)
end
local function mean_is(key, mean, sigma)
  equal(math.abs(sums[key]/n - mean) <= 5*sigma/math.sqrt(n), true, key .. " has the mean " .. sums[key]/n)
end
mean_is("x", 1, 4/math.sqrt(12))
mean_is("angle", math.pi/2 + 2/math.pi, math.sqrt(math.pi^2/3 + 2 - (math.pi/2 + 2/math.pi)^2))
for i = 1, 3 do
  for _, key in ipairs { "n", "turned" } do mean_is(key .. i, 0, math.sqrt(1/3)) end
  for _, key in ipairs { "square", "turned square" } do mean_is(key .. i, 1/3, math.sqrt(4/45)) end
end
equal(any.number(-1e308, 1e308).draw(function() return 0.75 end), 0.5e308, "no overflow")
equal(any.number(0.1, 0.1).draw(random), 0.1)

-- Shrinking -----------------------------------------------------------------------------------------------------------

-- What for_all says of a theorem that fails: the case it found and that which it shrank to, as values.
local function read(digits) return load("return " .. digits)() end
local function failing(case_values, f, options)
  local text = select(2, inside(function() for_all(case_values, f, options) end)):gsub("%s+", " ")
  local number, of, seed, found = text:match "case (%d+) of (%d+), seed (%S+): (%b{})"
  if not number then error("no case in " .. text, 2) end
  local simple = text:match "shrunk to (%b{})" or text:find "nothing simpler fails" and found
  return read(simple), read(found), math.tointeger(number), text, math.tointeger(of), math.tointeger(seed)
end
local function shrunk(...)
  local simple, _, _, text = failing(...)
  return simple, text
end
local function shrinks_to(expected, generator, condition, options)
  local simple = failing({ it = generator }, function(c) holds(not condition(c.it), "it") end, options).it
  equal(exact(simple), exact(expected))
end

shrinks_to(0.0, any.number(-5, 9), function() return true end)
shrinks_to(1.0, any.number(-5, 9), function(x) return x ~= 0 end)
shrinks_to(-1.0, any.number(-5, 9), function(x) return x < 0 end)
shrinks_to(5.0, any.number(-100, 100), function(x) return x > 4.2 end)
shrinks_to(-73.0, any.number(-100, 100), function(x) return x <= -73 end)
shrinks_to(0.5, any.number(0, 3), function(x) return x > 0.3 and x < 0.9 end)
shrinks_to(0.25, any.number(-1, 1), function(x) return x > 0.2 and x < 0.3 end)
shrinks_to(4.0, any.number(math.pi, 2*math.pi), function() return true end)
shrinks_to(0.25, any.number(0.1, 0.3), function() return true end)
shrinks_to(-4.0, any.number(-7.5, -3.5), function() return true end)
shrinks_to(1000.0, any.number(0, 1e300), function(x) return x >= 1000 end)
shrinks_to(0, any.integer(-1000, 1000), function() return true end)
shrinks_to(78, any.integer(-1000, 1000), function(k) return k > 77 end)
shrinks_to(-2, any.integer(-1000, 1000), function(k) return k < -1 end)
shrinks_to(17, any.integer(17, 99), function() return true end)
shrinks_to(-17, any.integer(-99, -17), function() return true end)
shrinks_to(math.mininteger + 9, any.integer(math.mininteger, math.mininteger + 9), function() return true end)
shrinks_to(1 << 40, any.integer(math.mininteger, math.maxinteger), function(k) return k >= 1 << 40 end)
shrinks_to(vec(1, 0, 0), any.direction, function() return true end)
shrinks_to(vec(0, 0, -1), any.direction, function(v) return v.z < -0.9 end)
shrinks_to(unit { 1, 1, 0 }, any.direction, function(v) return v.x > 0.1 and v.y > 0.1 end)
shrinks_to(unit { 1, 1, -1 }, any.direction, function(v) return v.x > 0.1 and v.y > 0.1 and v.z < -0.1 end)
shrinks_to(vec(0, 0, 0), any.vector(3), function() return true end)
shrinks_to(vec(0, 2, 0), any.vector(3), function(v) return v.y > 1.5 end)
shrinks_to(rotation({ 1, 0, 0 }, 0), any.rotation, function() return true end)
shrinks_to(rotation({ 0, 1, 0 }, pi/2), any.rotation, function(R) return (R*vec(1, 0, 0)).z < -0.1 end)
shrinks_to(rotation({ 1, 0, 0 }, pi), any.rotation, function(R) return R.angle > 3 end, { n = 1000 })
shrinks_to("c", any.one_of { "a", "b", "c", "d", "e" }, function(s) return s > "b" end, { seed = 3 })
shrinks_to({ 0, 4, 0 }, any.list(any.integer(0, 9), 3), function(list) return list[2] > 3 end)
contains(exact(any.number(0, 10).shrink(3 + 2^-30)), " 3.0,", "a little above a whole number")
contains(exact(any.number(0, 10).shrink(3 - 2^-30)), " 3.0,", "a little below")
-- A rotation that no simple one stands for keeps its angle or its axis, where the other is simple.
local slow = failing({ R = any.rotation }, function(c)
  holds(c.R.angle > 1.2 or c.R.angle < 0.9, "far")
end, { n = 300 }).R
equal(slow.axis, vec(1, 0, 0))
equal(slow.angle < 1.2 and slow.angle > 0.9, true)

-- Every proposal is in the range, and simpler than what it comes from: no chain of them is endless, whatever fails.
for name, generator in pairs { number = any.number(-3, 40), positive = any.number(0.1, 7),
  integer = any.integer(-9, 50), direction = any.direction, vector = any.vector(3), rotation = any.rotation } do
  for seed = 1, 20 do
    local choose, steps = generators.random(seed), 0
    local value = generator.draw(choose)
    while true do
      local simpler = generator.shrink(value)
      if #simpler == 0 then break end
      value, steps = simpler[choose(#simpler)], steps + 1
      equal(steps < 1000, true, name .. " goes on for ever")
      if name == "positive" then equal(value >= 0.1 and value <= 7, true) end
    end
  end
end

-- The digits make the case again, that which was found and that which it shrank to; both fail.
local function too_far(c) return c.R:distance(rotation.identity) + c.x > 4 end
local simple, found, number, text, of, seed = failing({ R = any.rotation, x = any.number(0, 2) }, function(c)
  holds(true, "beside it")
  holds(not too_far(c), "near enough")
end, { n = 500, seed = -3 })
equal(too_far(simple) and too_far(found), true)
case = drawn({ R = any.rotation, x = any.number(0, 2) }, { n = 500, seed = -3 })[number]
equal(found.R, case.R)
equal(found.x, case.x)
equal(of, 500)
equal(seed, -3)
-- The tries of shrinking are not counted: each check stands there once for each case up to that which failed.
contains(text, ("beside it (%d cases) PASS"):format(number))
contains(text, ("near enough (%d cases) FAIL"):format(number))
contains(text, "FAIL 1 of 2 checks")

-- The line of the table is that of the shrunk case.
contains(select(2, shrunk({ x = any.number(0, 10) }, function(c) near(0, c.x, 4.5, "x") end)),
  "0 5 5.0e+00 4.5e+00 FAIL")

-- Also where another check of this name is worse in the case found.
local nine = { draw = function() return 9 end, shrink = function(x) return { x - 1 } end }
contains(select(2, shrunk({ x = nine }, function(c)
  near(0, c.x, 4.5, "x")
  near(0, c.x, 0.5, "x")
end)), "0 1 1.0e+00 5.0e-01 FAIL")

-- What shrinks must fail by the same check: at 1 there is an error, at 0 another check that fails.
nine.shrink = function(x) return { x - 1, 1, 0 } end
equal(shrunk({ x = nine }, function(c)
  if c.x == 1 then error "one" end
  holds(c.x > 4, "not small")
  holds(c.x < 7, "not large")
end).x, 7)

-- An error is shrunk as long as there is one; a hypothesis that fails on the way is no failure. What was checked before
-- is there.
simple, text = shrunk({ k = any.integer(0, 1000) }, function(c)
  given(c.k ~= 900)
  holds(true, "before")
  if c.k >= 900 then error "large" end
end)
equal(simple.k, 901)
contains(text, "it ended in an error: ")
contains(text, "large FAIL")
contains(text, "cases) PASS")

-- At most 1000 tries; a generator of one's own, with shrink and without.
local tries = 0
local endless = { draw = function() return 0 end, shrink = function(x) return { x + 1 } end }
equal(failing({ x = endless }, function() tries = tries + 1 holds(false) end).x, 1000)
equal(tries, 1001)
verdict, output = inside(function() for_all({ x = function(r) return r(5, 6) end }, function(c) holds(c.x < 5) end) end)
equal(verdict, "FAIL")
contains(output, "nothing simpler fails")

-- What f does to its case is not done to the case reported.
simple = failing({ list = any.list(any.integer(1, 6), 2) }, function(c) c.list[1], c.more = 99, 1 holds(false) end)
equal(exact(simple), "{list = {1, 1}}")

-- Outside a theorem.
contains(printed(for_all, { x = any.number(0, 1) }, function(c) holds(c.x < 1, "below one") end),
  "PASS below one (100 cases)")
raises("shrunk to {x = 1.0}", function()
  for_all({ x = any.number(0, 1) }, function(c) holds(c.x < 0.5, "half") end)
end)

-- What is no test at all.
raises("for_all: expected a table of generators, {x = any.number(0, 1)}, got a nil", function() for_all(nil, print) end)
raises("for_all: there are no values to draw", function() for_all({}, print) end)
raises("for_all: the values need names", function() for_all({ any.rotation }, print) end)
raises("for_all: x: expected a generator", function() for_all({ x = 1 }, print) end)
raises("expected a generator, got a function of rotor, used as any.number(low, high)", function()
  for_all({ x = any.number }, print)
end)
raises("for_all: expected a function of a case, got a nil", function() for_all { x = any.rotation } end)
raises("for_all: unknown option 'sed'; did you mean 'seed'?", function()
  for_all({ x = print }, print, { sed = 1 })
end)
raises("for_all: n: expected a whole number, got 1.5", function()
  for_all({ x = print }, print, { n = 1.5 })
end)
raises("for_all: n: expected one case at least, got 0", function() for_all({ x = print }, print, { n = 0 }) end)
raises("for_all: expected options in braces, got a number", function() for_all({ x = print }, print, 5) end)
raises("for_all: x: shrink must give a list, got a nil", function()
  for_all({ x = { draw = function() return 1 end, shrink = function() end } }, function() holds(false) end)
end)
raises("any.number: expected a finite range", function() any.number(2, 1) end)
raises("any.number: expected a finite range", function() any.number(0, math.huge) end)
raises("any.integer: expected a finite range", function() any.integer(0.5, 2) end)
raises("any.vector: expected a size", function() any.vector(-1) end)
raises("any.one_of: expected a list of values", function() any.one_of() end)
raises("any.list: expected a generator", function() any.list(3, 4) end)
raises("any.list: expected a length", function() any.list(any.rotation, -1) end)

-- Ctrl-C leaves a case through a hook that goes on raising after each pcall; the next check stands alone again.
pcall(for_all, { x = any.rotation }, function()
  local for_all_itself = require "rotor.testing".for_all
  debug.sethook(function()
    for level = 2, math.huge do
      local info = debug.getinfo(level, "f")
      if not info then return end
      if info.func == for_all_itself then error "interrupted!" end
    end
  end, "", 1)
  while true do end
end)
debug.sethook()
contains(printed(holds, true, "later"), "PASS  later")
raises("given: it stands in the function", function() given(true) end)

-- The theorems that failed here had to.
package.loaded["rotor.testing"] = nil
