// Round numbers along an axis.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rotor {

/// The distance between ticks: digit x 10^exponent, digit 1, 2 or 5. A tick is a whole multiple of
/// it, so that labels are exact decimals. Long double, because the extent of double data may exceed
/// the largest double.
struct Step {
  int digit;
  int exponent;

  long double size() const;
  Step next() const;  // the next larger one
};

/// What the places along an axis are: the numbers, or their decimal logarithms. The ticks of the
/// latter are whole powers of ten, their steps 1 or more.
enum class Spacing { kLinear, kLogarithmic };

/// The smallest step that is not below `size` > 0, but for rounding.
Step step_from(long double size);

/// The labels of the ticks first .. last times the step, all in fixed form or all with an exponent,
/// whichever is shorter (fixed up to eight characters); powers of ten are "1e-09".
std::vector<std::string> tick_labels(Step step, std::int64_t first, std::int64_t last,
                                     Spacing spacing = Spacing::kLinear);

/// An extent on which to draw: `low` < `high`.
struct Extent {
  long double low;
  long double high;
};

/// From low to high. An extent below 16 ulps of its ends is that of a constant c, drawn amid c -+
/// |c|/2 (0 -+ 1). Of logarithms: whole decades, at least the two about a power of ten.
Extent drawable(double low, double high, Spacing spacing = Spacing::kLinear);

}  // namespace rotor
