-- Sessions as tests: rotor run.lua TRANSCRIPT...
--
-- A transcript is what a person sees: the lines that begin with a prompt hold what is typed, the others
-- what rotor answers. A Markdown file holds one in each of its blocks ```rotor; a first line "$ rotor"
-- stands for the start and makes the banner part of the session. What is typed is fed to "rotor -i", and
-- everything that comes out must be the transcript without what was typed.

local kPrompts = { "rotor> ", "   ..> " }

local rotor = arg[-1]

local function quoted(path) return "'" .. path:gsub("'", "'\\''") .. "'" end

local function read(path)
  local file <close> = assert(io.open(path))
  return file:read "a"
end

local function write(path, text)
  local file <close> = assert(io.open(path, "w"))
  assert(file:write(text))
end

--- The prompt that stands at `at` in the text, or nil.
local function prompt_at(text, at)
  for _, prompt in ipairs(kPrompts) do
    if text:sub(at, at + #prompt - 1) == prompt then return prompt end
  end
end

--- { name =, line =, text =, banner = } for each session of a file.
local function sessions_of(path)
  local name = path:match "[^/]*$"
  if not path:find "%.md$" then return { { name = name, line = 1, text = read(path) } } end
  local sessions, current, number = {}, nil, 0
  for line in (read(path) .. "\n"):gmatch "(.-)\n" do
    number = number + 1
    if current and line == "```" then
      current = nil
    elseif current and current.text == "" and line == "$ rotor" then
      current.banner, current.line = true, current.line + 1
    elseif current then
      current.text = current.text .. line .. "\n"
    elseif line == "```rotor" then
      current = { name = name, line = number + 1, text = "", banner = false }
      sessions[#sessions + 1] = current
    end
  end
  return sessions
end

--- What is typed in a session, a list of lines, and all that must come out.
local function split(text)
  local typed, expected = {}, {}
  for line in text:gmatch "([^\n]*)\n" do
    local prompt = prompt_at(line .. " ", 1)  -- an editor may have cut the blank after a bare prompt
    if prompt then typed[#typed + 1] = line:sub(#prompt + 1) end
    expected[#expected + 1] = prompt or line .. "\n"
  end
  return typed, table.concat(expected) .. kPrompts[1] .. "\n"  -- the end of the input closes the session
end

--- The output with what was typed put back after the prompts, so that it reads as the transcript does.
local function with_typed(output, typed)
  local parts, at, count = {}, 1, 0
  while at <= #output do
    local prompt = prompt_at(output, at)
    if prompt then
      count = count + 1
      parts[#parts + 1] = prompt .. (typed[count] or "") .. "\n"
      at = at + #prompt
    else
      local last = output:find("\n", at, true) or #output
      parts[#parts + 1] = output:sub(at, last)
      at = last + 1
    end
  end
  return table.concat(parts)
end

local function run(session, scratch)
  local typed, expected = split(session.text)
  write(scratch .. ".in", table.concat(typed, "\n") .. "\n")
  local command = ("%s %s -i <%s.in 2>&1"):format(quoted(rotor), session.banner and "" or "-q", scratch)
  local pipe <close> = assert(io.popen(command))
  local output = pipe:read "a"
  if #typed > 0 and output == expected then return true end
  io.stdout:write(("not ok: %s, the session at line %d\n"):format(session.name, session.line)):flush()
  write(scratch .. ".expected", with_typed(expected, typed))
  write(scratch .. ".got", with_typed(output, typed))
  os.execute(("diff -u %s.expected %s.got"):format(scratch, scratch))
  return false
end

local count, failed = 0, 0
local scratch = os.tmpname()
for _, path in ipairs(arg) do
  for _, session in ipairs(sessions_of(path)) do
    count = count + 1
    if not run(session, scratch) then failed = failed + 1 end
  end
end
for _, ending in ipairs { "", ".in", ".expected", ".got" } do os.remove(scratch .. ending) end
print(("%d sessions, %d failed"):format(count, failed))
os.exit(count > 0 and failed == 0, true)
