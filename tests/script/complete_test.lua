-- rotor.complete: what may stand at the cursor, found without running anything.
package.path = (arg[0]:match "^(.*/)" or "./") .. "?.lua;" .. package.path
local support = require "support"

support.use()
local complete = require "rotor.complete"

local function slerp() error "completion called a function" end
require("rotor.names").find("", "slerp").value = slerp
local globals = {
  slerp = slerp,
  rotation = setmetatable({ from_mrp = print }, { __call = function() error "called" end }),
  R = support.untouchable "rotation",
  run = support.untouchable "run",
  zz_trap = setmetatable({ raw_key = 1, ["no name"] = 2, inner = { deep = print } },
    { __index = function() error "__index ran" end, __pairs = function() error "__pairs ran" end }),
  zz_class = setmetatable({ own = 1 }, { __index = { turn = function() end, size = 2 } }),
  zz_list = { support.untouchable "vec" },
  zz_callable = setmetatable({}, { __call = function() error "called" end }),
  zz_text = "x",
}
for name, value in pairs(globals) do rawset(_G, name, value) end

-- The line with | at the cursor; the candidates, joined by spaces; the line with the only candidate put in.
local function check(marked, expected, completed)
  local before, after = marked:match "^(.-)|(.*)$"
  local start, found = complete(before .. after, #before)
  support.equal(table.concat(found, " "), expected, marked)
  if completed then
    support.equal(before:sub(1, start - 1) .. found[1] .. after, completed, marked)
  end
  support.equal(start >= 1 and start <= #before + 1, true, marked .. ": start")
end

-- Global names: raw globals, registered names, Lua's words; functions with the bracket of their call.
check("sl|", "slerp(", "slerp(")
check("x = sl|", "slerp(", "x = slerp(")
check("sl|(R, S)", "slerp", "slerp(R, S)")
check("evol|", "evolve{")
check("zz_call|", "zz_callable")
check("dof|", "dofile(")
check("els|", "else elseif")
check("qqq|", "")
check("zz_t|", "zz_text zz_trap")
check("1 ..sl|", "slerp(")
check("print(#zz_li|", "zz_list")

-- Members of tables by raw access, of values by their rows.
check("string.form|", "format(", "string.format(")
check("zz_trap.|", "inner raw_key", "zz_trap.inner")
check("zz_trap.inner.|", "deep(")
check("zz_trap . inner . d|", "deep(")
check("zz_trap:|", "")
check("zz_class.|", "own size turn(")
check("zz_class:|", "turn(")
check("rotation.f|", "from_mrp(")
check("R.|", "angle axis")
check("R:|", "euler_angles( inverse() slerp(")
check("R:inv|", "inverse()", "R:inverse()")
check("R.axis.|", "x")
check("zz_list[1].|", "x")
check("zz_list[2].|", "")
check("io.stdout:se|", "seek( setvbuf(")

-- Strings.
check('("x"):re|', "rep( reverse(", '("x"):rep(')
check("zz_text:rev|", "reverse(")

-- Along result types: nothing is called.
check("run.cost.s|", "seconds steps")
check("run(2*pi).|", "axis")
check("run(f(1, {2})).axis.|", "x")
check("slerp(R, S, 0.5).an|", "angle")
check("R:inverse():inverse():s|", "slerp(")
check("evolve{omega = {0, 0, 1}}.c|", "cost")
check("evolve{omega = {0, 0, 1}}:c|", "csv(")
check("(R).an|", "angle")
check("(R * S).an|", "")
check("unknown.|", "")
check("unknown().|", "")

-- Keys of options tables that are not there yet.
check("evolve{om|", "omega=", "evolve{omega=")
check("evolve{ omega = f(1, {a = 2}), ma|", "max_step= max_steps=")
check("evolve{omega = f, from = R, t|", "t= to=")
check("evolve{t = {0, 1}, t|", "to=")
check("R:slerp(S, 0.5, {|", "way=")
check("R:euler_angles('zyx', {fr|", "frame=")
check("evolve{omega = sl|", "slerp(")
check("evolve{slerp(1), sl|", "slerp(")
check("x = {sl|", "slerp(")

-- Where no name can stand.
check("1.|", "")
check("3|", "")
check("'sl|", "")
check("[[sl|", "")
check("-- sl|", "")
check("--[[ x ]] sl|", "slerp(")
check("'it' sl|", "slerp(")
check([['it\'s' sl|]], "slerp(")
check("x = [==[ ]] ]==] sl|", "slerp(")
check(")|", select(2, complete "") and table.concat(select(2, complete ""), " "))
check("].|", "")
check(").|", "")
check("}:|", "")

-- Names to ask help for.
check("?sl|", "slerp", "?slerp")
check(" ? evo|", "evolve")
check("?zz_call|", "zz_callable")
check("?cost|", "cost")
check("?run.|", "cost")
check("?run:|", "csv table")
check("?rotation.f|", "from_mrp")
check("?state.|", "axis")
check('help "evol|', "evolve", 'help "evolve')
check("help('run:c|", "csv")
check("?string.rev|", "reverse")

-- Sorted, without a position the end of the line, and the whole choice on an empty line.
local start, all = complete ""
support.equal(start, 1)
for i = 2, #all do
  if all[i - 1] >= all[i] then error("not sorted or twice: " .. all[i - 1] .. ", " .. all[i]) end
end
support.equal(#all > 60, true, "all global names and words")

-- Whatever stands on the line, completion neither fails nor runs forever.
math.randomseed(20240607)
local alphabet = { "R", "run", ".", ":", "(", ")", "{", "}", "[", "]", "'", '"', ",", " ", "=", "1", "--", "[[", "\\",
  "evolve", "?", "..", "zz_trap", "slerp", "\xcf\x89", "\xff" }
for case = 1, 5000 do
  local parts = {}
  for i = 1, math.random(1, 10) do parts[i] = alphabet[math.random(#alphabet)] end
  local line = table.concat(parts)
  local position = math.random(0, #line)
  local ended, first, found = pcall(complete, line, position)
  if not ended or first < 1 or first > position + 1 or type(found) ~= "table" then
    error(("case %d: complete(%q, %d): %s"):format(case, line, position, first))
  end
end
