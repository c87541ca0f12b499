// Numbers: constants, functions under their bare names, and how numbers are shown.
#include <numbers>
#include <optional>

#include "script/binding.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

double pi() { return std::numbers::pi; }
double degree() { return std::numbers::pi / 180; }

Results precision_entry(lua_State* L) {
  const auto digits = argument<std::optional<std::size_t>>(L, 1);
  if (!digits) {
    lua_pushinteger(L, precision());
    return {1};
  }
  if (*digits < 1 || *digits > kFullPrecision) {
    throw std::invalid_argument("expected 1 to 17 digits, got " + std::to_string(*digits));
  }
  set_precision(static_cast<int>(*digits));
  return {0};
}

constexpr Entry kValues[] = {
    {"pi", bound<pi>, "pi -> number", "Half a turn in radians.", "pi --> 3.141592653589793"},
    {"deg", bound<degree>, "deg -> number",
     "A degree in radians, pi/180: 30*deg. (math.deg is Lua's function.)",
     "180*deg == pi --> true"},
};

constexpr Entry kFunctions[] = {
    {"precision", bound<precision_entry>, "precision(digits) -> number",
     "Significant digits of numbers in the terminal and in rotor's own texts, 1 to 17; 17 (the "
     "default) is the "
     "shortest text that reads back as the same number. Without digits: the present setting.",
     "precision() --> 17"},
};

constexpr Group kGroups[] = {
    {"", Kind::kValue, kValues},
    {"", Kind::kFunction, kFunctions},
};

}  // namespace

std::span<const Group> terminal_groups() { return kGroups; }

}  // namespace rotor::script
