#include "rotation/factoring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "rotation/text.hpp"
#include "rotation/turn.hpp"

namespace rotor {
namespace {

constexpr Extended kPi = std::numbers::pi_v<Extended>;

// How well a Rotation knows its operator: its axis, three numbers rounded, is off by 1e-16 and
// moves points by twice that, its angle in [0, 2 pi] by 4.4e-16; as much again for what went into
// it. Both are in proportion to a small angle.
constexpr Extended kKnown = 1.5e-15L;
Extended known(const Rotation& r) {
  return kKnown * std::min<Extended>(1, std::abs(Extended{r.angle()}));
}

Extended angle_between(const ExtendedVector& u, const ExtendedVector& v) {
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

bool parallel(Extended angle, Extended tolerance = kKnown) {
  return std::min(angle, kPi - angle) <= tolerance;
}

// Q u - u, without cancellation for a small angle.
ExtendedVector shift(const ExtendedQuaternion& q, const ExtendedVector& u) {
  const ExtendedVector t = 2 * q.vec().cross(u);
  return q.w() * t + q.vec().cross(t);
}

// In [-pi, pi], of an angle in [-2 pi, 2 pi].
Extended wrapped(Extended angle) {
  return angle > kPi ? angle - 2 * kPi : angle < -kPi ? angle + 2 * kPi : angle;
}

// In (-pi, pi] as a double, and zero without a sign.
double rounded(Extended angle) {
  const auto x = static_cast<double>(angle);
  return x == -std::numbers::pi ? std::numbers::pi : x + 0.0;
}

// The angle, in [-pi, pi], of the operator's turn about u: of the nearest one if it has another
// axis.
Extended angle_about(const ExtendedVector& u, const ExtendedQuaternion& q) {
  const Extended sine = q.vec().dot(u);
  return 2 * (q.w() < 0 ? std::atan2(-sine, -q.w()) : std::atan2(sine, q.w()));
}

// The angle about u that takes p to p + difference.
Extended angle_about(const ExtendedVector& u, const ExtendedVector& p,
                     const ExtendedVector& difference) {
  const ExtendedVector from = u.cross(p);
  const ExtendedVector change = u.cross(difference);
  return std::atan2(u.dot(from.cross(change)), from.dot(from + change));
}

// Where R takes the last axis, and where it should.
std::string out_of_reach(const std::string& last, Extended phi, Extended least, Extended most) {
  const auto number = [](Extended x) {
    return text(std::abs(x) < kKnown ? 0 : static_cast<double>(x), 10);
  };
  const std::string range =
      least == most ? number(least) + " rad (cosine " + number(std::cos(least)) + ")"
                    : number(least) + " to " + number(most) + " rad (cosines " +
                          number(std::cos(most)) + " to " + number(std::cos(least)) + ")";
  return "out of reach: R takes " + last + " to " + number(phi) + " rad from axis 1 (cosine " +
         number(std::cos(phi)) + "), these axes reach " + range;
}

// What is determined: "a + c", or "a - c" where the axes are opposite.
std::string singular(const std::string& first, const std::string& second, Extended angle,
                     const std::string& taken) {
  return "only " + first + (angle < kPi / 2 ? " + " : " - ") + second + " is determined, " + taken +
         " = 0 is taken";
}

// The angles about u1 and u2 of an operator that takes u2 to where u1 can.
std::pair<Extended, Extended> pair_of(const ExtendedQuaternion& q, const ExtendedVector& u1,
                                      const ExtendedVector& u2) {
  if (parallel(angle_between(u1, u2))) return {angle_about(u1, q), 0};
  const Extended a = angle_about(u1, u2, shift(q, u2));
  return {a, angle_about(u2, turn(u1, -a) * q)};
}

// Three axes and what is asked of them: cosine cos b + sine sin b = u1.Q(u2, b) u3 -
// (u1.u2)(u2.u3).
struct Triple {
  ExtendedVector u1, u2, u3;
  Extended alpha = angle_between(u1, u2);
  Extended beta = angle_between(u2, u3);
  // The angles that u1 can make with Q(u1, a) Q(u2, b) u3.
  Extended least = std::abs(alpha - beta);
  Extended most = std::min(alpha + beta, 2 * kPi - alpha - beta);
  Extended cosine = u1.cross(u2).dot(u3.cross(u2));
  Extended sine = u1.dot(u2.cross(u3));
};

// b' of b = b0 + b' and b0 - b': the angle at u2 of the spherical triangle with sides alpha, beta,
// phi, by its half. On a border the factor that vanishes is zero exactly.
Extended corner(const Triple& axes, Extended phi) {
  const auto [alpha, beta] = std::pair(axes.alpha, axes.beta);
  const Extended sine = std::sin((phi + (alpha - beta)) / 2) * std::sin((phi - (alpha - beta)) / 2);
  const Extended cosine =
      std::sin((alpha + beta - phi) / 2) * std::sin((2 * kPi - alpha - beta - phi) / 2);
  return 2 * std::atan2(std::sqrt(std::max(sine, Extended{0})),
                        std::sqrt(std::max(cosine, Extended{0})));
}

// A small b once more, as a root of (change + 2 cosine) t^2 - 2 sine t + change = 0, t = tan(b/2),
// change = u1.(R u3 - u3), where nothing cancels at b = 0: good to its last digits.
Extended refined(const Triple& axes, Extended b, Extended half_width, Extended change) {
  const Extended amplitude = std::hypot(axes.sine, axes.cosine);
  if (std::abs(b) * amplitude >= std::abs(axes.sine) / 1024) return b;
  return 2 * std::atan(change /
                       (axes.sine + std::copysign(amplitude * std::sin(half_width), axes.sine)));
}

// What is left to the outer axes when b is known. Where they are nearly parallel a is badly known,
// and c makes up for it.
std::vector<double> completed(const Triple& axes, const ExtendedQuaternion& q, Extended b) {
  const ExtendedQuaternion middle = turn(axes.u2, b);
  const ExtendedVector there = shift(middle, axes.u3);
  const Extended a = angle_about(axes.u1, axes.u3 + there, shift(q, axes.u3) - there);
  const Extended c = angle_about(axes.u3, (turn(axes.u1, a) * middle).conjugate() * q);
  return {rounded(a), rounded(b), rounded(c)};
}

// The two solutions with b0 + b' and b0 - b', or one on a border of what is reachable.
std::vector<std::vector<double>> isolated(const Triple& axes, const ExtendedQuaternion& q,
                                          Extended phi) {
  const Extended middle = std::atan2(axes.sine, axes.cosine);
  const Extended half_width = corner(axes, phi);
  if (phi == axes.least || phi == axes.most) {
    return {completed(axes, q, wrapped(middle + half_width))};
  }
  const Extended change = axes.u1.dot(shift(q, axes.u3));
  std::array<Extended, 2> b = {wrapped(middle + half_width), wrapped(middle - half_width)};
  for (Extended& each : b) each = refined(axes, each, half_width, change);
  const Extended longer = std::abs(b[0]) - std::abs(b[1]);
  if (longer > kKnown || (longer >= -kKnown && b[0] < b[1])) std::swap(b[0], b[1]);
  return {completed(axes, q, b[0]), completed(axes, q, b[1])};
}

void require_sequence(const std::string& sequence) {
  constexpr const char* kSequences = "xyz xzy yxz yzx zxy zyx xyx xzx yxy yzy zxz zyz";
  const bool is_word = sequence.size() == 3 && sequence.find(' ') == sequence.npos;
  if (is_word && std::string(kSequences).find(sequence) != std::string::npos) return;
  throw std::invalid_argument(std::string("expected one of the sequences ") + kSequences +
                              ", got \"" + sequence + "\"" + letters_hint(sequence));
}

}  // namespace

Factoring angles_about(const Rotation& r, const Vector& u1, const Vector& u2) {
  const ExtendedVector first = direction(u1, "axis 1"), second = direction(u2, "axis 2");
  const ExtendedQuaternion q = turn(r);
  const Extended alpha = angle_between(first, second);
  const Extended phi = angle_between(first, second + shift(q, second));
  if (std::abs(phi - alpha) > kKnown) {
    throw std::invalid_argument(out_of_reach("axis 2", phi, alpha, alpha));
  }
  const auto [a, b] = pair_of(q, first, second);
  return {{{rounded(a), rounded(b)}}, parallel(alpha) ? singular("a", "b", alpha, "b") : ""};
}

Factoring angles_about(const Rotation& r, const Vector& u1, const Vector& u2, const Vector& u3) {
  const Triple axes{direction(u1, "axis 1"), direction(u2, "axis 2"), direction(u3, "axis 3")};
  const ExtendedQuaternion q = turn(r);
  const Extended phi = angle_between(axes.u1, axes.u3 + shift(q, axes.u3));
  if (phi < axes.least - kKnown || phi > axes.most + kKnown) {
    throw std::invalid_argument(out_of_reach("axis 3", phi, axes.least, axes.most));
  }
  if (parallel(axes.alpha) || parallel(axes.beta)) {
    const auto [a, c] = pair_of(q, axes.u1, axes.u3);
    return {{{rounded(a), 0, rounded(c)}},
            parallel(axes.alpha) ? singular("a", "b", axes.alpha, "b")
                                 : singular("b", "c", axes.beta, "b")};
  }
  const Extended snapped = phi - axes.least <= known(r)  ? axes.least
                           : axes.most - phi <= known(r) ? axes.most
                                                         : phi;
  if (!parallel(phi, known(r))) return {isolated(axes, q, snapped), ""};
  const Extended b = wrapped(std::atan2(axes.sine, axes.cosine) + corner(axes, snapped));
  const Extended a = angle_about(axes.u1, q * turn(axes.u2, -b));
  return {{{rounded(a), rounded(b), 0}}, singular("a", "c", phi, "c")};
}

Rotation from_euler_angles(const std::string& sequence, const std::array<double, 3>& angles,
                           Frame frame) {
  require_sequence(sequence);
  return Chain(axes_of_letters(sequence), {angles.begin(), angles.end()}, std::nullopt, frame)
      .rotation();
}

Factoring euler_angles(const Rotation& r, const std::string& sequence, Frame frame) {
  require_sequence(sequence);
  const std::vector<Vector> u = axes_of_letters(sequence);
  if (frame == Frame::kBody) return angles_about(r, u[0], u[1], u[2]);
  // R = Q(u3, c) Q(u2, b) Q(u1, a), so its inverse is Q(-u1, a) Q(-u2, b) Q(-u3, c).
  return angles_about(r.inverse(), -u[0], -u[1], -u[2]);
}

}  // namespace rotor
