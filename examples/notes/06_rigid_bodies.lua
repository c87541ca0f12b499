-- Notes, section 6: rigid bodies.
--
-- A body is rigid if its particles keep their distances [N16]. Then they keep the inner products of their
-- differences [N17], and every configuration comes from the reference configuration by
--   x = Q X + c   with a proper orthogonal Q [N18, N19].

-- A body of six particles, and where they are after a motion.
local X = { vec(0, 0, 0), vec(2, 0, 0), vec(0, 1, 0), vec(0, 0, 3), vec(1, 1, 1), vec(-1, 0.5, 2) }
local R, c = rotation({ 1, 2, 3 }, 1), vec(5, -1, 0.5)
local x = {}
for i, p in ipairs(X) do x[i] = R*p + c end

-- Coordinates of at most 8 are rounded by 4.4e-16 each, in x and once more in what is computed from it.
local tolerance = 4e-15

theorem("[N16, N17] distances and inner products are kept", function()
  local distance, product = 0, 0
  for i = 1, #X do
    for j = 1, #X do
      distance = math.max(distance, abs(norm(x[i] - x[j]) - norm(X[i] - X[j])))
      product = math.max(product, abs(dot(x[1] - x[i], x[1] - x[j]) - dot(X[1] - X[i], X[1] - X[j])))
    end
  end
  near(0, distance, tolerance, "|x - y| = |X - Y|, all pairs")
  near(0, product, 7*tolerance, "(x - y).(x - z) = (X - Y).(X - Z)")  -- of lengths up to 3.7
  holds(is_rigid(X, x), "is_rigid(X, x)")
end)

-- The frame of the body: P + l E_i goes to p + l e_i. (Printed: P + l e_i.)
local l = 0.125
local E = { vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1) }
local P, p = X[5], x[5]
local e = {}
for i = 1, 3 do e[i] = ((R*(P + l*E[i]) + c) - p)/l end

theorem("The current frame is orthonormal and right-handed", function()
  for i = 1, 3 do
    for j = i, 3 do near(i == j and 1 or 0, dot(e[i], e[j]), 8*tolerance, ("e%d . e%d"):format(i, j)) end
  end
  near(1, box(e[1], e[2], e[3]), 8*tolerance, "[e1, e2, e3]")
  local printed = norm((P + l*e[1]) - (R*(P + l*E[1]) + c))
  holds(printed > 1, ("P + l e1, as printed, misses that point, by %.2f"):format(printed))
end)

-- [N18] Q = e_i (x) E_i: the matrix whose columns are the e_i, the E_i being the standard basis.
local Q = {}
for i = 1, 3 do Q[i] = { e[1][i], e[2][i], e[3][i] } end

theorem("[N18] Q = e_i (x) E_i is the rotation; its transpose is E_i (x) e_i", function()
  near(R.matrix, Q, 8*tolerance, "Q")
  local transposed = R:inverse().matrix
  near(Q[1][2], transposed[2][1], 8*tolerance, "Q^T = E_i (x) e_i")
  holds(abs(Q[1][2] - transposed[1][2]) > 0.5, "Q^T = e_i (x) E_i, as printed, is Q again: wrong")
  -- det Q = [Q E1, Q E2, Q E3]/[E1, E2, E3]; printed with [Q e1, Q e2, Q e3] = [E1, E2, E3].
  near(1, box(R*E[1], R*E[2], R*E[3])/box(E[1], E[2], E[3]), tolerance, "det Q")
  holds(norm(R*e[1] - E[1]) > 0.5, "Q e1 is not E1: Q takes E1 to e1")
end)

-- [N19] The other way: Q and c from the particles alone.
local fit = fit_rigid(X, x)
print(tostring(fit) .. "\n")

theorem("[N19] x = Q X + c: the motion from the particles", function()
  near(R, fit.rotation, tolerance, "Q")
  near(c, fit.translation, tolerance, "c")
  near(0, fit.rms, tolerance, "rms of x - (Q X + c)")
  holds(fit.unique, "unique")
end)

theorem("Distances alone do not tell a body from its mirror image: continuity does", function()
  local mirrored = {}
  for i, v in ipairs(x) do mirrored[i] = vec(v.x, v.y, -v.z) end
  near(norm(x[2] - x[6]), norm(mirrored[2] - mirrored[6]), tolerance, "the distances agree")
  local rigid, why = is_rigid(X, mirrored)
  print("is_rigid: " .. why .. "\n")
  holds(not rigid, "no motion leads there")
  holds(fit_rigid(X, mirrored).rms > 0.1, "the best proper Q misses")
end)

theorem("How many particles determine Q: three that are not on a line", function()
  holds(fit_rigid({ X[1], X[2], X[3] }, { x[1], x[2], x[3] }).unique, "three")
  local two = fit_rigid({ X[1], X[2] }, { x[1], x[2] })
  holds(not two.unique, "two leave the turn about their line free")
  near(x[2] - x[1], two.rotation*(X[2] - X[1]), 2*tolerance, "the line is where it should be")
end)
