-- Text for a terminal of 80 columns.
local text = { columns = 80 }

--- The columns that a string takes: its characters, if it is UTF-8.
function text.width(s)
  return utf8.len(s) or #s
end

--- The string filled up with spaces on its right.
function text.pad(s, columns)
  return s .. (" "):rep(columns - text.width(s))
end

--- The shortest of 15, 16 or 17 digits that read back as the same number; a float that is whole ends in ".0".
function text.number(x)
  if math.type(x) == "integer" then return tostring(x) end
  if x ~= x then return "nan" end
  local digits = 15
  local short = ("%.15g"):format(x)
  while tonumber(short) ~= x and digits < 17 do
    digits = digits + 1
    short = ("%." .. digits .. "g"):format(x)
  end
  return short:find "^-?%d+$" and short .. ".0" or short
end

--- The words of `s` in lines that begin with `first`, then with `rest` (the same if not given).
function text.wrap(s, first, rest)
  rest = rest or first
  local lines, line, empty = {}, first, true
  for word in s:gmatch "%S+" do
    if not empty and text.width(line) + 1 + text.width(word) > text.columns then
      lines[#lines + 1] = line
      line, empty = rest, true
    end
    line = line .. (empty and "" or " ") .. word
    empty = false
  end
  lines[#lines + 1] = line
  return table.concat(lines, "\n")
end

--- Rows { left, right } as two columns. The left one is as wide as it must be, up to `widest`; what is longer
--- stands on a line of its own.
function text.two_columns(rows, widest)
  local columns, lines = 0, {}
  for _, row in ipairs(rows) do
    local width = text.width(row[1])
    if width <= widest then columns = math.max(columns, width) end
  end
  local indent = (" "):rep(columns + 4)
  for _, row in ipairs(rows) do
    local first = "  " .. text.pad(row[1], columns) .. "  "
    if text.width(row[1]) > columns then
      lines[#lines + 1] = text.wrap(row[1], "  ", "      ")
      first = indent
    end
    lines[#lines + 1] = text.wrap(row[2], first, indent):gsub("%s+$", "")
  end
  return table.concat(lines, "\n")
end

return text
