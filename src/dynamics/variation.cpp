#include "dynamics/variation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "dynamics/lyapunov.hpp"
#include "integrate/control.hpp"
#include "integrate/fgl_tables.hpp"
#include "integrate/loop.hpp"
#include "spin/models.hpp"

namespace rotor {
namespace {

constexpr Eigen::Index kStages = 12;
using Stages = Eigen::Matrix<double, kStages, 1>;
using Square = Eigen::Matrix<double, kStages, kStages>;
using Blocks = Eigen::Matrix<double, 3 * kStages, 3>;

// Gauss's method on [0, 1].
struct Collocation {
  Stages nodes;
  Stages weights;
  Square integrals;  // times the values at the nodes: the integrals from 0 to the nodes
  Eigen::Matrix<double, 2, kStages> ends;  // times the values: their polynomial at 0 and 1
  // Times the values: the last four coefficients of the series of P_n(2 s - 1) through them.
  Eigen::Matrix<double, 4, kStages> tail;
};

// c_n = (2 n + 1) sum_j w_j P_n(2 s_j - 1) f(s_j), and the integral of P_n from -1 to x is
// (P_(n+1) - P_(n-1))/(2 n + 1), x + 1 for n = 0.
Collocation gauss_collocation() {
  Collocation method;
  method.ends.setZero();
  std::array<std::array<Extended, kStages + 1>, kStages> p{};
  for (std::size_t j = 0; j < kStages; ++j) {
    const std::size_t k = j % 6;
    const Extended x = j < 6 ? kGauss12Nodes[k] : -kGauss12Nodes[k];
    p[j] = legendre<kStages + 1>(x);
    method.nodes(static_cast<Eigen::Index>(j)) = static_cast<double>((1 + x) / 2);
    method.weights(static_cast<Eigen::Index>(j)) = kGauss12Weights[k] / 2;
  }
  for (Eigen::Index i = 0; i < kStages; ++i) {
    const auto& at = p[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < kStages; ++j) {
      const auto& from = p[static_cast<std::size_t>(j)];
      Extended sum = at[1] + 1;
      for (std::size_t n = 1; n < kStages; ++n) sum += (at[n + 1] - at[n - 1]) * from[n];
      method.integrals(i, j) = static_cast<double>(sum / 2) * method.weights(j);
    }
    for (std::size_t n = 0; n < kStages; ++n) {
      const double part =
          static_cast<double>(static_cast<Extended>(2 * n + 1) * at[n]) * method.weights(i);
      method.ends(0, i) += n % 2 == 0 ? part : -part;
      method.ends(1, i) += part;
    }
    for (Eigen::Index n = 0; n < 4; ++n) {
      const Eigen::Index degree = kStages - 4 + n;
      method.tail(n, i) = static_cast<double>(2 * degree + 1) * method.weights(i) *
                          static_cast<double>(at[static_cast<std::size_t>(degree)]);
    }
  }
  return method;
}
const Collocation& gauss() {
  static const Collocation method = gauss_collocation();
  return method;
}

// A of E grows with the inverse square of the distance e from 2 pi k, its rounding with the inverse
// cube, and steps are some e long: at this distance rounding adds 2e-12 a step.
constexpr double kNearest = 1e-2;

// A jump's coefficients fall as n^-1/2, a bend's as n^-3/2: by 0.9 and 0.8 from 8, 9 to 10, 11.
constexpr double kSmooth = 0.25;

// What a step may err by, of d.
constexpr double kAllowed = 1e-10;

using Values = std::array<Matrix, kStages>;

// Of the series through values at the nodes: coefficients 8 and 9, 10 and 11.
struct Tail {
  double before = 0;
  double last = 0;

  explicit Tail(const Values& values) {
    std::array<double, 4> squares{};
    for (Eigen::Index n = 0; n < 4; ++n) {
      Matrix sum = Matrix::Zero();
      for (Eigen::Index j = 0; j < kStages; ++j)
        sum += gauss().tail(n, j) * values[static_cast<std::size_t>(j)];
      squares[static_cast<std::size_t>(n)] = sum.squaredNorm();
    }
    before = std::sqrt(squares[0] + squares[1]);
    last = std::sqrt(squares[2] + squares[3]);
  }
  double ratio() const { return last == 0 ? 0 : last / before; }
  // What the values may be off by between the nodes, if they are not smooth; else 0.
  double roughness() const { return ratio() < kSmooth ? 0 : std::max(last, before); }
};

// Where steps end: omega may jump or bend beside a step's ends, where it has no nodes. The flow has
// found the places, and is followed in short stretches there; those of closed forms are known.
std::vector<double> stops(const Run& run) {
  const AngularVelocity& omega = run.driver();
  if (omega.as<ConstantSpin>() != nullptr || omega.as<TurningSpin>() != nullptr) return {};
  std::vector<double> times = run.propagator().flow->mesh();
  const auto breaks = omega.breaks(std::min(run.t0(), run.t1()), std::max(run.t0(), run.t1()));
  times.insert(times.end(), breaks.begin(), breaks.end());
  if (run.t1() >= run.t0()) {
    std::sort(times.begin(), times.end());
  } else {
    std::sort(times.begin(), times.end(), std::greater<>());
  }
  return times;
}

}  // namespace

// From d to moved d; with the state and A at the end.
struct Variation::Step {
  bool passable = false;
  Matrix moved = Matrix::Identity();
  double error = std::numeric_limits<double>::infinity();
  State end;
  Matrix rate_at_end;
};

Variation::Variation(const Run& run, Chart chart, double first_step, Bridge bridge)
    : run_(run), chart_(chart), h_(first_step), bridge_(std::move(bridge)), stops_(stops(run)) {}

bool Variation::passable(const State& state) const {
  return part_of_chart(chart_, state) == part_ &&
         distance_from_singularity(chart_, state) > kNearest;
}

Matrix Variation::rate(double t, const State& state) const {
  const Frame frame = run_.propagator().frame;
  const Vector generator = run_.propagator().flow->generator(t);
  return rate_jacobian(chart_, state, frame == Frame::kSpace ? generator : Vector(-generator),
                       frame);
}

// X' = A X, X(0) = 1, with X(s) = 1 + h int_0^s A X at the nodes. What the polynomial leaves of X'
// is of degrees from 12 on, some f_12 P_12 in the series of h A X: at the end it counts by the part
// of these degrees in what carries it there, X(1) X(s)^-1, which is as smooth as X. That has
// f_11/46 P_12, and int_0^1 P_12^2 = 1/25. f falls by a ratio every two degrees: f_11 is by its
// root less than the larger of f_10 and f_11, f_12 by the whole of it. Where f hardly falls, as
// where omega jumps or bends, the nodes do not tell what lies between them; nor do they where A at
// the ends, which are no nodes, is not what they say.
Variation::Step Variation::step(double t, double t_next, const Matrix& rate_at_t) const {
  const Collocation& method = gauss();
  const double h = t_next - t;
  Step result;
  Values rates;
  for (Eigen::Index j = 0; j < kStages; ++j) {
    const double at = t + method.nodes(j) * h;
    const State state = chart_state(run_, at, chart_);
    if (!passable(state)) return result;
    rates[static_cast<std::size_t>(j)] = h * rate(at, state);
  }
  result.passable = true;
  result.error = Tail(rates).roughness();
  if (result.error > kAllowed) return result;  // for less work
  Eigen::Matrix<double, 3 * kStages, 3 * kStages> system;
  for (Eigen::Index j = 0; j < kStages; ++j) {
    for (Eigen::Index i = 0; i < kStages; ++i)
      system.block<3, 3>(3 * i, 3 * j) =
          -method.integrals(i, j) * rates[static_cast<std::size_t>(j)];
  }
  system.diagonal().array() += 1;
  const Blocks x = system.partialPivLu().solve(Matrix::Identity().replicate<kStages, 1>());
  result.end = chart_state(run_, t_next, chart_);
  result.rate_at_end = rate(t_next, result.end);
  Matrix miss_at_start = -h * rate_at_t;
  Matrix miss_at_end = -h * result.rate_at_end;
  Values slopes;
  for (Eigen::Index j = 0; j < kStages; ++j) {
    const Matrix& rate = rates[static_cast<std::size_t>(j)];
    Matrix& slope = slopes[static_cast<std::size_t>(j)];
    slope = rate * x.block<3, 3>(3 * j, 0);
    result.moved += method.weights(j) * slope;
    miss_at_start += method.ends(0, j) * rate;
    miss_at_end += method.ends(1, j) * rate;
  }
  const Tail tail(slopes);
  const double smooth = tail.last * tail.last * std::pow(tail.ratio(), 1.5) / (46 * 25);
  const double miss = std::max(miss_at_start.norm(), miss_at_end.norm());
  result.error = std::max({smooth, tail.roughness(), miss > 2 * tail.last ? miss : 0});
  return result;
}

// The first time that passes, of those twice as far each, or t_end.
double Variation::end_of_bridge(double t, double t_end) const {
  for (double h = h_;; h *= 2) {
    const double end = step_towards(t_end, t, h);
    if (end == t_end ||
        distance_from_singularity(chart_, chart_state(run_, end, chart_)) > 2 * kNearest)
      return end;
  }
}

void Variation::follow(double t, double t_end, Matrix& d, Vector& logs) {
  // Near a singularity steps shrink one after the other: of those that aim at all that is allowed a
  // third fails.
  constexpr double kCaution = 0.9;
  const double shortest = shortest_step(std::max(std::abs(t), std::abs(t_end)));
  State state = chart_state(run_, t, chart_);
  Matrix rate_at_t = rate(t, state);
  while (t != t_end) {
    part_ = part_of_chart(chart_, state);
    const double t_next = step_towards(t_end, t, h_);
    const double taken = std::abs(t_next - t);
    const Step made = step(t, t_next, rate_at_t);
    const double allowed = kAllowed * made.moved.norm();
    if (made.error <= allowed) {
      t = t_next;
      d = made.moved * d;
      state = made.end;
      rate_at_t = made.rate_at_end;
      // The last step of an interval is as short as its rest: it says nothing against h.
      const double factor = kCaution * step_factor(made.error, allowed, 2 * kStages);
      h_ = factor < 1 ? taken * factor : std::max(h_, taken * factor);
    } else if ((made.passable || distance_from_singularity(chart_, state) > 2 * kNearest) &&
               taken > shortest) {
      h_ = made.passable ? taken * step_factor(made.error, allowed, 2 * kStages) : taken / 2;
      continue;
    } else {
      const double end = end_of_bridge(t, t_end);
      d = bridge_(t, end) * d;
      t = end;
      state = chart_state(run_, t, chart_);
      rate_at_t = rate(t, state);
      ++bridged_;
    }
    logs += orthonormalise(d);
  }
}

void Variation::advance(double t, double t_end, Matrix& d, Vector& logs) {
  const double forward = t_end > t ? 1 : -1;
  const auto ahead = [forward](double a, double b) { return forward * (b - a) > 0; };
  for (; next_stop_ < stops_.size() && ahead(stops_[next_stop_], t_end); ++next_stop_) {
    const double stop = stops_[next_stop_];
    // Nearly singular places are bridged.
    if (!ahead(t, stop) ||
        distance_from_singularity(chart_, chart_state(run_, stop, chart_)) <= 2 * kNearest)
      continue;
    follow(t, stop, d, logs);
    t = stop;
  }
  follow(t, t_end, d, logs);
}

}  // namespace rotor
