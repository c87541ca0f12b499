// What of a state or of a rotation is written, drawn and read, by name.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/run.hpp"

namespace rotor {

/// A time of a run, and what of the state there is computed: only what is asked for, at most once
/// for all columns of a row. Axis and angle need the run's crossings, the quaternion does not.
class StateRow {
 public:
  StateRow(const Run& run, double t) : run_(run), t_(t) {}
  double t() const { return t_; }
  /// A state of which the quaternion alone is known, with what follows from it.
  const State& attitude();
  const State& state();
  const Vector& omega();
  const Rates& rates();

 private:
  const Run& run_;
  double t_;
  std::optional<State> attitude_;
  std::optional<State> state_;
  std::optional<Vector> omega_;
  std::optional<Rates> rates_;
};

struct Quantity {
  using Values = std::array<double, 9>;  // the first ones, as many as there are components

  const char* name;
  const char* components;  // one letter or two digits each; "" for a scalar
  const char* unit;        // suffix of the header
  const char* meaning;
  Values (*of_state)(StateRow&);
  Values (*of_rotation)(const Rotation&);  // null for what only a motion has
  Rotation (*rotation)(const Values&);     // null for what does not determine one

  /// The names of the components: "angle"; "axis_x", ...; "matrix_11", ...
  std::vector<std::string> parts() const;
  /// The meaning of one of them: "rotation axis n: component x", ...
  std::string meaning_of(std::size_t component) const;
  /// Whether they are Euler angles, the first and the last from -pi to pi.
  bool is_euler() const { return components == std::string_view("123"); }
};

/// All of them, of the faces first what keeps most of a rotation.
std::span<const Quantity> quantities();

}  // namespace rotor
