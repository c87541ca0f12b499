-- luacheck for lua/, examples/ and tests/: the names below are rotor's own beside those of Lua 5.4.
std = "lua54"
max_line_length = 120
cache = false

-- A script may give `ans` a value, as the terminal does.
globals = { "ans" }

read_globals = {
  "rotor",
  -- numbers and jets
  "pi", "deg", "abs", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt",
  "floor", "ceil",
  -- vectors
  "vec", "dot", "cross", "norm", "unit", "box", "det", "orientation", "permutation_sign",
  -- operators
  "matrix", "outer", "skew", "axial", "orthonormal_basis", "proper_orthogonal",
  -- rotations
  "rotation", "quaternion", "slerp", "angular_velocity", "rotation_rates", "chain", "commute", "fit_rigid", "mean",
  "is_rigid", "continuous_quaternions", "spherical_triangle", "draw_sphere",
  -- motion
  "spin", "evolve", "commensurate", "tradeoff", "compare_charts", "read_csv", "write_csv", "plot", "spectrum",
  -- scripted tests
  "theorem", "near", "holds", "fails", "for_each", "for_all", "given", "any",
  -- the terminal
  "help", "conventions", "precision",
}

-- A to-be-closed variable is used by being there.
ignore = { "211/_.+" }
