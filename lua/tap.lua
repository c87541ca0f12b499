-- `rotor --test FILES`: every theorem is a line of TAP (version 13); what the scripts print comes behind "# ".

-- luacheck: ignore 122

-- While `f` runs, what Lua code writes to standard output goes to `write`, and os.exit raises { exit = code }.
local function redirected(write, f)
  local methods = debug.getmetatable(io.stdout).__index
  local saved = { print = print, io_write = io.write, write = methods.write, exit = os.exit }
  local function print_to(...)
    local parts = table.pack(...)
    for i = 1, parts.n do parts[i] = tostring(parts[i]) end
    write(table.concat(parts, "\t") .. "\n")
  end
  function methods.write(file, ...)
    if file ~= io.stdout then return saved.write(file, ...) end
    write(table.concat { ... })
    return file
  end
  function io.write(...) return io.output():write(...) end
  function os.exit(code) error({ exit = code == nil or code == true or code == 0 }, 0) end
  rawset(_G, "print", print_to)
  local ended, raised = pcall(f)
  rawset(_G, "print", saved.print)
  io.write, methods.write, os.exit = saved.io_write, saved.write, saved.exit
  return ended, raised
end

-- A string as YAML reads it.
local function quoted(s)
  return '"' .. s:gsub('[\\"]', "\\%0"):gsub("\n", "\\n"):gsub("\t", "\\t"):gsub("%c", " ") .. '"'
end

-- The YAML block under a test that is not ok.
local function diagnosis(theorem)
  local lines = { "  ---" }
  if theorem.problem then lines[2] = "  problem: " .. quoted(theorem.problem) end
  if theorem.failed > 0 then lines[#lines + 1] = "  failed:" end
  for _, check in ipairs(theorem.checks) do
    if not check.pass then
      lines[#lines + 1] = "    - what: " .. quoted(check.what)
      if check.values then
        lines[#lines + 1] = "      predicted: " .. quoted(check.values[1])
        lines[#lines + 1] = "      measured: " .. quoted(check.values[2])
        lines[#lines + 1] = "      difference: " .. quoted(check.difference)
        lines[#lines + 1] = "      tolerance: " .. quoted(check.tolerance)
      end
      if check.note then lines[#lines + 1] = "      reason: " .. quoted(check.note) end
      if check.where then lines[#lines + 1] = "      at: " .. quoted(check.where) end
    end
  end
  lines[#lines + 1] = "  ..."
  return table.concat(lines, "\n")
end

return function(files, set_report)
  local stdout_write, stdout = debug.getmetatable(io.stdout).__index.write, io.stdout
  local count, failed, pending = 0, 0, ""
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
    out((theorem.pass and "ok " or "not ok ") .. count .. " - " .. name)
    if not theorem.pass then out(diagnosis(theorem)) end
  end
  out "TAP version 13"
  for _, file in ipairs(files) do
    local before = count
    set_report(function(theorem)
      if type(theorem.raised) == "table" and theorem.raised.exit ~= nil then error(theorem.raised, 0) end
      test(file, theorem)
    end)
    local environment = setmetatable({ arg = { [0] = file } }, { __index = _G })
    environment._G = environment
    local ended, raised = redirected(comment, function()
      local chunk, problem = loadfile(file, "bt", environment)
      if not chunk then error(problem, 0) end
      chunk(file)
    end)
    set_report(nil)
    local problem = not ended and tostring(raised) or nil
    if type(raised) == "table" and raised.exit ~= nil then
      problem = not raised.exit and "it ended itself with a status that means failure" or nil
    end
    if problem or count == before then
      test(file, { name = "runs", pass = not problem, problem = problem, failed = 0, checks = {} })
    end
    flush()
  end
  out("1.." .. count)
  return failed == 0 and count > 0
end
