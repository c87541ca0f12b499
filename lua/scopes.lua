-- What stands inside what: a theorem, and a case of for_each or for_all, is a scope while its function runs; the
-- checks made there are kept in it.
local scopes = {}

local innermost  -- { checks =, outer =, thread =, body =, ... }

-- Ctrl-C leaves a scope without giving it the chance to say so, so the stack is asked: that of the thread in which it
-- began, as its checks may stand in coroutines.
local function runs(scope)
  if coroutine.status(scope.thread) == "dead" then return false end
  for level = 0, math.huge do
    local info = debug.getinfo(scope.thread, level, "f")
    if not info then return false end
    if info.func == scope.body then return true end
  end
end

--- The scope from which this is called, or nil.
function scopes.here()
  while innermost and not runs(innermost) do innermost = innermost.outer end
  return innermost
end

--- What was raised, as text.
function scopes.message(raised)
  local ended, message = pcall(tostring, raised)
  return ended and message or "(error object whose __tostring fails)"
end

--- Calls f(...) in the scope. Returns nil, or what f raised, as text.
function scopes.run(scope, f, ...)
  local arguments = table.pack(...)
  scope.checks, scope.outer, scope.thread = {}, scopes.here(), coroutine.running()
  -- No tail call: as long as f runs, the body is on its stack.
  function scope.body()
    local ended, raised = pcall(f, table.unpack(arguments, 1, arguments.n))
    return not ended and scopes.message(raised) or nil
  end
  innermost = scope
  local problem = scope.body()
  innermost = scope.outer
  return problem
end

return scopes
