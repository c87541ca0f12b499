-- The limit that makes equation (4) of the paper regular at theta = 0: for f odd with f'(0) > 0, as theta -> 0,
--   as printed    {f' - theta cot(theta/2)/2}/f^2   ->  {f'(0)/12 + 2 f'''(0)/3}/f'(0)^2
--   as corrected  {f' - f cot(theta/2)/2}/f^2       ->  {f'(0)/12 +   f'''(0)/3}/f'(0)^2.
-- (An f is missing before the cotangent; (4) itself has it.) The two differ unless f'''(0) = 0, as for f = theta.
--
--   rotor examples/paper/p4_limit.lua                       three f with closed forms, and theta + theta^3/5
--   rotor examples/paper/p4_limit.lua "exp(theta) - exp(-theta)"     your f (regular to 1/4) for the last

local u = 2^-53  -- one rounding

-- Of the first three the fraction itself is known at every theta, and so its limit.
local cases = {
  { name = "theta", f = function(theta) return theta end,
    fraction = function(theta) return (1 - theta/2/tan(theta/2))/theta^2 end, limit = 1/12 },
  { name = "sin(theta/2)", f = function(theta) return sin(theta/2) end,
    fraction = function() return 0 end, limit = 0 },
  { name = "tan(theta/2)", f = function(theta) return tan(theta/2) end,
    fraction = function() return 1/2 end, limit = 1/2 },
}
local own = arg[1] or "theta + theta^3/5"
local own_f, problem = load("local theta = ...; return " .. own, "=" .. own)
if not own_f then error("f(theta) is expected, such as sin(theta/3): " .. problem, 0) end
cases[#cases + 1] = { name = own, f = own_f }

-- f, f', f'' ... at theta, exact but for rounding.
local function derivatives(f, theta)
  local list = evolve { omega = function(t) return f(t), 0, 0 end, t = { theta, theta } }:derivatives(theta)
  for k, value in ipairs(list) do list[k] = value.x end
  return list
end

local function fraction(f, theta)
  local d = derivatives(f, theta)
  return (d[2] - d[1]/tan(theta/2)/2)/d[1]^2
end

local function corrected(d) return (d[2]/12 + d[4]/3)/d[2]^2 end
local function printed(d) return (d[2]/12 + 2*d[4]/3)/d[2]^2 end

-- Its value at theta = 0 by Romberg's extrapolation in theta^2 from h, h/2, ..., and how far that may be off: by the
-- last step of the extrapolation, and by rounding. f' and f cot(theta/2)/2 are off by some 4 u each (of f'(0), which
-- they are near), over f^2; extrapolating doubles that at most.
local function extrapolated(f)
  local row, h = {}, 0.2
  for level = 1, 4 do
    local above = row
    row = { fraction(f, h) }
    for k = 2, level do row[k] = row[k - 1] + (row[k - 1] - above[k - 1])/(4^(k - 1) - 1) end
    h = h/2
  end
  local slope = derivatives(f, 0)[2]
  return row[4], abs(row[4] - row[3]) + 2*8*u/((2*h)^2*slope)
end
theorem("an f that (4) is for: odd, with f'(0) > 0", function()
  for_each(cases, function(case)
    local d = derivatives(case.f, 0)
    -- Each is a sum of what cancels, of the size of its neighbours, by some tens of roundings.
    near(vec(0, 0, 0), vec(d[1], d[3], d[5]), 64*u*math.max(d[2], abs(d[4]), abs(d[6])), "f, f'' and f'''' are 0 at 0")
    holds(d[2] > 0, "f'(0) > 0")
  end)
end)

print "f                    f'(0)  f'''(0)  extrapolated     corrected       printed"
for _, case in ipairs(cases) do
  local d = derivatives(case.f, 0)
  print(("%-18s %7.4f %8.4f %13.9f %13.9f %13.9f"):format(case.name, d[2], d[4], extrapolated(case.f), corrected(d),
    printed(d)))
end
print ""

theorem("as corrected: the limit", function()
  for_each(cases, function(case)
    local measured, off = extrapolated(case.f)
    near(corrected(derivatives(case.f, 0)), measured, off, "extrapolated to theta = 0")
    if case.limit then near(case.limit, corrected(derivatives(case.f, 0)), 4*u, "of the closed form") end
  end)
end)

theorem("the closed forms of the fraction, at any theta", function()
  -- Away from 0, f' and f cot(theta/2)/2 are of size f' (1.5 at most here), and f^2 is 0.005 at least.
  for_all({ theta = any.number(0.15, 2) }, function(case)
    for i = 1, 3 do
      near(cases[i].fraction(case.theta), fraction(cases[i].f, case.theta), 8*u*1.5/0.005, cases[i].name)
    end
  end)
end)

theorem("as printed: another limit, unless f'''(0) = 0", function()
  for_each(cases, function(case)
    local d = derivatives(case.f, 0)
    local measured, off = extrapolated(case.f)
    -- The two constants are f'''(0)/3 f'(0)^2 apart, and the corrected one is right to within `off`.
    near(d[4]/3/d[2]^2, printed(d) - measured, off + 4*u, "as printed: off by f'''(0)/(3 f'(0)^2)")
    if d[4] ~= 0 then holds(abs(printed(d) - measured) > 2*off, "as printed: not the limit") end
  end)
end)

theorem("as printed, without the f before the cotangent: no limit, unless f'(0) = 1", function()
  -- theta cot(theta/2)/2 -> 1, which leaves (f'(0) - 1)/(f'(0) theta)^2 (1 + c theta^2 + ...): four times as much
  -- at half of theta, up to 3 c theta^2; c = (f'''(0)/2 + 1/12)/(f'(0) - 1) - f'''(0)/(3 f'(0)) is 0.6 at most here.
  for i = 2, 3 do
    local function without(theta)
      local d = derivatives(cases[i].f, theta)
      return (d[2] - theta/tan(theta/2)/2)/d[1]^2
    end
    near(4, without(0.01)/without(0.02), 3*0.02^2, "as printed: at half of theta, f = " .. cases[i].name)
  end
end)

theorem("a body follows (4) with f through theta = 0 as it follows (9)", function()
  -- From the identity, so that the limit is what (4) has in place of the fraction.
  local function omega(t) return cos(3*t), t, 1 - t*t end
  local quaternion = evolve { omega = omega, t = { -0.1, 0.1 }, accuracy = 1e-13 }:from(rotation.identity)
  for_each(cases, function(case)
    local run = evolve { omega = omega, t = { -0.1, 0.1 }, equation = "generalized", f = case.f, method = "dop853",
      accuracy = 1e-13 }
    for _, t in ipairs { -0.09, -0.05, 0, 0.1 } do
      near(quaternion(t).rotation, run(t).rotation, 1.25*(quaternion.error_estimate + run.error_estimate) + 4*u,
        "the rotation by (4)")
    end
  end)
end)
