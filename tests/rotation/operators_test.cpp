// Operators: what a rotation's is made of, how it is recognised, and the ways back from it.
#include "rotation/operators.hpp"

#include "elements.hpp"
#include "exact.hpp"
#include "refusal.hpp"
#include "rotation/extended.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

using RealMatrix = Eigen::Matrix<Real, 3, 3>;

// The nearest rotation by Newton's iteration for the polar factor (det m > 0), in 50 digits.
RealMatrix polar_factor(const Matrix& m) {
  RealMatrix x = m.cast<Real>() / Real(m.cwiseAbs().maxCoeff());
  for (int i = 0; i < 60; ++i) x = (x + RealMatrix(x.inverse().transpose())) / Real(2);
  return x;
}

// The angle between r and an exact rotation matrix: 2 sqrt(2) sin(angle/2) is their distance.
Extended operator_error(const Rotation& r, const RealMatrix& q) {
  const Faces faces = exact_faces(r.axis(), r.angle());
  RealMatrix difference = q;
  for (int i = 0; i < 9; ++i) {
    const Exact& entry = faces.matrix[std::size_t(i)];
    difference(i / 3, i % 3) -= Real(entry.hi) + Real(entry.lo);
  }
  return Extended(Real(sqrt(difference.squaredNorm() / 2)));
}

std::vector<Rotation> cube_rotations() {
  std::vector<Rotation> all;
  for (const Vector& z : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1), Vector(-1, 0, 0),
                          Vector(0, -1, 0), Vector(0, 0, -1)}) {
    for (int i = 0; i < 3; ++i) {
      for (double sign : {1, -1}) {
        const Vector x = sign * Vector::Unit(i);
        if (x.dot(z) != 0) continue;
        Matrix m;
        m << x, z.cross(x), z;
        all.push_back(from_matrix(m));
      }
    }
  }
  return all;
}

}  // namespace

TEST_CASE("N4, N5 and N6 are the same operator") {
  Worst n4, n6;
  for (const Rotation& r : elements(500, 901)) {
    const Vector& u = r.axis();
    // cos and sin of a large angle as the matrix has them.
    const Extended c = std::cos(Extended(r.angle())), s = std::sin(Extended(r.angle()));
    const auto where = [&] { return described(r); };
    const Matrix uu = outer(u, u);
    const Matrix form4 = uu + double(c) * (Matrix::Identity() - uu) + double(s) * skew(u);
    n4.add((form4 - r.matrix()).cwiseAbs().maxCoeff(), where);
    const auto [first, v, w] = orthonormal_basis(u);
    const Matrix form6 = (outer(v, v) + outer(w, w)) * double(c) +
                         (outer(w, v) - outer(v, w)) * double(s) + outer(first, first);
    n6.add((form6 - r.matrix()).cwiseAbs().maxCoeff(), where);
  }
  // Each entry: five or six products and sums of numbers of at most 1, half an ulp each, 5.6e-17
  // below 1 and 1.1e-16 at it; in N6 also v and w, off by an ulp of 1.1e-16 each.
  n4.within("N4", 6 * 1.1e-16);
  n6.within("N6", 1e-15);
}

TEST_CASE("outer, skew and axial are what they do to a vector") {
  const std::uint64_t seed = 902;
  CAPTURE(seed);
  Draw draw(seed);
  for (int i = 0; i < 100; ++i) {
    const auto small = [&] {
      return Vector(draw.below(99) - 49, draw.below(99) - 49, draw.below(99));
    };
    const Vector a = small(), b = small(), x = small();  // whole: all exact
    CHECK(outer(a, b) * x == a * b.dot(x));
    CHECK(skew(a) * x == a.cross(x));
    CHECK(axial(skew(a)) == a);
    CHECK(axial(outer(a, b)) == -0.5 * a.cross(b));
    const Rotation r(a + Vector(0, 0, 1), draw.uniform(-7, 7));
    // Two entries off by kMatrix/2 at most make a component.
    CHECK((axial(r.matrix()) - r.axis() * std::sin(r.angle())).cwiseAbs().maxCoeff() <= kMatrix);
  }
  Matrix huge = Matrix::Zero();
  huge(2, 1) = 1.7e308;
  huge(1, 2) = -1.7e308;
  CHECK(axial(huge) == Vector(1.7e308, 0, 0));
}

TEST_CASE("orthonormal basis: orthonormal, right-handed, along u") {
  const std::uint64_t seed = 903;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  std::vector<Vector> directions = awkward_axes();
  for (int i = 0; i < 1000; ++i) directions.push_back(draw.awkward_axis());
  for (const Vector& u : directions) {
    const auto [first, v, w] = orthonormal_basis(u);
    Matrix basis;
    basis << first, v, w;
    const auto where = [&] { return text(u); };
    const ExtendedMatrix e = basis.cast<Extended>();
    worst.add((e.transpose() * e - ExtendedMatrix::Identity()).cwiseAbs().maxCoeff(), where);
    INFO(where());
    CHECK(first == unit(u));
    CHECK(basis.determinant() > 0);
  }
  // Nine components rounded once: a product of two columns is off by 2 sqrt(3) 2^-54 at most.
  worst.within("dot products", 2 * std::sqrt(3.0) * 0x1p-53);
  const Vector e1(1, 0, 0), e2(0, 1, 0), e3(0, 0, 1);
  CHECK(orthonormal_basis(2 * e1) == std::array{e1, e2, e3});
  CHECK(orthonormal_basis(e2) == std::array{e2, e3, e1});
  CHECK(orthonormal_basis(5e-324 * e3) == std::array{e3, e1, e2});
  CHECK(orthonormal_basis(-e1) == std::array<Vector, 3>{-e1, e2, -e3});
  CHECK(refusal([] { orthonormal_basis(Vector::Zero()); }).find("zero") != std::string::npos);
}

TEST_CASE("proper orthogonal, with the measured defect") {
  for (const Rotation& r : elements(100, 904)) {
    INFO(described(r));
    // Nine entries off by kMatrix together: 2 kMatrix of the columns' products.
    CHECK(proper_orthogonal(r.matrix(), 2 * kMatrix).proper);
    CHECK_FALSE(proper_orthogonal(-r.matrix()).proper);
    CHECK_FALSE(proper_orthogonal(r.matrix() * 1.001).proper);
    CHECK(proper_orthogonal(r.matrix() * 1.001, 0.003).proper);
  }
  const Matrix one = Matrix::Identity();
  CHECK(proper_orthogonal(one, 0).proper);
  CHECK(proper_orthogonal(one).measured ==
        "the largest entry of m^T m - 1 is 0.0 and the determinant is 1.0");
  CHECK(proper_orthogonal(-one).measured ==
        "the largest entry of m^T m - 1 is 0.0 and the determinant is -1.0, a reflection");
  CHECK(proper_orthogonal(2 * one).measured ==
        "the largest entry of m^T m - 1 is 3.0 and the determinant is 8.0");
  CHECK_FALSE(proper_orthogonal(Matrix::Zero(), 1).proper);
  CHECK_FALSE(proper_orthogonal(1e300 * one).proper);
  Matrix bad = one;
  bad(0, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(proper_orthogonal(bad).proper);
  CHECK(proper_orthogonal(bad).measured.find("not all entries are finite") == 0);
  for (double tolerance : {-1e-9, bad(0, 1), std::numeric_limits<double>::infinity()}) {
    CHECK(refusal([&] { proper_orthogonal(one, tolerance); }).find(text(tolerance)) !=
          std::string::npos);
  }
  CHECK(refusal([&] { from_matrix(2 * one); }) ==
        "from_matrix: expected a proper orthogonal matrix (within 1e-06), but the largest entry of "
        "m^T m - 1 is 3.0 and the determinant is 8.0; rotation.nearest(m) gives the nearest "
        "rotation");
  CHECK(refusal([&] { from_eigenvectors(-one); }).find("from_eigenvectors: ") == 0);
}

TEST_CASE("from_matrix: 1.5e-15 rad everywhere, close to pi too") {
  const std::uint64_t seed = 905;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  const auto add = [&](const Rotation& r) {
    worst.add(operator_error(from_matrix(r.matrix()), r), [&] { return described(r); });
  };
  for (const Rotation& r : elements(1000, 906)) add(r);
  for (int i = 0; i < 2000; ++i) {
    add({draw.awkward_axis(), draw.awkward_angle()});
    add({draw.awkward_axis(), kPi - std::pow(10, draw.uniform(-17, 0))});
  }
  worst.within("rad", kFromMatrix);
}

TEST_CASE("from_matrix: small angles to 4 ulp, down to the smallest double") {
  const std::uint64_t seed = 907;
  CAPTURE(seed);
  Draw draw(seed);
  Worst size, direction;
  for (int i = 0; i < 3000; ++i) {
    const Rotation r(draw.awkward_axis(), std::pow(10, draw.uniform(-323.3, -6)));
    const Matrix m = r.matrix();
    const Rotation back = from_matrix(m);
    // What the matrix, rounded as it is, says: sin(theta) n in 50 digits, theta^3/6 below an ulp
    // from 1e-8 on; below 1e-308 the entries are multiples of 5e-324.
    const RealVector s = (RealVector(Real(m(2, 1)), Real(m(0, 2)), Real(m(1, 0))) -
                          RealVector(Real(m(1, 2)), Real(m(2, 0)), Real(m(0, 1)))) /
                         Real(2);
    const Real sine = sqrt(s.squaredNorm());
    const auto where = [&] { return described(r); };
    if (sine == 0) {
      INFO(where());
      CHECK(back == Rotation());
      continue;
    }
    const Real angle = asin(sine);
    size.add(Extended(Real(abs(Real(back.angle()) - angle))) / ulp(back.angle()), where);
    direction.add(errors(back.axis(), split<3>(RealVector(s / sine))).norm(), where);
  }
  size.within("angle, ulp", 4);
  direction.within("axis", kAxis);
  const Vector e3(0, 0, 1);
  for (double angle : {5e-324, 1e-300, 1e-160, 1e-17, 1e-8}) {
    CHECK(from_matrix(Rotation(e3, angle).matrix()) == Rotation(e3, angle));
    CHECK(from_matrix(Rotation(e3, -angle).matrix()) == Rotation(-e3, angle));
  }
}

TEST_CASE("noise up to 1e-6: the nearest rotation, by Newton's iteration in 50 digits") {
  const std::uint64_t seed = 908;
  CAPTURE(seed);
  Draw draw(seed);
  Worst from, nearest;
  for (int i = 0; i < 150; ++i) {
    const Rotation r = draw.rotation();
    const double noise = std::pow(10, draw.uniform(-16, std::log10(4e-7)));  // 2 noise in m^T m
    Matrix m = r.matrix();
    for (double& x : m.reshaped()) x += draw.uniform(-noise, noise) / 2;
    const RealMatrix exact = polar_factor(m);
    const auto where = [&] { return described(r) + " noise " + text(noise); };
    from.add(operator_error(from_matrix(m), exact), where);
    nearest.add(operator_error(nearest_rotation(m), exact), where);
  }
  from.within("from_matrix, rad", kFromMatrix);
  nearest.within("nearest_rotation, rad", kFromMatrix);
}

TEST_CASE("nearest rotation to any matrix with det > 0, at any scale") {
  // The rounding of an axis and an angle in [0, pi], 4.2e-16, and the singular vectors in Extended,
  // some dozens of roundings of 2^-64 over the sharpness (s2 + s3)/s1.
  const std::uint64_t seed = 909;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  for (int i = 0; i < 150; ++i) {
    Matrix m;
    for (double& x : m.reshaped()) x = draw.uniform(-1, 1);
    if (m.determinant() < 0) m = -m;
    if (m.determinant() < 1e-3) continue;
    m *= std::pow(10, draw.uniform(-300, 300));
    worst.add(operator_error(nearest_rotation(m), polar_factor(m)), [&] { return text(m); });
  }
  worst.within("rad", 1e-15);
}

TEST_CASE("nearest: why there are many") {
  const Matrix one = Matrix::Identity();
  CHECK(refusal([&] { nearest_rotation(-one); }) ==
        "nearest: many rotations are as near: the matrix is a reflection whose two least singular "
        "values are equal (singular values (1.0, 1.0, 1.0))");
  CHECK(refusal([] {
          nearest_rotation(Vector(2e-300, 1e-300, -1e-300).asDiagonal());
        }).find("reflection") != std::string::npos);
  CHECK(refusal([] { nearest_rotation(Vector(0, 1e300, 0).asDiagonal()); }).find("has rank 1") !=
        std::string::npos);
  CHECK(refusal([] { nearest_rotation(Matrix::Zero()); }).find("has rank 0") != std::string::npos);
  // A rank that only the rounding of the entries makes is none.
  CHECK(refusal([] {
          nearest_rotation(outer({0.1, 0.2, 0.3}, unit({4, 5, 6})));
        }).find("has rank 1") != std::string::npos);
  for (double scale : {1e-320, 1e-300, 1e300}) {
    CHECK(nearest_rotation(scale * one).angle() <= 1e-19);
  }
}

TEST_CASE("eigenvalues and eigenvectors give the same rotation, less well near the identity") {
  const std::uint64_t seed = 910;
  CAPTURE(seed);
  Draw draw(seed);
  Worst ordinary, small;
  const auto add = [&](const Rotation& r) {
    // The matrix's rounding, kMatrix, turns an eigenvector by that over the distance
    // 2 sin(theta/2) of its eigenvalue to the next; the operator by 2 sin(theta/2) of that.
    ordinary.add(operator_error(from_eigenvectors(r.matrix()), r), [&] { return described(r); });
  };
  for (const Rotation& r : elements(500, 911)) add(r);
  for (const Rotation& r : cube_rotations()) add(r);
  for (int i = 0; i < 500; ++i) {
    add({draw.awkward_axis(), kPi - std::pow(10, draw.uniform(-17, 0))});
    const Rotation r(draw.vector(), std::pow(10, draw.uniform(-12, 0)));
    small.add((from_eigenvectors(r.matrix()).axis() - r.axis()).norm() * r.angle(),
              [&] { return described(r); });
  }
  ordinary.within("operator, rad", 2 * kFromMatrix);
  small.within("axis times angle", 1.1 * kMatrix);  // theta/(2 sin(theta/2)) <= 1.05
  CHECK(from_eigenvectors(Matrix::Identity()) == Rotation());
  CHECK(from_eigenvectors(Vector(-1, 1, -1).asDiagonal()) == Rotation({0, 1, 0}, kPi));
  CHECK(from_eigenvectors(Rotation({1, -2, -3}, kPi).matrix()).axis().z() > 0);
  CHECK(cube_rotations().size() == 24);
}
