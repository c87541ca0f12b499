-- Lists of rotations and tables of numbers: printed, written, read back.
package.path = (arg[0]:match "^(.*/)" or "./") .. "?.lua;" .. package.path
local support = require "support"
local equal, contains, fits, printed = support.equal, support.contains, support.fits, support.printed

local file = os.tmpname()

local function refused(f, ...)
  local ended, message = pcall(f, ...)
  equal(ended, false, "an error is expected")
  return message
end

-- Tables.
local list = {}
for i = 1, 12 do list[i] = rotation({ -1, i, 0.3 }, 5*i - 30.123456789) end
local text = printed(rotation.table, list)
fits(text)
contains(text, "i   angle_rad")
equal(select(2, text:gsub("\n", "")), 14)
fits(printed(rotation.table, list, { columns = { "quaternion", "angle" } }))
fits(printed(rotation.table, list, { columns = "euler_zyx" }))
precision(3)
contains(printed(rotation.table, { rotation({ 0, 0, 1 }, pi) }), " 3.14 ")
precision(17)
fits(printed(function() evolve{ omega = { 1, 2, 3 }, to = 1 }:table { "angle", "axis" } end))
equal(printed(rotation.table, {}, { columns = "angle" }), "i  angle_rad\n-  ---------\n")

fits(printed(rotation.table, list, { columns = { "euler_zyx", "mrp", "matrix" } }))
fits(printed(function() evolve{ omega = { 1, 2, 3 }, to = 1 }:table { "matrix", "omega" } end))
local timed = printed(rotation.table, { list[1], list[2] }, { columns = "mrp_z", times = { 0, 0.5 } })
equal(timed:match "^ *t  +mrp_z\n" ~= nil, true)
equal(timed, printed(rotation.table, { list[1], list[2] }, { columns = { "t", "mrp_z" }, times = { 0, 0.5 } }))

contains(refused(rotation.table, list, { times = { 1 } }), "times: expected one for each of the 12 rotations, got 1")
contains(refused(rotation.table, list, { columns = "t" }), "unknown column 't'; there are angle, axis,")
contains(refused(rotation.table, list, { columns = "axes" }), "unknown column 'axes'; did you mean 'axis'?")
contains(refused(rotation.table, list, { columns = "omega" }), "unknown column 'omega'; there are angle, axis,")
contains(refused(rotation.table, list, { columns = 3 }), "columns: expected a name or a list of names, got number 3")
contains(refused(rotation.table, list, { columns = {} }), "no columns given")
contains(refused(rotation.table, list, { colums = "axis" }), "unknown option 'colums'; did you mean 'columns'?")
contains(refused(rotation.table, { list[1], 2 }), "item 2: expected a rotation, got number 2")
contains(refused(rotation.table), "expected a list, got nothing")

-- Rotations to a file and back.
contains(printed(rotation.csv, file, list), "wrote " .. file .. " (12 rows) and " .. file .. ".json")
local back = rotation.read_csv(file)
equal(#back, 12)
for i = 1, 12 do
  equal(back[i].angle, list[i].angle)
  -- The axis is made unit again: within an ulp, 1.1e-16, a component.
  equal(norm(back[i].axis - list[i].axis) < 2e-16, true)
end
contains(printed(rotation.csv, file, { list[1] }, { columns = "quaternion" }), "(1 row)")
-- Four components to half an ulp, an angle in [0, 2 pi] and an axis as above: see list_output_test.cpp.
equal(rotation.read_csv(file, { face = "quaternion" })[1]:distance(list[1]) < 1.5e-15, true)
contains(refused(rotation.read_csv, file, { face = "quaternions" }), "did you mean 'quaternion'?")
contains(refused(rotation.read_csv, file, { face = "quaternion", columns = { "quaternion_v", "b", "c", "d" } }),
  "unknown column 'quaternion_v'; did you mean 'quaternion_w'?")
contains(refused(rotation.read_csv, file, { columns = { "quaternion_w" } }), "say which face")
contains(refused(rotation.csv, "", list), "the file name is empty")
contains(refused(rotation.csv, file, list, { columns = { "axis", "axis_x" } }), "two columns have the name 'axis_x'")
contains(refused(rotation.csv, "/dev/full", list), "/dev/full: No space left on device")
printed(rotation.csv, file, { list[1], list[2] }, { times = { 0.5, 1/3 } })
equal(io.lines(file)(), "t,angle_rad,axis_x,axis_y,axis_z")
equal(read_csv(file).t[2], 1/3)
equal(rotation.read_csv(file)[2].angle, list[2].angle)
printed(rotation.csv, file, { list[1] }, { columns = { "angle", "t" }, times = { 1 } })
equal(io.lines(file)(), "angle_rad,t")
printed(rotation.csv, file, {})
equal(#rotation.read_csv(file), 0)
os.remove(file .. ".json")

-- Columns to a file and back, bit for bit.
local awkward = { 5e-324, -0.0, 1/0, -1/0, 1.7e308, 1/3, 0/0 }
local names = { "", "a,b", '"', "\n", " x ", "nan", "\u{3c9}" }
equal(printed(write_csv, file, { x = awkward, name = names }), "wrote " .. file .. " (7 rows)\n")
local data = read_csv(file)
for i = 1, 6 do
  equal(string.pack("n", data.x[i]), string.pack("n", awkward[i]))
  equal(data.name[i], names[i])
end
equal(data.x[7] ~= data.x[7], true)
equal(data.name[7], names[7])

-- Vectors and quaternions have a column a component; the order is that asked for.
local q = rotation({ 1, 2, 2 }, 1).quaternion
printed(write_csv, file, { t = { 0 }, p = { { 1, 2, 3 } }, v = { vec(4, 5, 6) }, quaternion = { q } },
  { columns = { "t", "v", "quaternion" } })
equal(io.lines(file)(), "t,v_x,v_y,v_z,quaternion_w,quaternion_x,quaternion_y,quaternion_z")
equal(read_csv(file).v_z[1], 6.0)
equal(rotation.read_csv(file)[1]:distance(rotation({ 1, 2, 2 }, 1)) < 1.5e-15, true)
for i, name in ipairs { "w", "x", "y", "z" } do equal(read_csv(file)["quaternion_" .. name][1], q[i]) end
printed(write_csv, file, { p = { { 1, 2, 3 } }, a = { 1 } })
equal(io.lines(file)(), "a,p_x,p_y,p_z", "by the alphabet")
printed(write_csv, file, { t = {} })
equal(#read_csv(file).t, 0)

contains(refused(write_csv, file, { t = { 1, 2 }, x = { 1 } }),
  "write_csv: expected columns of one length, got 2 values in 't' and 1 in 'x'")
contains(refused(write_csv, file, { t = { 1, "2" } }), "'t': item 2: expected a number, got string \"2\"")
contains(refused(write_csv, file, { t = { true } }), "'t': expected numbers, strings, vecs or quaternions, got true")
contains(refused(write_csv, file, { t = 1 }), "'t': expected a list, got number 1")
contains(refused(write_csv, file, { { 1 } }), "expected columns by name, as {t = {0, 1}}, got the key number 1")
contains(refused(write_csv, file, 1), "argument 2: expected a table of lists by name, got number 1")
contains(refused(write_csv, file, { time = { 1 } }, { columns = "tiem" }), "did you mean 'time'?")
contains(refused(write_csv, file, {}), "a CSV file needs at least one column")
contains(refused(write_csv, file, { p = { vec(1, 2, 3) }, p_x = { 1 } }), "two columns have the name 'p_x'")
contains(refused(write_csv, "/dev/full", { t = { 1 } }), "No space left on device")
contains(refused(read_csv, file .. ".none"), "No such file or directory")
contains(refused(read_csv), "argument 1: expected a string, got nothing")
contains(refused(read_csv, file, {}, 1), "one argument too many")
contains(refused(read_csv, file, { separator = ";;" }), 'separator: expected one character, as ";", got ";;"')
contains(refused(read_csv, file, { separator = "" }), 'got ""')
equal(#read_csv(file).t, 0, "what fails leaves the file as it is")

-- Other separators.
local out <close> = assert(io.open(file, "w"))
out:write "time;q0;q1;q2;q3\n0;1;0;0;0\n"
out:flush()
for _, read in ipairs { read_csv, rotation.read_csv } do
  contains(refused(read, file), [[line 1: one column, 'time;q0;q1;q2;q3': separated by ';'? give separator = ";"]])
end
equal(read_csv(file, { separator = ";" }).q0[1], 1.0)
contains(refused(rotation.read_csv, file, { separator = ";" }),
  '; name them, the scalar first: {face = "quaternion", columns = {"q0", "q1", "q2", "q3"}}')
local named = { separator = ";", face = "quaternion", columns = { "q0", "q1", "q2", "q3" } }
equal(rotation.read_csv(file, named)[1].angle, 0.0)
os.remove(file)

theorem("read_csv gives back the vecs and quaternions that write_csv wrote", function()
  local name = os.tmpname()
  local points, spins = { vec(1, 2, 3), vec(-0.5, 0, 1e-300) }, { quaternion(1, 2, 3, 4), quaternion(0, 0, 0, 1) }
  local words = { "a", "b" }
  write_csv(name, { t = { 0, 1 }, p = points, q = spins, word_x = words, word_y = words, word_z = words })
  local read = read_csv(name)
  os.remove(name)
  holds(#read.p == 2 and read.p[1] == points[1] and read.p[2] == points[2], "vecs")
  holds(#read.q == 2 and read.q[1] == spins[1] and read.q[2] == spins[2], "quaternions")
  holds(read.p_x[2] == -0.5 and read.none == nil and read.t_x == nil and read[1] == nil, "columns and what is none")
  holds(read.word == nil, "no vecs of words")
  near(vec(2, 1, -3), rotation({ 1, 1, 0 }, pi):rotate(read.p)[1], 2e-15, "points of a file, turned")
  fails(function() return rotation.identity:rotate(read) end, "the columns are no list", "got a table with the key")
end)
