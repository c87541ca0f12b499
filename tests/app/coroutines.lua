-- What coroutine.resume, wrap and close do by Lua's manual. Every line holds in lua5.4 as well.
local create, resume, wrap, yield, close, status = coroutine.create, coroutine.resume, coroutine.wrap,
  coroutine.yield, coroutine.close, coroutine.status

local function same(expected, ...)
  local given = table.pack(...)
  assert(given.n == expected.n, ("%d values, expected %d"):format(given.n, expected.n))
  for i = 1, given.n do
    assert(given[i] == expected[i], ("value %d: %s, expected %s"):format(i, given[i], expected[i]))
  end
end
local values = table.pack

-- Values in and out, nil among them.
local co = create(function(...)
  local a, b = yield(select("#", ...), ...)
  return b, a, nil
end)
same(values(true, 3, 1, nil, nil), resume(co, 1, nil, nil))
same(values(true, "b", nil, nil), resume(co, nil, "b"))
same(values(false, "cannot resume dead coroutine"), resume(co))
same(values(false, "cannot resume dead coroutine"), resume(co))
assert(status(co) == "dead")

-- Errors: any value, and positions as Lua writes them.
local object = {}
same(values(false, object), resume(create(function() error(object) end)))
same(values(false, nil), resume(create(function() error() end)))
same(values(false, "text"), resume(create(function() error("text", 0) end)))
local line = debug.getinfo(1, "l").currentline + 1
local good, message = pcall(function() local x = wrap(function() error("text", 0) end)() return x end)
assert(not good and message:match ":(%d+): text$" == tostring(line), message)
same(values(false, object), pcall(wrap(function() error(object) end)))
same(values(false, "text"), pcall(wrap(function() error("text", 0) end)))
local dead = wrap(function() end)
dead()
same(values(false, "cannot resume dead coroutine"), pcall(dead))

-- A running coroutine, and one that waits for another, cannot be resumed or closed.
wrap(function()
  local outer = coroutine.running()
  same(values(false, "cannot resume non-suspended coroutine"), resume(outer))
  same(values(false, "cannot close a running coroutine"), pcall(close, outer))
  wrap(function()
    assert(status(outer) == "normal")
    same(values(false, "cannot resume non-suspended coroutine"), resume(outer))
    same(values(false, "cannot close a normal coroutine"), pcall(close, outer))
  end)()
end)()

-- Yields across pcall, metamethods, iterators and sort's refusal.
co = wrap(function()
  local ok, value = pcall(function()
    local got = yield(1)
    error(got, 0)
  end)
  yield(ok, value)
  local t = setmetatable({}, { __index = function(_, key) return yield(key) end })
  yield(t.name .. "!")
  for i in function(_, i) return yield(i) end do yield(i) end
  return "end"
end)
same(values(1), co())
same(values(false, "caught"), co("caught"))
same(values("name"), co())
same(values("rotor!"), co("rotor"))
same(values(nil), co())
same(values(7), co(7))
same(values(7), co())
same(values("end"), co(nil))
local comparing = create(function() table.sort({ 2, 1 }, yield) end)
same(values(false, "attempt to yield across a C-call boundary"), resume(comparing))

-- Closing runs what is to be closed, in order, and reports its error.
local log = {}
local function closing(name, failure)
  return setmetatable({}, { __close = function(_, why)
    log[#log + 1] = name .. ":" .. tostring(why)
    if failure then error(failure, 0) end
  end })
end
co = create(function()
  local _a <close> = closing "a"
  local _b <close> = closing("b", "b fails")
  yield()
end)
resume(co)
same(values(false, "b fails"), close(co))
assert(table.concat(log, " ") == "b:nil a:b fails", table.concat(log, " "))
same(values(true), close(co))
same(values(true), close(create(print)))
log = {}
same(values(false, "c fails"), pcall(wrap(function()
  local _c <close> = closing("c", "c fails")
  error("first", 0)
end)))
assert(log[1] == "c:first")

-- Wrong arguments are named as Lua names them.
for expected, call in pairs {
  ["bad argument #1 to 'resume' (thread expected, got number)"] = function() coroutine.resume(1) end,
  ["bad argument #1 to 'close' (thread expected, got no value)"] = function() coroutine.close() end,
  ["bad argument #1 to 'wrap' (function expected, got no value)"] = function() coroutine.wrap() end,
} do
  local _, text = pcall(call)
  assert(text:find(expected, 1, true), text)
end

-- As deep as Lua goes, and no crash beyond.
local function nest(depth)
  if depth == 0 then return 0 end
  return 1 + wrap(nest)(depth - 1)
end
assert(nest(150) == 150)
local deep, overflow = pcall(nest, 1000)
assert(not deep and overflow:find "C stack overflow", overflow)
print "ok"
