#include "dynamics/lyapunov.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "dynamics/variation.hpp"
#include "rotation/extended.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// D(t) along a run, with what the start adds to it once. None where the chart is singular at t.
class TangentMap {
 public:
  TangentMap(const Run& run, Chart chart) : run_(run), chart_(chart) {
    const State start = chart_state(run, run.t0(), chart);
    if (is_singular(start)) {
      throw std::invalid_argument(std::string("the chart ") + name_of(chart) +
                                  " is singular at the start, angle " + text(run.from().angle()));
    }
    before_ = chart_jacobian(chart, start).inverse();
    if (in_space()) before_ = start.matrix().transpose() * before_;
  }

  std::optional<Matrix> at(double t, const Observer& observer = {}) const {
    const State state = chart_state(run_, t, chart_, observer);
    if (is_singular(state)) return std::nullopt;
    const Matrix j = chart_jacobian(chart_, state);
    return in_space() ? Matrix(j * state.matrix() * before_) : Matrix(j * before_);
  }

 private:
  bool in_space() const { return run_.propagator().frame == Frame::kSpace; }
  // M0 and |M| are known to half the error of the rotation, and to their rounding.
  bool is_singular(const State& state) const {
    const double error = run_.propagator().error_estimate / 2;
    return !(distance_from_singularity(chart_, state) >
             error + 4 * std::numeric_limits<double>::epsilon());
  }

  const Run& run_;
  Chart chart_;
  Matrix before_;
};

Vector logs_of_singular_values(const Matrix& m) {
  const Eigen::JacobiSVD<ExtendedMatrix> svd(m.cast<Extended>());
  return svd.singularValues().array().log().matrix().cast<double>();
}

Vector sorted(Vector v) {
  std::sort(v.begin(), v.end(), std::greater<>());
  return v;
}

// The times without the start.
std::vector<double> after_start(const Run& run, std::span<const double> times) {
  std::vector<double> result;
  double last = run.t0();
  for (const double t : times) {
    const double forward = run.t1() >= run.t0() ? t - last : last - t;
    if (forward > 0) {
      result.push_back(t);
    } else if (!(t == run.t0() && result.empty())) {
      throw std::invalid_argument("times must follow one another from the start of the run, " +
                                  text(run.t0()) + "; got " + text(t) + " after " + text(last));
    }
    last = t;
  }
  if (result.empty()) {
    throw std::invalid_argument("Lyapunov exponents need a time after the start of the run, " +
                                text(run.t0()));
  }
  return result;
}

// The sums of log R_ii so far at the times at which they are known.
struct Sums {
  std::vector<double> times;
  std::array<std::vector<double>, 3> logs;

  void add(double t, const Vector& sum) {
    times.push_back(t);
    for (int i = 0; i < 3; ++i) logs[static_cast<std::size_t>(i)].push_back(sum(i));
  }
};

// The largest rate.
Average average_rate(const Sums& sums) {
  Average largest{kNan, kNan, kNan, kNan};
  if (sums.times.size() < 3) return largest;
  for (const auto& logs : sums.logs) {
    const Average rate = birkhoff_rate(sums.times, logs);
    if (!(rate.weighted <= largest.weighted)) largest = rate;
  }
  return largest;
}

}  // namespace

Vector orthonormalise(Matrix& m) {
  Vector logs;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < i; ++j) m.col(i) -= m.col(j).dot(m.col(i)) * m.col(j);
    const double length = m.col(i).norm();
    m.col(i) /= length;
    logs(i) = std::log(length);
  }
  return logs;
}

Matrix tangent_map(const Run& run, double t, Chart chart) {
  return TangentMap(run, chart).at(t).value_or(Matrix(Matrix::Constant(kNan)));
}

Vector finite_time_exponents(const Run& run, double t, Chart chart) {
  if (t == run.t0()) {
    throw std::invalid_argument("exponents need time to pass, got t = " + text(t) +
                                ", the start of the run");
  }
  const auto d = TangentMap(run, chart).at(t);
  if (!d) return Vector::Constant(kNan);
  return logs_of_singular_values(*d) / std::abs(t - run.t0());
}

LyapunovSpectrum lyapunov_spectrum(const Run& run, std::span<const double> times, Chart chart,
                                   LyapunovMethod method, const Observer& observer) {
  LyapunovSpectrum result;
  result.times = after_start(run, times);
  const TangentMap map(run, chart);
  Variation variation(run, chart, std::abs(result.times.front() - run.t0()),
                      [&map](double t0, double t1) -> Matrix {
                        return map.at(t1).value() * map.at(t0).value().inverse();
                      });
  Sums sums;
  sums.add(run.t0(), Vector::Zero());
  Matrix axes = Matrix::Identity();
  Vector sum = Vector::Zero();
  double last = run.t0();  // where axes and sum are
  double part = part_of_chart(chart, chart_state(run, run.t0(), chart));
  visit_times(result.times, observer, [&](double t) {
    const auto d = map.at(t, observer);
    if (!d) {
      result.singular.push_back(t);
      result.history.emplace_back(Vector::Constant(kNan));
      return;
    }
    const double length = std::abs(t - run.t0());
    if (method == LyapunovMethod::kExact) {
      const double now = part_of_chart(chart, chart_state(run, t, chart));
      if (now != std::exchange(part, now)) ++result.bridged;
      Matrix q = *d;
      sum = orthonormalise(q);
      result.history.emplace_back(logs_of_singular_values(*d) / length);
    } else {
      variation.advance(last, t, axes, sum);
      result.history.emplace_back(sorted(sum / length));
    }
    sums.add(t, sum);
    last = t;
  });
  result.bridged += variation.bridged();
  result.local = average_rate(sums);
  return result;
}

}  // namespace rotor
