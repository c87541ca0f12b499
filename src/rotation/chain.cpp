#include "rotation/chain.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "rotation/text.hpp"
#include "rotation/turn.hpp"

namespace rotor {
namespace {

// The relative error of a number that was rounded to double.
constexpr Extended kRounding = std::numeric_limits<double>::epsilon() / 2;

void require_size(std::size_t given, std::size_t axes, const char* what) {
  if (given != axes) {
    throw std::invalid_argument("expected as many " + std::string(what) + " as axes, got " +
                                std::to_string(given) + " for " + std::to_string(axes));
  }
}

void require_finite_list(const std::vector<double>& list, const char* what) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string name = std::string(what) + " " + std::to_string(i + 1);
    require_finite(list[i], name.c_str());
  }
}

using Decomposition = Eigen::JacobiSVD<Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>>;

Decomposition decomposed(const Eigen::Matrix<Extended, 3, Eigen::Dynamic>& jacobian,
                         Extended uncertainty) {
  Decomposition svd(jacobian, Eigen::ComputeThinU | Eigen::ComputeThinV);
  // Weyl: no singular value moves by more than the norm of the change of the matrix.
  svd.setThreshold(uncertainty / svd.singularValues()(0));
  return svd;
}

}  // namespace

std::string letters_hint(std::string letters) {
  for (char& letter : letters) {
    if (letter >= 'X' && letter <= 'Z') letter = static_cast<char>(letter - 'X' + 'x');
    if (letter >= '1' && letter <= '3') letter = static_cast<char>(letter - '1' + 'x');
  }
  if (letters.find_first_not_of("xyz") != letters.npos) return "";
  return "; write \"" + letters + R"(", the frame is "body" or "space")";
}

std::vector<Vector> axes_of_letters(const std::string& letters) {
  std::vector<Vector> axes;
  axes.reserve(letters.size());
  for (const char letter : letters) {
    if (letter < 'x' || letter > 'z') {
      throw std::invalid_argument("expected axes of the letters x, y, z, got \"" + letters + "\"" +
                                  letters_hint(letters));
    }
    axes.emplace_back(Vector::Unit(letter - 'x'));
  }
  return axes;
}

Chain::Chain(const std::vector<Vector>& axes, const std::vector<double>& angles,
             const std::optional<std::vector<double>>& rates, Frame frame) {
  if (axes.empty()) throw std::invalid_argument("expected at least one axis, got none");
  require_size(angles.size(), axes.size(), "angles");
  require_finite_list(angles, "angle");
  axes_.resize(3, static_cast<Eigen::Index>(axes.size()));

  // From the base outwards: the rotations before the k-th carry its axis along.
  ExtendedQuaternion q = ExtendedQuaternion::Identity();
  Extended turned = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::size_t k = frame == Frame::kBody ? i : axes.size() - 1 - i;
    const ExtendedVector u = direction(axes[k], ("axis " + std::to_string(k + 1)).c_str());
    axes_.col(static_cast<Eigen::Index>(k)) = q * u;
    // v_k moves at most as far as u_k and the angles before it do, by rounding. An angle of more
    // than a turn is taken for exact: it counts as one of a turn.
    uncertainty_ = std::hypot(uncertainty_, kRounding * (1 + turned));
    turned += std::min(std::abs(Extended{angles[k]}), 2 * std::numbers::pi_v<Extended>);
    q = q * turn(u, angles[k]);
  }
  rotation_ = rotation_of(q);

  if (!rates) return;
  require_size(rates->size(), axes.size(), "rates");
  require_finite_list(*rates, "rate");
  ExtendedVector omega = ExtendedVector::Zero();
  for (std::size_t k = 0; k < axes.size(); ++k) {
    omega += Extended{(*rates)[k]} * axes_.col(static_cast<Eigen::Index>(k));
  }
  omega_ = omega.cast<double>();
}

std::vector<Vector> Chain::axes() const {
  std::vector<Vector> axes;
  axes.reserve(size());
  for (const auto& axis : axes_.colwise()) axes.emplace_back(axis.cast<double>());
  return axes;
}

Vector Chain::omega() const {
  if (!omega_) {
    throw std::invalid_argument("omega: this chain was made without rates");
  }
  return *omega_;
}

Eigen::Index Chain::rank() const { return decomposed(axes_, uncertainty_).rank(); }

std::vector<Matrix> Chain::derivatives() const {
  // dQ_k/dtheta_k = [u_k]x Q_k, hence N21 is [v_k]x Q.
  const ExtendedMatrix q = turn(rotation_).toRotationMatrix();
  std::vector<Matrix> all;
  all.reserve(size());
  for (const auto& axis : axes_.colwise()) {
    ExtendedMatrix derivative;
    for (int j = 0; j < 3; ++j) {
      derivative.col(j) = ExtendedVector(axis).cross(ExtendedVector(q.col(j)));
    }
    all.emplace_back(derivative.cast<double>());
  }
  return all;
}

std::vector<double> Chain::rates(const Vector& omega) const {
  require_finite(omega, "omega");
  const auto svd = decomposed(axes_, uncertainty_);
  const ExtendedVector wanted = omega.cast<Extended>();
  const Eigen::Matrix<Extended, Eigen::Dynamic, 1> rates = svd.solve(wanted);
  const ExtendedVector rest = wanted - axes_ * rates;
  // Omega carries a few roundings, and J the uncertainty that decided its rank.
  if (rest.norm() > 8 * kRounding * wanted.norm() + uncertainty_ * rates.norm()) {
    throw std::invalid_argument("no rates give omega = " + text(omega) +
                                ": the chain's axes are of rank " + std::to_string(svd.rank()) +
                                " now, and " + text(Vector(rest.cast<double>())) +
                                " of it is out of reach");
  }
  std::vector<double> rounded;
  rounded.reserve(size());
  for (const Extended rate : rates) rounded.push_back(static_cast<double>(rate));
  if (!std::all_of(rounded.begin(), rounded.end(), [](double x) { return std::isfinite(x); })) {
    throw std::invalid_argument("the rates for omega = " + text(omega) +
                                " exceed the largest double");
  }
  return rounded;
}

Commutation commute(const Rotation& r, const Rotation& s, double tolerance) {
  if (!(tolerance >= 0)) {
    throw std::invalid_argument("expected a tolerance of 0 or more, got " + text(tolerance));
  }
  const ExtendedQuaternion p = turn(r), q = turn(s);
  // p q - q p = 2 p x q (vectors), of length 2 sin(theta_p/2) sin(theta_q/2) sin(angle of axes);
  // p q + q p = 0 iff both are half turns about perpendicular axes: the same operator again.
  const ExtendedVector cross = p.vec().cross(q.vec());
  const Extended difference = 2 * cross.norm();
  const Extended sum = 2 * std::hypot(p.w() * q.w() - p.vec().dot(q.vec()),
                                      (p.w() * q.vec() + q.w() * p.vec()).norm());
  const auto [least, most] = std::minmax(difference, sum);
  Commutation result{false, static_cast<double>(4 * std::atan2(least, most)), ""};
  if (!(result.distance <= tolerance)) return result;
  result.commute = true;
  const Extended sines = r.axis().cast<Extended>().cross(s.axis().cast<Extended>()).norm();
  if (sum < difference) {
    result.why = "perpendicular half turns";
  } else if (std::min(p.vec().norm(), q.vec().norm()) <= sines) {
    result.why = "identity";
  } else {
    result.why = "parallel axes";
  }
  return result;
}

}  // namespace rotor
