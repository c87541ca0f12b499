-- commensurate(wish, {most=}): the paper's omega whose motion is periodic.
local names = require "rotor.names"
local text = require "rotor.text"

-- As registered, whatever a script has made of the global name.
local write_csv = names.find("", "write_csv").value

local commensurate = {}

local kMost = 100
local kShown = 20  -- rows in the terminal
local kOptions = { "most" }
local kGreatest = 1e6
local kColumns = { "p", "q", "alpha", "T", "off", "attitude_period", "orbit_period" }

-- What is wrong with the arguments is raised as { message }.
local function refuse(...) error({ string.format(...) }, 0) end

local function described(value)
  if type(value) == "string" then return ("%q"):format(value) end
  return math.type(value) and text.number(value) or names.type_of(value)
end

local function checked(wish, options)
  if math.type(wish) == nil or not (wish > 0 and wish <= kGreatest) then
    refuse("wish: expected an alpha above 0, up to 1e6, got %s", described(wish))
  end
  if options ~= nil and names.type_of(options) ~= "table" then
    refuse("expected options in braces, {most = 100}, got %s", described(options))
  end
  for key in pairs(options or {}) do
    if key ~= "most" then
      local guess = type(key) == "string" and names.suggest(key, kOptions)
      refuse("unknown option '%s'%s", tostring(key), guess and "; did you mean '" .. guess .. "'?" or "")
    end
  end
  local most = options and options.most or kMost
  local whole = math.tointeger(most)
  if math.type(most) == nil or not (whole and whole >= 2 and whole <= kGreatest) then
    refuse("most: expected a whole number, 2 to 1e6, got %s", described(most))
  end
  return whole
end

local function coprime(p, q)
  while q ~= 0 do p, q = q, p % q end
  return p == 1
end

-- alpha grows with q/p = sin(atan(alpha)), so that for each p it is one of two q.
local function found(wish, most)
  local list, sine, least = {}, math.sin(math.atan(wish)), math.huge
  for p = 2, most do
    local low = math.max(1, math.min(p - 1, math.floor(p*sine)))
    local high = math.max(1, math.min(p - 1, math.ceil(p*sine)))
    for q = low, high do
      local alpha = q/math.sqrt((p - q)*(p + q))
      -- Of 2 p and 2 q alpha may be rounded to be nearer.
      if math.abs(alpha - wish) < least and coprime(p, q) then
        least = math.abs(alpha - wish)
        list[#list + 1] = { p = p, q = q, alpha = alpha, T = 2*math.pi/alpha, off = alpha - wish,
          attitude_period = q, orbit_period = (p + q) % 2 == 0 and q or 2*q }
      end
    end
  end
  return list
end

local methods = {}
local meta = { __name = "commensurate", __index = methods }

-- The table, for the terminal: the nearest.
function meta.__tostring(self)
  local first = math.max(1, #self - kShown + 1)
  local lines = { "alpha = q/sqrt(p^2 - q^2), T = 2 pi/alpha; what repeats after how many T",
    ("%8s %8s %14s %9s %14s %10s %10s"):format("p", "q", "alpha", "off", "T", "attitude", "quaternion") }
  if first > 1 then lines[#lines + 1] = ("%8s  and %d more, farther off"):format("...", first - 1) end
  for i = first, #self do
    local row = self[i]
    lines[#lines + 1] = ("%8d %8d %14.10g %9.1e %14.10g %10d %10d"):format(row.p, row.q, row.alpha, row.off, row.T,
      row.attitude_period, row.orbit_period)
  end
  return table.concat(lines, "\n")
end

--- Writes the rows.
function methods:csv(file)
  if names.type_of(self) ~= "commensurate" then error("csv: before the colon: expected a list of commensurate", 2) end
  local data = {}
  for _, name in ipairs(kColumns) do
    data[name] = {}
    for i, row in ipairs(self) do data[name][i] = row[name] end
  end
  write_csv(file, data, { columns = kColumns })
end

--- The global function commensurate(wish, {most=}).
function commensurate.find(wish, options)
  local ended, result = pcall(function() return found(wish, checked(wish, options)) end)
  if ended then return setmetatable(result, meta) end
  if type(result) == "table" then error("commensurate: " .. result[1], 2) end
  error(result, 0)
end

return commensurate
