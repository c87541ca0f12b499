-- All figures of the paper, one after another: figure1.lua to figure11.lua and body_point.lua, those that are beside
-- this file. After each a line says how long it took, of the processor's time, and how much was checked.
--
--   rotor examples/paper/figures.lua             prints and draws all, and writes their CSV, figure1.csv and so on
--   rotor examples/paper/figures.lua DIRECTORY   writes these into a directory

local here = arg[0]:match "^(.*/)" or "./"
-- With --test there is no program, arg[-1], before the script, and nothing is written.
local directory = arg[1] and arg[1]:gsub("/*$", "/") or arg[-1] and ""

local names = {}
for i = 1, 11 do names[i] = "figure" .. i end
names[12] = "body_point"

-- Globals of a script are its own, and so is arg; near, holds and fails count.
local function environment(path, csv)
  local count = 0
  local own = { arg = { [0] = path, csv } }
  for _, check in ipairs { "near", "holds", "fails" } do
    local made = _G[check]
    own[check] = function(...)
      count = count + 1
      return made(...)
    end
  end
  return setmetatable(own, { __index = _G }), function() return count end
end

local lines, broken, all = {}, {}, os.clock()
for _, name in ipairs(names) do
  local path = here .. name .. ".lua"
  local file = io.open(path)
  if file then
    file:close()
    print("== " .. name .. "\n")
    local own, checks = environment(path, directory and directory .. name .. ".csv")
    local start = os.clock()
    local ran, problem = pcall(function() assert(loadfile(path, "t", own))() end)
    lines[#lines + 1] = ("%-10s  %5.1f s  %8d checks%s"):format(name, os.clock() - start, checks(),
      ran and "" or "  ended in an error")
    if not ran then
      broken[#broken + 1] = name
      print(problem)
    end
    print("== " .. lines[#lines] .. "\n")
  end
end

print(table.concat(lines, "\n"))
print(("%-10s  %5.1f s"):format("together", os.clock() - all))
if #broken > 0 then error("ended in an error: " .. table.concat(broken, ", "), 0) end
