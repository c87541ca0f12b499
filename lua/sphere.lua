-- The unit sphere in characters, seen from far away: points on it, arcs of great circles, paths.
local names = require "rotor.names"

local vec, dot, cross, unit = names.registered "vec", names.registered "dot", names.registered "cross",
  names.registered "unit"

local sphere = {}

local kOptions = { "points", "arcs", "paths", "dots", "from", "width" }
local kFrom = { 3, 2, 1.5 }
local kWidth, kLeast, kMost = 40, 20, 80
local kNear = 0.5          -- rad: the points of a path that are nearer to each other are joined
local kHalfCircle = 1e-15  -- an arc as near to pi as this has no direction but that of rounding
local kDrawn = { axis = "the axis", omega = "omega", body_omega = "omega in the body frame" }
local kMarks = { outline = ":", front = "*", behind = ".", point = "o", point_behind = "+" }

-- What is asked for --------------------------------------------------------------------------------------------------

-- The options as the drawing wants them: unit vectors, arcs as pairs of them. What is wrong with them is raised as
-- { message }.
local function refuse(...) error({ string.format(...) }, 0) end

local function described(value)
  local kind = names.type_of(value)
  if kind == "table" then return "table of " .. #value .. " items" end
  if kind == "boolean" then return tostring(value) end
  return (kind == "string" and "%s %q" or kind == "number" and "%s %s" or "%s"):format(kind, value)
end

local function direction(value, what)
  local made, v = pcall(unit, value)
  if made then return v end
  refuse("%s: expected a vec or {x, y, z}, finite and not zero, got %s", what, described(value))
end

local function table_of(value, what, expected)
  if value == nil then return {} end
  if type(value) ~= "table" then refuse("%s: expected %s, got %s", what, expected, described(value)) end
  return value
end

local function points_of(given)
  local points, order = {}, {}
  for name, v in pairs(table_of(given, "points", "a table {name = vec, ...}")) do
    if type(name) ~= "string" then refuse("points: expected {name = vec, ...}, got the key %s", described(name)) end
    if name:find "%c" then refuse("points: a name has no control characters, got %q", name) end
    points[name] = direction(v, "points." .. name)
    order[#order + 1] = name
  end
  table.sort(order)
  return points, order
end

-- The shorter way from a to b, { a, b, angle }: cos(s) a + sin(s) b for s from 0 to the angle, b a quarter further;
-- nil between opposite ends.
local function shorter_way(a, b)
  local normal = cross(a, b)
  local angle = math.atan(math.sqrt(dot(normal, normal)), dot(a, b))
  if math.pi - angle < kHalfCircle then return nil end
  return angle > 0 and { a, unit(cross(normal, a)), angle } or { a, a, 0 }
end

local function arc_of(given, i, points)
  local what = ("arcs: item %d"):format(i)
  if type(given) ~= "table" or #given ~= 2 then refuse("%s: expected {a, b}, got %s", what, described(given)) end
  local ends = {}
  for k, value in ipairs(given) do
    local point = type(value) == "string" and points[value]
    if type(value) == "string" and not point then refuse("%s: there is no point named %q", what, value) end
    ends[k] = point or direction(value, what)
  end
  return shorter_way(ends[1], ends[2]) or refuse("%s: its ends are opposite: which way?", what)
end

-- Whether there is nothing to draw: nan, as an axis is where it has no limit, or 0.
local function is_gap(value)
  local kind = names.type_of(value)
  if kind ~= "vec" and (kind ~= "table" or #value ~= 3) then return false end
  local x, y, z = value[1], value[2], value[3]
  return x ~= x or y ~= y or z ~= z or x == 0 and y == 0 and z == 0
end

-- Appends the directions of a list as arcs, those without length where they are not to be joined.
local function add_path(arcs, list, what, joined)
  local before
  for i, value in ipairs(table_of(list, what, "a list of vecs")) do
    local v = not is_gap(value) and direction(value, ("%s: item %d"):format(what, i)) or nil
    local way = v and joined and before and shorter_way(before, v)
    if way and way[3] < kNear then
      arcs[#arcs + 1] = way
    elseif v then
      arcs[#arcs + 1] = { v, v, 0 }
    end
    before = v
  end
end

local function scene_of(options)
  if type(options) ~= "table" or names.type_of(options) ~= "table" then
    refuse("expected options in braces, got %s", described(options))
  end
  for key in pairs(options) do
    local known = false
    for _, name in ipairs(kOptions) do known = known or key == name end
    if not known then
      local guess = type(key) == "string" and names.suggest(key, kOptions)
      local shown = type(key) == "string" and "'" .. key .. "'" or described(key)
      refuse("unknown option %s%s", shown, guess and "; did you mean '" .. guess .. "'?" or "")
    end
  end
  local width = options.width or kWidth
  if math.type(width) ~= "integer" or width < kLeast or width > kMost then
    refuse("width: expected %d to %d columns, got %s", kLeast, kMost, described(width))
  end
  local points, order = points_of(options.points)
  local arcs = {}
  for i, given in ipairs(table_of(options.arcs, "arcs", "a list {{a, b}, ...}")) do
    arcs[i] = arc_of(given, i, points)
  end
  for i, list in ipairs(table_of(options.paths, "paths", "a list of lists of vecs")) do
    add_path(arcs, list, ("paths: item %d"):format(i), true)
  end
  add_path(arcs, options.dots, "dots", false)
  local from = options.from == nil and kFrom or options.from
  return { points = points, order = order, arcs = arcs, width = width, from = direction(from, "from") }
end

-- The picture --------------------------------------------------------------------------------------------------------

-- A canvas in whose middle the sphere lies; a character is twice as high as wide.
local function canvas(width)
  local radius = (width - 1) // 2
  local rows = {}
  for i = 1, 2*(radius // 2) + 1 do
    rows[i] = {}
    for j = 1, width do rows[i][j] = " " end
  end
  local function place(x, y)
    return math.floor(#rows/2 + 1 - y*(#rows - 1)/2), math.floor(radius*(1 + x) + 1.5)
  end
  return rows, place
end

-- The names of the points in each cell: { { row =, column =, name =, mark = }, ... }; what is in front gives the mark.
local function marks_of(scene, at)
  local marks, by_cell = {}, {}
  for _, name in ipairs(scene.order) do
    local v = scene.points[name]
    local row, column = at(v)
    local cell = row .. " " .. column
    local behind = dot(v, scene.from) < 0
    local mark = by_cell[cell]
    if mark then
      mark.name, mark.behind = mark.name .. "," .. name, mark.behind and behind
    else
      by_cell[cell] = { row = row, column = column, name = name, behind = behind }
      marks[#marks + 1] = by_cell[cell]
    end
  end
  return marks
end

-- Writes a name beside its point, a space between, to the right or to the left, where it covers less. It may stand
-- outside the picture on the right. Returns whether there was a place: none is on other points and their names, which
-- `taken` has by their columns.
local function write(row, taken, mark)
  local length = utf8.len(mark.name) or #mark.name
  local function cost(first)
    local covered = 0
    if first < 1 or first + length - 1 > kMost then return math.huge end
    for i = first - 1, first + length do
      if taken[i] and i ~= mark.column then return math.huge end
      if row[i] and row[i] ~= " " then covered = covered + 1 end
    end
    return covered
  end
  local right, left = mark.column + 2, mark.column - 1 - length
  local first = cost(left) < cost(right) and left or right
  if cost(first) == math.huge then return false end
  for i = #row + 1, first + length - 1 do row[i] = " " end
  row[first == right and mark.column + 1 or mark.column - 1] = " "
  for i = first, first + length - 1 do row[i], taken[i] = "", true end
  row[first] = mark.name
  return true
end

local function drawn(scene)
  local from = scene.from
  -- Seen from a pole, y is up.
  local up = math.abs(from.z) > 1 - 1e-12 and vec(0, 1, 0) or vec(0, 0, 1)
  local right = unit(cross(up, from))
  up = cross(from, right)
  local rows, place = canvas(scene.width)
  local function at(v) return place(dot(v, right), dot(v, up)) end

  local steps = 8*scene.width  -- around the sphere: some a character
  for i = 1, steps do
    local angle = 2*math.pi*i/steps
    local row, column = place(math.cos(angle), math.sin(angle))
    rows[row][column] = kMarks.outline
  end
  for _, behind in ipairs { true, false } do  -- what is in front is drawn over what is behind
    for _, arc in ipairs(scene.arcs) do
      local count = math.max(1, math.ceil(steps*arc[3]/(2*math.pi)))
      for i = 0, count do
        local s = arc[3]*i/count
        local v = math.cos(s)*arc[1] + math.sin(s)*arc[2]
        if (dot(v, from) < 0) == behind then
          local row, column = at(v)
          rows[row][column] = behind and kMarks.behind or kMarks.front
        end
      end
    end
  end
  local marks, unnamed = marks_of(scene, at), {}
  local taken = {}
  for _, mark in ipairs(marks) do
    rows[mark.row][mark.column] = mark.behind and kMarks.point_behind or kMarks.point
    taken[mark.row] = taken[mark.row] or {}
    taken[mark.row][mark.column] = true
  end
  for _, mark in ipairs(marks) do
    if not write(rows[mark.row], taken[mark.row], mark) then
      unnamed[#unnamed + 1] = ("%s at line %d, column %d"):format(mark.name, mark.row, mark.column)
    end
  end
  local lines = {}
  for i, row in ipairs(rows) do lines[i] = table.concat(row):gsub("%s+$", "") end
  lines[#lines + 1] = ("seen from (%.2f, %.2f, %.2f)"):format(from.x + 0.0, from.y + 0.0, from.z + 0.0)
  lines[#lines + 1] = ("in front %s %s   behind %s %s"):format(kMarks.front, kMarks.point, kMarks.behind,
    kMarks.point_behind)
  for _, where in ipairs(unnamed) do lines[#lines + 1] = where end
  return table.concat(lines, "\n")
end

-- f(...), or nil and what is refused.
local function answer(f, ...)
  local made, result = pcall(f, ...)
  if made then return result end
  if type(result) == "table" and #result == 1 then return nil, result[1] end
  error(result, 0)
end

--- The picture as a text, or nil and what is wrong with the options.
function sphere.picture(options)
  return answer(function() return drawn(scene_of(options)) end)
end

--- The global function draw_sphere{points=, arcs=, paths=, dots=, from=, width=}.
function sphere.draw(options)
  local picture, wrong = sphere.picture(options)
  if not picture then error("draw_sphere: " .. wrong, 2) end
  print(picture)
end

-- The options of draw_sphere for the states of a run, and what is drawn, in words.
local function motion_of(run, states, joined, options)
  if options.point ~= nil and options.of ~= nil then refuse "give one of of and point" end
  local place = options.point ~= nil and run.start:inverse()*direction(options.point, "point")
  local what = options.of or "axis"
  local list = {}
  for i, state in ipairs(states) do list[i] = place and state.matrix*place or not place and state[what] end
  local text_of = place and "a point of the body" or kDrawn[what]
  if #list == 0 then
    text_of = text_of .. ": no points"
  else
    text_of = ("%s, t %.6g .. %.6g, %s %d"):format(text_of, states[1].t, states[#list].t,
      joined and "n =" or "points", #list)
  end
  return { paths = joined and { list } or nil, dots = not joined and list or nil, from = options.from,
    width = options.width }, text_of
end

--- Draws the states of a run, a line if they are joined, else dots; returns what is wrong with the options, or nil.
function sphere.draw_motion(run, states, joined, options)
  local picture, wrong = answer(function()
    local scene, text_of = motion_of(run, states, joined, options or {})
    return drawn(scene_of(scene)) .. "\n" .. text_of
  end)
  if picture then print(picture) end
  return wrong
end

--- Draws a spherical_triangle; returns what is wrong with the options, or nil.
function sphere.draw_triangle(triangle, options)
  local v, arcs = triangle.vertices, {}
  for sides, length in pairs(triangle.arcs) do
    if math.pi - length >= kHalfCircle then arcs[#arcs + 1] = { sides:sub(1, 1), sides:sub(2, 2) } end
  end
  local middle = v.p + v.q + v.r
  options = options or {}
  local from = options.from
  if from == nil and dot(middle, middle) > 0.01 then from = middle end
  local picture, wrong = sphere.picture { points = v, arcs = arcs, from = from, width = options.width }
  if picture then print(picture) end
  return wrong
end

return sphere
