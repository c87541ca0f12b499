// matrix: what an operator is in the basis (e1, e2, e3).
#include <algorithm>
#include <string>

#include "script/binding.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

std::string text_of_matrix(const Matrix& m) {
  std::string text = "matrix";
  std::size_t width = 0;
  for (const double x : m.reshaped()) width = std::max(width, shown(x).size());
  for (int i = 0; i < 3; ++i) {
    text += "\n ";
    for (int j = 0; j < 3; ++j) {
      const std::string number = shown(m(i, j));
      text += std::string(width + 1 - number.size(), ' ') + number;
    }
  }
  return text;
}

constexpr Entry kOperators[] = {
    {"__tostring", bound<text_of_matrix>, "tostring(m) -> string",
     "The text under which the terminal shows it.",
     "#tostring(rotation.identity.matrix) > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"matrix", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> matrix_groups() { return kGroups; }

}  // namespace rotor::script
