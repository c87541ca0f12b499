-- What the tests of the Lua library share. They run under lua5.4, with the library from the source tree and a registry
-- of names made here, and under rotor, with the library inside the binary; the registry is the one made here again,
-- except where a test asks for `support.rotor`, rotor's own.
local support = {}

local here = arg[0]:match "^(.*)/[^/]*$" or "."

if package.preload["rotor.entries"] or package.loaded["rotor.entries"] then
  support.rotor = require "rotor.entries"
else
  package.path = here .. "/?.lua;" .. package.path
  table.insert(package.searchers, function(module)
    local name = module:match "^rotor%.(%w+)$"
    return name and loadfile(here .. "/../../lua/" .. name .. ".lua")
  end)
end

-- Rows for a small calculator; what they say of it does not have to be true.
support.entries = {
  { owner = "", name = "rotation", kind = "function", signature = "rotation(axis, angle) -> rotation",
    result = "rotation", summary = "The rotation about an axis of any length but zero. The angle is kept as it is.",
    example = "rotation({1,0,0}, 1).angle --> 1.0" },
  { owner = "rotation", name = "from_mrp", kind = "function", signature = "from_mrp(p) -> rotation",
    result = "rotation", summary = "From modified Rodrigues parameters.", example = "rotation.from_mrp{0,0,1} --> r" },
  { owner = "rotation", name = "axis", kind = "field", signature = "axis -> vec", result = "vec",
    summary = "The axis, of length 1." },
  { owner = "rotation", name = "angle", kind = "field", result = "number", summary = "The angle in radians." },
  { owner = "rotation", name = "inverse", kind = "method", signature = "inverse() -> rotation", result = "rotation",
    summary = "The same axis, the negative angle.", example = "R:inverse().angle --> -1.0" },
  { owner = "rotation", name = "slerp", kind = "method", signature = "R:slerp(S, s, {way=}) -> rotation",
    result = "rotation", summary = "Between two rotations." },
  { owner = "rotation", name = "euler_angles", kind = "method", result = "number",
    signature = 'R:euler_angles("zyx", {frame=, degenerate=}) -> number, number, number', summary = "Euler angles." },
  { owner = "rotation", name = "R * S", kind = "operator", signature = "R * S -> rotation", result = "rotation",
    summary = "First S, then R." },
  { owner = "rotation", name = "R * v", kind = "operator", signature = "R * v -> vec", result = "vec",
    summary = "The vector turned." },
  { owner = "rotation", name = "R ^ x", kind = "operator", signature = "R ^ x -> rotation", result = "rotation",
    summary = "The angle times x." },
  { owner = "", name = "slerp", kind = "function", signature = "slerp(R, S, s, {way=}) -> rotation",
    result = "rotation", summary = "Between two rotations.", example = "slerp(A, B, 0.5).angle --> 0.5" },
  { owner = "", name = "deg", kind = "value", signature = "deg", result = "number", summary = "pi/180." },
  { owner = "", name = "evolve", kind = "function", result = "run", example = "evolve{omega={0,0,1}, to=1} --> run",
    signature = "evolve{omega=, from=, t=, to=, accuracy=, method=, step=, max_step=, max_steps=, equation=} -> run",
    summary = "Follows the motion that an angular velocity drives. What stops it early is raised as an error." },
  { owner = "run", name = "run(t)", kind = "operator", result = "state", summary = "The state at t." },
  { owner = "run", name = "tostring(run)", kind = "operator", result = "string", summary = "Its text." },
  { owner = "run", name = "cost", kind = "field", result = "cost", summary = "What it took." },
  { owner = "run", name = "csv", kind = "method", signature = "run:csv(file, {n=, every=, times=})", result = "nil",
    summary = "Writes a table." },
  { owner = "run", name = "table", kind = "method", signature = "run:table(what)", result = "nil",
    summary = "Prints a table." },
  { owner = "spin", name = "constant", kind = "function", signature = "constant(w) -> function", result = "function",
    summary = "An angular velocity that does not change." },
  { owner = "cost", name = "steps", kind = "field", result = "number", summary = "Accepted steps." },
  { owner = "cost", name = "seconds", kind = "field", result = "number", summary = "Seconds." },
  { owner = "state", name = "axis", kind = "field", result = "vec", summary = "The continuous axis." },
  { owner = "vec", name = "x", kind = "field", result = "number", summary = "First component." },
  { owner = "vec", name = "[i]", kind = "field", result = "number", summary = "Component i." },
  { owner = "vec", name = "-v", kind = "operator", result = "vec", summary = "The opposite." },
  { owner = "vec", name = "#v", kind = "operator", result = "number", summary = "3." },
  { owner = "vec", name = "v == w", kind = "operator", result = "boolean", summary = "All components." },
  { owner = "", name = "vec", kind = "function", signature = "vec(x, y, z) -> vec", result = "vec",
    summary = "A vector.", example = "vec(1, 2, 3).x --> 1.0" },
}

--- A value of one of rotor's types that raises an error as soon as anything but raw access touches it.
function support.untouchable(type_name)
  local function touched() error("a metamethod was called", 2) end
  return setmetatable({}, { __name = type_name, __index = touched, __newindex = touched, __pairs = touched,
    __call = touched, __len = touched, __tostring = touched, __eq = touched, __metatable = "locked" })
end

--- Puts the registry made here (or another) in place of rotor's, and forgets the modules that knew the other.
function support.use(entries)
  for name in pairs(package.loaded) do
    if name:find "^rotor%." then package.loaded[name] = nil end
  end
  package.loaded["rotor.entries"] = entries or support.entries
end

--- Runs f and returns what it prints.
function support.printed(f, ...)
  local lines, saved = {}, print
  rawset(_G, "print", function(...)
    local parts = table.pack(...)
    for i = 1, parts.n do parts[i] = tostring(parts[i]) end
    lines[#lines + 1] = table.concat(parts, "\t") .. "\n"
  end)
  local ended, raised = pcall(f, ...)
  rawset(_G, "print", saved)
  if not ended then error(raised, 0) end
  return table.concat(lines)
end

--- Raises unless got == expected.
function support.equal(got, expected, what)
  if got ~= expected then
    error(("%s:\n  got      %s\n  expected %s"):format(what or "values differ", got, expected), 2)
  end
end

--- Raises unless the text has the plain string in it; where lines are broken does not count.
function support.contains(text, piece, what)
  if not text:gsub("%s+", " "):find((piece:gsub("%s+", " ")), 1, true) then
    error(("%s: no %q in\n%s"):format(what or "text", piece, text), 2)
  end
end

--- Raises if a line of the text is wider than 80 columns.
function support.fits(text)
  for line in text:gmatch "[^\n]+" do
    if utf8.len(line) > 80 then error("wider than 80 columns: " .. line, 2) end
  end
end

return support
