#include "spin/angular_velocity.hpp"

#include <utility>

#include "rotation/text.hpp"

namespace rotor {

AngularVelocity::AngularVelocity(const Vector& constant) : value_(constant) {
  if (!constant.allFinite()) {
    throw std::invalid_argument("omega: expected three finite numbers, got " + text(constant));
  }
}

AngularVelocity::AngularVelocity(Function function, std::string name)
    : value_(std::move(function)), name_(std::move(name)) {}

std::string AngularVelocity::description() const {
  const Vector* value = constant();
  return value == nullptr ? name_ : text(*value);
}

Vector AngularVelocity::operator()(double t) const {
  if (const Vector* value = constant()) return *value;
  const Vector omega = std::get<Function>(value_)(t);
  if (!omega.allFinite()) {
    throw NonFiniteOmega(name_ + " gave " + text(omega) + " at t = " + text(t) +
                         ", expected three finite numbers");
  }
  return omega;
}

}  // namespace rotor
