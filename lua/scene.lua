-- What the functions share that run evolve for a scene given to them: options, runs, distances.
local names = require "rotor.names"

-- As registered, whatever a script has made of the global name.
local evolve = names.find("", "evolve").value

local scene = {}

--- What is wrong with the options is raised as { message }.
function scene.refuse(...) error({ string.format(...) }, 0) end

local refuse = scene.refuse

--- Refuses what is no table, and keys that are in none of the lists.
function scene.check_keys(options, ...)
  if names.type_of(options) ~= "table" then
    refuse("expected options in braces, got %s", names.type_of(options))
  end
  local known, all = {}, {}
  for _, keys in ipairs { ... } do
    for _, key in ipairs(keys) do known[key], all[#all + 1] = true, key end
  end
  for key in pairs(options) do
    if not known[key] then
      local guess = type(key) == "string" and names.suggest(key, all)
      refuse("unknown option '%s'%s", tostring(key), guess and "; did you mean '" .. guess .. "'?" or "")
    end
  end
end

--- The run, or nil and the error object of one that stopped; what was wrong with the request is refused.
function scene.made(options)
  local ended, run = pcall(evolve, options)
  if ended then return run end
  if names.type_of(run) == "stop" and run.reason ~= "interrupted" then return nil, run end
  if type(run) == "string" then refuse("%s", run:match "evolve: (.*)" or run) end
  error(run, 0)
end

--- The angle between two attitudes, by their quaternions: good to the last digit at 0 too.
function scene.distance(p, q)
  local d = p:conj()*q
  return 2*math.atan(math.sqrt(d.x^2 + d.y^2 + d.z^2), math.abs(d.w))
end

--- f(options), where what is refused becomes an error of the global function `name`, in the
--- script's line: to be called by tail calls from there.
function scene.answer(name, f, options)
  local ended, result = pcall(f, options)
  if ended then return result end
  if type(result) == "table" and #result == 1 and not getmetatable(result) then
    error(name .. ": " .. result[1], 2)
  end
  error(result, 0)
end

return scene
