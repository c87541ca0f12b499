-- Lemma 5.2 of the paper: zeros of M = n sin(theta/2) are isolated. If M(t1) = 0, and omega^(i) is the first derivative
-- of omega that does not vanish there, then with h = t - t1
--   M(t1 + h) = omega^(i)(t1) h^(i+1)/(i+1)! M0(t1)/2 + o(h^(i+1)),
-- so that M is not zero near t1. The proof prints M0'(t1) = omega . M; by [P9] it is M0' = -omega . M/2. Both vanish at
-- t1, and the lemma stands; but with the printed one |M0| would grow beyond 1.

-- A motion with M = 0 at t1, turns counted: omega = w h^i/i! + v h^(i+1)/(i+1)!, |w| = |v| = 1.
local t1 = 1.5
local function factorial(n) return n < 2 and 1 or n*factorial(n - 1) end
local function through_zero(i, w, v, turns)
  local function omega(t)
    local h = t - t1
    return h^i/factorial(i)*w + h^(i + 1)/factorial(i + 1)*v
  end
  local run = evolve { omega = omega, t = { t1 - 1, t1 + 1 }, accuracy = 1e-12 }
  local back = run(t1).rotation:inverse()
  return run:from(rotation(back.axis, back.angle + 2*pi*turns)), omega
end
local function m(state) return vec(state.quaternion.x, state.quaternion.y, state.quaternion.z) end
local function m0(state) return state.quaternion.w end

-- M and M0 are known to half of what the rotation is; the estimate is of first order: a quarter more.
local function known(run) return 1.25/2*run.error_estimate + 1e-15 end

-- The size of the term of the lemma, and what |M| can differ from it. W = integral of |omega| from t1: |M| <= W/2, so
-- |M0(t) - M0(t1)| <= |M|^2 <= W^2/4; [P9] integrated leaves v's part of omega, W^3/24 from M0, W^2/8 from omega x M.
local function size(i, h) return abs(h)^(i + 1)/factorial(i + 1)/2 end
local function rest(i, h)
  local next_term = size(i + 1, h)
  local length = 2*(size(i, h) + next_term)
  return next_term + length^2/8 + length^3/24
end

print "|M(t1 + h)|/h^(i+1) for omega^(i)(t1) = (1, 0, 0) the first that does not vanish:\n"
print "h          i = 0      i = 1      i = 2      i = 3"
local runs = {}
for i = 0, 3 do runs[i] = through_zero(i, vec(1, 0, 0), vec(0, 0.6, 0.8), 0) end
for k = 0, 6, 2 do
  local line = ("1/%-4d"):format(2^k)
  for i = 0, 3 do line = line .. ("%11.6f"):format(norm(m(runs[i](t1 + 2^-k)))*2^(k*(i + 1))) end
  print(line)
end
print(("limit %11.6f%11.6f%11.6f%11.6f\n"):format(size(0, 1), size(1, 1), size(2, 1), size(3, 1)))

local function for_all_zeros(check)
  for_all({ i = any.integer(0, 3), w = any.direction, v = any.direction, turns = any.integer(-1, 1) }, function(case)
    local run, omega = through_zero(case.i, case.w, case.v, case.turns)
    check(run, case, omega)
  end, { n = 30, seed = 52 })
end

theorem("Lemma 5.2: the first term of M at a zero", function()
  for_all_zeros(function(run, case)
    local sign = m0(run(t1))
    near(1, abs(sign), known(run), "|M0(t1)|")
    for k = 0, 8, 2 do
      for _, h in ipairs { 2^-k, -2^-k } do
        local term = size(case.i, h)*(h < 0 and (-1)^(case.i + 1) or 1)*sign*case.w
        near(0, norm(m(run(t1 + h)) - term), rest(case.i, h) + known(run), ("M less its term, h = +-1/%d"):format(2^k))
      end
    end
  end)
end)

theorem("Lemma 5.2: so the zero is isolated", function()
  for_all_zeros(function(run, case)
    local i = case.i
    -- Up to this distance the term is greater than all the rest, which grows faster with h.
    local delta = 1
    while rest(i, delta) >= size(i, delta) do delta = delta/2 end
    for k = 1, 100 do
      for _, h in ipairs { k*delta/100, -k*delta/100 } do
        holds(norm(m(run(t1 + h))) >= size(i, h) - rest(i, h) - known(run), "|M| is at least the term less the rest")
      end
    end
    local zeros = {}
    for _, crossing in ipairs(run.crossings) do
      if abs(crossing.t - t1) < delta then zeros[#zeros + 1] = crossing.t end
    end
    near(1, #zeros, 0, "zeros that the run finds within it")
    -- Where |M|, at least half the term, is less than what is known of it, a zero cannot be told.
    near(t1, zeros[1], (4*factorial(i + 1)*known(run))^(1/(i + 1)), "when")
  end)
end)

-- Integral from t1 to t1 + 1 by Gauss-Legendre, three points in each of 100 parts: f^(6)/(2016000 100^6), 5e-19 of it.
local function integral(f)
  local sum = 0
  for part = 0, 99 do
    local function at(x) return f(t1 + (part + 0.5 + x/2)/100) end
    sum = sum + (5*at(-sqrt(0.6)) + 8*at(0) + 5*at(sqrt(0.6)))/18
  end
  return sum/100
end

theorem("M0' is -omega . M/2, not omega . M as printed", function()
  for_all_zeros(function(run, _, omega)
    local start, growth = m0(run(t1)), m0(run(t1 + 1)) - m0(run(t1))
    local work = integral(function(t) return dot(omega(t), m(run(t))) end)
    near(-work/2, growth, 2*known(run), "the growth of M0 in [t1, t1 + 1]")
    holds(abs(start + work) > 1 + 2*known(run), "as printed: |M0(t1 + 1)| would be above 1")
    near(1.5*abs(work), abs(work - growth), 2*known(run), "as printed: off by 3/2 of the integral")
  end)
end)

theorem("the hypothesis: with every derivative 0, M can stay 0", function()
  -- Still for 1 <= t <= 2, when the body is where it started.
  local omega = spin.piecewise { { 0, 0, 1 }, 1, { 0, 0, 0 }, 2, { 1, 0, 0 } }
  local run = evolve { omega = omega, from = rotation({ 0, 0, 1 }, -1), to = 3 }
  for_each({ 1, 1.25, 1.5, 1.75, 2 }, function(t) near(0, norm(m(run(t))), known(run), "M") end)
end)
