// What drives the body: its angular velocity as a function of time alone.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <variant>

#include "rotation/rotation.hpp"

namespace rotor {

/// omega(t) in the space frame, rad per unit of t: a constant or any function of t.
class AngularVelocity {
 public:
  using Function = std::function<Vector(double)>;

  /// Throws std::invalid_argument if the constant is not finite.
  AngularVelocity(const Vector& constant);
  /// `name` is what error messages call the function.
  AngularVelocity(Function function, std::string name = "omega");

  /// The value at t. Whatever the function throws passes through; a value that is not finite is a
  /// NonFiniteOmega.
  Vector operator()(double t) const;

  /// The constant "(x, y, z)", or the name of the function.
  std::string description() const;

  /// The value where it is known to be constant, else null.
  const Vector* constant() const { return std::get_if<Vector>(&value_); }

 private:
  std::variant<Vector, Function> value_;
  std::string name_;
};

/// omega(t) was NaN or infinite; the message gives name, t and value.
class NonFiniteOmega : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

}  // namespace rotor
