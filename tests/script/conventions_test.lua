-- conventions(): each line of rotor's on the page does what the other library does. The numbers are the other
-- libraries' own: SciPy 1.10.1 and Eigen 3.4 were run, MATLAB's are those printed in its documentation (4 digits).
package.path = (arg[0]:match "^(.*/)" or "./") .. "?.lua;" .. package.path
local support = require "support"
local equal, contains, fits = support.equal, support.contains, support.fits
local conventions = require "rotor.conventions"

-- The rotation of the quaternion 0.9 + 0.3 i - 0.1 j + 0.2 k, normalised: of norm sqrt(0.95), so its matrix has
-- nineteenths.
local R = rotation.from_quaternion(quaternion(0.9, 0.3, -0.1, 0.2):unit())
local q = R.quaternion
local function nineteenths(rows)
  for _, row in ipairs(rows) do
    for j, x in ipairs(row) do row[j] = x/19 end
  end
  return rows
end
local kMatrix = nineteenths { { 17, -8.4, -1.2 }, { 6, 13.8, -11.6 }, { 6, 10, 15 } }
local kTransposed = nineteenths { { 17, 6, 6 }, { -8.4, 13.8, 10 }, { -1.2, -11.6, 15 } }
local kQuaternion = { 0.30779350562554619, -0.10259783520851541, 0.20519567041703082, 0.92338051687663869 }
-- "ZYX" body-fixed: SciPy's as_euler, Eigen's eulerAngles (whose first angle is in [0, pi]).
local kZyx = { 0.3392926144540447, -0.3212885892648103, 0.5880026035475675 }

-- What is given for the letters of each line, and what the other library makes of it. A rotation is compared by its
-- quaternion (x, y, z, w) as they print it.
local unit_q = { w = q.w, x = q.x, y = q.y, z = q.z }
local angles = { a = 0.4, b = -0.7, c = 1.1 }
local sigma = { sigma = { 0.1, 0.2, 0.3 } }
local quarter = { { 0, 0, 1 }, { 0, 1, 0 }, { -1, 0, 0 } }  -- about y, active
local half = sqrt(0.5)
local kCases = {
  ["from_quat([x, y, z, w])"] = { unit_q, kQuaternion },
  ["as_quat()"] = { {}, kQuaternion },
  ['from_euler("ZYX",[a,b,c])'] = { angles,
    { 0.5392876123673933, -0.1889554082836125, 0.3347576751063035, 0.749267658307011 } },
  ['from_euler("xyz",[a,b,c])'] = { angles,
    { 0.3347576751063035, -0.1889554082836125, 0.5392876123673933, 0.749267658307011 } },
  ['as_euler("zyx")'] = { {}, { 0.4589306628524001, -0.063199958914534, 0.6582679678347243 } },
  ["as_rotvec()"] = { {}, { 0.6318072221704896, -0.2106024073901632, 0.4212048147803265 } },
  ["Quaterniond(w, x, y, z)"] = { unit_q, kQuaternion },
  ["coeffs()"] = { {}, kQuaternion },
  ["AngleAxisd(a, v)"] = { { a = 1.2, v = { 1, 2, 2 } },
    { 0.18821415779834511, 0.37642831559669021, 0.37642831559669021, 0.82533561490967833 } },
  ["eulerAngles(2, 1, 0)"] = { {}, kZyx },
  ["quat2rotm([w x y z])"] = { { w = half, x = 0, y = half, z = 0 }, quarter },
  ["axang2rotm([x y z a])"] = { { x = 0, y = 1, z = 0, a = pi/2 }, quarter },
  ["rotm2eul(m)"] = { { m = kMatrix }, kZyx },
  ['rotmat(q, "point")'] = { {}, kMatrix },
  ['rotmat(q, "frame")'] = { {}, kTransposed },
  ["quat2dcm(q)"] = { {}, kTransposed },
  ["quatrotate(q, v)"] = { { v = { 1, 2, 3 } }, { 47/19, 49.2/19, 20.6/19 } },  -- kTransposed * v
  ["Quaternion(x, y, z, w)"] = { unit_q, kQuaternion },
  ["setRPY(roll, pitch, yaw)"] = { { roll = 0.4, pitch = -0.7, yaw = 1.1 },
    { 0.3347576751063035, -0.1889554082836125, 0.5392876123673933, 0.749267658307011 } },
}

-- Row by row of the textbook formulas for passive matrices: 1 + (8 S^2 - 4 (1 - s^2) S)/(1 + s^2)^2 for an MRP of
-- length s with S = skew(sigma); at (0.1, 0.2, 0.3), s^2 = 0.14.
local kBN = (function()
  local x, y, z, n = 0.1, 0.2, 0.3, 1.14^2
  local k = 4*(1 - 0.14)
  return {
    { 1 - 8*(y*y + z*z)/n, (8*x*y + k*z)/n, (8*x*z - k*y)/n },
    { (8*x*y - k*z)/n, 1 - 8*(x*x + z*z)/n, (8*y*z + k*x)/n },
    { (8*x*z + k*y)/n, (8*y*z - k*x)/n, 1 - 8*(x*x + y*y)/n },
  }
end)()
kCases["MRP2C(sigma)"] = { sigma, kBN }
kCases["C2MRP(BN)"] = { { BN = kBN }, sigma.sigma }
kCases["EP2C(q)"] = { {}, kTransposed }
-- The shadow set, -sigma/|sigma|^2.
kCases["MRPswitch(sigma, 1)"] = { { sigma = { 0, 2, 0 } }, { 0, -0.5, 0 } }
kCases["MRP2Euler321(sigma)"] = { sigma, { 1.3563595201033078, 0.3519420332730421, 0.7415645738576649 } }

local function numbers(value)
  if tostring(value):find "^rotation" then
    local p = value.quaternion
    return { p.x, p.y, p.z, p.w }
  end
  return value
end

-- Some roundings of numbers up to 4, in each of the two: 1e-15 each.
local kTolerance = 2e-15
local lines, cases = 0, 0
theorem("from other libraries", function()
  for _, library in ipairs(conventions.libraries) do
    for i = 2, #library do
      local theirs, ours = library[i][1], library[i][2]
      local case = kCases[theirs] or error("no numbers for " .. theirs)
      local environment = setmetatable({ R = R, q = q }, { __index = _G })
      for name, value in pairs(case[1]) do environment[name] = value end
      near(case[2], numbers(assert(load("return " .. ours, "=" .. ours, "t", environment))()), kTolerance, theirs)
      lines = lines + 1
    end
  end
end)
for _ in pairs(kCases) do cases = cases + 1 end
equal(lines, cases, "lines of the page, and numbers for them")

-- The claims of the first half.
theorem("rotor's own", function()
  local k, v = vec(0, 0, 1), vec(1, 2, 3)
  near(vec(0, 1, 0), rotation(k, pi/2)*vec(1, 0, 0), 1e-15, "counter-clockwise")
  near((R*rotation(k, 1))*v, R*(rotation(k, 1)*v), 4e-15, "S * R: R first")
  near((R*rotation(k, 1)).matrix, (rotation(R*k, 1)*R).matrix, 2e-15, "the axis as R carries it")
  near(R.matrix[1][2], (R*vec(0, 1, 0)).x, 1e-15, "columns are the turned axes")
  near(quaternion(0, 0, 0, 1), quaternion(0, 1, 0, 0)*quaternion(0, 0, 1, 0), 0, "Hamilton's product")
  near(0.4, (rotation(k, 0.3)*rotation(k, 0.1)).angle, 1e-16, "angles")
  near(rotation(k, 0.4)*rotation({ 0, 1, 0 }, -0.7)*rotation({ 1, 0, 0 }, 1.1),
    rotation.from_euler_angles("zyx", 0.4, -0.7, 1.1), kTolerance, "body-fixed")
  near(rotation({ 1, 0, 0 }, 1.1)*rotation({ 0, 1, 0 }, -0.7)*rotation(k, 0.4),
    rotation.from_euler_angles("zyx", 0.4, -0.7, 1.1, { frame = "space" }), kTolerance, "space-fixed")
  -- omega in space: the rotation grows from the left.
  near(rotation(k, 1)*R, evolve { omega = k, from = R, to = 1 }(1).rotation, kTolerance, "omega in the space frame")
  -- Eigen's other solution, where "ZYX" begins with a negative angle: it printed these for (-0.4, -0.7, 1.1).
  near({ 2.7415926535897932, -2.4415926535897934, -2.041592653589793 },
    { rotation.from_euler_angles("zyx", -0.4, -0.7, 1.1):euler_angles("zyx", { solution = 2 }) }, kTolerance, "Eigen's")

  -- MATLAB's printed examples: 45 degrees about y, then 30 about the new x, is "point" for the one matrix, "frame" for
  -- the other's transpose; quat2dcm([1 0 1 0]).
  local printed = rotation.from_quaternion(quaternion(0.8924, 0.23912, 0.36964, 0.099046):unit())
  near({ { 0.7071, 0, 0.7071 }, { 0.3536, 0.8660, -0.3536 }, { -0.6124, 0.5, 0.6124 } }, printed.matrix, 1e-4, "point")
  near({ { 0, 0, -1 }, { 0, 1, 0 }, { 1, 0, 0 } },
    rotation.from_quaternion(quaternion(1, 0, 1, 0):unit()):inverse().matrix, 1e-15, "quat2dcm")
end)

-- The page: 80 columns, two screens of 24 lines; in help, in the reference.
local page = conventions.page()
fits(page)
local _, breaks = page:gsub("\n", "")
equal(breaks + 1 <= 48, true, "two screens")
equal(support.printed(_G.conventions), page .. "\n")
contains(require("rotor.help").text "conventions", page)
contains(require("rotor.help").text "intrinsic", "conventions(library)")
contains(require("rotor.reference").markdown(), page)

-- One library's part, in any case, and the error that lists them.
equal(support.printed(_G.conventions, "basilisk"), page:match "(Basilisk: .*)$" .. "\n")
equal(support.printed(_G.conventions, "SciPy"), page:match "(SciPy: .-)Eigen: ")
for given, shown in pairs { foo = '"foo"', [3] = "a number" } do
  local _, raised = pcall(_G.conventions, given)
  contains(raised, 'the library is one of "SciPy", "Eigen", "MATLAB", "ROS", "Basilisk", got ' .. shown)
end
theorem("units", function()
  local measured = vec(rotation.from_euler_angles("zyx", 30*deg, 20*deg, 10*deg):euler_angles("zyx"))/deg
  near({ 30, 20, 10 }, measured, 1e-13, "degrees")  -- some roundings of numbers up to 30, 3.6e-15 each
end)
