// To a face and back, and over every ordered pair of faces.
#include <functional>

#include "elements.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

// Making a rotation rounds its angle (half an ulp of at most 2 pi: 4.5e-16) and its axis (0.98e-16,
// which moves the operator by at most twice as much).
constexpr double kMaking = 4.5e-16 + 2e-16;

// The length of an error vector of kVectorUlps in each component, relative to the face vector's
// length.
const double kVector = std::sqrt(3.0) * kVectorUlps * std::ldexp(1, -52);

struct Face {
  std::string name;
  std::function<Rotation(const Rotation&)> trip;
  std::function<double(const Rotation&)> tolerance;  // of the operator, rad
};

const std::vector<Face>& faces() {
  static const std::vector<Face> all = {
      {"axis and angle", [](const Rotation& r) { return Rotation(r.axis(), r.angle()); },
       [](const Rotation&) { return 2 * kAxis; }},
      {"quaternion", [](const Rotation& r) { return from_quaternion(r.quaternion()); },
       [](const Rotation&) { return 2 * kQuaternion + kMaking; }},
      {"matrix", [](const Rotation& r) { return from_matrix(r.matrix()); },
       [](const Rotation&) { return kFromMatrix; }},
      // |d exp(E)| <= |dE|: the error grows with the angle. Below 5e-324 lie three subnormals.
      {"Euler vector", [](const Rotation& r) { return from_euler_vector(r.euler_vector()); },
       [](const Rotation& r) { return (kVector + kMaking) * std::max(1.0, std::abs(r.angle())); }},
      // M forgets the sign of cos(theta/2), so it is read off the canonical rotation. From |M| = m
      // with error e, theta = 2 asin m: 2 e/cos(theta/2), at most 2 sqrt(2 e) for m = 1.
      {"modified Gibbs vector",
       [](const Rotation& r) { return from_modified_gibbs(r.canonical().modified_gibbs()); },
       [](const Rotation& r) {
         const double sharp = 2 * kVector / std::cos(r.canonical().angle() / 2);
         return 2 * kMaking + 2 * kVector + std::min(sharp, 2 * std::sqrt(2 * kVector));
       }},
      // A relative error e of n tan(theta/2): 2 sin(theta/2) e of direction, sin(theta) e of
      // length.
      {"Gibbs vector", [](const Rotation& r) { return from_gibbs(r.gibbs()); },
       [](const Rotation&) { return 2 * kVector + kMaking; }},
      // Of n tan(theta/4): 2 |sin(theta/2)| e each.
      {"MRP", [](const Rotation& r) { return from_mrp(r.mrp()); },
       [](const Rotation&) { return 3 * kVector + kMaking; }},
  };
  return all;
}

}  // namespace

TEST_CASE("round trips over all pairs of faces") {
  const auto all = elements(300, 301);
  for (const Face& first : faces()) {
    for (const Face& second : faces()) {
      Worst ratio;
      for (const Rotation& r : all) {
        const Rotation between = first.trip(r), end = second.trip(between);
        ratio.add(operator_error(end, r) / Extended(first.tolerance(r) + second.tolerance(between)),
                  [&] { return described(r) + " -> " + described(between); });
      }
      ratio.within(first.name + ", then " + second.name + ", error over tolerance", 1);
    }
  }
}

TEST_CASE("faces that count turns keep the unit quaternion") {
  Worst quaternion, mrp, euler;
  for (const Rotation& r : elements(1000, 302)) {
    const auto where = [&] { return described(r); };
    quaternion.add(spinor_error(from_quaternion(r.quaternion()), r), where);
    // n tan(theta/4) has period 4 pi, as the quaternion has.
    mrp.add(spinor_error(from_mrp(r.mrp()), r), where);
    if (std::abs(r.angle()) > 4 * kPi) continue;
    const Rotation back = from_euler_vector(r.euler_vector());
    euler.add(spinor_error(back, r), where);
    INFO(where());
    CHECK(std::abs(back.angle() - std::abs(r.angle())) <= 4 * ulp(r.angle()));
  }
  quaternion.within("quaternion", kQuaternion + kMaking / 2);
  mrp.within("MRP", (3 * kVector + kMaking) / 2);
  euler.within("Euler vector", 4 * kPi * (kVector + kMaking) / 2);
}

TEST_CASE("the angle a face gives lies in its range") {
  for (const Rotation& r : elements(300, 303)) {
    INFO(described(r));
    const auto angle_in = [](const Rotation& s, double limit) {
      return 0 <= s.angle() && s.angle() <= limit;
    };
    CHECK(angle_in(from_quaternion(r.quaternion()), 2 * kPi));
    CHECK(angle_in(from_mrp(r.mrp()), 2 * kPi));
    CHECK(angle_in(from_matrix(r.matrix()), kPi));
    CHECK(angle_in(from_gibbs(r.gibbs()), kPi));
    CHECK(angle_in(from_modified_gibbs(r.modified_gibbs()), kPi));
  }
}

TEST_CASE("zero face vectors are the identity about e1") {
  const Vector zero = Vector::Zero();
  CHECK(from_euler_vector(zero) == Rotation());
  CHECK(from_modified_gibbs(zero) == Rotation());
  CHECK(from_gibbs(zero) == Rotation());
  CHECK(from_mrp(zero) == Rotation());
  CHECK(from_quaternion({1, 0, 0, 0}) == Rotation());
  CHECK(from_matrix(Matrix::Identity()) == Rotation());
  CHECK(from_quaternion({-1, 0, 0, 0}).angle() == 2 * kPi);
}

TEST_CASE("face vectors of extreme length") {
  const Vector e2(0, 1, 0);
  for (double length : {5e-324, 1e-300, 1e-17}) {
    CAPTURE(length);
    CHECK(from_euler_vector(length * e2) == Rotation(e2, length));
    CHECK(from_modified_gibbs(length * e2) == Rotation(e2, 2 * length));
    CHECK(from_gibbs(length * e2) == Rotation(e2, 2 * length));
    CHECK(from_mrp(length * e2) == Rotation(e2, 4 * length));
  }
  CHECK(from_gibbs({0, 1e300, 0}) == Rotation(e2, kPi));
  CHECK(from_mrp({0, 1.7e308, 0}) == Rotation(e2, 2 * kPi));
  CHECK(from_euler_vector({0, 1e300, 0}) == Rotation(e2, 1e300));
  CHECK(from_modified_gibbs({0, 1, 0}) == Rotation(e2, kPi));
  CHECK(from_modified_gibbs({0, 1 + 8e-16, 0}) == Rotation(e2, kPi));
  CHECK(Rotation(e2, kPi).gibbs().y() == Approx(1.633123935319537e16).epsilon(1e-15));
}

TEST_CASE("a quaternion or matrix slightly off is normalised") {
  const Rotation r({0.3, -0.5, 0.8}, 2);
  Quaternion q = r.quaternion();
  q.coeffs() *= 1 + 9e-7;
  within(operator_error(from_quaternion(q), r), 2 * kQuaternion + kMaking);
  // Scaling changes no direction: the nearest rotation of 1.0000004 Q is Q.
  within(operator_error(from_matrix(r.matrix() * (1 + 4e-7)), r), kFromMatrix);
  // A symmetric stretch S of Q: the nearest rotation of Q S is Q.
  Matrix stretch = Matrix::Identity();
  stretch(0, 1) = stretch(1, 0) = 3e-7;
  stretch(2, 2) += 2e-7;
  within(operator_error(from_matrix(r.matrix() * stretch), r), 2 * kFromMatrix);
}
