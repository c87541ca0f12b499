// What drives the body: its angular velocity as a function of time alone.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rotation/frame.hpp"
#include "rotation/rotation.hpp"
#include "spin/model.hpp"

namespace rotor {

/// omega(t), rad per unit of t: a model, and the frame in which it is given.
class AngularVelocity {
 public:
  using Function = std::function<Vector(double)>;

  /// A constant; throws std::invalid_argument if it is not finite.
  AngularVelocity(const Vector& constant);
  /// A function that is cheap to call; `name` is what error messages call it.
  AngularVelocity(Function function, std::string name = "omega");
  AngularVelocity(std::shared_ptr<const SpinModel> model, Frame frame = Frame::kSpace);

  /// The value at t. Whatever the model throws passes through; a value that is not finite is a
  /// NonFiniteOmega.
  Vector operator()(double t) const;
  /// The value with its derivatives, in its own frame; throws NotDifferentiable.
  VectorJet jet(double t) const { return model_->jet(t); }
  /// The model's, with "in the body frame" where it is.
  std::string description() const;
  std::vector<double> breaks(double low, double high) const { return model_->breaks(low, high); }
  bool dear() const { return model_->dear(); }

  Frame frame() const { return frame_; }
  /// The same function of t as one in the body frame.
  AngularVelocity in_body_frame() const { return {model_, Frame::kBody}; }

  /// The model, if it is of that type, else null.
  template <class Model>
  const Model* as() const {
    return dynamic_cast<const Model*>(model_.get());
  }

 private:
  std::shared_ptr<const SpinModel> model_;
  Frame frame_ = Frame::kSpace;
};

/// omega(t) was NaN or infinite; the message gives name, t and value.
class NonFiniteOmega : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

}  // namespace rotor
