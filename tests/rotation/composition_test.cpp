// Products against the true quaternion of the product, whose sign counts turns.
#include "elements.hpp"
#include "exact.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

struct CompositionErrors {
  Worst quaternion, cancelled;

  void add(const Rotation& second, const Rotation& first, const std::array<Exact, 4>& exact) {
    const auto where = [&] { return described(second) + " after " + described(first); };
    const Rotation product = second * first;
    quaternion.add(errors(components(product.quaternion()), exact).norm(), where);
    const bool identity = exact[0].hi > 0 && std::abs(exact[1].hi) < 1e-30 &&
                          std::abs(exact[2].hi) < 1e-30 && std::abs(exact[3].hi) < 1e-30;
    if (identity) cancelled.add(product.angle(), where);
  }
};

}  // namespace

TEST_CASE("products of awkward rotations") {
  CompositionErrors all;
  for (Row& row : table("rotation/compositions.csv")) {
    const Vector axis1 = row.vector();
    const double angle1 = row.number();
    const Vector axis2 = row.vector();
    const double angle2 = row.number();
    std::array<Exact, 4> exact;
    row.read(exact);
    all.add(Rotation(axis2, angle2), Rotation(axis1, angle1), exact);
  }
  all.quaternion.within("quaternion of the product", kComposition);
  all.cancelled.within("angle of an exact cancellation", kCancelled);
}

TEST_CASE("products of random rotations") {
  const std::uint64_t seed = 102;
  CAPTURE(seed);
  Draw draw(seed);
  CompositionErrors all;
  for (int i = 0; i < 10000; ++i) {
    const Vector axis1 = draw.awkward_axis(), axis2 = draw.awkward_axis();
    const double angle1 = draw.awkward_angle(), angle2 = draw.awkward_angle();
    all.add(Rotation(axis2, angle2), Rotation(axis1, angle1),
            split(exact_quaternion(axis2, angle2) * exact_quaternion(axis1, angle1)));
    all.add(Rotation(axis1, -angle1), Rotation(axis1, angle1), {Exact{1}, {}, {}, {}});
  }
  all.quaternion.within("quaternion of the product", kComposition);
  all.cancelled.within("angle of an exact cancellation", kCancelled);
}

TEST_CASE("an exact cancellation is the identity about e1") {
  for (const Rotation& r : elements(100, 103)) {
    INFO(described(r));
    CHECK(r.inverse() * r == Rotation());
    CHECK(r * r.inverse() == Rotation());
  }
}

TEST_CASE("tiny rotations compose without underflow") {
  const Rotation x({1, 0, 0}, 1e-300), y({0, 1, 0}, 1e-300);
  CHECK((x * y).angle() == Approx(std::sqrt(2.0) * 1e-300).epsilon(1e-15).margin(0));
  CHECK((x * x).angle() == Approx(2e-300).epsilon(1e-15).margin(0));
  const Rotation least({0, 0, 1}, 5e-324);
  CHECK((least * least).angle() == 1e-323);
  CHECK((least * least).axis() == Vector(0, 0, 1));
}

TEST_CASE("a product counts turns modulo 4 pi") {
  const Vector k(0, 0, 1);
  CHECK((Rotation(k, 3) * Rotation(k, 2)).angle() == Approx(5));
  CHECK((Rotation(k, 3) * Rotation(k, 2)).axis() == k);
  // 8 = -(4 pi - 8) modulo 4 pi.
  CHECK((Rotation(k, 5) * Rotation(k, 3)).angle() == Approx(4 * kPi - 8));
  CHECK((Rotation(k, 5) * Rotation(k, 3)).axis() == -k);
  CHECK((Rotation(k, 2 * kPi) * Rotation(k, 1)).angle() == Approx(2 * kPi - 1));
  CHECK((Rotation(k, 2 * kPi) * Rotation(k, 1)).axis() == -k);
}

TEST_CASE("theory 5: a composition") {
  const Rotation product =
      Rotation({std::sin(1.0), 0, std::cos(1.0)}, 1.4) * Rotation({0, 0, 1}, 0.9);
  CHECK(std::abs(product.angle() - 2.007127) <= 5e-7);
  CHECK((product.axis() - Vector(0.578763, -0.279575, 0.766075)).cwiseAbs().maxCoeff() <= 5e-7);
}

TEST_CASE("theory 5: the matrix Q(u, theta), u along (1, 2, 3), theta = 1") {
  Matrix printed;
  printed << 0.5731378554, -0.6090066421, 0.5482918096,  //
      0.7403488405, 0.6716445042, -0.0278792829,         //
      -0.3512785121, 0.4219058779, 0.8358222521;
  CHECK((Rotation({1, 2, 3}, 1).matrix() - printed).cwiseAbs().maxCoeff() <= 5e-11);
}
