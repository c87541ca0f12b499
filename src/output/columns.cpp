#include "output/columns.hpp"

#include <string_view>
#include <utility>

namespace rotor {

std::string listed(const std::vector<std::string>& names, const std::string& quote) {
  std::string list;
  for (const std::string& name : names)
    list.append(list.empty() ? "" : ", ").append(quote).append(name).append(quote);
  return list;
}

namespace {

bool is_t(const Quantity& quantity) { return quantity.name == std::string_view("t"); }

// Appends the value of each part; `values` computes all components of a quantity.
template <class Parts, class Compute>
void append(const Parts& parts, std::vector<double>& out, Compute compute) {
  Quantity::Values values{};
  const Quantity* computed = nullptr;
  for (const auto& part : parts) {
    if (part.quantity != computed) values = compute(*part.quantity);
    computed = part.quantity;
    out.push_back(values[part.component]);
  }
}

}  // namespace

UnknownName::UnknownName(const std::string& what_it_is, const std::string& unknown,
                         std::vector<std::string> there_are, const std::string& more)
    : std::invalid_argument("unknown " + what_it_is + " '" + unknown + "'; there are " +
                            listed(there_are) + more),
      kind(what_it_is),
      name(unknown),
      known(std::move(there_are)) {}

Columns::Columns(std::span<const std::string> names, bool (*is_known)(const Quantity&)) {
  for (const std::string& name : names) {
    const std::size_t before = columns_.size();
    std::vector<std::string> known;
    for (const Quantity& quantity : quantities()) {
      if (!is_known(quantity)) continue;
      known.emplace_back(quantity.name);
      const auto parts = quantity.parts();
      for (std::size_t c = 0; c < parts.size(); ++c) {
        const std::string header = parts[c] + quantity.unit;
        if (name != quantity.name && name != parts[c] && name != header) continue;
        columns_.push_back({parts[c], header, quantity.meaning_of(c), quantity.is_euler()});
        parts_.push_back({&quantity, c});
      }
    }
    if (columns_.size() == before)
      throw UnknownName("column", name, std::move(known), ", and their components, as axis_x");
  }
  if (columns_.empty()) throw std::invalid_argument("no columns given");
}

std::vector<std::string> Columns::headers() const {
  std::vector<std::string> headers;
  for (const Column& column : columns_) headers.push_back(column.header);
  return headers;
}

StateColumns::StateColumns(std::span<const std::string> names)
    : Columns(names, [](const Quantity&) { return true; }) {}

void StateColumns::values(StateRow& row, std::vector<double>& out) const {
  append(parts_, out, [&](const Quantity& quantity) { return quantity.of_state(row); });
}

std::span<const std::string> StateColumns::standard() {
  static const std::vector<std::string> names = {"t", "angle", "axis", "euler_vector",
                                                 "quaternion"};
  return names;
}

RotationColumns::RotationColumns(std::span<const std::string> names, bool timed)
    : Columns(
          names, timed ? [](const Quantity& q) { return q.of_rotation != nullptr || is_t(q); }
                       : [](const Quantity& q) { return q.of_rotation != nullptr; }) {}

void RotationColumns::values(const Rotation& r, double t, std::vector<double>& out) const {
  append(parts_, out, [&](const Quantity& quantity) {
    return is_t(quantity) ? Quantity::Values{t} : quantity.of_rotation(r);
  });
}

std::span<const std::string> RotationColumns::standard() {
  static const std::vector<std::string> names = {"angle", "axis"};
  return names;
}

}  // namespace rotor
