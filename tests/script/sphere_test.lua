-- draw_sphere and spherical_triangle:plot: what the picture shows, and what is refused.
package.path = (arg[0]:match "^(.*/)" or "./") .. "?.lua;" .. package.path
local support = require "support"
local equal, contains, fits = support.equal, support.contains, support.fits

local function lines_of(text)
  local lines = {}
  for line in text:gmatch "([^\n]*)\n" do lines[#lines + 1] = line end
  return lines
end

-- The line and the column of the only place where the text has the piece.
local function place(text, piece)
  local found
  for i, line in ipairs(lines_of(text)) do
    local column = line:find(piece, 1, true)
    if column then
      if found then error(piece .. " stands twice in\n" .. text) end
      found = { i, column }
    end
  end
  return found or error("no " .. piece .. " in\n" .. text)
end

local function check_place(picture, piece, line, column, what)
  local found = place(picture, piece)
  equal(found[1] .. ":" .. found[2], line .. ":" .. column, what or piece)
end

-- Width 41: radius 20 columns and 10 lines, centre at line 11, column 21. From x, y is to the right and z up.
local picture = support.printed(draw_sphere, { width = 41, from = { 5, 0, 0 },
  points = { xx = { 2, 0, 0 }, yy = { 0, 1, 0 }, zz = vec(0, 0, 1e-300), down = { 0, 0, -1 }, back = { -1, 0, 1 } } })
fits(picture)
check_place(picture, "o xx", 11, 21)
check_place(picture, "o yy", 11, 41, "a name may stand outside")
local crowded = support.printed(draw_sphere, { width = 41, from = { 1, 0, 0 },
  points = { o = { 1, 0, 0 }, same = { 1, 1e-9, 0 }, beside = { 1, 0.05, 0 }, right = { 1, 0.11, 0 } } })
fits(crowded)
check_place(crowded, "o,same o", 11, 14, "points in one place share a line")
check_place(crowded, "o right", 11, 23)
check_place(crowded, "beside at line 11, column 22", 24, 1, "a name without a place is told below")
check_place(picture, "o zz", 1, 21)
check_place(picture, "o down", 21, 21)
-- (-1, 0, 1)/sqrt(2) lies behind, 7.07 lines above the centre.
check_place(picture, "+ back", 4, 21)
contains(picture, "seen from (1.00, 0.00, 0.00)")

-- From the poles y is up; x is to the right from above, to the left from below.
local from_above = support.printed(draw_sphere, { width = 41, from = { 0, 0, 1 },
  points = { X = { 1, 0, 1 }, Y = { 0, 1, 0 } } })
check_place(from_above, "o Y", 1, 21)
check_place(from_above, "o X", 11, 35)
local from_below = support.printed(draw_sphere, { width = 41, from = { 0, 0, -1 }, points = { X = { 1, 0, -1 } } })
check_place(from_below, "o X", 11, 7)

-- An arc is in front or behind; the shorter way is taken.
local function marks(arcs)
  local drawing = support.printed(draw_sphere, { width = 41, from = { 1, 0, 0 }, arcs = arcs })
  drawing = drawing:gsub("\nseen from.*", "")
  return select(2, drawing:gsub("%*", "")), select(2, drawing:gsub("%.", ""))
end
local front, behind = marks { { { 1, 0, 0 }, { 0, 0, 1 } } }
equal(front, 11, "a quarter of a circle, upright: ten lines and the centre's")
equal(behind, 0)
front, behind = marks { { { -1, 0, 0 }, { 0, 0, 0.5 } } }
equal(front, 0)
equal(behind, 11)
front, behind = marks { { { 1, 0, 1e-9 }, { -1, 0, 1 } } }
equal(front, 11, "over the pole, behind what is in front")
equal(behind, 0)
front = marks { { { 1, 0, 0 }, { 1, 0, 0 } } }
equal(front, 1, "an arc from a point to itself")
equal(select(2, support.printed(draw_sphere, {}):gsub("\n", "")), 21, "40 columns: 19 lines and two of the legend")

-- A script's own globals do not reach into the library.
local saved = unit
rawset(_G, "unit", nil)
local without_unit = support.printed(draw_sphere,
  { width = 41, from = { 1, 0, 0 }, points = { P = { 1, 0, 0 } } })
check_place(without_unit, "o P", 11, 21)
rawset(_G, "unit", saved)

-- The triangle, seen from above its middle.
local triangle = spherical_triangle(rotation({ 0, 0, 1 }, 0.9), rotation({ sin(1), 0, cos(1) }, 1.4))
local plotted = support.printed(triangle.plot, triangle)
fits(plotted)
for _, name in ipairs { "p", "q", "r" } do
  equal(plotted:find("o " .. name .. "%f[%W]") ~= nil or plotted:find("%f[%w]" .. name .. " o") ~= nil, true, name)
end
contains(support.printed(triangle.plot, triangle, { from = { 0, 0, -2 }, width = 30 }), "from (0.00, 0.00, -1.00)")
contains(tostring(triangle), "turned about p by -theta/2 = -0.45")
fits(tostring(triangle))
fits(tostring(spherical_triangle(rotation({ 1, 2, 3 }, 1/3), rotation({ -3, 1e-5, 2 }, -2/3))))

-- What is refused.
local function refused(f, pattern)
  local ended, message = pcall(f)
  if ended then error("accepted; expected " .. pattern, 2) end
  contains(message, pattern)
end
refused(function() draw_sphere() end, "sphere_test.lua:")
refused(function() draw_sphere() end, "draw_sphere: expected options in braces, got nil")
refused(function() draw_sphere(vec(1, 2, 3)) end, "draw_sphere: expected options in braces, got vec")
refused(function() draw_sphere { point = {} } end, "unknown option 'point'; did you mean 'points'?")
refused(function() draw_sphere { 3 } end, "unknown option number 1")
refused(function() draw_sphere { width = 19 } end, "width: expected 20 to 80 columns, got number 19")
refused(function() draw_sphere { width = 81 } end, "width: expected 20 to 80 columns, got number 81")
refused(function() draw_sphere { width = 30.5 } end, "got number 30.5")
refused(function() draw_sphere { width = "60" } end, 'got string "60"')
refused(function() draw_sphere { from = { 0, 0, 0 } } end, "from: expected a vec or {x, y, z}, finite and not zero")
refused(function() draw_sphere { from = false } end,
  "from: expected a vec or {x, y, z}, finite and not zero, got false")
refused(function() draw_sphere { points = 3 } end, "points: expected a table {name = vec, ...}, got number 3")
refused(function() draw_sphere { points = { { 1, 0, 0 } } } end,
  "points: expected {name = vec, ...}, got the key number 1")
refused(function() draw_sphere { points = { p = { 1, 0/0, 0 } } } end,
  "points.p: expected a vec or {x, y, z}, finite")
refused(function() draw_sphere { arcs = "p" } end, 'arcs: expected a list {{a, b}, ...}, got string "p"')
refused(function() draw_sphere { arcs = { { "p" } } } end, "arcs: item 1: expected {a, b}, got table of 1 items")
refused(function() draw_sphere { arcs = { { "p", { 1, 0, 0 } } } } end, 'arcs: item 1: there is no point named "p"')
refused(function() draw_sphere { arcs = { { { 1, 0, 0 }, { -1, 0, 0 } } } } end, "arcs: item 1: its ends are opposite")
refused(function() triangle:plot { width = 3 } end, "plot: width: expected 20 to 80 columns, got number 3")
refused(function() triangle:plot { form = { 1, 0, 0 } } end, "plot: unknown option 'form'; did you mean 'from'?")
refused(function() triangle:plot(3) end, "plot: expected options in braces, got number 3")

-- Where there is no triangle, the fields of the product remain.
local k = { 0, 0, 1 }
local parallel = spherical_triangle(rotation(k, 1), rotation(k, 2))
equal(parallel.kind, "parallel")
equal(parallel.angle, 3.0)
contains(tostring(parallel), "no triangle: p and q are parallel: the product is about p, by theta + phi")
local opposite = spherical_triangle(rotation(k, 1), rotation({ 0, 0, -3 }, 2))
equal(opposite.kind, "opposite")
equal(opposite.rotation:same_operator(rotation(k, -1)), true)
local identity = spherical_triangle(rotation(k, 0), rotation({ 1, 0, 0 }, 0))
equal(identity.kind, "identity")
for _, none in ipairs { parallel, opposite, identity } do
  for _, field in ipairs { "vertices", "arcs", "half_angles" } do
    refused(function() return none[field] end, field .. ": no triangle: ")
  end
  refused(function() none:plot() end, "plot: no triangle: ")
  fits(tostring(none))
end
refused(function() spherical_triangle(rotation(k, 1), k) end,
  "spherical_triangle: argument 2: expected a rotation, got table of 3 items")
-- A side of half a circle is left out of the drawing.
local half = spherical_triangle(rotation({ 1, 0, 0 }, 0), rotation({ 0, 1, 0 }, -1))
equal(half.arcs.qr, math.pi)
contains(support.printed(half.plot, half), "in front")
