#include "rotation/spherical_triangle.hpp"

#include <cmath>

#include "rotation/extended.hpp"

namespace rotor {
namespace {

// Axes as near as this have one direction: a component of an axis is rounded to 0.51 ulp, which is
// at most 0.51 * 2^-53, so two axes of one direction differ by 2 sqrt(3) 0.51 * 2^-53 = 1.97e-16.
constexpr Extended kRounding = 2e-16L;

SphericalTriangle::Kind kind_of(Extended sin_c, Extended cos_c, Extended sin_half_gamma) {
  using Kind = SphericalTriangle::Kind;
  if (sin_c == 0) return cos_c > 0 ? Kind::kParallel : Kind::kOpposite;
  return sin_half_gamma == 0 ? Kind::kIdentity : Kind::kTriangle;
}

}  // namespace

SphericalTriangle spherical_triangle(const Rotation& first, const Rotation& second) {
  const ExtendedVector p = first.axis().cast<Extended>().normalized();
  const ExtendedVector q = second.axis().cast<Extended>().normalized();
  // The side c = pq and the normal of l. p x q = p x (q - p) = p x (q + p): with the shorter of
  // them nothing cancels where p and q are nearly parallel or opposite.
  Extended cos_c = p.dot(q);
  const ExtendedVector normal = p.cross(cos_c < 0 ? ExtendedVector(q + p) : ExtendedVector(q - p));
  Extended sin_c = normal.norm();
  ExtendedVector m = normal / sin_c;
  if (sin_c <= kRounding) {
    sin_c = 0;
    cos_c = cos_c < 0 ? -1 : 1;
    m = p.unitOrthogonal();  // any great circle through p will do
  }

  const Extended half_theta = Extended{first.angle()} / 2;
  const Extended half_phi = Extended{second.angle()} / 2;
  const Extended sin_p = std::sin(half_theta);
  const Extended cos_p = std::cos(half_theta);
  const Extended sin_q = std::sin(half_phi);
  const Extended cos_q = std::cos(half_phi);

  // One side and the angles at its ends give the rest: with the exterior angle gamma/2 at r,
  //   sin(gamma/2) (cos rp, sin rp) = (sin_p cos_q + cos_p sin_q cos c, sin_q sin c),
  //   sin(gamma/2) (cos qr, sin qr) = (sin_q cos_p + cos_q sin_p cos c, sin_p sin c),
  //   cos(gamma/2) = cos_p cos_q - sin_p sin_q cos c,
  // without cancellation where the angles are small. rp < 0 is backward along the side from p.
  const Extended along_rp = sin_p * cos_q + cos_p * sin_q * cos_c;
  const Extended across_rp = sin_q * sin_c;
  const Extended along_qr = sin_q * cos_p + cos_q * sin_p * cos_c;
  const Extended across_qr = sin_p * sin_c;
  const Extended cos_half_gamma = cos_p * cos_q - sin_p * sin_q * cos_c;

  // Where the side from p goes: from p towards q, turned about p by -theta/2.
  const ExtendedVector side = m.cross(p) * cos_p - m * sin_p;
  const ExtendedVector r = along_rp * p + across_rp * side;  // times sin(gamma/2)
  const auto arc = [](Extended across, Extended along) {
    return static_cast<double>(std::atan2(std::abs(across), along));
  };
  return {first,
          second,
          rotation_of(ExtendedQuaternion(cos_half_gamma, r.x(), r.y(), r.z())),
          kind_of(sin_c, cos_c, r.norm()),
          arc(sin_c, cos_c),
          arc(across_qr, along_qr),
          arc(across_rp, along_rp)};
}

}  // namespace rotor
