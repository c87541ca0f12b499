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
equal(names.suggest("euler", { "outer", "from_euler", "euler_vector", "euler_angles" }), "euler_angles", "goes on")
equal(names.suggest("from_Euler", { "from_polar", "from_euler_angles" }), "from_euler_angles")
equal(names.suggest("euler", { "outer", "from_euler" }), "from_euler", "four letters inside before two slips")
equal(names.suggest("ro", { "rotate" }), nil, "two letters go on in too many ways")

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
equal(help.text "R:inverse() -> rotation", inverse, "as it is printed")
contains(help.text "w", "Type vec, made by R * v, vec", "a letter that stands for a type")
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
equal(help.text(2.0), "A number of your own: 2.0")
equal(help.text(0/0), "A number of your own: nan")
-- 2^-54 + 2^-2 is 1/4 and one unit of its last place; 1/3 takes 16 digits, 0.1 + 0.2 takes 17.
for x, digits in pairs { [1/3] = 16, [0.1 + 0.2] = 17, [0.1] = 1, [0.25 + 2^-54] = 17 } do
  local shown = help.text(x):match "^A number of your own: 0%.(%d+)$"
  equal(tonumber("0." .. shown), x, "the number can be read back")
  equal(#shown, digits, "no more digits than it takes")
end
equal(help.text(true), "A boolean of your own: true")
equal(help.text {}, "A table of your own.")
contains(help.text(untouchable "unheard_of"), "unheard_of", "a type that nobody registered")

-- A variable of the user's that is named as a component or a type is: its value, then what rotor knows of the name.
local function of_variable(name, value)
  rawset(_G, name, value)
  local answer = help.text(name)
  rawset(_G, name, nil)
  return answer
end
equal(of_variable("axis", 1/3), "A number of your own: 0.3333333333333333\n\n" .. help.text "axis")
equal(of_variable("axis", false), "A boolean of your own: false\n\n" .. help.text "axis")
equal(of_variable("run", { 1 }), "A table of your own.\n\n" .. help.text "run")
equal(of_variable("axis", setmetatable({}, { __name = "vec", __tostring = function() return "vec as text" end })),
  "A vec of your own:\nvec as text\n\n" .. help.text "axis")
local own_run = {}
rawset(_G, "run", own_run)
equal(help.text(own_run), "A table of your own.", "by value: no library, though a type is named so")
rawset(_G, "run", nil)
local of_spin = help.text "spin"
equal(of_variable("spin", { constant = print }), of_spin, "a library of rotor is not the user's")
equal(help.text "table":match "^%C+", "run:table(what)", "a library of Lua is not the user's")
equal(of_variable("w", 3), "A number of your own: 3", "a letter that is the user's")
equal(of_variable("zz", 3), "A number of your own: 3", "a name of the user's alone")

-- Unknown names.
contains(help.text "slrep", "Did you mean slerp?")
contains(help.text "R:invers", "A rotation has no invers. Did you mean inverse?")
contains(help.text "run:cvs", "Did you mean csv?")
contains(help.text "modified Rodr", "rotation.from_mrp", "words of the summary")
contains(help.text "the", "more", "a word that is everywhere")
contains(help.text "%", "There is no name %.", "no pattern")
equal(help.text "of the parameters modified", [[
of the parameters modified is found in
  rotation.from_mrp(p) -> rotation
    From modified Rodrigues parameters.]], "all words in any order")
contains(help.text "modified qqqqqq", "Nothing has all of modified qqqqqq. Nearest:\n  rotation.from_mrp")
for _, word in ipairs { "interpolate", "Interpolation", "blend" } do  -- they stand in no summary
  contains(help.text(word), "R:slerp(S, s", word)
  contains(help.text(word), "slerp(R, S, s", word)
end
contains(help.text "modified-rodrigues", "from_mrp", "a hyphen is a space")
for _, word in ipairs { "quit", "exit" } do contains(help.text(word), "Ctrl-D", word) end
contains(help.text "qqqqqq", "help() lists the names")
equal(help.text "", help.overview())

-- The operators that lua-language-server knows, by the number of their operands beside the value itself.
local kOperands = { unm = 0, bnot = 0, len = 0, call = 1, add = 1, sub = 1, mul = 1, div = 1, mod = 1, pow = 1,
  idiv = 1, band = 1, bor = 1, bxor = 1, shl = 1, shr = 1, concat = 1 }

-- Each operator of the registry is in the stub once, but == < <= and tostring, for which there is no annotation.
local function check_annotations(stub, entries)
  local expected, found = 0, 0
  for _, row in ipairs(entries) do
    local annotated = row.kind == "operator" and not row.name:find "[<=]" and not row.name:find "^tostring%("
    expected = expected + (annotated and 1 or 0)
  end
  local class
  for line in stub:gmatch "[^\n]+" do
    class = line:match "^%-%-%-@class ([%w_]+)$" or class
    local operator, operand, result = line:match "^%-%-%-@operator (%l+)(.-): (%l+)$"
    if line:find "@operator" then
      equal(operand == "" and 0 or operand:find "^%([%l|]+%)$" and 1, kOperands[operator], line)
      equal(result ~= "any" and (operand ~= "(any)" or operator == "call"), true, "types in " .. line)
      found = found + 1
    elseif line:find "@field" then
      equal(line:find "^%-%-%-@field [%a_][%w_]* [%w_]+ " or line:find "^%-%-%-@field %[integer%] [%w_]+ ", 1, line)
    end
  end
  equal(found, expected, "operators in the stub")
end

-- Everything fits 80 columns, the overview a screen.
local function check_layout(entries)
  support.use(entries)
  local fresh = require "rotor.help"
  fits(fresh.overview())
  local _, lines = fresh.overview():gsub("\n", "")
  if lines + 1 > 23 then error("the overview has " .. lines + 1 .. " lines, and the prompt needs one of 24") end
  for _, name in ipairs { "evolve", "spin", "run", "state", "cost", "tradeoff", "compare_charts" } do
    local _, more = fresh.text(name):gsub("\n", "")
    if more + 1 > 23 then error(("the page of %s has %d lines"):format(name, more + 1)) end
  end
  for _, row in ipairs(entries) do
    fits(fresh.text(row.name))
    local name = row.owner == "" and row.name or row.owner .. "." .. row.name
    contains(fresh.text(name), row.kind == "operator" and row.name or row.name:match "[%w_]+", name)
  end
  local stub = fresh.stub()
  assert(load(stub, "=stub", "t", {}))()
  check_annotations(stub, entries)
  local reference = fresh.reference()
  for _, row in ipairs(entries) do contains(reference, fresh.usage(row), "reference") end
  return fresh
end
local stub = check_layout(support.entries).stub()

for _, piece in ipairs { "---@class rotation\n---@field axis vec The axis, of length 1.",
  "---@operator mul(rotation): rotation\n---@operator mul(vec): vec\n---@operator pow(number): rotation",
  "---@operator call(any): state\nlocal run_value", "---@field [integer] number Component i.",
  "---@operator unm: vec\n---@operator len: number\nlocal vec_value",
  "function rotation_value:slerp(S, s, options) end",
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
  local fresh = check_layout(support.rotor)
  local overview = fresh.overview()
  for word, name in pairs { interpolate = "slerp(", convert = "rotation.from_matrix(", compose = "R * S",
    product = "R * S", degrees = "deg", ["axis-angle"] = "rotation(axis", ["axis angle"] = "rotation(axis",
    save = "run:csv(", export = "run:csv(", draw = "run:plot(", ["angle between"] = "R:distance(" } do
    contains(fresh.text(word), name, word)
  end
  for word, first in pairs { ["cross product"] = "cross(", ["shadow set"] = "R.shadow_mrp",
    ["scalar last"] = 'conventions("Eigen")', ["rotation matrix"] = "rotation.from_matrix(",
    ["three axes"] = "R:angles_about(", ["n dimensions"] = "cross(", ["generalized cross product"] = "cross(",
    ["random attitudes"] = "rotation.random(", ["omega body"] = "state.body_omega",
    ["vector observations"] = "fit_rigid(",
    ["jacobian of exp"] = "rotation.left_jacobian(", ["csv columns"] = "read_csv(", ["euler angle rates"] = "C:rates(",
    quat2dcm = 'conventions("MATLAB")  quat2dcm(q) is R:inverse().matrix', as_rotvec = 'conventions("SciPy")',
    MRP2C = 'conventions("Basilisk")', sigma = 'conventions("Basilisk")', basilisk = 'conventions("Basilisk")',
    wahba = "fit_rigid(", triad = "fit_rigid(", quest = "fit_rigid(", markers = "R:rotate(", gyro = "read_csv(",
    CRP = "rotation.from_gibbs(", eigenaxis = "rotation(axis", ["3-2-1"] = "rotation.from_euler_angles(",
    expmap = "rotation.from_euler_vector(", slew = "slerp(", align = "fit_rigid(", semicolon = "read_csv(",
    ["interpolate spline"] = "rotation.spline(", DCM = "rotation.from_matrix(" } do
    contains(fresh.text(word):sub(1, 200), word .. " is found in " .. first, word)
    fits(fresh.text(word))
  end
  for word, more in pairs { jacobian = "rotation.left_jacobian, rotation.right_jacobian", csv = "read_csv, write_csv",
    exp = "quaternion:exp" } do
    contains(fresh.text(word), "See also " .. more, word)
  end
  contains(fresh.text "C:rates(omega) -> table":match "^%C+", "C:rates(omega) -> table")
  contains(fresh.text "C.omega":match "^%C+", "C.omega -> vec")
  contains(fresh.text "v[i]":match "^%C+", "v[i] -> number")
  for letter, kind in pairs { R = "rotation", S = "rotation", C = "chain", q = "quaternion", m = "matrix",
    n = "matrix", v = "vec", fit = "rigid_fit" } do
    local own = rawget(_G, letter)
    rawset(_G, letter, nil)
    contains(fresh.text(letter):match "^%C+", "Type " .. kind .. ", made by", letter)
    rawset(_G, letter, own)
  end
  contains(fresh.text "R:euler", "Did you mean euler_angles?")
  contains(overview, "?rotation from_euler_angles euler_angles")
  local full_names = {}
  for _, row in ipairs(support.rotor) do
    full_names[(row.owner == "" or row.kind == "operator") and row.name
      or row.owner .. (row.kind == "method" and ":" or ".") .. row.name] = true
  end
  for name in pairs(require "rotor.words") do equal(full_names[name], true, "words for " .. name) end
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
