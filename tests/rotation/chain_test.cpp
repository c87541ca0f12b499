// Chains of rotations against products and derivatives in 80 digits; rank, rates, commuting.
#include "rotation/chain.hpp"

#include <Eigen/Dense>

#include "elements.hpp"
#include "refusal.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

struct Sequence {
  std::vector<Vector> axes;
  std::vector<double> angles, rates;
  Frame frame;
  std::array<Exact, 9> matrix;
  std::array<Exact, 3> omega;
  std::vector<std::array<Exact, 3>> carried;
  std::vector<std::array<Exact, 9>> derivatives;
};

std::vector<Sequence> sequences() {
  std::vector<Sequence> all;
  for (Row& row : table("rotation/chains.csv")) {
    Sequence s;
    const auto n = std::size_t(row.number());
    s.frame = row.number() == 0 ? Frame::kBody : Frame::kSpace;
    for (std::size_t k = 0; k < n; ++k) {
      s.axes.push_back(row.vector());
      s.angles.push_back(row.number());
      s.rates.push_back(row.number());
    }
    row.read(s.matrix);
    row.read(s.omega);
    s.carried.resize(n);
    for (auto& axis : s.carried) row.read(axis);
    s.derivatives.resize(n);
    for (auto& derivative : s.derivatives) row.read(derivative);
    all.push_back(std::move(s));
  }
  return all;
}

std::string described(const Sequence& s) {
  std::string all = s.frame == Frame::kBody ? "body" : "space";
  for (std::size_t k = 0; k < s.axes.size(); ++k) {
    all += ", " + reference::described(s.axes[k], s.angles[k]) + " rate " + text(s.rates[k]);
  }
  return all;
}

Chain chain_of(const Sequence& s) { return {s.axes, s.angles, s.rates, s.frame}; }

// Whether the message of the std::invalid_argument has all the words.
}  // namespace

TEST_CASE("chain: the product, in both frames [N20]") {
  Worst worst;
  for (const Sequence& s : sequences()) {
    const Eigen::Matrix<Extended, 3, 3> m = wide(chain_of(s).rotation()).toRotationMatrix();
    Extended square = 0;
    for (int i = 0; i < 9; ++i) {
      const Exact& exact = s.matrix[std::size_t(i)];
      square += std::pow(m(i / 3, i % 3) - exact.hi - exact.lo, 2);
    }
    worst.add(std::sqrt(square), [&] { return described(s); });
  }
  // The product is rounded once: the axis by 1e-16, which turns by twice that, the angle below 2 pi
  // by 4.4e-16; a turn by d changes the matrix by sqrt(2) d.
  worst.within("Q", std::sqrt(2) * (2 * 1e-16 + 4.45e-16));
}

TEST_CASE(
    "chain: angular velocity, axes and derivatives are those of a moving product [N21, N23]") {
  Worst omega, axes, derivatives;
  for (const Sequence& s : sequences()) {
    const Chain chain = chain_of(s);
    const auto where = [&] { return described(s); };
    Extended scale = 0;
    for (const double rate : s.rates) scale += std::abs(rate);
    omega.add(errors(chain.omega(), s.omega).norm() / scale, where);
    for (std::size_t k = 0; k < s.axes.size(); ++k) {
      axes.add(errors(chain.axes()[k], s.carried[k]).norm(), where);
      derivatives.add(errors(entries(chain.derivatives()[k]), s.derivatives[k]).norm(), where);
      CHECK(chain.jacobian().col(Eigen::Index(k)) == chain.axes()[k]);
    }
  }
  // Rounded once from extended precision: sqrt(3) components of 2^-54 and less.
  omega.within("omega", 1e-16);
  axes.within("v_k", 1e-16);
  // [v_k]x Q of the rounded Q, as above (9.1e-16; the projection along v_k is lost), and rounded: a
  // column's entries by 2^-54 at most, nine of them 1.7e-16.
  derivatives.within("dQ/dtheta_k", 9.2e-16 + 1.7e-16);
}

TEST_CASE("chain: space-fixed is body-fixed in the opposite order") {
  for (const Sequence& s : sequences()) {
    Sequence opposite = s;
    for (auto* list : {&opposite.angles, &opposite.rates}) std::reverse(list->begin(), list->end());
    std::reverse(opposite.axes.begin(), opposite.axes.end());
    opposite.frame = s.frame == Frame::kBody ? Frame::kSpace : Frame::kBody;
    CAPTURE(described(s));
    CHECK(chain_of(opposite).rotation() == chain_of(s).rotation());
  }
}

TEST_CASE("chain: rates are the inverse of omega, and the smallest of several") {
  Worst consistent, unique;
  for (const Sequence& s : sequences()) {
    const Chain chain = chain_of(s);
    const auto rank = chain.rank();
    const auto rates = chain.rates(chain.omega());
    const Eigen::Map<const Eigen::VectorXd> x(rates.data(), Eigen::Index(rates.size()));
    const Eigen::Map<const Eigen::VectorXd> given(s.rates.data(), x.size());
    const Eigen::MatrixXd j = chain.jacobian();
    const double smallest = Eigen::JacobiSVD<Eigen::MatrixXd>(j).singularValues()(rank - 1);
    const auto where = [&] { return described(s); };
    // J x is evaluated in double here: n products of up to |x|, 2^-53 each, and as many sums.
    consistent.add((j * x - chain.omega()).norm() / (given.norm() + x.norm()), where);
    CHECK(x.norm() <= given.norm() * (1 + 1e-15 / smallest));
    if (rank == x.size()) unique.add((x - given).norm() * smallest / given.norm(), where);
  }
  consistent.within("J rates - omega", 14 * 1.2e-16);
  // omega was rounded (1e-16 of sum |rates| <= sqrt(3) |rates|), and so are the rates.
  unique.within("rates", std::sqrt(3) * 1e-16 + 1.2e-16);
}

TEST_CASE("chain: the minimum-norm rates have no part that J does not see") {
  Draw draw(71);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    std::vector<Vector> axes;
    std::vector<double> angles;
    for (int k = 0; k < 5; ++k) {
      axes.push_back(draw.vector());
      angles.push_back(draw.uniform(-3, 3));
    }
    const Chain chain(axes, angles);
    const Vector omega = draw.vector();
    const auto rates = chain.rates(omega);
    // x = J^T (J J^T)^-1 omega, by the normal equations in Extended.
    const Eigen::Matrix<Extended, 3, Eigen::Dynamic> j = chain.jacobian().cast<Extended>();
    const Eigen::Matrix<Extended, 3, 3> gram = j * j.transpose();
    const Eigen::Matrix<Extended, Eigen::Dynamic, 1> x =
        j.transpose() * gram.inverse() * omega.cast<Extended>();
    // J here is rounded by 1e-16 a column (2.3e-16 in all), which the condition amplifies.
    const Extended least = std::sqrt(
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(gram.cast<double>()).eigenvalues()(0));
    for (int k = 0; k < 5; ++k) {
      CHECK(std::abs(double(rates[std::size_t(k)] - x(k))) <=
            double((3 * 2.3e-16L / least + 1.2e-16L) * x.norm()));
    }
  }
}

TEST_CASE("chain: rank, at and near the singularity of Euler angles") {
  const auto rank = [](const std::string& letters, const std::vector<double>& angles) {
    return Chain(axes_of_letters(letters), angles).rank();
  };
  for (double a : {0.0, 1.0, -3.0}) {
    CAPTURE(a);
    CHECK(rank("zyx", {a, kPi / 2, 0.5}) == 2);
    CHECK(rank("zyx", {a, -kPi / 2, 0.5}) == 2);
    CHECK(rank("zxz", {a, 0, 0.5}) == 2);
    CHECK(rank("zxz", {a, kPi, 0.5}) == 2);
    // The least singular value is about 0.7 of the distance: well above a few roundings.
    CHECK(rank("zyx", {a, kPi / 2 + 1e-14, 0.5}) == 3);
    CHECK(rank("zyx", {a, 0, 0.5}) == 3);
    CHECK(rank("zxz", {a, 1e-14, 0.5}) == 3);
  }
  CHECK(rank("z", {0.3}) == 1);
  CHECK(rank("zz", {0.3, 1}) == 1);
  CHECK(rank("zzzz", {0.3, 1, 2, 3}) == 1);
  CHECK(rank("zx", {0.3, 1}) == 2);
  CHECK(rank("zxyzxy", {0.3, 1, 0.1, 0.2, 0.3, 0.4}) == 3);
  // Angles of many turns are taken at their word.
  CHECK(rank("zyx", {1e300, 1e300, 0}) == 3);
  // Axes that differ by a rounding are the same axis; by a hundred, not.
  CHECK(Chain({{1, 1, 1}, {0.1, 0.1, 0.1 + 1.4e-17}}, {0, 0}).rank() == 1);
  CHECK(Chain({{1, 1, 1}, {0.1, 0.1, 0.1 + 1.4e-15}}, {0, 0}).rank() == 2);
}

TEST_CASE("chain: an angular velocity out of reach, and one in reach at a singularity") {
  const Chain locked(axes_of_letters("zyx"), {0, kPi / 2, 0});  // v = e3, e2, -e3
  refused([&] { locked.rates({1, 0, 2}); }, {"rank 2", "(1.0, 0.0, 2.0)", "(1.0"});
  const auto shared = locked.rates({0, 3, 2});
  CHECK(shared[1] == Approx(3).epsilon(1e-15));
  CHECK(shared[0] == Approx(1).epsilon(1e-15));
  CHECK(shared[2] == Approx(-1).epsilon(1e-15));
  const Chain hinge(axes_of_letters("z"), {1});
  CHECK(hinge.rates({0, 0, 1e300}) == std::vector<double>{1e300});
  CHECK(hinge.rates({0, 0, 5e-324}) == std::vector<double>{5e-324});
  CHECK(hinge.rates({0, 0, 0}) == std::vector<double>{0});
  refused([&] { hinge.rates({0, 1e-9, 1}); }, {"rank 1", "(0.0, 1e-09, 0.0)"});
  const Chain nearly(axes_of_letters("zyx"), {0, kPi / 2 + 1e-12, 0});
  refused([&] { nearly.rates({1e300, 0, 0}); }, {"exceed", "1e+300"});
}

TEST_CASE("chain: bad input") {
  const Vector x = Vector::UnitX();
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  refused([&] { Chain({}, {}); }, {"at least one axis"});
  refused([&] { Chain({x, x}, {1}); }, {"angles", "1 for 2"});
  refused([&] { Chain({x}, {1, 2}); }, {"angles", "2 for 1"});
  refused([&] { Chain({x}, {1}, std::vector<double>{}); }, {"rates", "0 for 1"});
  refused([&] { Chain({x, Vector::Zero()}, {1, 2}); }, {"axis 2", "zero"});
  for (double bad : {nan, inf, -inf}) {
    refused([&] { Chain({x, x}, {1, bad}); }, {"angle 2", text(bad)});
    refused([&] { Chain({x}, {1}, std::vector<double>{bad}); }, {"rate 1", text(bad)});
    refused([&] { Chain({x, Vector(1, bad, 0)}, {1, 2}); }, {"axis 2", text(bad)});
    refused([&] { Chain({x}, {1}).rates({bad, 0, 0}); }, {"omega", text(bad)});
  }
  refused([&] { Chain({x}, {1}).omega(); }, {"without rates"});
  refused([&] { axes_of_letters("xw"); }, {"x, y, z", "xw"});
  refused([&] { axes_of_letters("XYZ"); }, {"x, y, z", "XYZ", "write \"xyz\""});
  refused([&] { axes_of_letters("321"); }, {"321", "write \"zyx\""});
}

TEST_CASE("commute: exactly the three cases") {
  const Rotation a({1, 2, 3}, 1);
  CHECK(commute(a, Rotation()).why == "identity");
  CHECK(commute(Rotation({0, 1, 0}, 0), a).why == "identity");
  CHECK(commute(Rotation({0, 1, 0}, 4 * kPi), a).why == "identity");
  CHECK(commute(Rotation({0, 1, 0}, 1e-13), a).why == "identity");
  CHECK(commute(a, Rotation({1, 2, 3}, -5)).why == "parallel axes");
  CHECK(commute(a, Rotation({-2, -4, -6}, 2.5)).why == "parallel axes");
  CHECK(commute(Rotation({1, 0, 0}, kPi), Rotation({0, 1, 0}, kPi)).why ==
        "perpendicular half turns");
  CHECK(commute(Rotation({1, 2, 3}, -kPi), Rotation({3, 0, -1}, 3 * kPi)).why ==
        "perpendicular half turns");
  // Neither a half turn alone nor perpendicular axes alone is enough.
  CHECK_FALSE(commute(Rotation({1, 0, 0}, kPi), Rotation({0, 1, 0}, 1)).commute);
  CHECK_FALSE(commute(Rotation({1, 0, 0}, kPi), Rotation({1, 1, 0}, kPi)).commute);
  CHECK(commute(a, Rotation({0, 1, 0}, 1)).why.empty());
  CHECK(commute(a, Rotation({0, 1, 0}, 1), 4).commute);  // no two are further apart than pi
  refused([&] { commute(a, a, -1); }, {"tolerance", "-1.0"});
  refused([&] { commute(a, a, std::nan("")); }, {"tolerance", "nan"});
}

TEST_CASE("commute: the distance is that of the two products") {
  Draw draw(72);
  Worst worst;
  for (int i = 0; i < 2000; ++i) {
    const Rotation r = draw.rotation(), s = draw.rotation();
    const Wide commutator = wide(r) * wide(s) * (wide(s) * wide(r)).conjugate();
    const Extended distance = 2 * std::atan2(commutator.vec().norm(), std::abs(commutator.w()));
    worst.add(std::abs(commute(r, s).distance - distance),
              [&] { return reference::described(r) + " and " + reference::described(s); });
  }
  // Rounded once, in [0, pi].
  worst.within("distance", 2.3e-16);
}
