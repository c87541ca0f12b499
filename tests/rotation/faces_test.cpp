// Every face of a rotation against its true value: over awkward axes and angles (faces.csv), and
// over 10,000 random ones in 50 digits.
#include "elements.hpp"
#include "exact.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

Faces read_faces(Row& row) {
  Faces faces;
  row.read(faces.axis);
  row.read(faces.quaternion);
  row.read(faces.matrix);
  row.read(faces.euler_vector);
  row.read(faces.modified_gibbs);
  row.read(faces.gibbs);
  row.read(faces.mrp);
  return faces;
}

// The angle between r and the operator of the true quaternion q.
Extended operator_error(const Rotation& r, const std::array<Exact, 4>& q) {
  return reference::operator_error(
      wide(r), Wide(q[0].hi + q[0].lo, q[1].hi + q[1].lo, q[2].hi + q[2].lo, q[3].hi + q[3].lo));
}

class FaceErrors {
 public:
  void add(const Vector& axis, double angle, const Faces& exact) {
    const Rotation r(axis, angle);
    const auto where = [&] { return described(axis, angle); };
    axis_.add(errors(r.axis(), exact.axis).norm(), where);
    for (std::size_t i = 0; i < 3; ++i) {
      const Extended wrong = std::abs(error(r.axis()[int(i)], exact.axis[i]));
      axis_component_.add(wrong / Extended(ulp(exact.axis[i].hi)), where);
    }
    quaternion_.add(errors(components(r.quaternion()), exact.quaternion).norm(), where);
    matrix_.add(errors(entries(r.matrix()), exact.matrix).norm(), where);
    euler_vector_.add(ulps(r.euler_vector(), exact.euler_vector), where);
    modified_gibbs_.add(ulps(r.modified_gibbs(), exact.modified_gibbs), where);
    gibbs_.add(ulps(r.gibbs(), exact.gibbs), where);
    mrp_.add(ulps(r.mrp(), exact.mrp), where);
    from_matrix_.add(operator_error(from_matrix(r.matrix()), exact.quaternion), where);
  }
  void within_bounds() const {
    axis_.within("axis", kAxis);
    axis_component_.within("axis component, ulp", 0.51);
    quaternion_.within("quaternion", kQuaternion);
    matrix_.within("matrix", kMatrix);
    euler_vector_.within("Euler vector, ulp", kVectorUlps);
    modified_gibbs_.within("modified Gibbs vector, ulp", kVectorUlps);
    gibbs_.within("Gibbs vector, ulp", kVectorUlps);
    mrp_.within("MRP, ulp", kVectorUlps);
    from_matrix_.within("back from the matrix, rad", kFromMatrix);
  }

 private:
  Worst axis_, axis_component_, quaternion_, matrix_, euler_vector_, modified_gibbs_, gibbs_, mrp_,
      from_matrix_;
};

}  // namespace

TEST_CASE("faces of awkward rotations") {
  FaceErrors all;
  for (Row& row : table("rotation/faces.csv")) {
    const Vector axis = row.vector();
    const double angle = row.number();
    all.add(axis, angle, read_faces(row));
  }
  all.within_bounds();
}

TEST_CASE("faces of random rotations") {
  const std::uint64_t seed = 101;
  CAPTURE(seed);
  Draw draw(seed);
  FaceErrors all;
  for (int i = 0; i < 10000; ++i) {
    const Vector axis = draw.awkward_axis();
    const double angle = draw.awkward_angle();
    all.add(axis, angle, exact_faces(axis, angle));
  }
  all.within_bounds();
}

TEST_CASE("the table and the 50 digits agree") {
  // Two oracles that share nothing; each is good to 2^-65, the numbers are at most 1 here.
  Worst disagreement;
  for (Row& row : table("rotation/faces.csv")) {
    const Vector axis = row.vector();
    const double angle = row.number();
    const Faces read = read_faces(row), computed = exact_faces(axis, angle);
    for (std::size_t i = 0; i < 9; ++i) {
      const Exact &a = read.matrix[i], &b = computed.matrix[i];
      disagreement.add(std::abs((Extended(a.hi) - b.hi) + (a.lo - b.lo)),
                       [&] { return described(axis, angle); });
    }
  }
  disagreement.within("matrix entries", std::ldexp(1, -64));
}

TEST_CASE("a rotation keeps the angle given and a unit axis") {
  for (const Vector& axis : awkward_axes()) {
    for (double angle : awkward_angles()) {
      const Rotation r(axis, angle);
      CHECK(r.angle() == angle);
      CHECK(std::signbit(r.angle()) == std::signbit(angle));
    }
  }
  CHECK(Rotation().angle() == 0);
  CHECK(Rotation().axis() == Vector::UnitX());
  CHECK(Rotation() == Rotation({1, 0, 0}, 0));
}

TEST_CASE("a scaled axis is the same axis") {
  const Rotation r({0.3, -0.5, 0.8}, 1);
  for (int power : {-1000, -500, 1, 1000}) {
    CAPTURE(power);
    const Vector scaled = Vector(0.3, -0.5, 0.8) * std::ldexp(1, power);
    CHECK(Rotation(scaled, 1) == r);
  }
}

TEST_CASE("norm neither overflows nor underflows on the way") {
  CHECK(norm({3e200, -4e200, 0}) == Approx(5e200).epsilon(1e-15));
  CHECK(norm({3e-200, 0, 4e-200}) == Approx(5e-200).epsilon(1e-15));
  CHECK(norm({0, 5e-324, 0}) == 5e-324);
  CHECK(norm({1e308, 1e308, 1e308}) == Approx(std::sqrt(3.0) * 1e308).epsilon(1e-15));
  CHECK(std::isinf(norm({1.7e308, 1.7e308, 0})));
  CHECK(norm(Vector::Zero()) == 0);
}
