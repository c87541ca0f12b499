-- The registered names: finding their rows, following types from name to name, the nearest name to a misspelt one.
-- Help, completion, the reference and the editor stub all stand on this. Nothing here runs code: access is raw.
local entries = require "rotor.entries"

local names = {}

--- The row of `name` with this owner ("" for a global), or nil.
function names.find(owner, name)
  for _, row in ipairs(entries) do
    if row.owner == owner and row.name == name then return row end
  end
end

--- What is registered as a global, whatever a script has made of the name; in a registry without values, the global.
function names.registered(name)
  local row = names.find("", name)
  return row and row.value or rawget(_G, name)
end

--- The name to ask for: "slerp", "rotation:inverse", "run.cost".
function names.full_name(row)
  if row.owner == "" or row.kind == "operator" then return row.name end
  return row.owner .. (row.kind == "method" and ":" or ".") .. row.name
end

--- All rows that `accept`s, in the order of the registry.
function names.select(accept)
  local rows = {}
  for _, row in ipairs(entries) do
    if accept(row) then rows[#rows + 1] = row end
  end
  return rows
end

--- The rows of one owner, of one kind if a kind is given.
function names.members(owner, kind)
  return names.select(function(row) return row.owner == owner and (not kind or row.kind == kind) end)
end

--- Whether values of this type exist: something other than a library's functions and values belongs to it.
function names.is_type(name)
  return name ~= "" and names.select(function(row)
    return row.owner == name and row.kind ~= "function" and row.kind ~= "value"
  end)[1] ~= nil
end

--- The type for whose values this name stands in signatures, as R in R:inverse() and S in R == S; or nil.
function names.stands_for(name)
  for _, row in ipairs(entries) do
    if row.kind == "field" or row.kind == "method" then
      if (row.signature or ""):match "^([%a_][%w_]*)[.:%[]" == name then return row.owner end
    elseif row.kind == "operator" then
      local left, right = row.name:match "^(%w+) == (%w+)$"
      if left == name or right == name then return row.owner end
    end
  end
end

--- Whether this is a global that holds functions or values, as rotation.from_matrix; it may be a function itself.
function names.is_library(name)
  return name ~= "" and (names.members(name, "function")[1] or names.members(name, "value")[1]) ~= nil
end

--- Whether an operator's row is a call of the value, as run(t). Not all that look like a call are: tostring(R) is not.
function names.is_call(row)
  return row.name:find "^[%a_][%w_]*%(" ~= nil and not row.name:find "^tostring%("
end

--- All types, sorted.
function names.types()
  local types, seen = {}, {}
  for _, row in ipairs(entries) do
    if not seen[row.owner] and names.is_type(row.owner) then types[#types + 1] = row.owner end
    seen[row.owner] = true
  end
  table.sort(types)
  return types
end

--- The row that registers this value itself, or nil.
function names.row_of(value)
  if value == nil then return nil end
  return names.select(function(row) return rawequal(row.value, value) end)[1]
end

--- "rotation", "vec", ... for rotor's values, else Lua's type.
function names.type_of(value)
  local meta = debug.getmetatable(value)
  local name = meta and rawget(meta, "__name")
  return type(name) == "string" and name or type(value)
end

-- The tables in which value[key] is looked for, first to last, as far as they are tables.
local function places(value)
  local list = {}
  while #list < 16 do
    if type(value) == "table" then list[#list + 1] = value end
    local meta = debug.getmetatable(value)
    value = meta and rawget(meta, "__index")
    if type(value) ~= "table" then break end
  end
  return list
end

-- A *thing* is what is known of an expression without running it: its `type`, its `value` where raw access reaches it,
-- the `row` that registers it.

--- The thing that is this value.
function names.thing(value)
  return { value = value, type = names.type_of(value), row = names.row_of(value) }
end

--- The thing under a global name, or nil.
function names.global(name)
  local value, row = rawget(_G, name), names.find("", name)
  if value ~= nil then
    local thing = names.thing(value)
    if row and row.value == nil then thing.row = row end
    return thing
  end
  return row and { type = row.kind == "function" and "function" or row.result, row = row }
end

--- The thing under `key` in a thing, or nil.
function names.member(thing, key)
  local row = names.find(thing.type, key)
  for _, place in ipairs(places(thing.value)) do
    local value = rawget(place, key)
    if value ~= nil then
      local found = names.thing(value)
      found.row = row or found.row
      return found
    end
  end
  return row and { type = row.kind == "field" and row.result or "function", row = row }
end

--- The thing that a call of this thing returns, or nil where no row says it.
function names.result(thing)
  local row = thing.row
  if not (row and (row.kind == "function" or row.kind == "method")) then
    row = nil
    for _, operator in ipairs(names.members(thing.type, "operator")) do
      if names.is_call(operator) then row = operator end
    end
  end
  return row and row.result and { type = row.result }
end

--- Calls visit(key, thing) for every member of a thing that can be named.
function names.each_member(thing, visit)
  local seen = {}
  local function once(key)
    if seen[key] or type(key) ~= "string" or not key:find "^[%a_][%w_]*$" then return end
    seen[key] = true
    visit(key, names.member(thing, key))
  end
  for _, row in ipairs(names.members(thing.type)) do
    if row.kind == "field" or row.kind == "method" then once(row.name) end
  end
  for _, place in ipairs(places(thing.value)) do
    for key in next, place do once(key) end
  end
end

--- The parameters of a signature `name(a, b, {c=, d=}) -> type`: a list of { name= } or { options = {names} }.
function names.parameters(signature)
  local list = {}
  local text = (signature:match "%b()" or signature:match "%b{}" or ""):gsub("^%((.*)%)$", "%1")
  for piece in (text:gsub("%b{}", function(options) return (options:gsub(",", " ")) end)):gmatch "[^,]+" do
    if piece:find "{.*=.*}" then
      local options = {}
      for option in piece:gmatch "([%a_][%w_]*)%s*=" do options[#options + 1] = option end
      list[#list + 1] = { options = options }
    else
      list[#list + 1] = { name = piece:match "%.%.%." or piece:match "^%s*([%a_][%w_]*)" }
    end
    list[#list].name = list[#list].name or list[#list].options and "options" or "argument" .. #list
  end
  return list
end

-- The least number of letters inserted, dropped, changed or swapped with their neighbour that makes b of a.
local function edits(a, b)
  local before, last
  local row = {}
  for j = 0, #b do row[j] = j end
  for i = 1, #a do
    before, last, row = last, row, { [0] = i }
    for j = 1, #b do
      local same = a:byte(i) == b:byte(j)
      row[j] = math.min(last[j] + 1, row[j - 1] + 1, last[j - 1] + (same and 0 or 1))
      if i > 1 and j > 1 and a:byte(i) == b:byte(j - 1) and a:byte(i - 1) == b:byte(j) then
        row[j] = math.min(row[j], before[j - 2] + 1)
      end
    end
  end
  return row[#b]
end

-- The first by the alphabet of the candidates that begin with the word, else of those that contain it.
local function extension(word, candidates)
  local best, least
  for _, candidate in ipairs(candidates) do
    local at = #candidate > #word and candidate:lower():find(word:lower(), 1, true)
    local rank = at == 1 and #word >= 3 and 1 or at and #word >= 4 and 2
    if rank and (not best or rank < least or rank == least and candidate < best) then best, least = candidate, rank end
  end
  return best
end

--- The candidate that `word` was most likely meant to be, or nil; case is ignored. One that goes on from three letters
--- or has four inside comes first, else at most one slip in three letters is forgiven.
function names.suggest(word, candidates)
  local best, least = extension(word, candidates), (#word + 1) // 3
  if best then return best end
  for _, candidate in ipairs(candidates) do
    if candidate ~= word and math.abs(#candidate - #word) <= least then
      local count = edits(word:lower(), candidate:lower())
      if count < least or count == least and (not best or candidate < best) then best, least = candidate, count end
    end
  end
  return best
end

return names
