-- Figure 8 of the paper: the Lyapunov exponents of E for omega = (cos alpha t, sin alpha t, 0), T = 2 pi/alpha = 40, over
-- t, down to "about 10^-5" after 10^5 steps. From this it is concluded that they are 0 and the motion not chaotic.
-- They are 0 for every omega(t), and need no experiment: Q(t) = U(t) Q(0) is an isometry. What is plotted is E's measure
-- of distance, s = (theta/2)/sin(theta/2) as long across n as that of the attitudes: with S(E) = n n' + s (1 - n n')
--   dE(t)/dE(0) = S(E(t)) R S(E(0))^-1,  R a rotation,
-- and the largest exponent at t is between -log s(theta(0))/t and log s(theta(t))/t: it falls as 1/t.
--
--   rotor examples/paper/figure8.lua figure8.csv     also writes the three exponents over t to that file

local alpha = 2*pi/40
local e0, last = vec(1, 1, 1)/sqrt(3), 1e5
local run = evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = alpha },
  from = rotation(e0, 1), to = last }

-- [P15] in closed form, from any E(0).
local function exact(e, t)
  local q0 = quaternion(0, e.x/2, e.y/2, e.z/2):exp()
  local q = (t/2*quaternion(0, 0, 0, alpha)):exp()*(t/2*quaternion(0, 1, 0, -alpha)):exp()*q0
  local m = vec(q.x, q.y, q.z)
  return 2*atan(norm(m), q.w)*unit(m)
end

-- The three exponents at t, largest first, from the derivative of the closed form, by differences of fourth order, which
-- know of no isometry: the roots of the squares of the singular values' equation.
local function exponents(t, h)
  local d = {}
  for i, direction in ipairs { vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1) } do
    local function e(x) return exact(e0 + x*direction, t) end
    d[i] = (8*(e(h) - e(-h)) - (e(2*h) - e(-2*h)))/(12*h)
  end
  local g, trace = {}, 0
  for i = 1, 3 do
    g[i] = { dot(d[i], d[1]), dot(d[i], d[2]), dot(d[i], d[3]) }
    trace = trace + g[i][i]
  end
  local p, scaled = 0, {}
  for i = 1, 3 do
    for j = 1, 3 do p = p + (g[i][j] - (i == j and trace/3 or 0))^2 end
  end
  p = sqrt(p/6)
  for i = 1, 3 do
    local row = {}
    for j = 1, 3 do row[j] = (g[i][j] - (i == j and trace/3 or 0))/p end
    scaled[i] = row
  end
  local third = acos(math.max(-1, math.min(1, det(scaled)/2)))/3
  local list = {}
  for i, turn in ipairs { 0, -2*pi/3, 2*pi/3 } do list[i] = log(trace/3 + 2*p*cos(third + turn))/(2*t) end
  return list
end
for _,t in ipairs{10,1000,2000,1e4,1e5} do
local c=os.clock()
local l = run:lyapunov{times={t}}
print(t,"exact",table.concat(l.exponents," "),os.clock()-c)
for _,h in ipairs{0.01,0.004,0.002,0.001} do print(h,table.concat(exponents(t,h)," ")) end
end
c=os.clock()
local l = run:lyapunov{times={1e3,2e3,1e4,1e5},method="qr"}
for i=1,4 do print(table.concat(l.history[i]," ")) end
print(os.clock()-c, l.bridged,#l.singular)
local l = run:lyapunov{n=100001,method="qr"}
print(table.concat(l.exponents," "),os.clock()-c, l.bridged,#l.singular,l.weighted,l.weighted_error,l.isometry)
for _,n in ipairs{1e4,2e4,50000,200000} do local l = run:lyapunov{n=n} print(n,l.weighted) end
