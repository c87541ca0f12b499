// Random rotations: their distribution against the Haar measure's, and that they never change.
#include "rotation/random.hpp"

#include <functional>

#include "elements.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

constexpr std::size_t kCount = 20000;
constexpr double kChance = 1e-6;  // of a sound generator to fail one check, had it another seed

// The greatest distance between the distribution of the values and the one expected, times sqrt(n).
double deviation(std::vector<double> values, const std::function<double(double)>& distribution) {
  std::sort(values.begin(), values.end());
  const auto n = double(values.size());
  double greatest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double p = distribution(values[i]);
    greatest = std::max({greatest, double(i + 1) / n - p, p - double(i) / n});
  }
  return greatest * std::sqrt(n);
}
// P(deviation > t) <= 2 exp(-2 t^2) for every n (Dvoretzky, Kiefer, Wolfowitz, Massart).
const double kDeviation = std::sqrt(std::log(2 / kChance) / 2);

double angle_distribution(double theta) { return (theta - std::sin(theta)) / kPi; }
double component_distribution(double z) { return (1 + z) / 2; }  // Archimedes: of a point of S^2

void is_uniform(const std::vector<Rotation>& rotations) {
  std::vector<double> angles;
  for (const Rotation& r : rotations) angles.push_back(r.angle());
  CHECK(deviation(angles, angle_distribution) <= kDeviation);
  std::nth_element(angles.begin(), angles.begin() + long(angles.size() / 2), angles.end());
  const double median = angles[angles.size() / 2];
  const std::vector<Vector> directions = {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1),
                                          Vector(0.6, -0.48, 0.64)};
  for (const Vector& direction : directions) {
    CAPTURE(text(direction));
    // The axis, of small and of great angles, and where a fixed direction is turned to.
    std::vector<double> components[2], images;
    for (const Rotation& r : rotations) {
      components[r.angle() > median ? 1 : 0].push_back(r.axis().dot(direction));
      images.push_back((r * Vector(0, 0.8, 0.6)).dot(direction));
    }
    CHECK(deviation(components[0], component_distribution) <= kDeviation);
    CHECK(deviation(components[1], component_distribution) <= kDeviation);
    CHECK(deviation(images, component_distribution) <= kDeviation);
  }
}

}  // namespace

TEST_CASE("random rotations are uniform on SO(3)") {
  for (const std::uint64_t seed : {0ULL, 1ULL, 2026ULL, ~0ULL}) {
    CAPTURE(seed);
    is_uniform(random_rotations(seed, kCount));
  }
}

TEST_CASE("the first random rotations of successive seeds are uniform too") {
  std::vector<Rotation> first;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    first.push_back(random_rotations(seed, 1).front());
  }
  is_uniform(first);
}

TEST_CASE("a rotation of all random rotations, from either side, leaves them uniform") {
  const Rotation turn({1, -2, 0.5}, 2.5);
  std::vector<Rotation> left, right;
  for (const Rotation& r : random_rotations(5, kCount)) {
    left.push_back((turn * r).canonical());
    right.push_back((r * turn).canonical());
  }
  is_uniform(left);
  is_uniform(right);
}

TEST_CASE("moments of random rotations: entries have mean 0, products mean 1/3 or 0") {
  // Hoeffding: the mean of n values in [-1, 1] is off by t with probability 2 exp(-n t^2/2) at
  // most.
  const double bound = std::sqrt(2 * std::log(2 / kChance) / kCount);
  Eigen::Matrix<double, 9, 1> mean = Eigen::Matrix<double, 9, 1>::Zero();
  Eigen::Matrix<double, 9, 9> products = Eigen::Matrix<double, 9, 9>::Zero();
  for (const Rotation& r : random_rotations(3, kCount)) {
    const Eigen::Matrix<double, 9, 1> q = entries(r.matrix());
    mean += q / kCount;
    products += q * q.transpose() / kCount;
  }
  CHECK(mean.cwiseAbs().maxCoeff() <= bound);
  const auto expected = (Eigen::Matrix<double, 9, 9>::Identity() / 3).eval();
  CHECK((products - expected).cwiseAbs().maxCoeff() <= bound);
}

TEST_CASE("random rotations are canonical, and the same for the same seed, however many") {
  const std::vector<Rotation> many = random_rotations(11, 1000);
  for (const Rotation& r : many) {
    if (!(r == r.canonical())) FAIL_CHECK(described(r) << " is not canonical");
  }
  CHECK(random_rotations(11, 10) == std::vector<Rotation>(many.begin(), many.begin() + 10));
  CHECK(random_rotations(12, 1).front() != many.front());
  CHECK(random_rotations(11, 0).empty());
  CHECK_THROWS_AS(random_rotations(11, 10'000'001), std::invalid_argument);
}

TEST_CASE("random rotations are those of the published generator, computed elsewhere") {
  // mt19937_64 by its recurrence, the rest in 40 digits: the first and the 400th.
  const std::vector<Rotation> zero = random_rotations(0, 400), year = random_rotations(2026, 400);
  Worst worst;
  const auto compare = [&](const Rotation& r, const Vector& axis, double angle) {
    worst.add((r.axis() - axis).norm() + std::abs(r.angle() - angle), [&] { return described(r); });
  };
  compare(zero[0], {-0.5001152330875832, -0.0823124186841131, 0.8620379454317099},
          0.801021654640956);
  compare(zero[399], {-0.943720526288147, -0.3290808017486062, -0.03312694044003106},
          2.9103189237532145);
  compare(year[0], {-0.33159296431865903, 0.05596527740420809, -0.9417611128834289},
          2.3943104451770654);
  compare(year[399], {-0.7565609333320842, -0.5239880496873585, 0.39121870857683194},
          2.7655244872457434);
  // An ulp of each component and of the angle.
  worst.within("axis and angle", kAxis + 4.5e-16);
}
