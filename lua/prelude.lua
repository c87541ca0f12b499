-- Run once at the start: the names that are made in Lua. It must stay small, as every start pays for it.
local entries = require "rotor.entries"

for _, row in ipairs(require "rotor.rows") do
  entries[#entries + 1] = row
  _G[row.name] = row.value
end

-- The functions of math under their bare names, each with an argument and its value as an example.
for name, example in pairs {
  sin = "0) --> 0.0", cos = "0) --> 1.0", tan = "0) --> 0.0", asin = "0) --> 0.0", acos = "1) --> 0.0",
  atan = "0) --> 0.0", exp = "0) --> 1.0", log = "1) --> 0.0", sqrt = "4) --> 2.0", abs = "-3) --> 3",
} do
  entries[#entries + 1] = {
    owner = "", name = name, kind = "function", result = "number", value = math[name],
    signature = name .. "(x) -> number", summary = "math." .. name .. ".", example = name .. "(" .. example,
  }
  _G[name] = math[name]
end

return true
