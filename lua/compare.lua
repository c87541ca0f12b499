-- How far two values are apart, for near().
local names = require "rotor.names"

local kComponents = { vec = 3, quaternion = 4, matrix = 3 }

-- Appends the numbers in a value and the places where they stand ("[1][2]"), or returns false: not made of numbers.
local function flatten(value, place, numbers, places)
  if type(value) == "number" then
    numbers[#numbers + 1], places[#places + 1] = value, place
    return true
  end
  local kind = names.type_of(value)
  local count = kComponents[kind] or kind == "table" and #value
  if not count then return false end
  for i = 1, count do
    if not flatten(value[i], place .. "[" .. i .. "]", numbers, places) then return false end
  end
  return true
end

-- |a - b|, 0 between equal infinities; NaN if either is NaN.
local function distance(a, b)
  if a == b then return 0.0 end
  local d = math.abs((a + 0.0) - (b + 0.0))
  return d == 0 and 1.0 or d  -- integers that are not equal but round to the same float are 1 apart at least
end

--- Compares two values. Returns { difference =, predicted =, measured =, place = }: the two numbers that are farthest
--- apart and where they stand in the values ("" for plain numbers); for rotations their operators' distance and no
--- numbers. Returns nil and the reason where the two cannot be compared.
return function(predicted, measured)
  local kinds = { names.type_of(predicted), names.type_of(measured) }
  if kinds[1] == "rotation" and kinds[2] == "rotation" then
    return { difference = predicted:distance(measured), place = "" }
  end
  local p, m, p_places, m_places = {}, {}, {}, {}
  for _, given in ipairs { flatten(predicted, "", p, p_places), flatten(measured, "", m, m_places) } do
    if not given then return nil, "a " .. kinds[1] .. " was predicted and a " .. kinds[2] .. " measured" end
  end
  if table.concat(p_places) ~= table.concat(m_places) then
    return nil, ("%d numbers were predicted and %d measured, or in another shape"):format(#p, #m)
  elseif #p == 0 then
    return nil, "there are no numbers in it"
  end
  local worst = { difference = -1 }
  for i, a in ipairs(p) do
    local d = distance(a, m[i])
    if d > worst.difference or d ~= d then
      worst = { difference = d, predicted = a, measured = m[i], place = p_places[i] }
    end
    if d ~= d then break end
  end
  return worst
end
