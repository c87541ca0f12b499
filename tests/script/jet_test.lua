-- Derivatives of scripted functions, and the functions of math that take jets.
package.path = (arg[0]:match "^(.*/)" or "./") .. "?.lua;" .. package.path
local support = require "support"
local equal, contains = support.equal, support.contains

local function derivatives(omega, t)
  return evolve{ omega = omega, t = { t, t }, method = "rk4", step = 1 }:derivatives(t)
end
-- Of a function in place of omega's z.
local function along(f, t) return derivatives(function(s) return 0, 0, f(s) end, t) end
local function refused(omega, t)
  local ended, message = pcall(derivatives, omega, t)
  equal(ended, false, "an error is expected")
  return tostring(message)
end

theorem("omega and its eight derivatives", function()
  local a, t = 2*pi/40, 7.3
  local d = derivatives(function(s) return cos(a*s), math.sin(a*s), s^3/6 end, t)
  equal(#d, 9)
  for k = 0, 8 do
    local x, y = a^k*math.cos(a*t + k*pi/2), a^k*math.sin(a*t + k*pi/2)
    local z = ({ t^3/6, t^2/2, t, 1 })[k + 1] or 0
    -- A recurrence of k steps, some (k + 1)^2 u of the largest; k roundings of a^k; pi/2 k to 1e-15.
    near(vec(x, y, z), d[k + 1], 1e-14*math.max(a^k, math.abs(z)), "derivative " .. k)
  end
end)

theorem("every way of giving three values", function()
  local expected = { vec(0.25, 0, 2), vec(1, 0, 0), vec(2, 0, 0) }
  for what, omega in pairs {
    values = function(t) return t*t, 0, 2 end,
    table = function(t) return { t*t, 0, 2 } end,
    ["a wider table"] = function(t) return { t^2, 0, 2.0, n = 3 } end,
  } do
    local d = derivatives(omega, 0.5)
    for i = 1, 3 do holds(d[i] == expected[i], what .. " " .. i) end
  end
  holds(derivatives(function() return vec(1, 2, 3) end, 0)[1] == vec(1, 2, 3), "a vec that does not vary")
  holds(derivatives({ 1, 2, 3 }, 5)[1] == vec(1, 2, 3) and derivatives({ 1, 2, 3 }, 5)[2] == vec(0, 0, 0), "a vector")
end)

theorem("operators of jets and numbers, on both sides", function()
  for source, slope in pairs {
    ["1 + t"] = 1, ["t + 1"] = 1, ["t + t"] = 2, ["1 - t"] = -1, ["t - 1"] = 1, ["2*t"] = 2, ["t*2"] = 2,
    ["t*t"] = 3, ["3/t"] = -3/2.25, ["t/2"] = 0.5, ["-t"] = -1, ["t^2"] = 3, ["2^t"] = 2^1.5*math.log(2),
    ["t^t"] = 1.5^1.5*(1 + math.log(1.5)), ["t % 1"] = 1, ["t % -1"] = 1, ["7 % t"] = -4, ["t//1*t"] = 1,
    ["7//t*t"] = 4,
    ["floor(t)*t"] = 1, ["ceil(t)*t"] = 2, ["({10, 20})[floor(t)]*t"] = 10, ["t < 2 and 2*t or t"] = 2,
    ["2 > t and 2*t or t"] = 2, ["1 <= t and 2*t or t"] = 2, ["t >= t and 2*t or t"] = 2,
    ["t == t and 2*t or t"] = 2,
    ["math.max(t, 1)"] = 1, ["math.max(1, 2, t)"] = 0, ["math.min(t, 2)"] = 1, ["math.min(2, t*t, 7)"] = 0,
    ["sin(t)"] = math.cos(1.5), ["cos(t)"] = -math.sin(1.5), ["tan(t)"] = 1 + math.tan(1.5)^2,
    ["exp(t)"] = math.exp(1.5),
    ["asin(t/2)"] = 1/math.sqrt(1.75), ["acos(t/2)"] = -1/math.sqrt(1.75), ["atan(t)"] = 1/3.25,
    ["atan(t, 2)"] = 2/6.25, ["atan(2, t)"] = -2/6.25, ["atan(t, t)"] = 0, ["log(t)"] = 1/1.5,
    ["log(t, 10)"] = 1/1.5/math.log(10), ["log(3, t)"] = -math.log(3)/math.log(1.5)^2/1.5,
    ["sqrt(t)"] = 0.5/math.sqrt(1.5),
    ["abs(-t)"] = 1, ["math.abs(t)"] = 1, ["-3 < t and t or 0"] = 1,
  } do
    local f = assert(load("local t = ... return " .. source))
    local d = along(f, 1.5)
    holds(d[1].z == f(1.5), source)
    -- Three roundings here, some four there, of terms that tan makes four times as large.
    near(slope, d[2].z, 4e-15*math.max(1, math.abs(slope)), source .. ", derivative")
  end
end)

-- What cannot be differentiated is said, with where and why.
local line = debug.getinfo(1, "l").currentline + 1
local message = refused(function(t) return 0, 0, abs(t - 1) end, 1)
contains(message, ("derivatives: omega (function at %s:%d) cannot be differentiated at t = 1.0: "):format(
  debug.getinfo(1, "S").short_src, line))
contains(message, ":" .. line .. ": abs: no derivatives at x = 0.0")
for source, why in pairs {
  ["sqrt(t)"] = "sqrt: no derivatives at x = 0.0",
  ["t^0.5"] = "x ^ y: no derivatives at x = 0.0, y = 0.5",
  ["1 // 1 // (t + 1)*t"] = "x // y: no derivatives at x = 1.0, y = 1.0",
  ["math.max(t, 0)"] = "a kink or a jump: its derivatives there foretell",
  ["math.max(t, 0)^2"] = "a kink or a jump",
  ["t < 0 and 1 or 2"] = "foretell (0.0, 0.0, 2.0) at t = ",
  ["t <= 0 and 1 or 2"] = "a kink or a jump",
  ["t == 0 and 1 or 2"] = "called with a number it gives (0.0, 0.0, 1.0), with a jet (0.0, 0.0, 2.0)",
  ["type(t) == 'number' and 1 or 2"] = "with a jet (0.0, 0.0, 2.0) (t == 1 is true of no jet; t <= 1 can be)",
  ["vec(t, 0, 0).x"] = "vec: argument 1: expected a number, got jet; usage: vec(x, y, z) -> vec; jets go through + - ",
  ["('%g'):format(t) + 0"] = "(number expected, got jet); jets go through",
  ["(vec(1, 2, 3)*t).x"] = "v * x: a vec times jet is not defined",
  ["#(t .. '')"] = "attempt to concatenate a jet value (local 't'); jets go through",
  ["type(t) == 'number' and 1 or exp(800 + t)"] = "its derivative of order 0 is (0.0, 0.0, inf)",
  ["type(t) == 'number' and 1 or nil"] = "called with a jet it gives number 0, number 0, nil",
  ["type(t) == 'number' and 1 or vec(1, 2, 3)"] = "called with a jet it gives number 0, number 0, vec",
} do
  contains(refused(load("local t = ... return 0, 0, " .. source), 0), why, source)
end
contains(refused(function(t) if type(t) ~= "number" then error { code = 7 } end return 1, 2, 3 end, 0),
  "cannot be differentiated at t = 0.0: table")
contains(refused(function(t) if t ~= 0 then error "elsewhere" end return 1, 2, 3 end, 0), "elsewhere")
contains(refused(function(t) return type(t) == "number" and { 1, 2, 3 } or { 1, 2 } end, 0),
  "called with a jet it gives")

theorem("at the end of where a function is defined, the other side decides", function()
  holds(along(function(t) assert(t >= 0, "too early") return t*t end, 0)[3].z == 2, "t^2 from 0 on")
  fails(function() along(function(t) if t < 0 then error "no" end return math.max(t - 1e-7, 0) end, 0) end,
    "the side that there is must agree", "a kink or a jump")
end)

theorem("the rest of a function's noise is no kink", function()
  near(math.cos(1.5), along(function(t) return 1e8 + sin(t) - 1e8 end, 1.5)[2].z, 1e-15, "digits lost")
  for _, size in ipairs { 1e-300, 1e-8, 1, 1e8, 1e300 } do
    for _, t in ipairs { 0, 1e-300, 1, 2*pi, 1e6, -1e9 } do
      local d = along(function(s) return size*cos(s) end, t)
      -- The recurrence is in sin t and cos t themselves.
      holds(math.abs(d[2].z + size*math.sin(t)) <= 4e-16*size, ("%g cos t at %g"):format(size, t))
      holds(along(function(s) return size*sin(s) end, t)[1].z == size*math.sin(t), "and its sine")
    end
  end
end)

theorem("numbers get what Lua's own functions give", function()
  holds(math.sin == sin and math.floor == floor and math.log == log, "bare and in math one and the same")
  holds(math.type(abs(-3)) == "integer" and abs(math.mininteger) == math.mininteger and abs("-3") == 3.0, "abs")
  holds(math.type(floor(2.5)) == "integer" and floor(-2.5) == -3 and floor(1e300) == 1e300 and floor(7) == 7, "floor")
  holds(math.type(ceil("2.5")) == "integer" and ceil(-2.5) == -2 and math.type(ceil(1e300)) == "float", "ceil")
  holds(log(8, 2) == 3.0 and log(1000, 10) == 3.0 and log(2, nil) == math.log(2) and log("8", "2") == 3.0, "log")
  holds(atan(1, -1) == 3*pi/4 and atan(-0.0, -1) == -pi and atan("1", nil) == pi/4, "atan")
  holds(sqrt(-1) ~= sqrt(-1) and log(0) == -math.huge and sin("0") == 0.0, "no number is refused")
  fails(function() sin() end, "nothing", "bad argument #1 to 'sin' %(number expected, got no value%)")
  fails(function() math.sqrt(nil) end, "nil", "bad argument #1 to 'sqrt' %(number expected, got nil%)")
  fails(function() abs({}) end, "a table", "bad argument #1 to 'abs' %(number expected, got table%)")
  fails(function() floor("x") end, "a word", "bad argument #1 to 'floor' %(number expected, got string%)")
  fails(function() log(2, {}) end, "base", "bad argument #2 to 'log' %(number expected, got table%)")
  fails(function() atan("x", 1) end, "y", "bad argument #1 to 'atan' %(number expected, got string%)")
end)

theorem("a jet is a value: its text, and no fields to lose derivatives by", function()
  local jet
  along(function(t) if type(t) ~= "number" then jet = t end return t end, 0.5)
  equal(tostring(jet), "jet 0.5, derivatives 1.0")
  equal(tostring(jet^3), "jet 0.125, derivatives 0.75 3.0 6.0")
  equal(tostring(0*jet), "jet 0.0, constant")
  fails(function() return jet.value end, "no fields", "a jet has no field value")
  fails(function() return jet + {} end, "a table", "x %+ y: expected a number or a jet, got table")
  fails(function() return jet < "1" end, "a string", "expected a number or a jet, got string")
end)

fails(function() evolve{ omega = { 1, 2, 3 }, to = 1 }:derivatives(2) end, "outside",
  "derivatives: t = 2.0 is outside the run, 0.0 .. 1.0")
fails(function() evolve{ omega = { 1, 2, 3 }, to = 1 }:derivatives() end, "no time", "expected a number, got nothing")
