-- Euclidean vector spaces: orientation, the cross product, the box product, the determinant of an operator
-- (section 1 of the notes on rotation). In n dimensions a vector is a list of n numbers in a right-handed basis.

local function random_vector(n)
  local v = {}
  for i = 1, n do v[i] = math.random(-9, 9) end
  return v
end

local function random_list(n)
  local list = {}
  for i = 1, n do list[i] = random_vector(n) end
  return list
end

local function inner(a, b)
  local sum = 0
  for i = 1, #a do sum = sum + a[i]*b[i] end
  return sum
end

-- The operator with the rows of T, applied to a.
local function apply(T, a)
  local image = {}
  for i, row in ipairs(T) do image[i] = inner(row, a) end
  return image
end

math.randomseed(1)
print "In every dimension, integers at random:\n"
print " n  box product     det T         box of the images"
local images_agree, perpendicular, box_is_dot = true, true, true
for n = 2, 8 do
  local a, T = random_list(n), random_list(n)
  local images = {}
  for i = 1, n do images[i] = apply(T, a[i]) end
  print(("%2d  %-14.0f  %-12.0f  %.0f"):format(n, box(table.unpack(a)), det(T), box(table.unpack(images))))
  -- Whole numbers up to 2^53 are exact; the products for n > 5 may be larger, so they are compared by their ratio.
  local ratio = det(T)*box(table.unpack(a))/box(table.unpack(images))
  images_agree = images_agree and abs(ratio - 1) <= 4*2^-53
  local product = cross(table.unpack(a, 2))
  for i = 2, n do perpendicular = perpendicular and inner(a[i], product) == 0 end
  box_is_dot = box_is_dot and inner(a[1], product) == box(table.unpack(a))
end
print ""

theorem("(1), (2): cross(a2, ..., an) and the box product, n = 2 to 8", function()
  holds(perpendicular, "cross is perpendicular to a2 ... an")
  holds(box_is_dot, "[a1, ..., an] = a1 . cross(a2, ..., an)")
  near({ 4, -3 }, cross { 3, 4 }, 0, "in the plane: (a2, -a1)")
  near(vec(-3, 6, -3), cross({ 1, 2, 3 }, { 4, 5, 6 }), 0, "in space: a x b")
  fails(function() return cross({ 1, 2, 3 }, { 1, 2 }) end, "wrong sizes are an error", "n %- 1 vectors of n numbers")
end)

theorem("(3): det T [a1, ..., an] = [T a1, ..., T an]", function()
  holds(images_agree, "n = 2 to 8")
  near(1, det(rotation({ 1, 2, 3 }, 1).matrix), 1e-15, "of a rotation operator")
end)

theorem("Orientation", function()
  near(1, orientation({ 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }), 0, "the standard basis")
  near(-1, orientation({ 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }), 0, "e1 and e2 interchanged")
  -- Two bases have the same orientation iff the determinant of [ai . bj] is positive.
  local same = true
  for _ = 1, 100 do
    local a, b, products = random_list(4), random_list(4), {}
    for i = 1, 4 do
      products[i] = {}
      for j = 1, 4 do products[i][j] = dot(a[i], b[j]) end
    end
    same = same and (det(products) > 0) == (orientation(table.unpack(a)) == orientation(table.unpack(b)))
  end
  holds(same, "det [ai . bj] > 0 iff they are the same: 100 pairs")
  fails(function() return orientation({ 1, 2 }, { 2, 4 }) end, "dependent vectors have none", "dependent")
end)

theorem("The box product does not change under even permutations", function()
  local a = random_list(4)
  local all = true
  local function visit(order)
    if #order == 4 then
      local permuted = {}
      for i, k in ipairs(order) do permuted[i] = a[k] end
      all = all and box(table.unpack(permuted)) == permutation_sign(order)*box(table.unpack(a))
      return
    end
    for k = 1, 4 do
      if not (" " .. table.concat(order, " ")):find(" " .. k) then
        visit { k, table.unpack { order[1], order[2], order[3] } }
      end
    end
  end
  visit {}
  holds(all, "and changes sign under odd ones: all 24 of 4 vectors")
end)
