-- any: what for_all draws its cases from. A generator is { draw = f(random), shrink = f(value) }: draw makes a value,
-- shrink lists simpler ones, simplest first. Each of these is simpler by an order in which nothing descends for ever.
local names = require "rotor.names"

local vec, unit, rotation = names.registered "vec", names.registered "unit", names.registered "rotation"

local generators = {}

--- random() is uniform in [0, 1), random(n) and random(m, n) whole numbers as math.random's. SplitMix64 (Steele, Lea,
--- Flood 2014): integers alone, the same everywhere, and math.random's state is not touched.
function generators.random(seed)
  local state = seed
  local function bits()
    state = state + 0x9e3779b97f4a7c15
    local z = (state ~ state >> 30)*0xbf58476d1ce4e5b9
    z = (z ~ z >> 27)*0x94d049bb133111eb
    return z ~ z >> 31
  end
  return function(m, n)
    if m == nil then return (bits() >> 11)*0x1p-53 end
    local low, high = math.tointeger(n == nil and 1 or m), math.tointeger(n == nil and m or n)
    if not low or not high or low > high then
      error(("random: expected whole numbers, the first not above the second, got %s, %s"):format(m, n), 2)
    end
    local span, mask = high - low, -1  -- of 64 bits without a sign
    while mask ~= 0 and not math.ult(mask >> 1, span) do mask = mask >> 1 end
    local x
    repeat x = bits() & mask until not math.ult(span, x)
    return low + x
  end
end

-- Numbers -------------------------------------------------------------------------------------------------------------

local kPlaces = 20  -- binary places at most to which a number is cut; with more it is no simple one

-- Binary places after the point.
local function places(x)
  local count = 0
  while x % 1 ~= 0 do x, count = 2*x, count + 1 end
  return count
end

-- Fewer binary places first, then the smaller size, then the positive one.
local function simpler(a, b)
  local p, q = places(a), places(b)
  if p ~= q then return p < q end
  local s, t = math.abs(a + 0.0), math.abs(b + 0.0)  -- as floats, since -math.mininteger is no integer
  if s ~= t then return s < t end
  return a > b
end

-- The simplest number in the range, of those with few places.
local function simplest(low, high)
  if low <= 0 and high >= 0 then return 0.0 end
  if high < 0 then return -simplest(-high, -low) end
  for k = 0, kPlaces do
    local x = math.ceil(low*2^k)/2^k
    if x <= high then return x end
  end
  return low
end

-- Appends x - d, x - d/2, x - d/4, ...: from the origin back to x, in whole multiples of `one`.
local function halfway(try, x, origin, one)
  local d = (x - origin)//one
  for _ = 1, 64 do
    if d == 0 then return end
    try(x - d*one)
    d = d > 0 and d//2 or -(-d//2)
  end
end

-- A list, and the function that appends a number to it if it is in the range, simpler than x and not there yet.
local function candidates(x, low, high)
  local list, seen = {}, {}
  return list, function(y)
    if y >= low and y <= high and not seen[y] and simpler(y, x) then
      list[#list + 1], seen[y] = y, true
    end
  end
end

local function simpler_numbers(x, low, high)
  local list, try = candidates(x, low, high)
  for _, y in ipairs { simplest(low, high), 0.0, 1.0, -1.0, 2.0, -2.0, 0.5, -0.5, -x } do try(y) end
  try(x < 0 and -(math.sqrt(-x)//1) or math.sqrt(x)//1)  -- from 1e300 it is far by halves
  local count = places(x)
  for k = 0, math.min(count, kPlaces) do
    local one = 2.0^-k
    try(x//one*one)
    try(-(-x//one)*one)
  end
  if count <= kPlaces then halfway(try, x, simplest(low, high), 2.0^-count) end
  return list
end

local function simpler_integers(x, low, high)
  local list, try = candidates(x, low, high)
  local origin = low > 0 and low or high < 0 and high or 0
  for _, y in ipairs { origin, 1, -1, 2, -2, -x } do try(y) end
  halfway(try, x, origin, 1)
  return list
end

local function expect_range(name, low, high, number)
  low, high = number(low), number(high)
  if not (low and high and low <= high and low > -math.huge and high < math.huge) then
    error(("any.%s: expected a finite range, low and high"):format(name), 3)
  end
  return low, high
end

local any = {}
generators.any = any

function any.number(low, high)
  low, high = expect_range("number", low, high, function(x) return type(x) == "number" and x + 0.0 end)
  return {
    draw = function(random)
      local u = random()
      return math.max(low, math.min(high, low*(1 - u) + high*u))  -- rounding may lead out
    end,
    shrink = function(x) return simpler_numbers(x, low, high) end,
  }
end

function any.integer(low, high)
  low, high = expect_range("integer", low, high, math.tointeger)
  return {
    draw = function(random) return random(low, high) end,
    shrink = function(x) return simpler_integers(x, low, high) end,
  }
end

-- Vectors and rotations ----------------------------------------------------------------------------------------------

-- The items of a list before that which equals the value; all if none does.
local function before(list, value)
  local simple = {}
  for _, item in ipairs(list) do
    if item == value then break end
    simple[#simple + 1] = item
  end
  return simple
end

-- A point of the unit disk but its middle, and its distance from there squared (Marsaglia 1972).
local function in_disk(random)
  local x, y, s
  repeat
    x, y = 2*random() - 1, 2*random() - 1
    s = x*x + y*y
  until s < 1 and s > 0
  return x, y, s
end

local axes = { vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1), vec(-1, 0, 0), vec(0, -1, 0), vec(0, 0, -1) }

-- The axes, then what lies between two of them, then between three.
local function simple_directions()
  local list = table.move(axes, 1, #axes, 1, {})
  for count = 2, 3 do
    for i = 0, 26 do
      local v = vec((2 - i%3)%3 - 1, (2 - i//3%3)%3 - 1, (2 - i//9)%3 - 1)
      if v.x^2 + v.y^2 + v.z^2 == count then list[#list + 1] = unit(v) end
    end
  end
  return list
end
local directions = simple_directions()

any.direction = {
  draw = function(random)
    local x, y, s = in_disk(random)
    local r = 2*math.sqrt(1 - s)
    return unit(vec(r*x, r*y, 1 - 2*s))
  end,
  shrink = function(v) return before(directions, v) end,
}

function any.vector(size)
  if type(size) ~= "number" or not (size >= 0 and size < math.huge) then
    error("any.vector: expected a size, zero or more, got " .. tostring(size), 2)
  end
  local component = any.number(-size, size)
  return {
    draw = function(random)
      local x, y, z = component.draw(random), component.draw(random), component.draw(random)
      return vec(x, y, z)
    end,
    shrink = function(v)
      local list = before({ vec(0, 0, 0) }, v)
      for i = 1, 3 do
        for _, x in ipairs(component.shrink(v[i])) do
          local w = { v.x, v.y, v.z }
          w[i] = x
          list[#list + 1] = vec(w[1], w[2], w[3])
        end
      end
      return list
    end,
  }
end

local simple_rotations = { rotation(axes[1], 0.0) }
for _, angle in ipairs { math.pi/2, math.pi } do
  for i = 1, 3 do simple_rotations[#simple_rotations + 1] = rotation(axes[i], angle) end
end

any.rotation = {
  draw = function(random)
    local x, y = in_disk(random)
    local z, w, s = in_disk(random)
    local r = math.sqrt((1 - x*x - y*y)/s)
    z, w = r*z, r*w
    if w < 0 then x, y, z, w = -x, -y, -z, -w end
    return rotation(vec(x, y, z), 2*math.atan(math.sqrt(x*x + y*y + z*z), w))
  end,
  shrink = function(R)
    local list = before(simple_rotations, R)
    if #list < #simple_rotations then return list end
    for _, axis in ipairs(before(directions, R.axis)) do list[#list + 1] = rotation(axis, R.angle) end
    for _, angle in ipairs(before({ math.pi/2, math.pi }, R.angle)) do list[#list + 1] = rotation(R.axis, angle) end
    return list
  end,
}

-- Choices and lists ---------------------------------------------------------------------------------------------------

function any.one_of(choices)
  if type(choices) ~= "table" or #choices == 0 then error("any.one_of: expected a list of values", 2) end
  return {
    draw = function(random) return choices[random(#choices)] end,
    shrink = function(value) return before(choices, value) end,
  }
end

function any.list(generator, n)
  local made, problem = generators.made(generator)
  if not made then error("any.list: " .. problem, 2) end
  if not math.tointeger(n) or n < 0 then error("any.list: expected a length, got " .. tostring(n), 2) end
  return {
    draw = function(random)
      local list = {}
      for i = 1, n do list[i] = made.draw(random) end
      return list
    end,
    shrink = function(list)
      local simple = {}
      for i = 1, n do
        for _, value in ipairs(made.shrink(list[i])) do
          local other = table.move(list, 1, n, 1, {})
          other[i] = value
          simple[#simple + 1] = other
        end
      end
      return simple
    end,
  }
end

local function nothing() return {} end

--- What was given for a generator: one of any's, a table of the user's own, or the function draw alone; or nil and what
--- is wrong with it.
function generators.made(given)
  local draw = type(given) == "table" and given.draw or given
  local shrink = type(given) == "table" and given.shrink or nothing
  local row = type(given) == "function" and names.row_of(given)
  if row then return nil, "expected a generator, got a function of rotor, used as " .. row.signature end
  if type(draw) == "function" and type(shrink) == "function" then return { draw = draw, shrink = shrink } end
  return nil, "expected a generator (any.number(0, 1), any.rotation, ..., {draw=, shrink=}, or a function of random), "
    .. "got a " .. names.type_of(given)
end

return generators
