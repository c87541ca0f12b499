-- Lua's own names, for help: they lead to Lua's manual.
local text = require "rotor.text"

local manual = {}

local kManual = "https://www.lua.org/manual/5.4/manual.html#"
local kLibraries = { coroutine = "6.2", package = "6.3", string = "6.4", utf8 = "6.5", table = "6.6", math = "6.7",
  io = "6.8", os = "6.9", debug = "6.10" }
local kFunctions = " assert collectgarbage dofile error getmetatable ipairs load loadfile next pairs pcall print "
  .. "rawequal rawget rawlen rawset require select setmetatable tonumber tostring type warn xpcall _G _VERSION "
local kKeywords = " and break do else elseif end false for function goto if in local nil not or repeat return then "
  .. "true until while "

--- What is said of a name of Lua, or nil if it is none.
function manual.about(name)
  local library, member = name:match "^(%w+)%.(%w+)$"
  if kKeywords:find(" " .. name .. " ", 1, true) then
    return name .. " is a word of the language Lua:\n  " .. kManual .. "3"
  elseif kFunctions:find(" " .. name .. " ", 1, true)
    or kLibraries[library] and rawget(rawget(_G, library) or {}, member) ~= nil then
    return name .. " is Lua's own:\n  " .. kManual .. "pdf-" .. name
  elseif kLibraries[name] then
    local members = {}
    for key in next, rawget(_G, name) or {} do members[#members + 1] = tostring(key) end
    table.sort(members)
    return name .. " is a library of Lua:\n  " .. kManual .. kLibraries[name] .. "\n"
      .. text.wrap(table.concat(members, " "), "  ")
  end
end

--- The name under which a value without a row can be reached in Lua's libraries, or nil.
function manual.name_of(value)
  for name in kFunctions:gmatch "%S+" do
    if rawequal(rawget(_G, name), value) then return name end
  end
  for library in pairs(kLibraries) do
    local members = rawget(_G, library)
    if rawequal(members, value) then return library end
    for key, member in next, type(members) == "table" and members or {} do
      if rawequal(member, value) and type(value) == "function" then return library .. "." .. key end
    end
  end
end

return manual
