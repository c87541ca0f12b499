-- Completion at the prompt. It reads the line, the registry of names and raw values; it never runs code.
local names = require "rotor.names"

local kKeywords = { "and", "break", "do", "else", "elseif", "end", "false", "for", "function", "goto", "if", "in",
  "local", "nil", "not", "or", "repeat", "return", "then", "true", "until", "while" }

-- Tokens of a piece of Lua: { kind = "name" | "number" | "string" | "open" | symbol, text =, at = }. An "open" is a
-- string or comment that the piece does not end.
local function tokens_of(line)
  local list, at = {}, 1
  local function push(kind, last, begin)
    list[#list + 1] = { kind = kind, text = line:sub(begin or at, last), at = begin or at }
    at = last + 1
  end
  while true do
    at = line:find("%S", at)
    if not at then return list end
    local equals = line:match("^%[(=*)%[", at) or line:match("^%-%-%[(=*)%[", at)
    local comment = line:find("^%-%-", at)
    local quote = line:match("^[\"']", at)
    if equals then
      local _, last = line:find("]" .. equals .. "]", at, true)
      if not last then
        push("open", #line)
      elseif comment then
        at = last + 1
      else
        push("string", last)
      end
    elseif comment then
      push("open", #line)
    elseif quote then
      local last = at + 1
      while last <= #line and line:sub(last, last) ~= quote do
        last = last + (line:sub(last, last) == "\\" and 2 or 1)
      end
      push(last <= #line and "string" or "open", math.min(last, #line))
    elseif line:find("^[%a_]", at) then
      push("name", select(2, line:find("^[%w_]+", at)))
    elseif line:find("^%.?%d", at) then
      push("number", select(2, line:find("^%.?%d[%w.]*", at)))
    else
      local symbol = line:match("^%.%.%.?", at) or line:match("^::", at) or line:sub(at, at)
      push(symbol, at + #symbol - 1)
    end
  end
end

local kOpening = { [")"] = "(", ["]"] = "[", ["}"] = "{" }
local kClosing = { ["("] = ")", ["["] = "]", ["{"] = "}" }

-- The place of the bracket that the one at `last` closes, or nil.
local function opening(tokens, last)
  local depth = 0
  for i = last, 1, -1 do
    local kind = tokens[i].kind
    depth = depth + (kOpening[kind] and 1 or kClosing[kind] and -1 or 0)
    if depth == 0 then return i end
  end
end

-- What is known of the expression whose last token is `last`: `a.b`, `a:f(x).c`, `f{...}`, `("x")`, `a[1]`.
-- `root` finds the thing of a name that stands alone.
local function thing_of(tokens, last, root)
  local token = tokens[last]
  if not token then return nil end
  local before = tokens[last - 1]
  if token.kind == "name" then
    if before and (before.kind == "." or before.kind == ":") then
      local owner = thing_of(tokens, last - 2, root)
      return owner and names.member(owner, token.text)
    end
    return root(token.text)
  end
  local callable = before and (before.kind == "name" or before.kind == ")" or before.kind == "]")
  if token.kind == "string" then
    if not callable then return names.thing "" end
    local called = thing_of(tokens, last - 1, root)
    return called and names.result(called)
  end
  local first = kOpening[token.kind] and opening(tokens, last)
  if not first then return nil end
  before = tokens[first - 1]
  callable = before and (before.kind == "name" or before.kind == ")" or before.kind == "]")
  if token.kind == "]" then
    local index = last == first + 2 and tokens[first + 1].kind == "number" and math.tointeger(tokens[first + 1].text)
    local list = index and callable and thing_of(tokens, first - 1, root)
    local value = list and type(list.value) == "table" and rawget(list.value, index)
    return value ~= nil and value ~= false and names.thing(value) or nil
  elseif callable then
    local called = thing_of(tokens, first - 1, root)
    return called and names.result(called)
  end
  return token.kind == ")" and last == first + 2 and thing_of(tokens, last - 1, root) or nil
end

-- The innermost bracket left open before the end, or nil.
local function innermost(tokens)
  local depth = 0
  for i = #tokens, 1, -1 do
    local kind = tokens[i].kind
    depth = depth + (kOpening[kind] and 1 or kClosing[kind] and -1 or 0)
    if depth < 0 then return i end
  end
end

-- The row of the function in whose options table a key may stand at the end, and the keys already there; or nil.
local function options_at(tokens)
  local brace, last = innermost(tokens), tokens[#tokens]
  if not brace or tokens[brace].kind ~= "{" then return nil end
  if last.kind ~= "{" and last.kind ~= "," and last.kind ~= ";" then return nil end
  local before, called = tokens[brace - 1], brace - 1
  if before and (before.kind == "," or before.kind == "(") then
    called = innermost(table.move(tokens, 1, brace - 1, 1, {}))
    if not called or tokens[called].kind ~= "(" then return nil end
    called = called - 1
  end
  local thing = thing_of(tokens, called, names.global)
  local given, depth = {}, 0
  for i = brace + 1, #tokens do
    local kind = tokens[i].kind
    depth = depth + (kClosing[kind] and 1 or kOpening[kind] and -1 or 0)
    if depth == 0 and kind == "=" then given[tokens[i - 1].text] = true end
  end
  return thing and thing.row, given
end

local function begins(name, word)
  return name:sub(1, #word) == word
end

-- A function's name with the bracket that its call begins with: "slerp(", "evolve{", "inverse()".
local function called(name, thing, following)
  if thing.type ~= "function" or following:find "^%s*[({\"']" then return name end
  local signature = thing.row and thing.row.signature or ""
  local bracket = signature:find "^[%w_.:]+%s*{" and "{" or signature:find "%(%s*%)" and "()" or "("
  return name .. bracket
end

-- Members of a thing: after a colon the functions that take it, after a dot what it holds.
local function members(thing, separator, word, spell)
  local found = {}
  names.each_member(thing, function(key, member)
    local is_method = member.row and member.row.kind == "method"
    if begins(key, word) and (separator == "." and not is_method or separator == ":" and member.type == "function") then
      found[#found + 1] = spell(key, member)
    end
  end)
  return found
end

local function globals(word, spell)
  local found, seen = {}, {}
  local function add(name)
    if type(name) == "string" and not seen[name] and name:find "^[%a_][%w_]*$" and begins(name, word) then
      seen[name] = true
      found[#found + 1] = spell(name, names.global(name))
    end
  end
  for name in next, _G do add(name) end
  for _, row in ipairs(names.members "") do add(row.name) end
  return found
end

-- Names to ask help for: globals, types and what belongs to either, without brackets.
local function help_names(question)
  local path, separator, word = question:match "^(.-)([.:]?)([%w_]*)$"
  local function bare(name) return name end
  if separator == "" then
    local found = globals(word, bare)
    for _, name in ipairs(names.types()) do
      if begins(name, word) and rawget(_G, name) == nil and not names.find("", name) then found[#found + 1] = name end
    end
    return word, found
  end
  local function root(name)
    local thing = names.global(name)
    return (not thing or thing.type == "function") and names.is_type(name) and { type = name } or thing
  end
  local tokens = tokens_of(path)
  local thing = thing_of(tokens, #tokens, root)
  local found = thing and members(thing, separator, word, bare) or {}
  for _, row in ipairs(separator == "." and names.members(path, "function") or {}) do
    if begins(row.name, word) and not (thing and thing.value) then found[#found + 1] = row.name end
  end
  return word, found
end

local function candidates(line, following)
  local question = line:match "^%s*%?%s*([%w_.:]*)$" or line:match "^%s*help%s*%(?%s*[\"']([%w_.:]*)$"
  if question then return help_names(question) end
  local tokens = tokens_of(line)
  local word, last = "", tokens[#tokens]
  if last and last.kind == "open" then return "", {} end
  if last and (last.kind == "name" or last.kind == "number") and last.at + #last.text == #line + 1 then
    if last.kind == "number" then return "", {} end
    word = last.text
    tokens[#tokens] = nil
    last = tokens[#tokens]
  end
  local function spell(name, thing) return called(name, thing, following) end
  if last and (last.kind == "." or last.kind == ":") then
    local thing = thing_of(tokens, #tokens - 1, names.global)
    return word, thing and members(thing, last.kind, word, spell) or {}
  end
  local row, given = options_at(tokens)
  local found = {}
  for _, parameter in ipairs(row and names.parameters(row.signature or "") or {}) do
    for _, option in ipairs(parameter.options or {}) do
      if begins(option, word) and not given[option] then found[#found + 1] = option .. "=" end
    end
  end
  if #found > 0 then return word, found end
  found = globals(word, spell)
  for _, keyword in ipairs(kKeywords) do
    if begins(keyword, word) then found[#found + 1] = keyword end
  end
  return word, found
end

--- Completes the word that ends `position` bytes into the line (its end, if not given). Returns the index of the word's
--- first byte and the sorted list of what may stand in its place. A function comes with the bracket that opens its
--- call ("slerp(", "evolve{", "inverse()"), an option with its "=", so that one goes on typing the argument:
--- nothing is to be appended.
return function(line, position)
  position = position or #line
  local word, found = candidates(line:sub(1, position), line:sub(position + 1))
  table.sort(found)
  return position - #word + 1, found
end
