-- A point of the body, B, for omega = (cos alpha t, sin alpha t, 0), T = 2 pi/alpha = 40: the paper says that "B should
-- trace out a torus", and shows it beside omega and n = E/|E| in animations. Corrected: |B| stays 1, and B fills a band
-- of the sphere. With Omega = sqrt(1 + alpha^2) and u = (i - alpha k)/Omega, B turns about u at the rate Omega, and u
-- about k at the rate alpha. So from r = B(0), with what it has along u, s = r . u, and across, p = |r - s u|,
--   B_z is between -s alpha/Omega - p/Omega and -s alpha/Omega + p/Omega,
--   B_x has the lines alpha/(2 pi), (Omega -+ alpha)/(2 pi), of amplitudes |s|/Omega, p (1 +- alpha/Omega)/2.
-- Both frequencies beside the drive are twice those of E, f_F and f_F + 1/T, less or more a drive.
--
--   rotor examples/paper/body_point.lua [body_point.csv]   writes t, B, omega and n, the axis, until
--                                                        t = 400 to that file

local alpha = 2*pi/40
local omega = sqrt(1 + alpha^2)
local last = 4200
-- The point that is at i when the body is not rotated: B is the first column of the matrix.
local run = evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = alpha },
  from = rotation({ 1, 1, 1 }, 1), to = last }
local function body_point(state)
  local m = state.matrix
  return vec(m[1][1], m[2][1], m[3][1])
end

-- B(t) by Rodrigues' formula, twice.
local u, k = vec(1, 0, -alpha)/omega, vec(0, 0, 1)
local function turned(v, axis, angle)
  return cos(angle)*v + sin(angle)*cross(axis, v) + (1 - cos(angle))*dot(axis, v)*axis
end
local r = turned(vec(1, 0, 0), vec(1, 1, 1)/sqrt(3), 1)
local function exact(t) return turned(turned(r, u, omega*t), k, alpha*t) end

-- alpha t and Omega t are rounded by 3 units each here, and in the run. The run's own estimate is of first order: a
-- quarter more.
local function known(t) return 1.25*run.error_estimate + 2*3*2^-53*(alpha + omega)*t + 4e-15 end

local s = dot(r, u)
local p = norm(r - s*u)
local low, high = (-s*alpha - p)/omega, (-s*alpha + p)/omega

local early = {}
for i = 0, 400 do early[i + 1] = i/4 end
run:sphere { point = r, times = early }
run:strobe(1):plot("matrix_11", "matrix_31", { title = "B to t = 4200: B_z over B_x", height = 14 })
local density = run:spectrum { of = "matrix_11" }
density:plot { to = 0.3, title = "B_x", height = 14 }
local lines = run:frequencies(3, { of = "matrix_11" })

-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "body_point.csv"
if csv then
  local data = { t = {}, B = {}, omega = {}, axis = {} }
  for i = 1, 4001 do
    local state = run((i - 1)/10)
    data.t[i], data.B[i], data.omega[i], data.axis[i] = state.t, body_point(state), state.omega, state.axis
  end
  write_csv(csv, data, { columns = { "t", "B", "omega", "axis" } })
end

local named = {
  { "drive", alpha/(2*pi), abs(s)/omega, 0.025 },
  { "2 f_F", (omega - alpha)/(2*pi), p*(1 + alpha/omega)/2, 0.136106 },
  { "2 drive + 2 f_F", (omega + alpha)/(2*pi), p*(1 - alpha/omega)/2, 0.186106 },
}

print "\npaper: \"B should trace out a torus\", no numbers\n\nlines of B_x\n"
print "                 rotor                           rotor"
print "name             frequency       exact           amplitude   exact"
for i, line in ipairs(named) do
  print(("%-15s  %.12f  %.12f  %.8f  %.8f"):format(lines[i].name, lines[i].frequency, line[2], lines[i].amplitude,
    line[3]))
end
print ""

local times = {}
for t = 0, last do times[t + 1] = t end

theorem("B(t) is that of the closed form, on the sphere", function()
  for_each(times, function(t)
    local b = body_point(run(t))
    near(exact(t), b, known(t), "B(t)")
    -- Each of three entries by some four roundings, from a quaternion that is rounded.
    near(1, norm(b), (sqrt(3)*4 + 4)*2^-53, "|B|")
  end)
end)

theorem("B fills a band of the sphere", function()
  local least, most, fields, count = 1, -1, {}, 0
  for t = 0, last, 0.1 do
    local b = body_point(run(t))
    least, most = math.min(least, b.z), math.max(most, b.z)
    local field = floor((atan(b.y, b.x)/pi + 1)*6 % 12)*6 + math.min(5, floor(6*(b.z - low)/(high - low)))
    if not fields[field] then fields[field], count = true, count + 1 end
  end
  -- B_z is a cosine of frequency Omega: 0.1 apart, its greatest is met to (Omega 0.05)^2/2 of p/Omega.
  local off = p/omega*(0.05*omega)^2/2 + known(last)
  near(low, least, off, "the least B_z of 42001 samples")
  near(high, most, off, "the greatest")
  holds(low - known(last) <= least and most <= high + known(last), "all are in the band")
  near(72, count, 0, "fields of the band, 12 by 6, in which B comes")
end)

theorem("B_x has three lines, and no others", function()
  local peaks = density:peaks(3)
  for_each(named, function(line, i)
    near(line[4], line[2], 0.5e-6, "the frequency, as known")
    near(line[2], lines[i].frequency, 1e-8, "the frequency, as found")
    near(line[3], lines[i].amplitude, lines[i].amplitude_error + 2^-52, "the amplitude")
    holds(lines[i].name == line[1], "its name")
    near(line[2], peaks[i].frequency, density.frequencies[2], "the peak of the density")
  end)
  near(3, #run:frequencies(6, { of = "matrix_11" }), 0, "how many stand out")
end)
