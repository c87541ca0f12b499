#include "output/columns.hpp"

#include <array>
#include <optional>
#include <stdexcept>

namespace rotor {
namespace {

// A state, and what of it is computed at most once for all columns of a row.
class Row {
 public:
  Row(const Run& run, const State& state) : run_(run), state_(state) {}
  const State& state() const { return state_; }
  const Vector& omega() {
    if (!omega_) omega_ = run_.omega(state_.t);
    return *omega_;
  }
  const Rates& rates() {
    if (!rates_) rates_ = run_.rates(state_, omega());
    return *rates_;
  }

 private:
  const Run& run_;
  const State& state_;
  std::optional<Vector> omega_;
  std::optional<Rates> rates_;
};

using Values = std::array<double, 9>;

struct Quantity {
  const char* name;
  const char* components;  // one letter or two digits each; "" for a scalar
  const char* unit;        // suffix of the header
  const char* meaning;
  Values (*values)(Row&);
};

Values of(const Vector& v) { return {v.x(), v.y(), v.z()}; }

constexpr std::array kQuantities = {
    Quantity{"t", "", "", "time", [](Row& r) { return Values{r.state().t}; }},
    Quantity{"angle", "", "_rad", "rotation angle theta, continuous",
             [](Row& r) { return Values{r.state().angle}; }},
    Quantity{"axis", "xyz", "", "rotation axis n, continuous",
             [](Row& r) { return of(r.state().axis); }},
    Quantity{"euler_vector", "xyz", "_rad", "Euler vector E = n theta",
             [](Row& r) { return of(r.state().euler_vector()); }},
    Quantity{"quaternion", "wxyz", "", "unit quaternion (cos theta/2, n sin theta/2)",
             [](Row& r) {
               const Quaternion& q = r.state().quaternion;
               return Values{q.w(), q.x(), q.y(), q.z()};
             }},
    Quantity{"modified_gibbs", "xyz", "", "modified Gibbs vector M = n sin(theta/2)",
             [](Row& r) { return of(r.state().modified_gibbs()); }},
    Quantity{"gibbs", "xyz", "", "Gibbs vector G = n tan(theta/2)",
             [](Row& r) { return of(r.state().gibbs()); }},
    Quantity{"mrp", "xyz", "", "modified Rodrigues parameters n tan(theta/4)",
             [](Row& r) { return of(r.state().mrp()); }},
    Quantity{"matrix", "111213212223313233", "", "rotation matrix, row and column",
             [](Row& r) {
               Values m;
               const Matrix rows = r.state().matrix().transpose();
               std::copy(rows.data(), rows.data() + 9, m.begin());
               return m;
             }},
    Quantity{"omega", "xyz", "", "angular velocity in the space frame, rad per unit of t",
             [](Row& r) { return of(r.omega()); }},
    Quantity{"angle_rate", "", "", "d theta/dt, rad per unit of t",
             [](Row& r) { return Values{r.rates().angle_rate}; }},
    Quantity{"axis_rate", "xyz", "", "dn/dt per unit of t",
             [](Row& r) { return of(r.rates().axis_rate); }},
    Quantity{"euler_rate", "xyz", "", "dE/dt, rad per unit of t",
             [](Row& r) { return of(r.rates().euler_rate); }},
};

// The components' suffixes: "" for a scalar, else "_x", ... or "_11", ...
std::vector<std::string> suffixes(const Quantity& quantity) {
  const std::string letters = quantity.components;
  if (letters.empty()) return {""};
  const std::size_t width = letters.size() == 18 ? 2 : 1;
  std::vector<std::string> list;
  for (std::size_t i = 0; i < letters.size(); i += width)
    list.push_back("_" + letters.substr(i, width));
  return list;
}

std::string unknown_column(const std::string& name) {
  std::string message = "unknown column '" + name + "'; there are";
  for (const Quantity& quantity : kQuantities)
    message.append(" ").append(quantity.name).append(",");
  return message + " and their components, as axis_x";
}

}  // namespace

Columns::Columns(std::span<const std::string> names) {
  for (const std::string& name : names) {
    const std::size_t before = columns_.size();
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
      const Quantity& quantity = kQuantities[q];
      const auto parts = suffixes(quantity);
      for (std::size_t c = 0; c < parts.size(); ++c) {
        const std::string part = quantity.name + parts[c];
        if (name != quantity.name && name != part && name != part + quantity.unit) continue;
        columns_.push_back({part, part + quantity.unit, quantity.meaning});
        parts_.push_back({q, c});
      }
    }
    if (columns_.size() == before) throw std::invalid_argument(unknown_column(name));
  }
  if (columns_.empty()) throw std::invalid_argument("no columns given");
}

std::vector<std::string> Columns::headers() const {
  std::vector<std::string> headers;
  for (const Column& column : columns_) headers.push_back(column.header);
  return headers;
}

void Columns::values(const Run& run, const State& state, std::vector<double>& out) const {
  Row row(run, state);
  Values values{};
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    // Components of one quantity stand together and are computed together.
    if (i == 0 || parts_[i].quantity != parts_[i - 1].quantity) {
      values = kQuantities[parts_[i].quantity].values(row);
    }
    out.push_back(values[parts_[i].component]);
  }
}

std::span<const std::string> Columns::standard() {
  static const std::vector<std::string> names = {"t", "angle", "axis", "euler_vector",
                                                 "quaternion"};
  return names;
}

}  // namespace rotor
