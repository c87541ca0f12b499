// Functions of numbers and of jets, the arithmetic of jets, and the derivatives of a run's omega.
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "spin/jet.hpp"

namespace rotor::script {
namespace {

bool is_jet(lua_State* L, int index) { return test_user_value<Jet>(L, index) != nullptr; }

// The functions of Lua's library math for numbers, to the bit and at its speed, and for jets. What
// is neither is refused in Lua's words.

template <double (*Function)(double), Jet (*OfJet)(const Jet&)>
int elementary(lua_State* L) {
  int is_number = 0;
  const double x = lua_tonumberx(L, 1, &is_number);
  if (is_number == 0) return is_jet(L, 1) ? bound<OfJet>(L) : luaL_typeerror(L, 1, "number");
  lua_pushnumber(L, Function(x));
  return 1;
}

template <double (*One)(double), double (*Two)(double, double), auto OfJets>
int one_or_two(lua_State* L) {
  int first_is = 0;
  int second_is = 1;
  const double x = lua_tonumberx(L, 1, &first_is);
  const bool alone = lua_isnoneornil(L, 2);
  const double y = alone ? 0 : lua_tonumberx(L, 2, &second_is);
  if (first_is != 0 && second_is != 0) {
    lua_pushnumber(L, alone ? One(x) : Two(x, y));
    return 1;
  }
  if (is_jet(L, 1) || is_jet(L, 2)) return bound<OfJets>(L);
  return luaL_typeerror(L, first_is == 0 ? 1 : 2, "number");
}

double atan_of_number(double y) { return std::atan2(y, 1.0); }
Jet atan_of_jets(const Jet& y, const std::optional<Jet>& x) {
  return atan(y, x.value_or(Jet::constant(1)));
}
Jet log_of_jets(const Jet& x, const std::optional<Jet>& base) {
  return base ? log(x, *base) : log(x);
}

int abs_entry(lua_State* L) {
  if (lua_isinteger(L, 1)) {
    const lua_Integer n = lua_tointeger(L, 1);
    // The opposite of the least integer is itself, as in Lua.
    lua_pushinteger(L, n < 0 ? static_cast<lua_Integer>(0 - static_cast<lua_Unsigned>(n)) : n);
    return 1;
  }
  return elementary<std::fabs, rotor::abs>(L);
}

// As an integer where it is one.
Results push_whole(lua_State* L, double x) {
  lua_Integer n = 0;
  if (lua_numbertointeger(x, &n)) {
    lua_pushinteger(L, n);
  } else {
    lua_pushnumber(L, x);
  }
  return {1};
}

template <double (*OfJet)(const Jet&)>
Results push_whole_of_jet(lua_State* L) {
  return push_whole(L, OfJet(argument<Jet>(L, 1)));
}

template <double (*Function)(double), double (*OfJet)(const Jet&)>
int whole(lua_State* L) {
  if (lua_isinteger(L, 1)) {
    lua_settop(L, 1);
    return 1;
  }
  int is_number = 0;
  const double x = lua_tonumberx(L, 1, &is_number);
  if (is_number != 0) return push_whole(L, Function(x)).count;
  return is_jet(L, 1) ? bound<push_whole_of_jet<OfJet>>(L) : luaL_typeerror(L, 1, "number");
}

Jet negative(const Jet& x, const Jet& /*again*/) { return -x; }
Jet sum(const Jet& x, const Jet& y) { return x + y; }
Jet difference(const Jet& x, const Jet& y) { return x - y; }
Jet product(const Jet& x, const Jet& y) { return x * y; }
Jet quotient(const Jet& x, const Jet& y) { return x / y; }
bool less(const Jet& x, const Jet& y) { return x.c[0] < y.c[0]; }
bool less_or_equal(const Jet& x, const Jet& y) { return x.c[0] <= y.c[0]; }
bool equal(const Jet& x, const Jet& y) { return x.c[0] == y.c[0]; }

// "jet 0.841471, derivatives 0.540302 -0.841471": up to the last that is not zero.
std::string text_of_jet(const Jet& x) {
  std::size_t last = Jet::kOrder;
  while (last > 0 && x.c[last] == 0) --last;
  std::string result = "jet " + text(x.c[0], 6) + (last > 0 ? ", derivatives" : ", constant");
  for (std::size_t k = 1; k <= last; ++k) result += " " + text(x.derivative(k), 6);
  return result;
}

std::vector<Vector> derivatives(const SharedRun& run, double t) {
  run->attitude(t);  // refuses a t outside
  const VectorJet omega = run->driver().jet(t);
  std::vector<Vector> list;
  list.reserve(Jet::kOrder + 1);
  for (std::size_t k = 0; k <= Jet::kOrder; ++k) {
    list.emplace_back(omega[0].derivative(k), omega[1].derivative(k), omega[2].derivative(k));
  }
  return list;
}

constexpr Entry kFunctions[] = {
    {"sin", elementary<std::sin, rotor::sin>, "sin(x) -> number", "math.sin, of a number or a jet.",
     "sin(0) --> 0.0"},
    {"cos", elementary<std::cos, rotor::cos>, "cos(x) -> number", "math.cos, of a number or a jet.",
     "cos(0) --> 1.0"},
    {"tan", elementary<std::tan, rotor::tan>, "tan(x) -> number", "math.tan, of a number or a jet.",
     "tan(0) --> 0.0"},
    {"asin", elementary<std::asin, rotor::asin>, "asin(x) -> number",
     "math.asin, of a number or a jet.", "asin(0) --> 0.0"},
    {"acos", elementary<std::acos, rotor::acos>, "acos(x) -> number",
     "math.acos, of a number or a jet.", "acos(1) --> 0.0"},
    {"atan", one_or_two<atan_of_number, std::atan2, atan_of_jets>, "atan(y, x) -> number",
     "math.atan, of numbers or jets: the angle of the point (x, y), of y/1 without x.",
     "atan(0) --> 0.0"},
    {"exp", elementary<std::exp, rotor::exp>, "exp(x) -> number", "math.exp, of a number or a jet.",
     "exp(0) --> 1.0"},
    {"log", one_or_two<std::log, log_to_base, log_of_jets>, "log(x, base) -> number",
     "math.log, of numbers or jets: the natural logarithm without a base.", "log(1) --> 0.0"},
    {"sqrt", elementary<std::sqrt, rotor::sqrt>, "sqrt(x) -> number",
     "math.sqrt, of a number or a jet.", "sqrt(4) --> 2.0"},
    {"abs", abs_entry, "abs(x) -> number", "math.abs, of a number or a jet.", "abs(-3) --> 3"},
    {"floor", whole<std::floor, rotor::floor>, "floor(x) -> number",
     "math.floor, of a number or a jet: of a jet too it gives a number, as it does not vary "
     "between "
     "its jumps.",
     "floor(2.7) --> 2"},
    {"ceil", whole<std::ceil, rotor::ceil>, "ceil(x) -> number",
     "math.ceil, of a number or a jet: of a jet too it gives a number, as it does not vary between "
     "its jumps.",
     "ceil(2.2) --> 3"},
};

#define ROTOR_JET(z) \
  "evolve{omega = function(t) return 0, 0, " z " end, to = 2}:derivatives(1)[2].z"

constexpr Entry kMethods[] = {
    {"derivatives", bound<derivatives>, "run:derivatives(t) -> table",
     "omega at t, its first derivative, and so on to the eighth: a list of nine vecs, in the frame "
     "in which omega is given. They are exact but for rounding: a function is called with a jet, a "
     "number that carries its derivatives, in place of t, and what comes is held against its "
     "values at t and near t. Where there are none (a kink, a jump, a function that does not take "
     "jets) the error says why.",
     "evolve{omega = function(t) return 0, 0, t^3 end, to = 2}:derivatives(2)[3] --> vec(0.0, 0.0, "
     "12.0)"},
};

constexpr Entry kOperators[] = {
    {"__add", bound<sum>, "x + y -> jet",
     "Of jets and numbers. A jet is what a function gets in place of t where its derivatives are "
     "asked for: its value and eight derivatives. + - * / ^ // % and sin, cos, ... take jets.",
     ROTOR_JET("1 + t") " --> 1.0"},
    {"__sub", bound<difference>, "x - y -> jet", "Of jets and numbers.",
     ROTOR_JET("1 - t") " --> -1.0"},
    {"__mul", bound<product>, "x * y -> jet", "Of jets and numbers.", ROTOR_JET("t*t") " --> 2.0"},
    {"__div", bound<quotient>, "x / y -> jet", "Of jets and numbers.",
     ROTOR_JET("1/(1 + t)") " --> -0.25"},
    {"__pow", bound<rotor::pow>, "x ^ y -> jet",
     "Of jets and numbers: at x = 0 for whole y, 0 or more.", ROTOR_JET("t^3") " --> 3.0"},
    {"__mod", bound<rotor::mod>, "x % y -> jet",
     "Of jets and numbers: the rest of x // y, except where that jumps.",
     ROTOR_JET("(t + 0.5) % 3") " --> 1.0"},
    {"__idiv", bound<floor_divide>, "x // y -> number",
     "Of jets and numbers: a number, as it does not vary between its jumps.",
     ROTOR_JET("t*((t + 6) // 5)") " --> 1.0"},
    {"__unm", bound<negative>, "-x -> jet", "The opposite.", ROTOR_JET("-t") " --> -1.0"},
    {"__lt", bound<less>, "x < y -> boolean", "Of the values of jets and numbers.",
     ROTOR_JET("t < 3 and 2*t or t") " --> 2.0"},
    {"__le", bound<less_or_equal>, "x <= y -> boolean", "Of the values of jets and numbers.",
     ROTOR_JET("t <= 3 and 2*t or t") " --> 2.0"},
    {"__eq", bound<equal>, "x == y -> boolean",
     "Of the values of two jets. A jet is equal to no number, whatever its value: write x <= 1, "
     "not "
     "x == 1.",
     ROTOR_JET("t == t and 2*t or t") " --> 2.0"},
    {"__tostring", bound<text_of_jet>, "tostring(x) -> string",
     "Its value and its derivatives, up to the last that is not zero.",
     ROTOR_JET("#tostring(t) > 0 and t or 0") " --> 1.0"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},
    {"run", Kind::kMethod, kMethods},
    {"jet", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> jet_groups() { return kGroups; }

}  // namespace rotor::script
