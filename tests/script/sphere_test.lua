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

-- A path is joined where it goes on by less than 0.5 rad, and dots are not; nan and 0 are gaps. At the angle s above x,
-- seen from x, a point is 10 sin(s) lines above the centre: 3.9 for 0.4, 5.6 for 0.6, each rounded.
local function up(s) return vec(cos(s), 0, sin(s)) end
local function drawn_marks(options)
  options.width, options.from = 41, { 1, 0, 0 }
  local drawing = support.printed(draw_sphere, options):gsub("\nseen from.*", "")
  return select(2, drawing:gsub("%*", "")), select(2, drawing:gsub("%.", ""))
end
local quarter = {}
for i = 0, 16 do quarter[i + 1] = up(i/16*pi/2) end
equal(drawn_marks { paths = { quarter } }, 11, "ten lines and the centre's")
equal(drawn_marks { dots = { quarter[1], quarter[9], quarter[17] } }, 3)
equal(drawn_marks { paths = { { up(0), up(0.4) } } }, 5, "joined")
equal(drawn_marks { paths = { { up(0), up(0.6) } } }, 2, "not joined")
equal(drawn_marks { paths = { { up(0), vec(0/0, 0, 0), up(0.4) } } }, 2, "nan is a gap")
equal(drawn_marks { paths = { { up(0), { 0, 0, 0 }, up(0.4) } } }, 2, "0 is a gap")
equal(drawn_marks { paths = { { up(0), up(pi), -up(0), up(0) } } }, 1, "opposite ends are not joined")
equal(drawn_marks { paths = { { up(0) }, { up(0.4) }, {} } }, 2, "each is a path of its own")
equal(drawn_marks { dots = { up(0), up(0.4), up(0) } }, 2, "dots")
front, behind = drawn_marks { dots = { { -1, 0, 0 }, { -1, 0, 0.1 } } }
equal(front .. " " .. behind, "0 2", "behind")

-- Of a run about z by t: e1 goes to e2 in a quarter of a turn, along the middle line to the right.
local function shown(value, options)
  options.width, options.from = 41, options.from or { 1, 0, 0 }
  local drawing = support.printed(value.sphere, value, options)
  fits(drawing)
  equal(select(2, drawing:gsub("\n", "")) <= 24, true, "fits a screen")
  return lines_of(drawing), drawing
end
local about_z = evolve { omega = { 0, 0, 1 }, to = pi/2 }
local lines, drawing = shown(about_z, { point = { 2, 0, 0 } })
equal(lines[11]:sub(21), ("*"):rep(21))
equal(lines[11]:sub(2, 20), (" "):rep(19))
equal(select(2, drawing:gsub("%*", "")), 21 + 1, "nothing else, and the legend")
contains(drawing, "a point of the body, t 0 .. 1.5708, n = 1000")
-- It is the place at the start, also from another attitude.
drawing = select(2, shown(evolve { omega = { 0, 0, 1 }, from = rotation({ 1, 2, 3 }, 2), to = pi/2 },
  { point = { 1, 0, 0 }, n = 50 }))
equal(drawing:match "^(.*)\nseen", table.concat(lines, "\n"):match "^(.*)\nseen")
-- The axis of a turn about z is z.
lines, drawing = shown(about_z, {})
equal(lines[1]:sub(21, 21), "*")
equal(select(2, drawing:gsub("%*", "")), 2)
contains(drawing, "the axis, t 0 .. 1.5708")
-- P15's omega goes round the equator; in front of what is behind it takes all of the middle line.
local a = 2*pi/40
local p15 = evolve { omega = function(t) return 3*cos(a*t), 3*sin(a*t), 0 end, to = 40 }
lines, drawing = shown(p15, { of = "omega", n = 200 })
equal(lines[11], ("*"):rep(41))
equal(select(2, drawing:gsub("%*", "")), 42)
-- From a quarter of a turn about x, omega = z is y for the body, on the right.
lines, drawing = shown(evolve { omega = { 0, 0, 2 }, from = rotation({ 1, 0, 0 }, pi/2), to = 1 },
  { of = "body_omega" })
equal(lines[11]:sub(41), "*")
equal(select(2, drawing:gsub("%*", "")), 2)
contains(drawing, "omega in the body frame")
-- A strobe's points are not joined: four of them at the ends of x and y, seen from above.
local strobe = evolve { omega = { 0, 0, 1 }, to = 1.5*pi }:strobe(pi/2)
lines, drawing = shown(strobe, { point = { 1, 0, 0 }, from = { 0, 0, 1 } })
equal(lines[1]:sub(21, 21) .. lines[11]:sub(1, 1) .. lines[11]:sub(41, 41) .. lines[21]:sub(21, 21), "****")
equal(select(2, drawing:gsub("%*", "")), 4 + 1)
contains(drawing, "a point of the body, t 0 .. 4.71239, points 4")
-- A body at rest at the identity has no axis, and a section that is not met no points.
drawing = select(2, shown(evolve { omega = { 0, 0, 0 }, to = 1 }, { n = 5 }))
equal(select(2, drawing:gsub("%*", "")), 1, "the legend's")
contains(select(2, shown(about_z:section { plane = { 0, 0, 1 }, offset = 9 }, {})), "the axis: no points")

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
refused(function() draw_sphere { paths = { up(0) } } end, "paths: item 1: expected a list of vecs, got vec")
refused(function() draw_sphere { paths = { { up(0), 3 } } } end, "paths: item 1: item 2: expected a vec or {x, y, z}")
refused(function() draw_sphere { dots = { { 1/0, 0, 0 } } } end, "dots: item 1: expected a vec or {x, y, z}, finite")
refused(function() draw_sphere { dots = 3 } end, "dots: expected a list of vecs, got number 3")
refused(function() about_z:sphere { of = "omgea" } end, 'sphere: of: expected one of "axis", "omega", "body_omega"')
refused(function() about_z:sphere { off = "axis" } end, "sphere: unknown option 'off'; did you mean 'of'?")
refused(function() about_z:sphere { n = 3, every = 1 } end, "sphere: give one of n, every and times")
refused(function() about_z:sphere { of = "axis", point = { 1, 0, 0 } } end, "sphere: give one of of and point")
refused(function() about_z:sphere { point = { 0, 0, 0 } } end, "sphere: point: expected a vec or {x, y, z}, finite")
refused(function() about_z:sphere { width = 3 } end, "sphere: width: expected 20 to 80 columns, got number 3")
refused(function() strobe:sphere { n = 3 } end, "sphere: unknown option 'n'")
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
