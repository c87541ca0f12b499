-- Run once at the start: the names that are made in Lua. It must stay small, as every start pays for it.
local entries = require "rotor.entries"

for _, row in ipairs(require "rotor.rows") do
  entries[#entries + 1] = row
  local library = row.owner == "" and _G or _G[row.owner] or {}
  if row.owner ~= "" then _G[row.owner] = library end
  library[row.name] = row.value
end

-- The functions of math that take jets too, in the place of Lua's: bare and in math one and the same.
for _, row in ipairs(entries) do
  if row.owner == "" and row.kind == "function" and math[row.name] then rawset(math, row.name, row.value) end
end

return true
