#include "dynamics/birkhoff.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "rotation/rotation.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

// A value that stands for a stretch of the way.
struct Sample {
  double begin;
  double end;
  double integral;  // the value times the length
};

double middle(const Sample& sample) { return sample.begin / 2 + sample.end / 2; }

// The two means, over the part of the way that the samples cover.
struct Means {
  double plain;
  double weighted;
};
Means means(std::span<const Sample> samples) {
  const double start = samples.front().begin;
  const double length = samples.back().end - start;
  Extended plain = 0;
  Extended weighted = 0;
  Extended weights = 0;
  for (const Sample& sample : samples) {
    const double s = (middle(sample) - start) / length;
    const double weight = std::exp(-1 / (s * (1 - s)));
    plain += sample.integral;
    weighted += Extended{weight} * sample.integral;
    weights += Extended{weight} * std::abs(sample.end - sample.begin);
  }
  return {static_cast<double>(plain / std::abs(length)), static_cast<double>(weighted / weights)};
}

Average average(std::span<const Sample> samples) {
  const Means all = means(samples);
  const Means first = means(samples.first(samples.size() / 2));
  const Means second = means(samples.last(samples.size() / 2));
  const auto spread = [&](double Means::*mean) {
    const auto [least, most] = std::minmax({all.*mean, first.*mean, second.*mean});
    return most - least;
  };
  return {all.plain, all.weighted, spread(&Means::plain), spread(&Means::weighted)};
}

void require_finite_sample(double value, std::size_t i) {
  if (std::isfinite(value)) return;
  throw std::invalid_argument("an average needs finite numbers, got " + text(value) +
                              " as sample " + std::to_string(i + 1));
}

}  // namespace

Average birkhoff(std::span<const double> samples) {
  if (samples.size() < 2) {
    throw std::invalid_argument("an average needs at least 2 samples, got " +
                                std::to_string(samples.size()));
  }
  std::vector<Sample> list;
  list.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    require_finite_sample(samples[i], i);
    list.push_back({static_cast<double>(i), static_cast<double>(i + 1), samples[i]});
  }
  return average(list);
}

Average birkhoff_rate(std::span<const double> t, std::span<const double> sum) {
  if (t.size() != sum.size() || t.size() < 3) {
    throw std::invalid_argument(
        "the average of a rate needs at least 3 sums, each with its time; got " +
        std::to_string(sum.size()) + " sums and " + std::to_string(t.size()) + " times");
  }
  std::vector<Sample> list;
  list.reserve(t.size() - 1);
  require_finite_sample(sum[0], 0);
  for (std::size_t i = 1; i < t.size(); ++i) {
    require_finite_sample(sum[i], i);
    list.push_back({t[i - 1], t[i], sum[i] - sum[i - 1]});
  }
  return average(list);
}

}  // namespace rotor
