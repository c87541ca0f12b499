-- Figure 10 of the paper: power spectral densities of E for omega = (cos alpha t, sin alpha t, 0), for the periods
-- T = 2 pi/alpha = 40 and pi. Printed are dominant frequencies of "about 0.068 and 0.0925" for T = 40, with "no obvious
-- connection to any of the input values", and periods of "roughly 3 and 53" for T = pi. They are, with
-- Omega = sqrt(1 + alpha^2),
--   f_F = (Omega - alpha)/(4 pi), f_F + 1/T = (Omega + alpha)/(4 pi): 0.068053, 0.093053, and 0.018786, 0.337096,
-- as Q(t) = exp(k alpha t/2) exp((i - alpha k) t/2) Q(0). The quaternion has these alone, and |E| has them strongest; E
-- is a function of the two angles alpha t/2 and Omega t/2, its lines are at whole numbers of f_F and 1/T, and its
-- Fourier coefficients their amplitudes. In E_x, for T = pi, that at 2 f_F is stronger than that at 0.337.
--
--   rotor examples/paper/figure10.lua [figure10.csv]   writes the density of E_x for T = 40 to that file, for T = pi
--                                                    to figure10_pi.csv

local e0, last = vec(1, 1, 1)/sqrt(3), 4200
local q0 = quaternion(0, e0.x/2, e0.y/2, e0.z/2):exp()

local scenes = { { name = "T = 40", period = 40, to = 0.2 }, { name = "T = pi", period = pi, to = 0.4 } }
for _, scene in ipairs(scenes) do
  local alpha = 2*pi/scene.period
  local omega = sqrt(1 + alpha^2)
  scene.alpha, scene.omega = alpha, omega
  scene.low, scene.high = (omega - alpha)/(4*pi), (omega + alpha)/(4*pi)
  scene.run = evolve { omega = spin.turning { vector = { 1, 0, 0 }, about = { 0, 0, 1 }, rate = alpha },
    from = rotation(e0, 1), to = last }
  scene.spectrum = scene.run:spectrum { of = "euler_vector_x" }
  scene.lines = scene.run:frequencies(6, { of = "euler_vector_x" })
  scene.spectrum:plot { to = scene.to, title = "Figure 10: E_x, " .. scene.name, height = 14 }
end
-- Neither figures.lua nor --test has the program, arg[-1], before the script.
local csv = arg[1] or arg[-1] and "figure10.csv"
if csv then
  scenes[1].spectrum:csv(csv)
  scenes[2].spectrum:csv((csv:gsub("%.csv$", "")) .. "_pi.csv")
end

-- j/T + k f_F = ((2 j - k) alpha + k Omega)/(4 pi), of the lines that are to be the strongest, and their names.
local kNames = {
  { "f_F", 0, 1 }, { "drive + f_F", 1, 1 }, { "drive + 2 f_F", 1, 2 }, { "2 f_F", 0, 2 }, { "3 f_F", 0, 3 },
  { "drive", 1, 0 }, { "drive + 3 f_F", 1, 3 },
}

-- The amplitudes of E_x at these, from n x n pairs of angles.
local function amplitudes(scene, n)
  local u = quaternion(0, 1, 0, -scene.alpha)/scene.omega
  local x, turns = {}, {}
  for i = 0, n - 1 do turns[i] = (2*pi*i/n*u):exp()*q0 end
  for i = 0, n - 1 do
    local about = quaternion(cos(2*pi*i/n), 0, 0, sin(2*pi*i/n))
    for l = 0, n - 1 do
      local q = about*turns[l]
      local m = norm { q.x, q.y, q.z }
      x[i*n + l] = 2*atan(m, q.w)*q.x/m
    end
  end
  local list = {}
  for _, line in ipairs(kNames) do
    local name, j, k = line[1], line[2], line[3]
    local re, im = 0, 0
    for i = 0, n - 1 do
      for l = 0, n - 1 do
        local angle = 2*pi*(((2*j - k)*i + k*l) % n)/n
        re, im = re + x[i*n + l]*cos(angle), im + x[i*n + l]*sin(angle)
      end
    end
    list[name] = { frequency = j/scene.period + k*scene.low, amplitude = 2*sqrt(re^2 + im^2)/n^2 }
  end
  return list
end

local function frequency(which, name)
  for i = 1, #scenes[which].lines do
    if scenes[which].lines[i].name == name then return scenes[which].lines[i].frequency end
  end
end
print ""
print(("%-30s %-16s %14s %14s"):format("", "paper", "rotor", "exact"))
for _, row in ipairs {
  { "T = 40: frequency", "about 0.068", frequency(1, "f_F"), scenes[1].low },
  { "        its period", "about 14.7", 1/frequency(1, "f_F"), 1/scenes[1].low },
  { "        frequency", "about 0.0925", frequency(1, "drive + f_F"), scenes[1].high },
  { "        its period", "about 10.8", 1/frequency(1, "drive + f_F"), 1/scenes[1].high },
  { "        the drive", "1/40", frequency(1, "drive"), 1/40 },
  { "T = pi: period", "roughly 53", 1/frequency(2, "f_F"), 1/scenes[2].low },
  { "        period", "roughly 3", 1/frequency(2, "drive + f_F"), 1/scenes[2].high },
} do
  print(("%-30s %-16s %14.10g %14.10g"):format(table.unpack(row)))
end

for _, scene in ipairs(scenes) do
  scene.exact, scene.coarse = amplitudes(scene, 128), amplitudes(scene, 64)
  print("\nlines of E_x, " .. scene.name .. "\n")
  print "name             frequency       exact           amplitude   exact"
  for i = 1, #scene.lines do
    local line = scene.lines[i]
    local exact = scene.exact[line.name]
    print(("%-15s  %.12f  %.12f  %.8f  %.8f"):format(line.name, line.frequency, exact.frequency, line.amplitude,
      exact.amplitude))
  end
end
print ""

theorem("Figure 10: the dominant frequencies are (Omega -+ alpha)/(4 pi)", function()
  for_each({ { scenes[1], 0.068053, 0.093053 }, { scenes[2], 0.018786, 0.337096 } }, function(case)
    local scene = case[1]
    near(case[2], scene.low, 0.5e-6, "(Omega - alpha)/(4 pi)")
    near(case[3], scene.high, 0.5e-6, "(Omega + alpha)/(4 pi)")
    -- The strongest two of |E|, and of the quaternion, which has no others. 1e-8 is what is asked for.
    for _, of in ipairs { "angle", "quaternion_w" } do
      local found = scene.run:frequencies(2, { of = of })
      local low, high = found[1], found[2]
      if low.frequency > high.frequency then low, high = high, low end
      near(scene.low, low.frequency, 1e-8, of .. ", the lower")
      near(scene.high, high.frequency, 1e-8, of .. ", the higher")
      holds(low.name == "f_F" and high.name == "drive + f_F", "their names")
    end
    holds(#scene.run:frequencies(8, { of = "quaternion_w" }) == 2, "the quaternion has two lines only")
  end)
end)

theorem("Figure 10: the lines of E_x are at whole numbers of f_F and 1/T", function()
  for_each(scenes, function(scene)
    near(6, #scene.lines, 0, "how many were asked for")
    for i = 1, #scene.lines do
      local line = scene.lines[i]
      local exact = scene.exact[line.name]
      near(exact.frequency, line.frequency, 1e-8, "frequency")
      -- What the coefficients of half as many angles are off by is more than those are.
      near(exact.amplitude, line.amplitude, line.amplitude_error + abs(exact.amplitude
        - scene.coarse[line.name].amplitude), "amplitude")
    end
  end)
end)

theorem("Figure 10: the peaks of the density are these lines", function()
  for_each(scenes, function(scene)
    local density = scene.spectrum
    local peaks = density:peaks(4)
    for i, peak in ipairs(peaks) do
      local line = scene.lines[i]
      -- The highest sample is within half of their spacing of the line, and the parabola's top of that.
      near(scene.exact[line.name].frequency, peak.frequency, density.frequencies[2], "the four highest, in order")
    end
  end)
end)
