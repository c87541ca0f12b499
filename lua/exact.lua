-- Values as text that makes them again: all digits, whatever precision() says.
local names = require "rotor.names"
local text = require "rotor.text"

local kDepth = 8  -- as far down as tables in tables are written; they may hold themselves

local exact

-- The first `count` items, with commas.
local function items(value, count, depth)
  local parts = {}
  for i = 1, count do parts[i] = exact(value[i], depth) end
  return table.concat(parts, ", ")
end

-- A plain table: its list, then its other fields, sorted.
local function table_text(value, depth)
  if depth == 0 then return "{...}" end
  local parts, keys = { #value > 0 and items(value, #value, depth - 1) or nil }, {}
  for key in next, value do
    if not (math.type(key) == "integer" and key >= 1 and key <= #value) then keys[#keys + 1] = key end
  end
  table.sort(keys, function(a, b) return tostring(a) < tostring(b) end)
  for _, key in ipairs(keys) do
    local plain = type(key) == "string" and key:find "^[%a_][%w_]*$"
    parts[#parts + 1] = (plain and key or "[" .. exact(key, depth - 1) .. "]") .. " = " .. exact(value[key], depth - 1)
  end
  return "{" .. table.concat(parts, ", ") .. "}"
end

local kWritten = {
  number = text.number,
  string = function(s) return ("%q"):format(s) end,
  table = table_text,
  vec = function(v) return "vec(" .. items(v, 3) .. ")" end,
  quaternion = function(q) return "quaternion(" .. items(q, 4) .. ")" end,
  matrix = function(m) return "matrix{{" .. items(m[1], 3) .. "}, {" .. items(m[2], 3) .. "}, {" .. items(m[3], 3)
    .. "}}" end,
  rotation = function(R) return ("rotation({%s}, %s)"):format(items(R.axis, 3), text.number(R.angle)) end,
}

--- The text of a value; of one that has no such text what tostring gives.
function exact(value, depth)
  local kind = names.type_of(value)
  if kind == "table" and getmetatable(value) then kind = nil end
  return (kWritten[kind] or tostring)(value, depth or kDepth)
end

return exact
