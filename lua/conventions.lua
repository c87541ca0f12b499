-- The page of conventions: rotor's own, and how to come from other libraries and go to them.
local text = require "rotor.text"

local conventions = {}

local kTheirs = 25  -- columns of what others call it

local kOwn = {
  { "Rotations", "are active and right-handed: R * v is v turned counter-clockwise, seen from the tip of the axis. "
    .. "The coordinates of a fixed v in the turned axes are R:inverse() * v." },
  { "S * R", "is R first, then S, each about an axis that stays in space; R * S is R first, then S about its axis "
    .. "as R has carried it." },
  { "Angles", "are radians (30*deg) and any real number: turns count. vec(R:euler_angles(\"zyx\"))/deg is in degrees. "
    .. "From products, quaternions and MRP they are in [0, 2 pi], from matrices, Gibbs and modified Gibbs vectors and "
    .. "R:canonical() in [0, pi]." },
  { "Quaternions", "are (w, x, y, z), scalar first, Hamilton's product; q and -q are one operator, a turn apart." },
  { "Matrices", "are m[i][j], row i and column j, and multiply columns; the columns of R.matrix are the turned axes." },
  { "Euler angles", "\"zyx\", a, b, c: about z by a, about the new y by b, about the newest x by c (body-fixed, "
    .. "intrinsic); with {frame = \"space\"} about z, y, x that stay (extrinsic)." },
  { "omega", "is in the space frame, in radians per unit of time; from the body frame R * omega." },
}

--- By library: its name and what is to be known of it, then rows { theirs, the same in rotor }. In rotor's part
--- R is the rotation, q its quaternion, m its matrix, v a vector.
conventions.libraries = {
  { "SciPy: active; (x, y, z, w); capitals for body-fixed axes, small for space-fixed",
    { "from_quat([x, y, z, w])", "rotation.from_quaternion(w, x, y, z)" },
    { "as_quat()", "{q.x, q.y, q.z, q.w}" },
    { 'from_euler("ZYX",[a,b,c])', 'rotation.from_euler_angles("zyx", a, b, c)' },
    { 'from_euler("xyz",[a,b,c])', 'rotation.from_euler_angles("zyx", c, b, a)' },
    { 'as_euler("zyx")', '{R:euler_angles("zyx", {frame = "space"})}' },
    { "as_rotvec()", "R:canonical().euler_vector" } },
  { "Eigen: active; its constructor is scalar first, its coeffs() scalar last",
    { "Quaterniond(w, x, y, z)", "rotation.from_quaternion(w, x, y, z)" },
    { "coeffs()", "{q.x, q.y, q.z, q.w}" },
    { "AngleAxisd(a, v)", "rotation(v, a)" },
    { "eulerAngles(2, 1, 0)", '{R:euler_angles("zyx")}  -- or its {solution = 2}' } },
  { "MATLAB: (w, x, y, z); Aerospace and \"frame\" are passive, the rest is active",
    { "quat2rotm([w x y z])", "rotation.from_quaternion(w, x, y, z).matrix" },
    { "axang2rotm([x y z a])", "rotation({x, y, z}, a).matrix" },
    { "rotm2eul(m)", '{rotation.from_matrix(m):euler_angles("zyx")}' },
    { 'rotmat(q, "point")', "R.matrix" },
    { 'rotmat(q, "frame")', "R:inverse().matrix" },
    { "quat2dcm(q)", "R:inverse().matrix" },
    { "quatrotate(q, v)", "R:inverse() * v" } },
  { "ROS: active; (x, y, z, w); roll, pitch, yaw about x, y, z fixed in space",
    { "Quaternion(x, y, z, w)", "rotation.from_quaternion(w, x, y, z)" },
    { "setRPY(roll, pitch, yaw)", 'rotation.from_euler_angles("zyx", yaw, pitch, roll)' } },
  { "Basilisk: (w, x, y, z); matrices BN are passive; shadow set where |sigma| > 1",
    { "MRP2C(sigma)", "rotation.from_mrp(sigma):inverse().matrix" },
    { "C2MRP(BN)", "rotation.from_matrix(BN):inverse().mrp" },
    { "EP2C(q)", "R:inverse().matrix" },
    { "MRPswitch(sigma, 1)", "rotation.from_mrp(sigma):canonical().mrp" },
    { "MRP2Euler321(sigma)", '{rotation.from_mrp(sigma):euler_angles("zyx")}' } },
}

local function name_of(library) return library[1]:match "^%w+" end

-- The library of this name, in any case; else nil and the names that there are.
local function find(name)
  local known = {}
  for i, library in ipairs(conventions.libraries) do
    if type(name) == "string" and name_of(library):lower() == name:lower() then return library end
    known[i] = '"' .. name_of(library) .. '"'
  end
  return nil, table.concat(known, ", ")
end

local function part(library)
  local rows = {}
  for i = 2, #library do rows[i - 1] = { text.pad(library[i][1], kTheirs), library[i][2] } end
  return library[1] .. "\n" .. text.two_columns(rows, kTheirs)
end

--- The page as a text of 80 columns and at most two screens; of one library ("SciPy") its part.
function conventions.page(name)
  if name ~= nil then
    local library, known = find(name)
    if library then return part(library) end
    local given = type(name) == "string" and '"' .. name .. '"' or "a " .. type(name)
    error("conventions: the library is one of " .. known .. ", got " .. given, 3)
  end
  local parts = { text.two_columns(kOwn, 12) }
  for _, library in ipairs(conventions.libraries) do parts[#parts + 1] = part(library) end
  return table.concat(parts, "\n")
end

--- The lines about libraries as rows, for the search of help.
function conventions.lines()
  local rows = {}
  for _, library in ipairs(conventions.libraries) do
    local call = ('conventions("%s")'):format(name_of(library))
    local function add(name, summary)
      rows[#rows + 1] = { owner = "", name = name, kind = "function", signature = call, summary = summary }
    end
    add(name_of(library), library[1])
    for i = 2, #library do add(library[i][1], library[i][1] .. " is " .. library[i][2]) end
  end
  return rows
end

return conventions
