-- rotor.help, rotor.names, rotor.reference: lookup, search, wrapping, the editor stub.
package.path = (arg[0]:match "^(.*/)" or "./") .. "?.lua;" .. package.path
local support = require "support"
local equal, contains, fits, untouchable = support.equal, support.contains, support.fits, support.untouchable

support.use()
local names = require "rotor.names"
local help = require "rotor.help"

local function slerp() end
names.find("", "slerp").value = slerp
local from_mrp = names.find("rotation", "from_mrp")
from_mrp.value = function() end
local rotors = { slerp = rawget(_G, "slerp"), rotation = rawget(_G, "rotation") }
rawset(_G, "slerp", slerp)
rawset(_G, "rotation", setmetatable({ from_mrp = from_mrp.value }, { __call = function() end }))
rawset(_G, "R", untouchable "rotation")

-- suggest: a slip in three letters is forgiven, more is not; case does not count; ties go by the alphabet.
equal(names.suggest("sler", { "rotation", "slerp" }), "slerp")
equal(names.suggest("selrp", { "slerp" }), "slerp", "two neighbours swapped are one slip")
equal(names.suggest("Accuracy", { "accuracy" }), "accuracy")
equal(names.suggest("acuracyy", { "accuracy" }), "accuracy", "two slips in eight letters")
equal(names.suggest("xyurxcy", { "accuracy" }), nil, "a word with little in common")
equal(names.suggest("x", { "y" }), nil, "one letter is no hint")
equal(names.suggest("bat", { "cat", "bar" }), "bar", "a tie")
equal(names.suggest("slerp", { "slerp" }), nil, "the name itself is not misspelt")
equal(names.suggest("", { "x" }), nil)

-- parameters
local function shown_parameters(signature)
  local parts = {}
  for i, parameter in ipairs(names.parameters(signature)) do
    parts[i] = parameter.name .. (parameter.options and "{" .. table.concat(parameter.options, " ") .. "}" or "")
  end
  return table.concat(parts, ", ")
end
equal(shown_parameters "f() -> number", "")
equal(shown_parameters "slerp(R, S, s, {way=}) -> rotation", "R, S, s, options{way}")
equal(shown_parameters "evolve{omega=, from=} -> run", "options{omega from}")
equal(shown_parameters 'R:euler_angles("zyx", {frame=, degenerate=}) -> number', "argument1, options{frame degenerate}")
equal(shown_parameters "cross(a, ...) -> table", "a, ...")
equal(shown_parameters "angle -> number", "")

-- help "name": every way to say it.
equal(help.text "slerp", [[
slerp(R, S, s, {way=}) -> rotation
  Between two rotations.

  rotor> slerp(A, B, 0.5).angle
  0.5

See also rotation:slerp]])
equal(help.text "slerp()", help.text "slerp")
equal(help.text(slerp), help.text "slerp", "by value")
local inverse = [[
rotation:inverse() -> rotation
  The same axis, the negative angle.

  rotor> R:inverse().angle
  -1.0]]
equal(help.text "R:inverse", inverse, "through a global variable")
equal(help.text "S:inverse", inverse, "through a name that is nothing yet")
equal(help.text "rotation:inverse", inverse, "through the type")
equal(help.text "inverse", inverse, "without an owner")
contains(help.text "rotation.from_mrp", "rotation.from_mrp(p) -> rotation")
contains(help.text "run:csv", "run:csv(file, {n=, every=, times=})")
contains(help.text "run.cost.steps", "cost.steps -> number", "along result types")
contains(help.text "axis", "rotation.axis -> vec", "all owners")
contains(help.text "axis", "state.axis -> vec", "all owners")
contains(help.text "*", "R * S -> rotation")
contains(help.text "*", "R * v -> vec")
contains(help.text "R ^ x", "The angle times x.")

-- A type, a value of it, the maker of it.
local of_type = help.text(untouchable "rotation")
for _, piece in ipairs { "made by rotation, slerp", ".axis -> vec", ":inverse() -> rotation", "R * v -> vec",
  "rotation.from_mrp(p) -> rotation" } do
  contains(of_type, piece)
end
equal(help.text "R", of_type, "the name of a variable")
contains(help.text(rawget(_G, "rotation")), "rotation(axis, angle) -> rotation", "the maker by value")
contains(help.text "rotation", ":inverse() -> rotation")
contains(help.text(untouchable "run"), "run(t) -> state")

-- Lua's own, and the user's own: no error, nothing invented.
contains(help.text "string.format", "manual.html#pdf-string.format")
contains(help.text(string.format), "manual.html#pdf-string.format")
contains(help.text "string", "byte char dump")
contains(help.text "while", "a word of the language Lua")
contains(help.text(print), "manual.html#pdf-print")
contains(help.text(function() end), "help_test.lua, line")
contains(help.text(nil), "has no value")
equal(help.text(3), "A number of your own: 3")
equal(help.text(true), "A boolean of your own: true")
equal(help.text {}, "A table of your own.")
contains(help.text(untouchable "unheard_of"), "unheard_of", "a type that nobody registered")

-- Unknown names.
contains(help.text "sler", "Did you mean slerp?")
contains(help.text "R:invers", "A rotation has no invers. Did you mean inverse?")
contains(help.text "run:cvs", "Did you mean csv?")
contains(help.text "modified Rodr", "rotation.from_mrp", "words of the summary")
contains(help.text "t", "more", "a word that is everywhere")
contains(help.text "%", "There is no name %.", "no pattern")
contains(help.text "qqqqqq", "help() lists the names")
equal(help.text "", help.overview())

-- Everything fits 80 columns, the overview a screen.
local function check_layout(entries)
  support.use(entries)
  local fresh = require "rotor.help"
  fits(fresh.overview())
  local _, lines = fresh.overview():gsub("\n", "")
  if lines + 1 > 23 then error("the overview has " .. lines + 1 .. " lines, and the prompt needs one of 24") end
  for _, row in ipairs(entries) do
    fits(fresh.text(row.name))
    local name = row.owner == "" and row.name or row.owner .. "." .. row.name
    contains(fresh.text(name), row.kind == "operator" and row.name or row.name:match "[%w_]+", name)
  end
  assert(load(fresh.stub(), "=stub", "t", {}))()
  local reference = fresh.reference()
  for _, row in ipairs(entries) do contains(reference, fresh.usage(row), "reference") end
  return fresh
end
local stub = check_layout(support.entries).stub()

for _, piece in ipairs { "---@class rotation\n---@field axis vec The axis, of length 1.",
  "---@operator mul(rotation): rotation\n---@operator mul(vec): vec\n---@operator pow(number): rotation",
  "---@operator call(any): state", "function rotation_value:slerp(S, s, options) end",
  "---@return number\n---@return number\n---@return number\nfunction rotation_value:euler_angles",
  "---@overload fun(axis: any, angle: any): rotation\nrotation = {}", "function rotation.from_mrp(p) end",
  "---@param options? { way?: any }\n---@return rotation\nfunction slerp(R, S, s, options) end",
  "---@param options { omega?: any, from?: any,", "---@type number\ndeg = nil" } do
  contains(stub, piece, "stub")
end

contains(support.printed(require "rotor.help", "deg"), "pi/180.", "the module prints when called")

-- Rotor's own registry, where there is one: and what the overview says to type first does work.
if support.rotor then
  for _, name in ipairs { "slerp", "rotation", "R" } do rawset(_G, name, rotors[name]) end
  local overview = check_layout(support.rotor).overview()
  local environment = setmetatable({}, { __index = _G })
  local typed = 0
  for line in overview:match "\n(  .-)\n\n":gmatch "[^\n]+" do
    local code = line:match "^  (.-)   +" or line:match "^  (.*)$"
    local chunk = assert(load("return " .. code, "=overview", "t", environment)
      or load(code, "=overview", "t", environment))
    chunk()
    typed = typed + 1
  end
  equal(typed, 4, "lines to type first")
end
