// What the fast integrator leaves behind: U at the ends of its steps, and what lies between when it
// is asked for.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "integrate/fgl_kernel.hpp"
#include "integrate/flow.hpp"
#include "integrate/panel.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

/// U(t), piecewise: on half a step, or where that does not resolve it on a part of a half, a
/// polynomial of degree 17 through 18 values of the method. It is worked out when a time within it
/// is asked for, and kept until one in another step is. (Hence `at` and `generator` must not be
/// called from two threads at once.)
class FglFlow final : public Flow {
 public:
  FglFlow(const AngularVelocity& omega, double t0);

  /// Appends a step whose samples were of omega itself, which will be called again; U at its end,
  /// and a bound of the angle by which it turns.
  void append(double end, const Quaternion& u, double turn);
  /// Appends a panel of equal steps: U at the end of each.
  void append(const Panel& panel, const std::vector<Quaternion>& u, double turn);
  /// Appends a panel on which U turns about one direction.
  void append_turn(const Panel& panel, double turn);

  /// Between the ends of steps U is to be right to that, rad; before any time is asked for.
  void resolve_to(double rotation_error) { allowed_ = rotation_error / 2; }

  const Quaternion& last() const { return values_.back(); }
  double t1() const { return spans_.empty() ? t0_ : spans_.back().end; }

  Quaternion at(double t) const override;
  Vector generator(double t) const override;
  std::vector<double> mesh() const override;

 private:
  static constexpr std::size_t kNoPanel = static_cast<std::size_t>(-1);
  struct Span {
    double begin;
    double end;
    double turn;
    std::size_t first;  // values_[first] is U at `begin`
    std::size_t steps;  // 0 for a turn about one direction
    std::size_t panel;
  };
  struct Step {
    std::size_t span;
    std::size_t number;
    std::array<std::vector<FglPiece>, 2> halves;  // in equal parts
    std::size_t known;                            // the halves that are: none, the first, both
    Quaternion middle;                            // U there, where the first is
  };
  // The piece of the kept step that was asked for last, and how t lies in it.
  struct Part {
    const FglPiece* piece = nullptr;
    double begin = 0;  // of the span
    double end = 0;
    double parts = 0;  // as long as this one, are in the span,
    double shift = 0;  // and this one's place is -shift, from 1 - parts to parts - 1
    double z(double t) const { return ((t - begin) - (end - t)) / (end - begin) * parts + shift; }
    // The one of `among`, of so many parts, that t is in.
    std::size_t number(double t, std::size_t among) const;
  };

  std::size_t span_at(double t) const;
  bool is_in_part(double t) const;
  bool find_part(double t) const;
  void fill_next() const;
  // The pieces of a half in so many parts, from U at its begin, to `end` if it is given; U there.
  Quaternion fill(const Span& span, std::size_t half, std::size_t parts, const Quaternion& from,
                  const Quaternion* end, std::vector<FglPiece>& pieces) const;
  bool is_resolved(const std::vector<FglPiece>& pieces) const;
  FglInterior interior(const Span& span, double middle, double half) const;

  AngularVelocity omega_;
  double sign_;
  double t0_;
  std::vector<Span> spans_;
  std::vector<Panel> panels_;
  std::vector<Quaternion> values_;
  double allowed_ = 0;  // of quaternions, between the ends of steps
  mutable std::optional<Step> step_;
  mutable Part part_;
};

}  // namespace rotor
