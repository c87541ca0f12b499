-- Lemma 3.3 of the paper, an identity of Gibbs: for any vectors of three dimensions
--   D (A . (B x C)) = B x C (A . D) + C x A (B . D) + A x B (C . D),
-- and what it does in the proof of Theorem 3.2: r = Rot(n, theta) r_b, moved by (5), has r' - omega x r =
-- Q (1 - cos theta)/2 with a Q that it shows to be zero. Lemma and proof hold as printed.

local u = 2^-53  -- one rounding

theorem("the identity, for any four vectors", function()
  -- In lengths of 1: the triple product and each term on the right are some eight roundings of 1 at most.
  for_all({ A = any.direction, B = any.direction, C = any.direction, D = any.direction }, function(v)
    local A, B, C, D = v.A, v.B, v.C, v.D
    near(D*box(A, B, C), cross(B, C)*dot(A, D) + cross(C, A)*dot(B, D) + cross(A, B)*dot(C, D), 4*8*u, "both sides")
  end)
end)

theorem("A, B, C in one plane: the right side is zero, whatever D", function()
  for_all({ A = any.direction, B = any.direction, D = any.direction, b = any.number(-1, 1) }, function(v)
    local A, B, D = v.A, v.B, v.D
    local C = A + v.b*B  -- of length 2 at most
    near(vec(0, 0, 0), cross(B, C)*dot(A, D) + cross(C, A)*dot(B, D) + cross(A, B)*dot(C, D), 2*4*8*u, "the right side")
  end)
end)

local motion = { n = any.direction, theta = any.number(-7, 7), omega = any.direction, rb = any.direction }

theorem("Q of the proof is zero", function()
  for_all(motion, function(m)
    local n, w, rb = m.n, m.omega, m.rb
    local Q = n*dot(rb, cross(w, n)) - cross(w, n)*dot(n, rb) - cross(n, rb)*dot(w, n) - cross(rb, w)*dot(n, n)
    near(vec(0, 0, 0), Q, 4*8*u, "Q")
  end)
end)

theorem("r' as the proof has it is omega x r", function()
  -- Some six terms of eight roundings each, on either side.
  for_all(motion, function(m)
    local n, theta, w, rb = m.n, m.theta, m.omega, m.rb
    local wn, c, s = cross(w, n), cos(m.theta), sin(m.theta)
    local rate = (n*dot(wn, rb) - cross(n, rb)*dot(w, n) + wn*dot(n, rb))*(1 - c)/2
      + (n*dot(w, rb) - rb*dot(w, n))*s + cross(w, rb)*(1 + c)/2
    near(cross(w, rotation(n, theta)*rb), rate, 2*6*8*u, "r'")
  end)
end)
