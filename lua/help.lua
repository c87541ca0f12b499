-- help(): the overview, a name, a value. All of it is read from the registry of names.
local entries = require "rotor.entries"
local manual = require "rotor.manual"
local names = require "rotor.names"
local search = require "rotor.search"
local text = require "rotor.text"

local help = {}

local kMentions = 6  -- as many rows as a search shows
local kRelated = 6  -- as many names under "See also"
local kBrief = 96  -- characters of a summary in a list
local kScreen = 23  -- lines, beside that of the prompt

--- The order in which the overview and the reference show the global names; what is not here comes under "Other".
help.topics = {
  { "Rotations", "rotation quaternion slerp mean commute chain spherical_triangle" },
  { "Vectors", "vec dot cross norm unit box orientation orthonormal_basis is_rigid" },
  { "Matrices", "matrix det outer skew axial proper_orthogonal permutation_sign" },
  { "Motion", "evolve spin angular_velocity spectrum compare_charts commensurate" },
  { "Data", "read_csv write_csv rotation_rates continuous_quaternions fit_rigid" },
  { "Numbers", "deg pi sin cos tan asin acos atan sinh cosh tanh exp log sqrt abs floor ceil" },
  { "Testing", "theorem near holds fails for_each for_all given any tradeoff" },
  { "Terminal", "help conventions precision plot draw_sphere" },
}

-- What the type rotation has that the topics do not show and many come for.
local kOfRotation = "from_euler_angles euler_angles angles_about from_mrp spline table"

--- The topics with those of their names that there are: { { title, { row, ... } }, ... }.
function help.by_topic()
  local topics, placed = {}, {}
  local function add(title, rows)
    if #rows > 0 then topics[#topics + 1] = { title, rows } end
  end
  for _, topic in ipairs(help.topics) do
    local rows = {}
    for name in topic[2]:gmatch "%S+" do
      rows[#rows + 1] = names.find("", name)
      placed[name] = true
    end
    add(topic[1], rows)
  end
  add("Other", names.select(function(row) return row.owner == "" and not placed[row.name] end))
  return topics
end

--- How a name is used: its signature with its owner before it and its result after it.
function help.usage(row)
  local usage = row.signature or row.name
  if row.owner ~= "" and row.kind ~= "operator" and not usage:find "^[%a_][%w_]*[.:%[][%a_]" then
    usage = row.owner .. (row.kind == "method" and ":" or ".") .. usage
  end
  if row.result and row.result ~= "nil" and not usage:find("->", 1, true) then usage = usage .. " -> " .. row.result end
  return usage
end

local function in_full(row)
  local parts = { text.wrap(help.usage(row), "", "    "), text.wrap(row.summary or "", "  ") }
  if row.example then
    local call, shown = row.example:match "^(.-)%s*%-%->%s*(.*)$"
    parts[#parts + 1] = ""
    parts[#parts + 1] = text.wrap(call or row.example, "  rotor> ", "         ")
    if shown and shown ~= "" then parts[#parts + 1] = "  " .. shown end
  end
  if row.page then parts[#parts + 1] = "\n" .. row.page() end
  return table.concat(parts, "\n")
end

-- The first sentence of a summary, or as much of it as a list has room for.
local function brief(summary)
  local sentence = summary:match "^(.-[^.%s]%.)%s+%a" or summary
  if text.width(sentence) <= kBrief then return sentence end
  return sentence:sub(1, kBrief):match "^(.-)[,;:]?%s%S*$" .. " ..."
end

-- Under a type's heading its name goes without saying: ".axis -> vec".
local function usage_in_list(row, under_type)
  local usage = help.usage(row)
  return under_type and row.kind ~= "operator" and usage:gsub("^[%a_][%w_]*([.:])", "%1") or usage
end

-- Usage and first sentence, a row a paragraph.
local function in_short(rows, under_type)
  local cells = {}
  for i, row in ipairs(rows) do cells[i] = { usage_in_list(row, under_type), brief(row.summary or "") } end
  return text.two_columns(cells, 30)
end

-- The same, a row a line: the options are left out, and what does not fit.
local function in_lines(rows, under_type)
  local cells, columns = {}, 0
  for i, row in ipairs(rows) do
    local usage = usage_in_list(row, under_type):gsub(" %-> .*$", ""):gsub("%b{}", "{...}")
    cells[i] = { usage, brief(row.summary or "") }
    if text.width(usage) <= 30 then columns = math.max(columns, text.width(usage)) end
  end
  for i, cell in ipairs(cells) do
    local line = ("  %s%s  %s"):format(cell[1], (" "):rep(columns - text.width(cell[1])), cell[2])
    local fits = text.width(line) <= text.columns
    cells[i] = fits and line or line:sub(1, text.columns - 4):match "^(.-)[,;:]?%s%S*$" .. " ..."
  end
  return table.concat(cells, "\n")
end

-- The names alone, as many in a line as fit, after a heading.
local function in_names(rows, heading)
  local list = { heading }
  for i, row in ipairs(rows) do list[i + 1] = usage_in_list(row, true):match "^[^%s(]+" end
  return text.wrap(table.concat(list, "  "), "", "  ")
end

local kTypeGroups = { { "Fields", "field" }, { "Methods", "method" }, { "Operators", "operator" },
  { "Functions", "function" }, { "Values", "value" } }

-- What a type's values can do, and where they come from: in lines where a screen has no room for paragraphs, and its
-- fields by their names where it has none for lines.
local function about_type(name)
  local makers = names.select(function(row) return row.result == name and row.owner ~= name and row.kind ~= "field" end)
  for i, row in ipairs(makers) do makers[i] = names.full_name(row) end
  local made = makers[1] and ", made by " .. table.concat(makers, ", ") or ""
  local head = text.wrap((names.is_type(name) and "Type " or "Library ") .. name .. made, "", "    ")
  local first
  local function parts(list, between, names_of_fields)
    local all = { head }
    for _, group in ipairs(kTypeGroups) do
      -- That a value has a text goes without saying.
      local rows = names.select(function(row)
        return row.owner == name and row.kind == group[2] and not row.name:find "^tostring%("
      end)
      if #rows > 0 then
        first = first or names.full_name(rows[1])
        all[#all + 1] = names_of_fields and group[2] == "field" and in_names(rows, group[1])
          or between .. group[1] .. "\n" .. list(rows, group[2] ~= "function")
      end
    end
    return table.concat(all, "\n")
  end
  local function fits(page, lines) return select(2, page:gsub("\n", "")) < lines end
  local page = parts(in_short, "\n")
  if fits(page, kScreen - 1) then return page end
  page = parts(in_lines, "")
  if not fits(page, kScreen - 2) then
    local shorter = parts(in_lines, "", true)
    if fits(shorter, kScreen) then return shorter end
  end
  return ('%s\nOne of them in full: help "%s"'):format(page, first)
end

local function about_rows(rows)
  if #rows > 4 then return in_short(rows) end
  local parts = {}
  for i, row in ipairs(rows) do parts[i] = in_full(row) end
  return table.concat(parts, "\n\n")
end

-- "See also" and names that have to do with the word: the given rows, then more that are not shown. Or nil.
local function see_also(word, rows, shown)
  local list, seen = {}, {}
  for _, row in ipairs(shown) do seen[row] = true end
  for _, more in ipairs { rows, search.related(word) } do
    for _, row in ipairs(more) do
      if not seen[row] and row.owner ~= word and #list < kRelated then list[#list + 1] = names.full_name(row) end
      seen[row] = true
    end
  end
  return list[1] and text.wrap("See also " .. table.concat(list, ", "), "", "    ")
end

-- The rows for a name without an owner; a global one first.
local function about_word(word)
  local row, named = names.find("", word), names.select(function(r) return r.name == word and r.owner ~= "" end)
  local listing = (names.is_type(word) or names.members(word)[1]) and about_type(word)
  if not (row or listing or named[1]) then return nil end
  local parts = { row and in_full(row) or listing or about_rows(named) }
  if row then parts[2] = listing or nil end
  parts[#parts + 1] = see_also(word, named, row and { row } or listing and {} or named)
  return table.concat(parts, "\n\n")
end

-- A value -------------------------------------------------------------------------------------------------------------

-- The global name of a value whose row does not hold it (a library such as `spin`), or nil.
local function global_name(value)
  if type(value) ~= "table" then return nil end
  for _, row in ipairs(entries) do
    local name = row.owner == "" and row.name or row.owner
    if (row.owner == "" or names.is_library(name)) and rawequal(rawget(_G, name), value) then return name end
  end
end

-- What is said of a value that is no part of rotor or Lua: its kind, and what the terminal would show if that is short.
local function of_your_own(value)
  local kind = names.type_of(value)
  if kind == "function" then
    local info = debug.getinfo(value, "S")
    return "A function of your own, defined in " .. info.short_src .. ", line " .. info.linedefined .. "."
  end
  local shown = kind == "number" and ": " .. text.number(value) or kind == "boolean" and ": " .. tostring(value)
    or names.is_type(kind) and ":\n" .. tostring(value) or "."
  return "A " .. kind .. " of your own" .. shown
end

local function about_value(value)
  local kind = names.type_of(value)
  local row, name = names.row_of(value), global_name(value)
  if row and row.owner ~= "" then return in_full(row) end
  if row or name then return about_word(row and row.name or name) end
  name = manual.name_of(value)
  if name then return manual.about(name) end
  if names.is_type(kind) then return about_type(kind) end
  if kind == "nil" then return 'nil: this name has no value. To look for it write it in quotes: help "name"' end
  return of_your_own(value)
end

-- What is known of the word, after the user's own value if the word is a global of theirs too.
local function about_own_and_word(word)
  local known, value = about_word(word), rawget(_G, word)
  local own = value ~= nil and not names.find("", word) and not names.is_library(word) and manual.name_of(value) ~= word
  return known and own and of_your_own(value) .. "\n\n" .. known or known
end

-- A name --------------------------------------------------------------------------------------------------------------

-- The thing at the end of a path from a thing: ".cost.steps" along values and result types; or nil.
local function follow(thing, path)
  for key in path:gmatch "[^.:]+" do
    thing = thing and names.member(thing, key)
  end
  return thing
end

-- "R:inverse", "run.cost.steps", "rotation.from_mrp", "C:rates": nil where it leads nowhere.
local function about_path(path)
  local first, rest = path:match "^([%a_][%w_]*)([.:%[].+)$"
  if not first then return nil end
  local row = names.find(first, rest:sub(2))
  if row then return in_full(row) end
  local own, kind = names.global(first), names.stands_for(first)
  local thing = follow(own and own.type ~= "function" and own or { type = first }, rest)
  thing = thing or kind and follow({ type = kind }, rest)
  if thing then return thing.row and in_full(thing.row) or thing.value ~= nil and about_value(thing.value) end
  local last = rest:match "([%a_][%w_]*)$"
  local known = names.is_type(first) or own or kind
  return not known and last and about_word(last) or nil
end

local function about_operator(symbol)
  if symbol == "" or symbol:find "^[%w_.:]+$" then return nil end
  local rows = names.select(function(row)
    if row.kind ~= "operator" then return false end
    return row.name == symbol or not symbol:find "[%w_]" and row.name:gsub("[%w_%s]", "") == symbol
  end)
  return rows[1] and about_rows(rows)
end

-- "R:foo" where R is a rotation: what its type has that is like it.
local function about_missing_member(path)
  local owner, key = path:match "^([%a_][%w_]*)[.:]([%a_][%w_]*)$"
  local thing = owner and names.global(owner)
  local kind = thing and names.is_type(thing.type) and thing.type
    or owner and not thing and names.stands_for(owner) or owner
  if not owner or not names.is_type(kind) then return nil end
  local all = names.members(kind)
  for i, row in ipairs(all) do all[i] = row.name end
  local guess = names.suggest(key, all)
  return text.wrap(('A %s has no %s. %s help "%s" lists what it has.'):format(kind, key,
    guess and "Did you mean " .. guess .. "?" or "", kind), "")
end

local function about_unknown(word)
  local found, in_part = search.rows(word)
  if found[1] then
    local answer = in_part and "Nothing has all of " .. word .. ". Nearest:" or word .. " is found in"
    local shown = table.move(found, 1, math.min(#found, kMentions), 1, {})
    answer = text.wrap(answer, "") .. "\n" .. in_short(shown)
    return answer .. (#found > kMentions and ("\n  and %d more"):format(#found - kMentions) or "")
  end
  local all = {}
  for i, row in ipairs(entries) do all[i] = word:find "[.:]" and names.full_name(row) or row.name end
  local guess = names.suggest(word, all)
  if guess and word:find "[.:]" and not guess:find "[.:]" then guess = nil end
  return text.wrap("There is no name " .. word .. "." .. (guess and " Did you mean " .. guess .. "?"
    or ' help() lists the names; help "word" looks for a word in all of them.'), "")
end

-- What is known of a name as it is given, or nil.
local function about_known(name)
  local answer = about_own_and_word(name) or about_path(name) or about_operator(name) or manual.about(name)
  if answer then return answer end
  local value = name:find "^[%a_][%w_]*$" and rawget(_G, name)
  if value ~= nil and value ~= false then return about_value(value) end
  local kind = names.stands_for(name)
  return kind and about_type(kind)
end

-- The name may be spelled as help prints it: "C:rates(omega) -> table".
local function about_name(name)
  name = name:match "^%s*(.-)%s*$"
  local bare = name:gsub("%s*%->.*$", "")
  local answer = about_known(name) or about_known(bare) or about_known((bare:gsub("%b()$", ""):gsub("%b{}$", "")))
  if answer then return answer end
  if name == "quit" or name == "exit" then return "Ctrl-D ends the terminal, os.exit() a script." end
  return about_missing_member(name) or about_unknown(name)
end

-- The overview --------------------------------------------------------------------------------------------------------

local kFirst = [[
Type an expression to see its value; anything of Lua 5.4 works.
  R = rotation({1,0,0}, 90*deg)       a quarter turn about x
  R * {0,1,0}                         what it does to a vector
  run = evolve{omega = {0,0,1}, from = R, to = 4*pi}
  run(2*pi).axis                      where the axis is after a whole turn
]]

local kLast = [[
help "slerp"   of a type: help "run"   help "R:inverse"   help(R)   help "word"
At the prompt also ?slerp. help "conventions": other libraries' and rotor's.
Angles are in radians (30*deg), quaternions (w, x, y, z), rotations active;
omega is given in the space frame and depends on t alone.
Unlike lua5.4: status 1 after an error on piped input; numbers know no locale.]]

--- The overview: what to type first, the names by topic, the conventions. It fits a screen of 80 x 24.
function help.overview()
  local rows = {}
  for _, topic in ipairs(help.topics) do
    local list = {}
    for name in topic[2]:gmatch "%S+" do
      if names.find("", name) or names.is_library(name) then list[#list + 1] = name end
    end
    rows[#rows + 1] = { topic[1], table.concat(list, " ") }
  end
  local topics = help.by_topic()
  local other = topics[#topics]
  if other and other[1] == "Other" then
    local list = {}
    for i, row in ipairs(other[2]) do list[i] = row.name end
    rows[#rows + 1] = { "Other", table.concat(list, " ") }
  end
  local list = {}
  for name in kOfRotation:gmatch "%S+" do list[#list + 1] = names.find("rotation", name) and name end
  table.insert(rows, 2, { "?rotation", table.concat(list, " ") })
  local types = {}  -- those that no topic has
  for _, name in ipairs(names.types()) do
    if not (names.find("", name) or names.is_library(name)) then types[#types + 1] = name end
  end
  rows[#rows + 1] = { "Types", table.concat(types, " ") }
  return kFirst .. "\n" .. text.two_columns(rows, 12) .. "\n\n" .. kLast
end

--- The text that help(...) prints.
function help.text(...)
  if select("#", ...) == 0 or ... == "" then return help.overview() end
  local subject = ...
  return type(subject) == "string" and about_name(subject) or about_value(subject)
end

--- The whole reference as Markdown.
function help.reference() return require("rotor.reference").markdown() end

--- The stub file for editors (---@meta of lua-language-server).
function help.stub() return require("rotor.reference").stub() end

--- Called, the module is the global function `help`: it prints.
return setmetatable(help, { __call = function(_, ...) print(help.text(...)) end })
