#include "dynamics/variation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "integrate/control.hpp"
#include "integrate/dop853_tableau.hpp"
#include "integrate/step.hpp"

namespace rotor {
namespace {

// A of E grows with the inverse square of the distance e from 2 pi k, its rounding with the inverse
// cube, and steps are some e/20 long: at this distance rounding adds 1e-13 a step, a tenth of what
// is allowed.
constexpr double kNearest = 1e-2;

}  // namespace

Variation::Variation(const Run& run, Chart chart, double first_step)
    : run_(run), chart_(chart), h_(first_step) {}

Matrix Variation::rates(double t) const {
  const Frame frame = run_.propagator().frame;
  const Vector generator = run_.propagator().flow->generator(t);
  return rate_jacobian(chart_, chart_state(run_, t, chart_),
                       frame == Frame::kSpace ? generator : Vector(-generator), frame);
}

// The increment is added to d; the error of it, by Hairer's combination, is the answer.
double Variation::step(double t, double h, Matrix& d) const {
  std::array<Matrix, 12> k;
  for (std::size_t i = 0; i < k.size(); ++i) {
    k[i] = rates(t + kDop853Tableau.c[i] * h) * (d + h * weighted_sum(kDop853Tableau.a[i], k, i));
  }
  d += h * weighted_sum(kDop853Tableau.b, k);
  const double e5 = std::abs(h) * weighted_sum(kDop853Error5, k).norm();
  const double e3 = std::abs(h) * weighted_sum(kDop853Error3, k).norm();
  return e5 == 0 ? 0 : e5 * (e5 / std::hypot(e5, 0.1 * e3));
}

bool Variation::advance(double t, double t_end, Matrix& d) {
  constexpr double kAllowed = 1e-12;
  const double part = part_of_chart(chart_, chart_state(run_, t, chart_));
  const auto passable = [&](double at) {
    const State state = chart_state(run_, at, chart_);
    return part_of_chart(chart_, state) == part &&
           distance_from_singularity(chart_, state) > kNearest;
  };
  if (!passable(t) || !passable(t_end)) return false;
  const double first = h_;
  Matrix moved = d;
  while (t != t_end) {
    const double t_next = step_towards(t_end, t, h_);
    Matrix next = moved;
    const double error = step(t, t_next - t, next);
    const double allowed = kAllowed * moved.norm();
    const double factor = step_factor(error, allowed, kDop853Tableau.order);
    const double taken = std::abs(t_next - t);
    if (error <= allowed) {
      t = t_next;
      moved = next;
      // The last step of an interval is as short as its rest: it says nothing against h.
      h_ = factor < 1 ? taken * factor : std::max(h_, taken * factor);
    } else {
      h_ = taken * factor;
    }
    if (!passable(t) || h_ < shortest_step(t)) {
      h_ = first;
      return false;
    }
  }
  d = moved;
  return true;
}

}  // namespace rotor
