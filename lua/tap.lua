-- `rotor --test FILES`: every theorem is a line of TAP (version 13), with its time behind "# ", which is no directive
-- as TODO and SKIP are. What the scripts print comes behind "# " too.

-- luacheck: ignore 122

local next, rawset = next, rawset  -- what restores the tables must not be looked up in them

-- Copies of all tables that the scripts share, the libraries' among them: { [table] = its fields }.
local function shared_tables()
  local copies = {}
  local function keep(t)
    if type(t) ~= "table" or copies[t] then return end
    copies[t] = {}
    for key, value in next, t do
      copies[t][key] = value
      keep(value)
    end
  end
  keep(_G)
  keep(debug.getmetatable(io.stdout).__index)
  return copies
end

-- Undoes what a script changed. It works on the tables themselves, not on copies of its own, so that it sees what it
-- changed wherever Lua looks: package.path in require, a function added to string as a method of strings.
local function restore(copies)
  for t, copy in next, copies do
    for key in next, t do
      if copy[key] == nil then rawset(t, key, nil) end
    end
    for key, value in next, copy do rawset(t, key, value) end
  end
  io.output(io.stdout)
  io.input(io.stdin)
end

-- Until restore: what Lua code writes to standard output goes to `write`, and os.exit calls `exit(success)`.
local function redirect(write, exit)
  local methods = debug.getmetatable(io.stdout).__index
  local file_write = methods.write
  local function print_to(...)
    local parts = table.pack(...)
    for i = 1, parts.n do parts[i] = tostring(parts[i]) end
    write(table.concat(parts, "\t") .. "\n")
  end
  function methods.write(file, ...)
    if file ~= io.stdout then return file_write(file, ...) end
    write(table.concat { ... })
    return file
  end
  function io.write(...) return io.output():write(...) end
  function os.exit(code) exit(code == nil or code == true or code == 0) end
  rawset(_G, "print", print_to)
end

-- A string as YAML reads it.
local function quoted(s)
  return '"' .. s:gsub('[\\"]', "\\%0"):gsub("\n", "\\n"):gsub("\t", "\\t"):gsub("%c", " ") .. '"'
end

-- The YAML block under a test that is not ok.
local function diagnosis(theorem)
  local title = require "rotor.testing".title
  local lines = { "  ---" }
  if theorem.problem then lines[2] = "  problem: " .. quoted(theorem.problem) end
  if theorem.failed > 0 then lines[#lines + 1] = "  failed:" end
  for _, check in ipairs(theorem.checks) do
    if not check.pass then
      lines[#lines + 1] = "    - what: " .. quoted(title(check))
      if check.values then
        lines[#lines + 1] = "      predicted: " .. quoted(check.values[1])
        lines[#lines + 1] = "      measured: " .. quoted(check.values[2])
        lines[#lines + 1] = "      difference: " .. quoted(check.difference)
        lines[#lines + 1] = "      tolerance: " .. quoted(check.tolerance)
      end
      if check.note then lines[#lines + 1] = "      reason: " .. quoted(check.note) end
      if check.said and check.said[1] then lines[#lines + 1] = "      cases:" end
      for _, line in ipairs(check.said or {}) do lines[#lines + 1] = "        - " .. quoted(line) end
      if check.where then lines[#lines + 1] = "      at: " .. quoted(check.where) end
    end
  end
  lines[#lines + 1] = "  ..."
  return table.concat(lines, "\n")
end

--- Runs the files; `part`: whether only a part of the theorems is wanted, and files without any are not mentioned.
return function(files, set_report, part)
  local message = require "rotor.scopes".message
  local stdout_write, stdout = debug.getmetatable(io.stdout).__index.write, io.stdout
  local milliseconds = require "rotor.testing".milliseconds
  local count, failed, seconds, pending = 0, 0, 0, ""
  local function out(line) stdout_write(stdout, line, "\n") end
  local function flush()
    if pending ~= "" then out("# " .. pending) end
    pending = ""
  end
  local function comment(piece)
    pending = pending .. piece
    for line in pending:gmatch "([^\n]*)\n" do out("# " .. line) end
    pending = pending:match "[^\n]*$"
  end
  local function test(file, theorem)
    flush()
    count = count + 1
    failed = failed + (theorem.pass and 0 or 1)
    local name = (file .. ": " .. theorem.name):gsub("%s+", " "):gsub("#", "\\#")
    local time = theorem.seconds and " # time=" .. milliseconds(theorem.seconds, "ms") or ""
    seconds = seconds + (theorem.seconds or 0)
    out((theorem.pass and "ok " or "not ok ") .. count .. " - " .. name .. time)
    if not theorem.pass then out(diagnosis(theorem)) end
  end
  stdout:setvbuf "line"  -- so that what a script's os.execute prints comes after what stands before it
  out "TAP version 13"
  local tables = shared_tables()
  for _, file in ipairs(files) do
    local before = count
    local exited  -- once the script called os.exit, also if a pcall of its own caught what that raises
    set_report(function(theorem)
      if exited then
        theorem.pass, theorem.problem = false, "os.exit ended the script before the theorem was finished"
      end
      test(file, theorem)
      if exited then error(exited, 0) end
    end)
    redirect(comment, function(success)
      exited = { success = success }
      error(exited, 0)
    end)
    local environment = setmetatable({ arg = { [0] = file } }, { __index = _G })
    environment._G = environment
    local ended, raised = pcall(function()
      local chunk, problem = loadfile(file, "bt", environment)
      if not chunk then error(problem, 0) end
      chunk(file)
    end)
    restore(tables)
    set_report(nil)
    local problem
    if not ended and not exited then
      problem = message(raised)
    elseif exited and not exited.success then
      problem = "it ended itself with a status that means failure"
    end
    if problem or count == before and not part then
      test(file, { name = "runs", pass = not problem, problem = problem, failed = 0, checks = {} })
    end
    flush()
  end
  out("1.." .. count)
  out("# time=" .. milliseconds(seconds, "ms"))
  return failed == 0 and count > 0
end
