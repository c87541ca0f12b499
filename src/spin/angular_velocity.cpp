#include "spin/angular_velocity.hpp"

#include <utility>

#include "rotation/text.hpp"
#include "spin/models.hpp"

namespace rotor {

AngularVelocity::AngularVelocity(const Vector& constant)
    : model_(std::make_shared<const ConstantSpin>(constant)) {}

AngularVelocity::AngularVelocity(Function function, std::string name)
    : model_(std::make_shared<const FunctionSpin>(std::move(function), std::move(name))) {}

AngularVelocity::AngularVelocity(std::shared_ptr<const SpinModel> model, Frame frame)
    : model_(std::move(model)), frame_(frame) {}

std::string AngularVelocity::description() const {
  return model_->description() + (frame_ == Frame::kBody ? ", in the body frame" : "");
}

Vector AngularVelocity::operator()(double t) const {
  const Vector omega = model_->value(t);
  if (!omega.allFinite()) {
    throw NonFiniteOmega(model_->description() + " gave " + text(omega) + " at t = " + text(t) +
                         ", expected three finite numbers");
  }
  return omega;
}

}  // namespace rotor
