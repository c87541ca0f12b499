// Euler angles and factoring about any axes: every solution makes the rotation again, all are
// found, and what is out of reach is said.
#include "rotation/factoring.hpp"

#include "elements.hpp"
#include "refusal.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

const std::vector<std::string> kSequences = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx",
                                             "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"};
constexpr double kRebuilt = 4e-15;
// A Rotation rounds its axis (1e-16, which moves points by twice that) and its angle below 2 pi.
constexpr double kStored = 2 * 1e-16 + 4.45e-16;

using WideVector = Eigen::Matrix<Extended, 3, 1>;

Wide about(const Vector& axis, Extended angle) {
  const WideVector v = axis.cast<Extended>().normalized() * std::sin(angle / 2);
  return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

Wide product(const std::vector<Vector>& axes, const std::vector<double>& angles) {
  Wide q = Wide::Identity();
  for (std::size_t k = 0; k < axes.size(); ++k) q = q * about(axes[k], angles[k]);
  return q;
}

Wide euler_product(const std::string& sequence, const std::vector<double>& angles, Frame frame) {
  std::vector<Vector> axes = axes_of_letters(sequence);
  std::vector<double> in_order = angles;
  if (frame == Frame::kSpace) {
    std::reverse(axes.begin(), axes.end());
    std::reverse(in_order.begin(), in_order.end());
  }
  return product(axes, in_order);
}

bool in_range(const std::vector<double>& angles) {
  return std::all_of(angles.begin(), angles.end(),
                     [](double a) { return -kPi < a && a <= kPi && !(a == 0 && std::signbit(a)); });
}

std::string listed(const std::vector<double>& angles) {
  std::string all;
  for (const double a : angles) all += " " + text(a);
  return all;
}

// Uniform on SO(3): a point of the ball in four dimensions.
Rotation uniform_rotation(Draw& draw) {
  for (;;) {
    const Vector v = draw.vector();
    const Quaternion q(draw.uniform(-1, 1), v.x(), v.y(), v.z());
    if (q.squaredNorm() <= 1 && q.squaredNorm() > 1e-6) return rotation_of(q);
  }
}

Extended between(const Vector& u, const WideVector& v) {
  const WideVector w = u.cast<Extended>().normalized();
  return std::atan2(w.cross(v).norm(), w.dot(v));
}

// How often u1.Q(u2, b) u3 - u1.R u3 changes its sign while b goes once round: brute force.
int crossings(const Rotation& r, const std::vector<Vector>& u) {
  const WideVector u1 = u[0].cast<Extended>().normalized(), u3 = u[2].cast<Extended>().normalized();
  const Extended wanted = u1.dot(wide(r) * u3);
  int count = 0;
  bool above = u1.dot(u3) > wanted;
  constexpr int kSteps = 400;
  for (int i = 1; i <= kSteps; ++i) {
    const bool now = u1.dot(about(u[1], 2 * kPi * i / kSteps) * u3) > wanted;
    count += now != above ? 1 : 0;
    above = now;
  }
  return count;
}

// Angles that are awkward in any place, and offsets from a singular middle angle.
const std::vector<double> kOuter = {0, 1, -2.5, kPi / 2, -kPi / 2, kPi, 1e-9, -3.1};
const std::vector<double> kOffsets = {0,     1e-16,  -3e-16, 1e-15, -2e-15, 1e-14, 1e-13,
                                      1e-12, -1e-11, 1e-10,  1e-9,  -1e-8,  1e-7,  1e-6,
                                      -1e-5, 1e-3,   0.3,    -0.7,  1};

}  // namespace

TEST_CASE("Euler angles: every solution makes the rotation again, the singular ones too") {
  Worst worst;
  for (const std::string& sequence : kSequences) {
    const bool proper = sequence.front() == sequence.back();
    for (const Frame frame : {Frame::kBody, Frame::kSpace}) {
      for (const double lock : {0.0, kPi / 2, kPi, -kPi / 2}) {
        for (const double offset : kOffsets) {
          for (const double a : kOuter) {
            const double c = 0.8 * a + 0.3;
            const Rotation r = from_euler_angles(sequence, {a, lock + offset, c}, frame);
            const Factoring all = euler_angles(r, sequence, frame);
            CAPTURE(sequence, int(frame), a, lock + offset, c);
            for (const auto& angles : all.solutions) {
              CHECK(in_range(angles));
              worst.add(operator_error(euler_product(sequence, angles, frame), wide(r)),
                        [&] { return sequence + listed(angles); });
            }
            const double b = all.solutions[0][1];
            CHECK((proper ? 0 <= b : -kPi / 2 <= b));
            CHECK((proper ? b <= kPi : b <= kPi / 2));
            const bool locked =
                std::abs(proper ? std::sin(lock + offset) : std::cos(lock + offset)) < 0.9e-15;
            const bool clear =
                std::abs(proper ? std::sin(lock + offset) : std::cos(lock + offset)) > 3e-15;
            if (locked) CHECK(!all.singular.empty());
            if (clear) CHECK(all.singular.empty());
            CHECK(all.solutions.size() == (all.singular.empty() ? 2 : 1));
            if (!all.singular.empty()) CHECK(all.solutions[0][2] == 0);
          }
        }
      }
    }
  }
  worst.within("rebuilt", kRebuilt);
}

TEST_CASE("Euler angles: those given come back, as one of the two solutions") {
  Draw draw(73);
  Worst worst;
  for (int i = 0; i < 3000; ++i) {
    const std::string& sequence = kSequences[std::size_t(draw.below(12))];
    const bool proper = sequence.front() == sequence.back();
    const Frame frame = draw.below(2) == 0 ? Frame::kBody : Frame::kSpace;
    const std::vector<double> given = {draw.uniform(-kPi, kPi), draw.uniform(-kPi, kPi),
                                       draw.uniform(-kPi, kPi)};
    const Rotation r = from_euler_angles(sequence, {given[0], given[1], given[2]}, frame);
    const auto solutions = euler_angles(r, sequence, frame).solutions;
    REQUIRE(solutions.size() == 2);
    Extended nearest = 10;
    for (const auto& angles : solutions) {
      Extended largest = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        largest = std::max<Extended>(
            largest, std::abs(std::remainder(Extended{angles[k]} - given[k], 2 * Extended(kPi))));
      }
      nearest = std::min(nearest, largest);
    }
    // R as stored is off by e; a and c turn about axes at the distance sin(phi) of the one moved,
    // so they are off by e/sin(phi), and rounded (2.3e-16 below pi).
    const double sine = std::abs(proper ? std::sin(given[1]) : std::cos(given[1]));
    worst.add(nearest / (kStored / sine + 2.3e-16), [&] { return sequence + listed(given); });
  }
  worst.within("of the bound", 1);
}

TEST_CASE("Euler angles: small ones are good to their last digits") {
  for (const std::string sequence : {"zyx", "xyz", "yzx"}) {
    for (const double size : {1e-8, 1e-20, 1e-160, 1e-300}) {
      CAPTURE(sequence, text(size));
      const std::vector<double> given = {size, -2 * size, 3 * size};
      const Rotation r = from_euler_angles(sequence, {given[0], given[1], given[2]});
      const auto found = euler_angles(r, sequence).solutions[0];
      // The Euler vector, 3.75 sizes long, was stored with an axis rounded by 5.7e-17 a component
      // and an angle by 1.1e-16 of itself; the result, 3 sizes at most, is rounded too.
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(found[k] - given[k]) <= (3.75 * (5.7e-17 + 1.12e-16) + 3 * 1.12e-16) * size);
      }
    }
  }
  const auto zero = euler_angles(Rotation(), "zyx").solutions[0];
  CHECK(zero == std::vector<double>{0, 0, 0});
  CHECK(euler_angles(Rotation({1, 0, 0}, 5e-324), "zyx").solutions[0] ==
        std::vector<double>{0, 0, 5e-324});
}

TEST_CASE("Euler angles: what is singular says which sum is determined") {
  using std::string;
  const auto why = [](const string& sequence, double b, Frame frame) {
    return euler_angles(from_euler_angles(sequence, {0.4, b, 0.3}, frame), sequence, frame);
  };
  for (const Frame frame : {Frame::kBody, Frame::kSpace}) {
    for (const string& sequence : kSequences) {
      const bool proper = sequence.front() == sequence.back();
      for (const double b : {proper ? 0 : kPi / 2, proper ? kPi : -kPi / 2}) {
        CAPTURE(sequence, b, int(frame));
        const Factoring found = why(sequence, b, frame);
        const bool sum = found.singular == "only a + c is determined, c = 0 is taken";
        CHECK((sum || found.singular == "only a - c is determined, c = 0 is taken"));
        CHECK(found.solutions[0][0] == Approx(sum ? 0.7 : 0.1).epsilon(1e-14));
      }
    }
  }
}

TEST_CASE("Factoring about any three axes: all solutions, each makes the rotation again") {
  Draw draw(74);
  Worst worst;
  int reachable = 0, compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Vector> u = {draw.vector() * 1e200, draw.vector(), draw.vector() * 1e-300};
    const Rotation r = uniform_rotation(draw);
    CAPTURE(i);
    Factoring all;
    try {
      all = angles_about(r, u[0], u[1], u[2]);
      ++reachable;
    } catch (const std::invalid_argument&) {
    }
    for (const auto& angles : all.solutions) {
      CHECK(in_range(angles));
      worst.add(operator_error(product(u, angles), wide(r)), [&] { return listed(angles); });
    }
    // A grid of 400 sees every root that is not within a step of a double one.
    const Extended alpha = between(u[0], u[1].cast<Extended>().normalized());
    const Extended beta = between(u[2], u[1].cast<Extended>().normalized());
    const Extended phi = between(u[0], wide(r) * u[2].cast<Extended>().normalized());
    const Extended wanted = std::cos(phi);
    if (std::abs(wanted - std::cos(alpha + beta)) < 1e-3 ||
        std::abs(wanted - std::cos(alpha - beta)) < 1e-3) {
      continue;
    }
    ++compared;
    CHECK(int(all.solutions.size()) == crossings(r, u));
    if (all.solutions.size() == 2) {
      CHECK(std::abs(all.solutions[0][1]) <= std::abs(all.solutions[1][1]));
    }
  }
  worst.within("rebuilt", kRebuilt);
  CHECK(reachable > 300);
  CHECK(reachable < 900);
  CHECK(compared > 950);
}

TEST_CASE("Factoring: reach is everything iff u2 is perpendicular to u1 and u3 (Davenport)") {
  Draw draw(75);
  const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  int of_spanning = 0;
  for (int i = 0; i < 10000; ++i) {
    const Rotation r = uniform_rotation(draw);
    const Vector u2 = draw.vector();
    // Perpendicular in double: to rounding only, and still everything.
    const Vector u1 = u2.cross(draw.vector()), u3 = u2.cross(draw.vector());
    CAPTURE(i);
    CHECK_NOTHROW(angles_about(r, u1, u2, u3));
    CHECK_NOTHROW(angles_about(r, x, y, x));  // does not span
    if (refusal([&] { angles_about(r, x, x + y, z); }) == "(accepted)") ++of_spanning;
  }
  // u1.R u3 is uniform in [-1, 1] for a uniform R and within 1/sqrt(2) of 0 for these axes: five
  // standard deviations of the count are 5 sqrt(10000 0.707 0.293) = 228.
  CHECK(std::abs(of_spanning - 10000 / std::sqrt(2)) < 228);
}

TEST_CASE("Factoring: on the border of what is reachable, and just beyond it") {
  const Vector u1(1, 0, 0), u2(1, 1, 0), u3(0.2, 0.3, 1);
  const Extended alpha = between(u1, u2.cast<Extended>().normalized());
  const Extended beta = between(u3, u2.cast<Extended>().normalized());
  const WideVector normal = u1.cross(u2).cast<Extended>().normalized();
  // The rotation that leaves u3 at the angle phi from u1, turned by a about u1 and by c about u3.
  const auto at = [&](Extended phi) {
    const WideVector from = u3.cast<Extended>().normalized();
    const WideVector to =
        u1.cast<Extended>() * std::cos(phi) + normal.cross(u1.cast<Extended>()) * std::sin(phi);
    return rotation_of(about(u1, 0.7L) * Wide::FromTwoVectors(from, to) * about(u3, -2));
  };
  const Extended least = std::abs(alpha - beta), most = alpha + beta;
  for (const Extended inside : {0.0L, 1e-15L, 1e-14L, 1e-12L, 1e-9L, 1e-5L, 0.1L}) {
    for (const Extended phi : {least + inside, most - inside}) {
      CAPTURE(double(inside), double(phi));
      const Rotation r = at(phi);
      const Factoring all = angles_about(r, u1, u2, u3);
      CHECK(all.singular.empty());
      if (inside == 0) CHECK(all.solutions.size() == 1);
      if (inside >= 1e-14L) CHECK(all.solutions.size() == 2);
      for (const auto& angles : all.solutions) {
        within(operator_error(product({u1, u2, u3}, angles), wide(r)), kRebuilt);
      }
    }
  }
  for (const Extended phi : {least - 1e-14L, least - 0.1L, most + 1e-14L}) {
    CAPTURE(double(phi));
    refused([&] { angles_about(at(phi), u1, u2, u3); },
            {"out of reach", "axis 3", text(double(least), 10), text(double(most), 10)});
  }
}

TEST_CASE("Euler angles: a small rotation about the middle axis is not singular") {
  for (const double angle : {1e-14, 1e-15, 1e-17, 1e-300}) {
    CAPTURE(angle);
    const Factoring found = euler_angles(Rotation({1, 0, 0}, angle), "zxz");
    CHECK(found.singular.empty());
    REQUIRE(found.solutions.size() == 2);
    CHECK(found.solutions[0] == std::vector<double>{0, angle, 0});
  }
  CHECK_FALSE(euler_angles(Rotation({0, 0, 1}, 1e-300), "zxz").singular.empty());
}

TEST_CASE("Factoring: axes that are parallel") {
  const Vector u(1, 2, 3), v(-2, 0.5, 1);
  const Rotation r = Rotation(u, 0.5) * Rotation(v, 1.25);
  const auto check = [&](const std::vector<Vector>& axes, const std::string& determined) {
    const Factoring found = angles_about(r, axes[0], axes[1], axes[2]);
    CHECK(found.singular == determined);
    REQUIRE(found.solutions.size() == 1);
    CHECK(found.solutions[0][1] == 0);
    within(operator_error(product(axes, found.solutions[0]), wide(r)), kRebuilt);
  };
  check({u, 2 * u, v}, "only a + b is determined, b = 0 is taken");
  check({u, -3 * u, v}, "only a - b is determined, b = 0 is taken");
  check({u, v, 5 * v}, "only b + c is determined, b = 0 is taken");
  check({u, -v, v}, "only b - c is determined, b = 0 is taken");
  refused([&] { angles_about(r, v, v, u); }, {"out of reach"});
  refused([&] { angles_about(r, u, u, u); }, {"out of reach"});
  CHECK(angles_about(Rotation(u, 1), u, u, u).solutions[0] == std::vector<double>{1, 0, 0});
}

TEST_CASE("Factoring about two axes: where there is an answer it is found") {
  Draw draw(76);
  Worst worst;
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Vector> u = {draw.vector(), draw.vector()};
    const std::vector<double> given = {draw.uniform(-kPi, kPi), draw.uniform(-kPi, kPi)};
    const Rotation r = rotation_of(product(u, given));
    const Factoring found = angles_about(r, u[0], u[1]);
    REQUIRE(found.solutions.size() == 1);
    worst.add(operator_error(product(u, found.solutions[0]), wide(r)),
              [&] { return listed(given); });
    CHECK(found.solutions[0][0] == Approx(given[0]).epsilon(0).margin(1e-13));
    CHECK(found.solutions[0][1] == Approx(given[1]).epsilon(0).margin(1e-13));
    // Turned further about anything else, R u2 leaves the cone.
    refused(
        [&] { angles_about(rotation_of(about(u[0].cross(u[1]), 1e-9L) * wide(r)), u[0], u[1]); },
        {"out of reach", "axis 2"});
  }
  worst.within("rebuilt", kRebuilt);
  const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  refused([&] { angles_about(Rotation(z, kPi / 3), x, y); },
          {"axis 2", "-0.866", "1.570796327 rad", "cosine 0.0"});
  const Factoring same = angles_about(Rotation(x, 1.5), x, -x);
  CHECK(same.singular == "only a - b is determined, b = 0 is taken");
  CHECK(same.solutions[0] == std::vector<double>{1.5, 0});
  refused([&] { angles_about(Rotation(z, 1), x, x); }, {"out of reach"});
}

TEST_CASE("Factoring: bad input") {
  const Vector x(1, 0, 0), y(0, 1, 0), zero = Vector::Zero();
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  refused([&] { angles_about({}, zero, y, x); }, {"axis 1", "zero"});
  refused([&] { angles_about({}, x, zero, x); }, {"axis 2", "zero"});
  refused([&] { angles_about({}, x, y, zero); }, {"axis 3", "zero"});
  refused([&] { angles_about({}, x, zero); }, {"axis 2", "zero"});
  for (const double bad : {nan, inf, -inf}) {
    refused([&] { angles_about({}, x, y, {bad, 0, 0}); }, {"axis 3", text(bad)});
    refused([&] { from_euler_angles("zyx", {0, bad, 0}); }, {"angle 2", text(bad)});
  }
  for (const std::string bad :
       {"", "z", "zz", "zzx", "xyy", "xyzx", "abc", "yx ", " xy", "xyz xzy"}) {
    CAPTURE(bad);
    refused([&] { from_euler_angles(bad, {0, 0, 0}); }, {"xyz", "zyz", "got \"" + bad + "\""});
    refused([&] { euler_angles({}, bad); }, {"got \"" + bad + "\""});
  }
  refused([&] { from_euler_angles("ZYX", {0, 0, 0}); }, {"write \"zyx\"", "body"});
}
