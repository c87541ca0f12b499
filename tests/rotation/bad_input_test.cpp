// What is refused, and what the message says.
#include <functional>

#include "elements.hpp"
#include "refusal.hpp"
#include "rotation/quaternion.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("refused: an axis without direction, an angle without value") {
  refused([] { Rotation({0, 0, 0}, 1); }, {"axis", "zero"});
  refused([] { Rotation({0, -0.0, 0}, 0); }, {"axis", "zero"});
  for (double bad : {kNan, kInf, -kInf}) {
    CAPTURE(bad);
    refused([&] { Rotation({1, bad, 0}, 1); }, {"axis", text(Vector(1, bad, 0))});
    refused([&] { Rotation({1, 0, 0}, bad); }, {"angle", text(bad)});
    refused([&] { unit({0, 0, bad}, "omega"); }, {"omega", text(bad)});
  }
  refused([] { unit(Vector::Zero(), "direction"); }, {"direction", "zero"});
}

TEST_CASE("refused: faces that are not finite") {
  const std::vector<std::function<void(const Vector&)>> vector_faces = {
      from_euler_vector, from_modified_gibbs, from_gibbs, from_mrp};
  for (double bad : {kNan, kInf, -kInf}) {
    CAPTURE(bad);
    for (const auto& from : vector_faces) refused([&] { from({0, bad, 0}); }, {text(bad)});
    refused([&] { from_quaternion({bad, 0, 0, 0}); }, {"from_quaternion", text(bad)});
    refused([&] { from_quaternion({1, 0, 0, bad}); }, {"from_quaternion", text(bad)});
    refused([&] { polar({0, bad, 0, 0}); }, {"polar"});
    Matrix m = Matrix::Identity();
    m(1, 2) = bad;
    refused([&] { from_matrix(m); }, {"from_matrix", text(bad)});
    refused([&] { nearest_rotation(m); }, {"nearest", text(bad)});
    refused([&] { Rotation() * Vector(bad, 0, 0); }, {text(bad)});
    refused([&] { slerp({}, {{0, 0, 1}, 1}, bad); }, {text(bad)});
  }
}

TEST_CASE("refused: a quaternion that is not unit, with its norm") {
  refused([] { from_quaternion({2, 0, 0, 0}); }, {"from_quaternion", "unit", "2.0"});
  refused([] { from_quaternion({0, 0, 0, 0}); }, {"from_quaternion", "unit", "0.0"});
  refused([] { from_quaternion({1 + 2e-6, 0, 0, 0}); }, {"from_quaternion", "1.000002"});
  refused([] { from_quaternion({1e308, 1e308, 1e308, 1e308}); }, {"from_quaternion"});
  refused([] { polar({0, 0, 0, 0}); }, {"polar", "zero"});
}

TEST_CASE("refused: a matrix that is not a rotation, with its defect") {
  Matrix sheared = Matrix::Identity();
  sheared(0, 1) = 0.25;
  refused([&] { from_matrix(sheared); }, {"from_matrix", "orthogonal", "0.25", "nearest"});
  refused([] { from_matrix(2 * Matrix::Identity()); }, {"from_matrix", "orthogonal", "3.0"});
  refused([] { from_matrix(Matrix::Zero()); }, {"from_matrix", "orthogonal", "1.0"});
  refused([] { from_matrix(1e300 * Matrix::Identity()); }, {"from_matrix", "orthogonal"});
  refused([] { from_matrix(-Matrix::Identity()); }, {"from_matrix", "reflection"});
  refused([] { from_matrix(Vector(1, -1, 1).asDiagonal()); }, {"from_matrix", "reflection"});
}

TEST_CASE("refused: vectors outside the domain of their face") {
  refused([] { from_modified_gibbs({0, 1.001, 0}); }, {"from_modified_gibbs", "1.001"});
  refused([] { from_modified_gibbs({0, 1 + 4e-15, 0}); }, {"from_modified_gibbs"});
  refused([] { from_modified_gibbs({0.8, 0.8, 0}); }, {"from_modified_gibbs", "(0.8, 0.8, 0.0)"});
  refused([] { from_euler_vector({1.7e308, 1.7e308, 0}); }, {"1.7e+308"});
}

TEST_CASE("refused: a power without value") {
  refused([] { Rotation({0, 0, 1}, 1e200).power(1e200); }, {"1e+200"});
  refused([] { Rotation({0, 0, 1}, 1).power(kNan); }, {"nan"});
  refused([] { Rotation({0, 0, 1}, 0).power(kInf); }, {"inf"});
}

TEST_CASE("refused: a matrix without a nearest rotation") {
  refused([] { nearest_rotation(Matrix::Zero()); }, {"nearest"});
  refused([] { nearest_rotation(Vector(1, 0, 0).asDiagonal()); }, {"nearest", "rank"});
  refused([] { nearest_rotation(Vector(1, 2, 3) * Vector(4, 5, 6).transpose()); },
          {"nearest", "rank"});
  refused([] { nearest_rotation(-Matrix::Identity()); }, {"nearest"});
  refused([] { nearest_rotation(Vector(2, 1, -1).asDiagonal()); }, {"nearest"});
}
