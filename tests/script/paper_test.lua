-- The paper's scripts can fail: each of these, with one formula put as it is printed, or wrong, is not ok.
local directory = arg[0]:match "^(.*/)" or "./"
local paper = directory .. "../../examples/paper/"

local kWrong = {
  { "lemma_5_3.lua", "s/((i + 2)*length^3)", "s*(i + 1)/((i + 2)*length^3)" },
  { "theorem_4_1.lua", "or atan(c*sin(half), cos(half))", "or acos(cos(half)/a)" },
  { "p4_limit.lua", "return (d[2]/12 + d[4]/3)/d[2]^2", "return (d[2]/12 + 2*d[4]/3)/d[2]^2" },
}

for _, wrong in ipairs(kWrong) do
  local name, right, put = table.unpack(wrong)
  local file <close> = assert(io.open(paper .. name))
  local text = file:read "a"
  local first, last = text:find(right, 1, true)
  assert(first, name .. " has no " .. right)
  local copy = os.tmpname()
  local out <close> = assert(io.open(copy, "w"))
  assert(out:write(text:sub(1, first - 1), put, text:sub(last + 1)))
  assert(out:flush())
  local pipe = assert(io.popen(("'%s' --test '%s'"):format(arg[-1], copy)))
  local tap = pipe:read "a"
  local ended, how, code = pipe:close()
  os.remove(copy)
  if ended or how ~= "exit" or code ~= 1 then error(name .. ": a wrong prediction ended with status " .. code) end
  if not (tap:find("\nnot ok ", 1, true) and tap:find("difference:", 1, true)) then
    error(name .. ": a wrong prediction is not told:\n" .. tap)
  end
  -- What the change does not touch goes on holding.
  assert(tap:find("\nok ", 1, true), name .. ": nothing holds any more")
end
