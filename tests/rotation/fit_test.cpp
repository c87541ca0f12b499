// Rigid motions fitted to points, the rigidity of configurations, and the mean of rotations.
#include "rotation/fit.hpp"

#include "elements.hpp"
#include "refusal.hpp"
#include "rotation/quaternion.hpp"
#include "rotation/random.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

using Points = std::vector<Vector>;

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kRounded = std::ldexp(1, -53);

Points cloud(Draw& draw, int count, const Vector& size = Vector::Ones()) {
  Points points;
  for (int i = 0; i < count; ++i) points.emplace_back(draw.vector().cwiseProduct(size));
  return points;
}

Points moved(const Points& points, const Rotation& r, const Vector& c) {
  Points all;
  for (const Vector& p : points) all.emplace_back(r * p + c);
  return all;
}

Points times(const Points& points, const Eigen::DiagonalMatrix<double, 3>& factors) {
  Points all;
  for (const Vector& p : points) all.emplace_back(factors * p);
  return all;
}

const Points kTetrahedron = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

double squares(const Points& X, const Points& x, const std::vector<double>& weights,
               const Rotation& r, const Vector& c) {
  double sum = 0;
  for (std::size_t i = 0; i < X.size(); ++i)
    sum += weights[i] * (x[i] - (r * X[i] + c)).squaredNorm();
  return sum;
}

}  // namespace

TEST_CASE("fit_rigid finds the motion that moved the points, at any size") {
  const std::uint64_t seed = 631;
  CAPTURE(seed);
  Draw draw(seed);
  for (const double scale : {1e-170, 1e-30, 1.0, 1e30, 1e150}) {
    CAPTURE(scale);
    Worst turn, shift, residual;
    for (int i = 0; i < 200; ++i) {
      const Points X = cloud(draw, 4 + draw.below(20), Vector::Constant(scale));
      const Rotation r = draw.rotation().canonical();
      const Vector c = scale * draw.vector();
      const RigidFit fit = fit_rigid(X, moved(X, r, c));
      const auto where = [&] { return described(r) + " set " + std::to_string(i); };
      if (!fit.unique) FAIL_CHECK(where() << " is not unique");
      turn.add(operator_error(fit.rotation, r), where);
      shift.add((fit.translation - c).norm() / scale, where);
      residual.add(fit.rms / scale, where);
    }
    // Points of size up to 3.5 are rounded by 2 ulp of 4 a coordinate. The turn is worse by size
    // over thickness: of four random points the thinnest here is 0.1.
    turn.within("rad", 2e-14);
    shift.within("translation", 2e-14);
    residual.within("rms", 2e-15);
  }
}

TEST_CASE("fit_rigid is the least-squares solution: no neighbour is better, c is best") {
  const std::uint64_t seed = 632;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst, rms;
  for (int i = 0; i < 200; ++i) {
    const int n = 3 + draw.below(8);
    const Points X = cloud(draw, n), x = cloud(draw, n);  // unrelated: large residuals
    std::vector<double> weights;
    double total = 0;
    for (int k = 0; k < n; ++k) total += weights.emplace_back(draw.uniform(0.1, 3));
    const RigidFit fit = fit_rigid(X, x, {weights});
    const double least = squares(X, x, weights, fit.rotation, fit.translation);
    const auto where = [&] { return "set " + std::to_string(i); };
    rms.add(std::abs(std::sqrt(least / total) - fit.rms), where);
    for (int k = 0; k < 50; ++k) {
      const double size = std::pow(10, draw.uniform(-7, 0));
      const Rotation r = Rotation(draw.vector(), size) * fit.rotation;
      worst.add(least - squares(X, x, weights, r, fit.translation), where);
      worst.add(least - squares(X, x, weights, r, fit.translation + size * draw.vector()), where);
    }
  }
  // Sums of at most 10 squares of at most 3 times 16, each to a few ulp, here.
  worst.within("a neighbour", 1e-13);
  rms.within("rms", 1e-14);
}

TEST_CASE("weights count as repeated points do, and a weight of zero leaves a point out") {
  Draw draw(633);
  const Points X = cloud(draw, 5), x = cloud(draw, 5);
  const RigidFit weighted = fit_rigid(X, x, {{1, 2, 3, 0, 1}});
  Points many, images;
  for (const int i : {0, 1, 1, 2, 2, 2, 4}) {
    many.push_back(X[std::size_t(i)]);
    images.push_back(x[std::size_t(i)]);
  }
  const RigidFit repeated = fit_rigid(many, images);
  within(operator_error(weighted.rotation, repeated.rotation), 1e-15);
  within((weighted.translation - repeated.translation).norm(), 4e-16);
  within(std::abs(weighted.rms - repeated.rms), 4e-16);
  const RigidFit huge = fit_rigid(X, x, {{1e308, 1.5e308, 1e308, 0, 1e308}});
  CHECK(huge.rotation == fit_rigid(X, x, {{2, 3, 2, 0, 2}}).rotation);
}

TEST_CASE("far from the origin the rounding there decides, and the answer says so") {
  const std::uint64_t seed = 634;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  const Vector far(1e8, -2e8, 5e7);
  for (int i = 0; i < 100; ++i) {
    Points X = cloud(draw, 10);
    for (Vector& p : X) p += far;
    const Rotation r = draw.rotation();
    const Vector c = -(r * far) + far;
    const RigidFit fit = fit_rigid(X, moved(X, r, c));
    CHECK(fit.unique);
    worst.add(operator_error(fit.rotation, r), [&] { return described(r); });
  }
  // Coordinates of 4e8 at most: rounded by 3e-8 in R X and once more in + c, of points at 0.5.
  worst.within("rad", 2e-7);
  // A line of points, which rounding there makes a thin crooked thing.
  Points line, turned;
  const Rotation r({1, 1, 0}, 1);
  for (int i = 0; i < 10; ++i) {
    line.emplace_back(far + i * Vector(0.1, 0.2, -0.3));
    turned.emplace_back(r * line.back());
  }
  CHECK_FALSE(fit_rigid(line, turned).unique);
  const Points same(5, far);
  const RigidFit none = fit_rigid(same, moved(same, r, {0.1, 0.2, 0.3}));
  CHECK_FALSE(none.unique);
  CHECK(none.rotation == Rotation());
}

TEST_CASE("points that leave the rotation undetermined, and the answer given") {
  const Rotation turn({0, 0, 1}, 1);
  const Points line = {{-1, 0, 0}, {0.3, 0, 0}, {2, 0, 0}};
  SECTION("on a line: the least turn of the line") {
    const RigidFit fit = fit_rigid(line, moved(line, turn * Rotation({1, 0, 0}, 2), {0, 0, 5}));
    CHECK_FALSE(fit.unique);
    within(operator_error(fit.rotation, turn), 4e-16);
    CHECK(fit.rms <= 4e-16);
  }
  SECTION("on a line that is reversed: a half turn") {
    const RigidFit fit = fit_rigid(line, {{1, 0, 0}, {-0.3, 0, 0}, {-2, 0, 0}});
    CHECK_FALSE(fit.unique);
    CHECK(fit.rotation.angle() == kPi);
    CHECK(fit.rms <= 1e-16);
  }
  SECTION("coincident, or one: the identity and the translation") {
    for (const std::size_t n : {1U, 3U}) {
      const RigidFit fit = fit_rigid(Points(n, {1, 2, 3}), Points(n, {0.5, 2, 4}));
      CHECK_FALSE(fit.unique);
      CHECK(fit.rotation == Rotation());
      CHECK(fit.translation == Vector(-0.5, 0, 1));
      CHECK(fit.rms == 0);
    }
    CHECK_FALSE(fit_rigid(Points(2, {0, 0, 0}), Points(2, {0, 0, 0})).unique);
    CHECK_FALSE(fit_rigid(kTetrahedron, Points(4, {0, 1, 0})).unique);
  }
  SECTION("mirrored and as thick every way") {
    const RigidFit fit = fit_rigid(kTetrahedron, times(kTetrahedron, {1, 1, -1}));
    CHECK_FALSE(fit.unique);
    // tr(Q^T M) = 1 at best for a reflection M and proper Q; H is M times 1, |X|^2 = 3.
    CHECK(fit.rms == Approx(std::sqrt(3 + 3 - 2 * 1)).epsilon(1e-15));
  }
  SECTION("thin, but not as thin as rounding") {
    Draw draw(635);
    for (const double thickness : {1e-3, 1e-6, 1e-8}) {
      CAPTURE(thickness);
      const Points needle = cloud(draw, 8, {1, thickness, thickness});
      const Rotation r({0.3, -0.5, 0.8}, 2);
      const RigidFit fit = fit_rigid(needle, moved(needle, r, {0, 0, 0}));
      CHECK(fit.unique);
      within(operator_error(fit.rotation, r), 2e-15 / thickness);
    }
  }
}

TEST_CASE("mirrored and flat sets: the best proper rotation") {
  const std::uint64_t seed = 636;
  CAPTURE(seed);
  Draw draw(seed);
  Worst flat;
  for (int i = 0; i < 100; ++i) {
    const Points X = cloud(draw, 6, {1, 1, 0});
    const Rotation r = draw.rotation();
    const RigidFit fit = fit_rigid(X, moved(X, r, {1, 0, 0}));
    CHECK(fit.unique);
    flat.add(operator_error(fit.rotation, r), [&] { return described(r); });
  }
  flat.within("rad", 2e-14);
  // Mirrored across its thinnest direction a box is best left as it is: off by twice its thickness.
  Points box;
  for (int i = 0; i < 8; ++i) box.emplace_back(i & 1 ? 3 : -3, i & 2 ? 2 : -2, i & 4 ? 1 : -1);
  const RigidFit fit = fit_rigid(box, times(box, {1, 1, -1}));
  CHECK(fit.unique);
  CHECK(fit.rotation.angle() <= 1e-18);
  CHECK(fit.rms == 2);
  // Across its longest: s = (9, 4, 1), the best is the half turn that leaves the thinnest wrong.
  const RigidFit across = fit_rigid(box, times(box, {-1, 1, 1}));
  within(operator_error(across.rotation, Rotation({0, 1, 0}, kPi)), 4e-16);
  CHECK(across.rms == Approx(2).epsilon(1e-15));
  CHECK(fit.mirrored);
  CHECK(across.mirrored);
}

TEST_CASE("a fit says that the points are mirrored, whatever their noise") {
  Draw draw(641);
  for (const double noise : {0.0, 1e-12, 1e-3, 0.1}) {
    CAPTURE(noise);
    const Points X = cloud(draw, 8, {3, 2, 1});
    Points x = moved(X, draw.rotation(), {5, 0, 0});
    for (Vector& p : x) p += noise * draw.vector();
    CHECK_FALSE(fit_rigid(X, x).mirrored);
    CHECK(fit_rigid(X, times(x, {1, 1, -1})).mirrored);
  }
  // Noise alone turns a flat set over as often as not, and a reflection fits that hardly better.
  for (int i = 0; i < 50; ++i) {
    const Points X = cloud(draw, 8, {1, 1, 0});
    Points x = moved(X, draw.rotation(), {0, 0, 0});
    for (Vector& p : x) p += 1e-3 * draw.vector();
    CHECK_FALSE(fit_rigid(X, x).mirrored);
    CHECK_FALSE(fit_rigid(times(X, {1, 1, -1}), x).mirrored);
  }
  // A plate whose bumps changed: a reflection leads there no more than a motion does.
  const Points plate = cloud(draw, 30, {1, 1, 1e-6}), bumpy = cloud(draw, 30, {0, 0, 1e-6});
  Points other = plate;
  for (std::size_t i = 0; i < plate.size(); ++i) other[i].z() = bumpy[i].z();
  for (const double side : {1.0, -1.0}) {
    CHECK(is_rigid(plate, times(other, {1, 1, side})).message.starts_with("all distances agree"));
  }
  const Rigidity bad = is_rigid(kTetrahedron, times(kTetrahedron, {1.01, 1, -1}));
  CHECK(bad.message.find("nearer") + bad.message.find("farther") != std::string::npos);
  CHECK(bad.message.ends_with("and it is mirrored"));
}

TEST_CASE("without translation: the attitude from pairs of vectors") {
  const Rotation r({1, 2, -1}, 2.5);
  const Points stars = {Vector(1, 0, 0), Vector(0, 0.6, 0.8)};
  const RigidFit fit = fit_rigid(stars, moved(stars, r, Vector::Zero()), {{}, false});
  CHECK(fit.unique);
  CHECK(fit.translation == Vector(0, 0, 0));
  within(operator_error(fit.rotation, r), 1e-15);
  // The same two as points lie on a line.
  CHECK_FALSE(fit_rigid(stars, moved(stars, r, Vector::Zero())).unique);
  CHECK_FALSE(fit_rigid({{1, 0, 0}, {-2, 0, 0}}, {{0, 1, 0}, {0, -2, 0}}, {{}, false}).unique);
}

TEST_CASE("refused: lists that are no two configurations, weights that are none") {
  const Points one = {{1, 2, 3}};
  CHECK(refusal([&] { fit_rigid({}, {}); }) == "fit_rigid: expected one point or more");
  CHECK(refusal([&] { fit_rigid(one, {}); }) ==
        "fit_rigid: expected as many points in both lists, got 1 and 0");
  CHECK(refusal([&] {
          fit_rigid(one, {{1, kNan, 3}});
        }) ==
        "fit_rigid: point 1 of the second list: expected finite numbers, got (1.0, nan, 3.0)");
  CHECK(refusal([&] { fit_rigid(one, one, {{1, 2}}); }) == "fit_rigid: expected 1 weights, got 2");
  CHECK(refusal([&] { fit_rigid(one, one, {{-1}}); }) ==
        "fit_rigid: weight 1: expected a finite number, 0 or more, got -1.0");
  CHECK(refusal([&] { fit_rigid(one, one, {{kNan}}); }).find("nan") != std::string::npos);
  CHECK(refusal([&] { fit_rigid(one, one, {{0}}); }) == "fit_rigid: all weights are zero");
  CHECK(refusal([&] { is_rigid(one, {}); }).starts_with("is_rigid: expected as many"));
  for (const double bad : {0.0, -1.0, kNan}) {
    CHECK(refusal([&] { is_rigid(one, one, bad); }).find(text(bad)) != std::string::npos);
  }
  CHECK(refusal([] { mean({}); }) == "mean: expected one rotation or more");
  CHECK(refusal([] { mean({Rotation()}, {0}); }) == "mean: all weights are zero");
}

TEST_CASE("rigid configurations, and what is wrong with others") {
  Draw draw(637);
  const Points X = cloud(draw, 50);
  const Rotation r = draw.rotation();
  Points x = moved(X, r, {1, 2, 3});
  CHECK(is_rigid(X, x).rigid);
  CHECK(is_rigid(X, x).message.starts_with("all distances agree to "));
  x[7] += 1e-6 * (x[7] - x[30]).normalized();
  const Rigidity bent = is_rigid(X, x);
  CHECK_FALSE(bent.rigid);
  CHECK(bent.message.starts_with("points "));
  CHECK(bent.message.find(" 8 ") != std::string::npos);
  CHECK(is_rigid(X, x, 1e-6).rigid);
  const Points stretched = times({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {1.25, 1, 1});
  CHECK(is_rigid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, stretched).message ==
        "points 1 and 2 are farther apart by 0.156 of the body's size");
}

TEST_CASE("the search for a pair can be stopped") {
  const Points two = {Vector(0, 0, 0), Vector(1, 0, 0)};
  CHECK_THROWS_AS(is_rigid(two, two, 1e-9, [] { throw std::bad_function_call(); }),
                  std::bad_function_call);
}

TEST_CASE("mirrored bodies keep all distances and are not rigid; flat ones can be turned over") {
  Draw draw(638);
  const Rotation r = draw.rotation();
  for (const double scale : {1e-150, 1.0, 1e150}) {
    CAPTURE(scale);
    const Points body = cloud(draw, 20, Vector::Constant(scale));
    const Rigidity mirrored = is_rigid(body, moved(times(body, {1, -1, 1}), r, {0, scale, 0}));
    CHECK_FALSE(mirrored.rigid);
    CHECK(mirrored.message.starts_with("mirrored"));
    const Points flat = cloud(draw, 20, {scale, scale, 0});
    CHECK(is_rigid(flat, moved(times(flat, {1, -1, 1}), r, {0, scale, 0})).rigid);
    const Points line = cloud(draw, 20, {scale, 0, 0});
    CHECK(is_rigid(line, moved(times(line, {-1, 1, 1}), r, {0, scale, 0})).rigid);
  }
  CHECK_FALSE(is_rigid(kTetrahedron, times(kTetrahedron, {1, 1, -1})).rigid);
  // A mirrored sheet passes while it is thinner than the tolerance allows.
  const Points sheet = cloud(draw, 20, {1, 1, 1e-5});
  CHECK_FALSE(is_rigid(sheet, times(sheet, {1, -1, 1})).rigid);
  CHECK(is_rigid(sheet, times(sheet, {1, -1, 1}), 1e-4).rigid);
  CHECK(is_rigid({{1, 2, 3}}, {{3, 2, 1}}).rigid);
  CHECK(is_rigid(Points(3, {1, 2, 3}), Points(3, {0, 0, 0})).rigid);
  CHECK_FALSE(is_rigid(Points(2, {1, 2, 3}), {{0, 0, 0}, {0, 0, 1}}).rigid);
}

TEST_CASE("the mean of rotations is the nearest rotation to the mean of their matrices") {
  // sum w |R - R_i|^2 = const - 2 tr(R^T sum w R_i): another route to the same rotation.
  const std::uint64_t seed = 639;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  for (int i = 0; i < 300; ++i) {
    std::vector<Rotation> rotations;
    std::vector<double> weights;
    Matrix sum = Matrix::Zero();
    const Rotation centre = draw.rotation();
    for (int k = 1 + draw.below(10); k > 0; --k) {
      rotations.push_back(Rotation(draw.vector(), draw.uniform(-1, 1)) * centre);
      weights.push_back(draw.uniform(0, 2));
      sum += weights.back() * rotations.back().matrix();
    }
    worst.add(operator_error(mean(rotations, weights), nearest_rotation(sum)),
              [&] { return described(centre); });
  }
  // Turns of at most 1 rad: sum w R_i / w is at least cos 1 in every direction, its rounding of
  // kMatrix and a few sums turns by no more than that over cos 1; and the nearest rotation's own.
  worst.within("rad", 1e-14);
}

TEST_CASE("the mean of symmetric sets") {
  const Rotation centre({1, -2, 2}, 2.5);
  std::vector<Rotation> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * kPi * i / 5;
    star.push_back(centre * Rotation({std::cos(angle), std::sin(angle), 0}, 1));
  }
  within(operator_error(mean(star), centre), 2e-15);
  // Turns count for nothing, nor does the order.
  for (Rotation& r : star) r = {r.axis(), r.angle() + 2 * kPi};
  within(operator_error(mean({star[3], star[1], star[0], star[4], star[2]}), centre), 4e-15);
  CHECK(mean({Rotation({0, 0, 1}, 7)}) == Rotation({0, 0, 1}, 7).canonical());
  const Rotation a({0, 0, 1}, 0.5), b({0, 0, 1}, 1.5);
  within(operator_error(mean({a, b}), Rotation({0, 0, 1}, 1)), 4e-16);
  within(operator_error(mean({a, b}, {1e308, 1e308}), Rotation({0, 0, 1}, 1)), 4e-16);
  within(operator_error(mean({a, b}, {0, 1}), b), 4e-16);
  // Two weights: (w_a q_a q_a^T + w_b q_b q_b^T) in the plane of both, tan(2 x) as of a sum of
  // vectors w at the angles of the rotations.
  const double expected =
      std::atan2(3 * std::sin(0.5) + std::sin(1.5), 3 * std::cos(0.5) + std::cos(1.5));
  within(operator_error(mean({a, b}, {3, 1}), Rotation({0, 0, 1}, expected)), 4e-16);
}

TEST_CASE("refused: a mean that is not unique") {
  const Rotation r({1, 2, 3}, 1);
  const std::string message = refusal([&] { mean({r, r * Rotation({0, 0, 1}, kPi)}); });
  CHECK(message ==
        "mean: many rotations are as near to all: the two greatest eigenvalues of sum w q q^T are "
        "equal, 0.5");
  CHECK(refusal([&] {
          mean({Rotation(), Rotation({1, 0, 0}, kPi), Rotation({0, 1, 0}, kPi),
                Rotation({0, 0, 1}, kPi)});
        }).find("0.25") != std::string::npos);
  // A little off a half turn there is a mean: the middle of the shorter way. Rounding over the gap
  // of the eigenvalues, 5e-7.
  const Rotation near_half({0, 0, 1}, kPi - 1e-6);
  within(operator_error(mean({Rotation(), near_half}), Rotation({0, 0, 1}, kPi / 2 - 5e-7)), 1e-9);
}
