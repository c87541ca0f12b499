-- commensurate: the list, its text and file, what is refused. What it lists is shown to close in
-- examples/paper/commensurate.lua.
package.path = arg[0]:match "^(.*)/[^/]*$" .. "/?.lua;" .. package.path
local support = require "support"
local equal, contains, fits = support.equal, support.contains, support.fits

-- The fractions q/p from 1/2 to 3/5, ever nearer to sin(atan(0.76)) = 0.605.
local list = commensurate(0.76, { most = 10 })
equal(#list, 3)
equal(table.concat({ list[1].p, list[1].q, list[2].p, list[2].q, list[3].p, list[3].q }, " "), "2 1 3 2 5 3")
local last = list[3]
equal(last.alpha, 0.75)
near(8*pi/3, last.T, 2e-15, "T, of two roundings")
near(-0.01, last.off, 1e-16, "alpha less the wish")
equal(last.attitude_period, 3)
equal(last.orbit_period, 3)
equal(list[1].attitude_period, 1)
equal(list[1].orbit_period, 2)

-- As near as any, by all of them.
for _, wish in ipairs { 1e-9, 0.03, 0.9, 4, 100 } do
  local least = math.huge
  for p = 2, 30 do
    for q = 1, p - 1 do least = math.min(least, abs(q/sqrt(p*p - q*q) - wish)) end
  end
  local found = commensurate(wish, { most = 30 })
  -- Two roundings of alpha < 8 and of the difference < 100.
  near(least, abs(found[#found].off), 2e-14, "the nearest to " .. wish)
  for i = 2, #found do holds(abs(found[i].off) < abs(found[i - 1].off), "ever nearer") end
end
local paper = commensurate(pi/20)
equal(paper[#paper].p, 58)
equal(paper[#paper].q, 9)
equal(paper[#paper].orbit_period, 18)

-- The text.
local text = tostring(list)
fits(text)
contains(text, "       5        3           0.75  -1.0e-02    8.37758041          3          3")
local long = commensurate(1e6, { most = 1000 })
equal(#long, 999)
fits(tostring(long))
contains(tostring(long), "...  and 979 more, farther off")
equal(select(2, tostring(long):gsub("\n", "")), 22)

-- The file.
local file = os.tmpname()
list:csv(file)
local read = read_csv(file)
os.remove(file)
equal(#read.p, 3)
equal(read.alpha[1], list[1].alpha)
equal(read.orbit_period[1], 2)
equal(read.off[3], last.off)

-- What is wrong is refused.
local function refused(pattern, ...)
  local ended, message = pcall(commensurate, ...)
  equal(ended, false, "an error is expected")
  contains(message, "commensurate: " .. pattern)
end
refused("wish: expected an alpha above 0, up to 1e6, got nil")
refused("wish: expected an alpha above 0, up to 1e6, got 0.0", 0.0)
refused("wish: expected an alpha above 0, up to 1e6, got nan", 0/0)
refused('wish: expected an alpha above 0, up to 1e6, got "1"', "1")
refused("expected options in braces, {most = 100}, got 50", 1, 50)
refused("unknown option 'msot'; did you mean 'most'?", 1, { msot = 50 })
refused("most: expected a whole number, 2 to 1e6, got 1", 1, { most = 1 })
refused("most: expected a whole number, 2 to 1e6, got 2.5", 1, { most = 2.5 })
refused("most: expected a whole number, 2 to 1e6, got 1000001", 1, { most = 1000001 })
refused('most: expected a whole number, 2 to 1e6, got "10"', 1, { most = "10" })
contains(select(2, pcall(list.csv, "x.csv")), "csv: before the colon")
