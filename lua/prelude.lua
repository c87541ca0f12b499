-- Run once at the start: the names that are made in Lua. It must stay small, as every start pays for it.
local entries = require "rotor.entries"

for _, row in ipairs(require "rotor.rows") do
  entries[#entries + 1] = row
  _G[row.name] = row.value
end

-- The functions of math under their bare names.
for _, name in ipairs { "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sqrt", "abs" } do
  entries[#entries + 1] = { owner = "", name = name, kind = "function", result = "number", value = math[name],
    signature = name .. "(x) -> number", summary = "math." .. name .. ".", example = name .. "(0.5) --> " ..
    tostring(math[name](0.5)) }
  _G[name] = math[name]
end

return true
