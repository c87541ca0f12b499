#include "dynamics/frequencies.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "dynamics/fft.hpp"
#include "dynamics/spectrum.hpp"
#include "integrate/loop.hpp"
#include "rotation/rotation.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

using Complex = std::complex<double>;

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNearest = 2;  // cycles over the record between lines that are told apart

// Below that an amplitude may be the rounding of samples so large.
double least_of(double largest) { return 64 * kEpsilon * largest; }

// a cos(2 pi f x) + b sin(2 pi f x); x goes from -1/2 to 1/2 over the record, f in cycles over it.
struct Wave {
  double f;
  double a;
  double b;
  double amplitude() const { return std::hypot(a, b); }
};

// The samples, what has been found in them, and what is left.
class Search {
 public:
  explicit Search(std::span<const double> y)
      : y_(y), rest_(y.begin(), y.end()), weight_(window_values(Window::kHann, y.size())) {
    double sum = 0;
    for (double& w : weight_) sum += w *= w;
    for (double& w : weight_) w /= sum;
    for (const double value : y) largest_ = std::max(largest_, std::abs(value));
    subtract();
  }

  const std::vector<Wave>& waves() const { return waves_; }
  double mean() const { return mean_; }
  double threshold() const { return threshold_; }
  // The place of sample i: the window is highest at 0.
  double x(std::size_t i) const {
    const auto n = static_cast<double>(y_.size());
    return (static_cast<double>(i) - n / 2) / n;
  }

  bool add_highest();
  void fit(int most_steps);
  void drop_rounding();
  void drop_unresolved();
  Wave errors(const Wave& wave, double sample_error) const;

 private:
  template <class Visit>
  void sweep(double f, Visit visit) const;
  Eigen::MatrixXd normal_matrix() const;
  Eigen::VectorXd step() const;
  void move(const Eigen::VectorXd& step, double part);
  double subtract();

  std::span<const double> y_;
  std::vector<double> rest_;
  std::vector<double> weight_;  // of sum 1
  std::vector<Wave> waves_;
  double mean_ = 0;
  double largest_ = 0;
  double threshold_ = 0;
};

// The sums of w cos(2 pi v x), w x sin(2 pi v x) and w x^2 cos(2 pi v x), which fall with the fifth
// power of v, as integrals by 256 points: exact enough for the matrix of a step that is repeated.
struct Moments {
  double zeroth = 0;
  double first = 0;
  double second = 0;
};

Moments moments(double v) {
  constexpr int kPoints = 256;
  constexpr double kFurthest = 50;
  Moments sum;
  if (std::abs(v) > kFurthest) return sum;
  for (int i = 1; i < kPoints; ++i) {
    const double x = static_cast<double>(i) / kPoints - 0.5;
    const double c = std::cos(std::numbers::pi * x);
    const double w = 8 * c * c * c * c / (3 * kPoints);  // Hann^2, of mean 1
    sum.zeroth += w * std::cos(kTwoPi * v * x);
    sum.first += w * x * std::sin(kTwoPi * v * x);
    sum.second += w * x * x * std::cos(kTwoPi * v * x);
  }
  return sum;
}

// Calls visit(i, cos, sin) with those of 2 pi f x_i: directly every sixteenth time, by turning on
// between. Of thousands of cycles the whole ones are taken off before they cost digits.
template <class Visit>
void Search::sweep(double f, Visit visit) const {
  constexpr std::size_t kTurns = 16;
  const auto n = static_cast<Extended>(y_.size());
  const Complex turn = std::polar(1.0, kTwoPi * f / static_cast<double>(n));
  for (std::size_t start = 0; start < y_.size(); start += kTurns) {
    const Extended cycles = f * (static_cast<Extended>(start) - n / 2) / n;
    const double angle = kTwoPi * static_cast<double>(cycles - std::nearbyint(cycles));
    double c = std::cos(angle);
    double s = std::sin(angle);
    const std::size_t end = std::min(start + kTurns, y_.size());
    for (std::size_t i = start; i < end; ++i) {
      visit(i, c, s);
      const double next = c * turn.real() - s * turn.imag();
      s = s * turn.real() + c * turn.imag();
      c = next;
    }
  }
}

// The remainder of what has been found; gives its weighted square.
double Search::subtract() {
  std::fill(rest_.begin(), rest_.end(), mean_);
  for (const Wave& wave : waves_) {
    sweep(wave.f, [&](std::size_t i, double c, double s) { rest_[i] += wave.a * c + wave.b * s; });
  }
  double square = 0;
  for (std::size_t i = 0; i < y_.size(); ++i) {
    rest_[i] = y_[i] - rest_[i];
    square += weight_[i] * rest_[i] * rest_[i];
  }
  return square;
}

// Adds the highest peak of the remainder, unless none stands out.
bool Search::add_highest() {
  const std::size_t n = y_.size();
  std::vector<Complex> weighted(n);
  for (std::size_t i = 0; i < n; ++i) weighted[i] = weight_[i] * rest_[i];
  const auto transform = fourier_transform(weighted);
  std::vector<double> height(n / 2);
  for (std::size_t k = 0; k < height.size(); ++k) height[k] = 2 * std::abs(transform[k]);
  // Of noise the heights x have the distribution 1 - exp(-(x/s)^2), of median 0.83 s. In all the
  // bins it passes sqrt(log(1e4 n/2)) s once in ten thousand times.
  std::vector<double> sorted = height;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double scale = *middle / std::sqrt(std::numbers::ln2);
  threshold_ = std::max(scale * std::sqrt(std::log(1e4 * static_cast<double>(height.size()))),
                        least_of(largest_));
  std::size_t best = 0;
  for (std::size_t k = 1; k + 1 < height.size(); ++k) {
    const auto f = static_cast<double>(k);
    const bool free =
        f >= kNearest && std::none_of(waves_.begin(), waves_.end(),
                                      [&](const Wave& w) { return std::abs(w.f - f) < kNearest; });
    if (free && (best == 0 || height[k] > height[best])) best = k;
  }
  if (best == 0 || !(height[best] > threshold_)) return false;
  // A parabola through the logarithms: within a tenth of a bin of the top of the lobe.
  double shift = 0;
  if (height[best - 1] > 0 && height[best + 1] > 0) {
    const double below = std::log(height[best - 1] / height[best]);
    const double above = std::log(height[best + 1] / height[best]);
    shift = std::clamp((below - above) / (2 * (below + above)), -0.5, 0.5);
    if (!std::isfinite(shift)) shift = 0;
  }
  waves_.push_back({static_cast<double>(best) + shift, 0, 0});
  return true;
}

// The normal matrix of the columns 1, cos_1, sin_1, d/df_1, cos_2, ...: products of two of them
// are cosines and sines of the sum and the difference, and odd ones vanish. A wave without an
// amplitude yet has no derivative by its frequency.
Eigen::MatrixXd Search::normal_matrix() const {
  constexpr double kPi = std::numbers::pi;
  const auto size = static_cast<Eigen::Index>(1 + 3 * waves_.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  normal(0, 0) = 1;
  for (Eigen::Index i = 1; i < size; i += 3) {
    const Wave& p = waves_[static_cast<std::size_t>(i / 3)];
    const Moments alone = moments(p.f);
    normal(i, 0) = alone.zeroth;
    normal(i + 2, 0) = -kTwoPi * p.a * alone.first;
    for (Eigen::Index j = 1; j <= i; j += 3) {
      const Wave& q = waves_[static_cast<std::size_t>(j / 3)];
      const Moments sum = moments(p.f + q.f);
      const Moments apart = moments(p.f - q.f);
      normal(i, j) = (apart.zeroth + sum.zeroth) / 2;
      normal(i + 1, j + 1) = (apart.zeroth - sum.zeroth) / 2;
      normal(i, j + 2) = -kPi * q.a * (sum.first - apart.first);
      normal(i + 1, j + 2) = kPi * q.b * (sum.first + apart.first);
      normal(i + 2, j) = -kPi * p.a * (sum.first + apart.first);
      normal(i + 2, j + 1) = kPi * p.b * (sum.first - apart.first);
      normal(i + 2, j + 2) =
          2 * kPi * kPi *
          (p.b * q.b * (apart.second + sum.second) + p.a * q.a * (apart.second - sum.second));
    }
    if (p.amplitude() == 0) normal(i + 2, i + 2) = 1;
  }
  return normal;
}

// The step of Gauss and Newton: what the columns of the normal matrix have of the remainder.
Eigen::VectorXd Search::step() const {
  const auto size = static_cast<Eigen::Index>(1 + 3 * waves_.size());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  for (std::size_t i = 0; i < y_.size(); ++i) right(0) += weight_[i] * rest_[i];
  for (std::size_t w = 0; w < waves_.size(); ++w) {
    double of_cos = 0;
    double of_sin = 0;
    double of_f = 0;
    sweep(waves_[w].f, [&](std::size_t i, double c, double s) {
      const double value = weight_[i] * rest_[i];
      of_cos += value * c;
      of_sin += value * s;
      of_f += value * x(i) * (waves_[w].b * c - waves_[w].a * s);
    });
    right.segment<3>(static_cast<Eigen::Index>(1 + 3 * w)) << of_cos, of_sin, kTwoPi * of_f;
  }
  return normal_matrix().selfadjointView<Eigen::Lower>().ldlt().solve(right);
}

void Search::move(const Eigen::VectorXd& step, double part) {
  mean_ += part * step(0);
  for (std::size_t w = 0; w < waves_.size(); ++w) {
    const auto column = static_cast<Eigen::Index>(1 + 3 * w);
    waves_[w].a += part * step(column);
    waves_[w].b += part * step(column + 1);
    waves_[w].f += part * step(column + 2);
  }
}

// Safeguarded: no frequency moves by more than half a cycle over the record at a time, and a step
// that leaves more behind is halved.
void Search::fit(int most_steps) {
  double square = subtract();
  for (int count = 0; count < most_steps; ++count) {
    const Eigen::VectorXd step = this->step();
    if (!step.allFinite()) return;
    double furthest = 0;
    for (std::size_t w = 0; w < waves_.size(); ++w)
      furthest = std::max(furthest, std::abs(step(static_cast<Eigen::Index>(3 + 3 * w))));
    const std::vector<Wave> waves = waves_;
    const double mean = mean_;
    double part = furthest > 0.5 ? 0.5 / furthest : 1;
    double next = 0;
    for (int halving = 0;; ++halving, part /= 2) {
      waves_ = waves;
      mean_ = mean;
      move(step, part);
      next = subtract();
      if (next <= square || halving == 4) break;
    }
    if (!(next <= square)) {  // at rounding, or nowhere to go
      waves_ = waves;
      mean_ = mean;
      subtract();
      return;
    }
    // The first step of a new wave has no frequency in it.
    if (furthest < 1e-12 && next > 0.99 * square) return;
    square = next;
  }
}

// What was the rest of a line before the last step, and is nothing after it.
void Search::drop_rounding() {
  const auto gone = std::erase_if(
      waves_, [&](const Wave& wave) { return wave.amplitude() <= least_of(largest_); });
  if (gone > 0) fit(1);
}

// Two lines nearer than kNearest trade what they have: their errors say nothing of that. The weaker
// of them goes, and a line that is as near to the mean, until there are none.
void Search::drop_unresolved() {
  for (;;) {
    auto weakest = waves_.end();
    for (auto one = waves_.begin(); one != waves_.end(); ++one) {
      const bool near =
          std::abs(one->f) < kNearest ||
          std::any_of(waves_.begin(), waves_.end(), [&](const Wave& other) {
            return &other != &*one && std::abs(std::abs(other.f) - std::abs(one->f)) < kNearest;
          });
      if (near && (weakest == waves_.end() || one->amplitude() < weakest->amplitude()))
        weakest = one;
    }
    if (weakest == waves_.end()) return;
    waves_.erase(weakest);
    fit(20);
  }
}

// The errors of f, a and b (of either as much). With what is left, r, and the window's weights,
// R(f) = 2 sum w r exp(-2 pi i f x) is the amplitude that r has at f, and the error of a and b; the
// normal equation of the frequency is 4 pi A <x^2> df = |2 sum w x r exp(-2 pi i f x)|. At f itself
// the fit has made both zero: what they would be without it is taken to be the greatest nearby.
Wave Search::errors(const Wave& wave, double sample_error) const {
  constexpr int kReach = 6;  // half cycles over the record
  double second = 0;
  double first = 0;
  for (std::size_t i = 0; i < y_.size(); ++i) {
    second += weight_[i] * x(i) * x(i);
    first += weight_[i] * std::abs(x(i));
  }
  double of_amplitude = 0;
  double of_moment = 0;
  for (int k = -kReach; k <= kReach; ++k) {
    Complex amplitude = 0;
    Complex moment = 0;
    sweep(wave.f + 0.5 * k, [&](std::size_t i, double c, double s) {
      const Complex term = 2 * weight_[i] * rest_[i] * Complex(c, -s);
      amplitude += term;
      moment += term * x(i);
    });
    of_amplitude = std::max(of_amplitude, std::abs(amplitude));
    of_moment = std::max(of_moment, std::abs(moment));
  }
  of_amplitude += 2 * sample_error;
  of_moment += 2 * first * sample_error;
  const double of_f = of_moment / (kTwoPi * wave.amplitude() * second);
  return {of_f + 4 * kEpsilon * wave.f, of_amplitude + 4 * kEpsilon * largest_, 0};
}

void require_samples(std::span<const double> y, double every, std::size_t n) {
  if (n == 0 || n > 100) {
    throw std::invalid_argument("frequencies: n must be from 1 to 100, got " + std::to_string(n));
  }
  if (y.size() < 32) {
    throw std::invalid_argument("frequencies: expected at least 32 samples, got " +
                                std::to_string(y.size()));
  }
  if (!(every > 0 && std::isfinite(every))) {
    throw std::invalid_argument("frequencies: every must be positive and finite, got " +
                                text(every));
  }
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!std::isfinite(y[i])) {
      throw std::invalid_argument("frequencies: expected finite samples, got " + text(y[i]) +
                                  " as number " + std::to_string(i + 1) + " of " +
                                  std::to_string(y.size()));
    }
  }
}

}  // namespace

Frequencies frequencies(std::span<const double> y, double every, std::size_t n,
                        const FrequencyOptions& options) {
  require_samples(y, every, n);
  constexpr std::size_t kMore = 8;
  Search search(y);
  search.fit(1);
  while (search.waves().size() < n + kMore) {
    if (options.observer && !options.observer(static_cast<double>(search.waves().size())))
      throw Interrupted();
    if (!search.add_highest()) break;
    search.fit(5);
  }
  search.fit(20);
  search.drop_rounding();
  search.drop_unresolved();

  Frequencies result;
  result.mean = search.mean();
  result.least_amplitude = search.threshold();
  const double length = static_cast<double>(y.size()) * every;
  for (const Wave& of_either_sign : search.waves()) {
    Wave wave = of_either_sign;
    if (wave.f < 0) wave = {-wave.f, wave.a, -wave.b};
    const Wave error = search.errors(wave, options.sample_error);
    if (!(error.f < kNearest / 4)) continue;  // nothing is known of it
    // cos(2 pi f x) is a phase of -pi f before, at the first sample.
    const double phase = std::atan2(-wave.b, wave.a) - std::numbers::pi * wave.f;
    const double amplitude = wave.amplitude();
    result.lines.push_back({wave.f / length, amplitude, std::remainder(phase, kTwoPi),
                            error.f / length, error.a,
                            error.a / amplitude + std::numbers::pi * error.f});
  }
  std::stable_sort(result.lines.begin(), result.lines.end(),
                   [](const Line& a, const Line& b) { return a.amplitude > b.amplitude; });
  if (result.lines.size() > n) result.lines.resize(n);
  return result;
}

}  // namespace rotor
