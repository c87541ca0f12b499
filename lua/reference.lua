-- The registry of names as a whole: the reference in Markdown, and the stub that editors read.
local help = require "rotor.help"
local names = require "rotor.names"

local reference = {}

local kKinds = { "function", "value", "field", "method", "operator" }

local function capital(kind)
  return kind:sub(1, 1):upper() .. kind:sub(2) .. "s"
end

--- Owners that are no globals, sorted: types and libraries.
local function owners()
  local list, seen = {}, { [""] = true }
  for _, row in ipairs(require "rotor.entries") do
    if not seen[row.owner] then list[#list + 1] = row.owner end
    seen[row.owner] = true
  end
  table.sort(list)
  return list
end

local function markdown_of(row)
  local text = "**`" .. help.usage(row) .. "`**\n\n" .. (row.summary or "") .. "\n"
  if row.page then text = text .. "\n```text\n" .. row.page() .. "\n```\n" end
  return row.example and text .. "\n```lua\n" .. row.example .. "\n```\n" or text
end

--- Everything, by topic and by type.
function reference.markdown()
  local parts = { "# Reference\n" }
  for _, topic in ipairs(help.by_topic()) do
    parts[#parts + 1] = "## " .. topic[1] .. "\n"
    for _, row in ipairs(topic[2]) do parts[#parts + 1] = markdown_of(row) end
  end
  for _, owner in ipairs(owners()) do
    parts[#parts + 1] = "## " .. (names.is_type(owner) and "Type" or "Library") .. " `" .. owner .. "`\n"
    for _, kind in ipairs(kKinds) do
      local rows = names.members(owner, kind)
      if #rows > 0 then parts[#parts + 1] = "### " .. capital(kind) .. "\n" end
      for _, row in ipairs(rows) do parts[#parts + 1] = markdown_of(row) end
    end
  end
  return table.concat(parts, "\n")
end

-- The stub ------------------------------------------------------------------------------------------------------------

local kOperators = { ["+"] = "add", ["-"] = "sub", ["*"] = "mul", ["/"] = "div", ["^"] = "pow", ["%"] = "mod",
  ["//"] = "idiv" }
local kUnary = { ["-"] = "unm", ["#"] = "len" }
local kOperands = { R = "rotation", S = "rotation", v = "vec", w = "vec", q = "quaternion", m = "matrix", n = "matrix",
  s = "number", x = "number", y = "jet|number" }

local function comment(summary)
  return summary and summary ~= "" and "---" .. summary:gsub("\n", "\n---") .. "\n" or ""
end

-- The types after "->" of a signature, else the row's result; a type that is no single word is `any`.
local function results(row)
  local after, types = row.signature and row.signature:match "%->%s*(.+)$" or row.result or "nil", {}
  for piece in after:gmatch "[^,]+" do
    local word = piece:match "^%s*([%a_][%w_]*)%s*$" or "any"
    if word ~= "nil" then types[#types + 1] = word end
  end
  return types
end

local function options_type(options)
  local fields = {}
  for i, option in ipairs(options) do fields[i] = option .. "?: any" end
  return "{ " .. table.concat(fields, ", ") .. " }"
end

-- A signature says names and options, not types, of its arguments: they are `any`, rather than wrong.
local function parameters(row)
  local list, lines = {}, {}
  for i, parameter in ipairs(names.parameters(row.signature or "")) do
    list[i] = parameter.name
    -- Options after other arguments may be left out; alone, as in evolve{...}, they are the argument.
    local mark = parameter.options and i > 1 and "?" or ""
    lines[i] = ("---@param %s%s %s\n"):format(parameter.name, mark,
      parameter.options and options_type(parameter.options) or "any")
    if parameter.name == "..." then break end  -- "a1, ..., an" is "a1, ..."
  end
  return table.concat(list, ", "), table.concat(lines)
end

local function function_stub(row, name)
  local list, lines = parameters(row)
  for _, result in ipairs(results(row)) do lines = lines .. "---@return " .. result .. "\n" end
  return comment(row.summary) .. lines .. "function " .. name .. "(" .. list .. ") end\n"
end

local function value_stub(row, name)
  return comment(row.summary) .. "---@type " .. (row.result or "any") .. "\n" .. name .. " = nil\n\n"
end

-- "R * S" -> mul, "-v" -> unm, "run(t)" -> call; "" for what the editor has no word for (==, tostring).
local function operator_stub(row)
  local result = results(row)[1] or "any"
  if names.is_call(row) then return "---@operator call(any): " .. result .. "\n" end
  local unary = kUnary[row.name:match "^(%p)%s*[%w_]+$"]
  if unary then return ("---@operator %s: %s\n"):format(unary, result) end
  local symbol, right = row.name:match "^[%w_]+%s*(%p+)%s*([%w_]+)$"
  local word = kOperators[symbol]
  return word and ("---@operator %s(%s): %s\n"):format(word, kOperands[right] or "any", result) or ""
end

local function class_stub(owner)
  local text = "---@class " .. owner .. "\n"
  for _, row in ipairs(names.members(owner, "field")) do
    local name = row.name:gsub("^%[[%a_]+%]$", "[integer]")  -- v[i]
    text = text .. ("---@field %s %s %s\n"):format(name, row.result or "any", (row.summary or ""):gsub("\n", " "))
  end
  for _, row in ipairs(names.members(owner, "operator")) do text = text .. operator_stub(row) end
  text = text .. "local " .. owner .. "_value = {}\n\n"
  for _, row in ipairs(names.members(owner, "method")) do
    text = text .. function_stub(row, owner .. "_value:" .. row.name) .. "\n"
  end
  return text
end

-- A global that holds functions, and may be a function itself: rotation(...), rotation.from_mrp(...).
local function library_stub(owner)
  local text, maker = "", names.find("", owner)
  if maker then
    local typed = {}
    for i, parameter in ipairs(names.parameters(maker.signature or "")) do
      typed[i] = parameter.name .. ": " .. (parameter.options and options_type(parameter.options) or "any")
    end
    text = comment(maker.summary) .. "---@class " .. owner .. "_library\n---@overload fun("
      .. table.concat(typed, ", ") .. "): " .. (results(maker)[1] or "nil") .. "\n"
  end
  text = text .. owner .. " = {}\n\n"
  for _, row in ipairs(names.members(owner, "value")) do
    text = text .. value_stub(row, owner .. "." .. row.name)
  end
  for _, row in ipairs(names.members(owner, "function")) do
    text = text .. function_stub(row, owner .. "." .. row.name) .. "\n"
  end
  return text
end

--- A ---@meta file for lua-language-server: a class for each type, the functions with their parameters and results.
function reference.stub()
  local parts = { "---@meta\n\n" }
  for _, owner in ipairs(owners()) do
    if names.is_type(owner) then parts[#parts + 1] = class_stub(owner) end
    if names.is_library(owner) then parts[#parts + 1] = library_stub(owner) end
  end
  for _, row in ipairs(names.members "") do
    if row.kind == "value" then
      parts[#parts + 1] = value_stub(row, row.name)
    elseif not names.is_library(row.name) then
      parts[#parts + 1] = function_stub(row, row.name) .. "\n"
    end
  end
  return table.concat(parts)
end

return reference
