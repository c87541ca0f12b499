#include "rotation/text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace rotor {
namespace {

std::string with_point(std::string digits) {
  if (digits.find_first_of(".en") == std::string::npos) digits += ".0";
  return digits;
}

template <class... Precision>
std::string written(double x, Precision... precision) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  const double size = std::abs(x);
  const bool fixed = size == 0 || (size >= 1e-5 && size < 1e15);
  std::array<char, 64> buffer;
  auto end =
      std::to_chars(buffer.begin(), buffer.end(), x,
                    fixed ? std::chars_format::fixed : std::chars_format::scientific, precision...);
  return {buffer.begin(), end.ptr};
}

}  // namespace

std::string text(double x) { return with_point(written(x)); }

std::string text(double x, int digits) {
  if (x == 0 || !std::isfinite(x)) return text(x);
  // Rounding to the digits first makes the choice of form and the place of the last digit those of
  // the rounded value.
  std::array<char, 64> buffer;
  auto end = std::to_chars(buffer.begin(), buffer.end(), x, std::chars_format::general, digits);
  double rounded = 0;
  const auto read = std::from_chars(buffer.begin(), end.ptr, rounded);
  // Rounded up past the largest double: the digits are the text already.
  if (read.ec != std::errc()) return {buffer.begin(), end.ptr};
  return text(rounded);
}

std::string text(const Eigen::Vector3d& v) {
  return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
}

std::string text(const Eigen::Quaterniond& q) {
  return "(" + text(q.w()) + ", " + text(q.x()) + ", " + text(q.y()) + ", " + text(q.z()) + ")";
}

std::string text(const Eigen::Matrix3d& m) {
  const auto row = [&](int i) { return text(Eigen::Vector3d(m.row(i).transpose())); };
  return "(" + row(0) + ", " + row(1) + ", " + row(2) + ")";
}

}  // namespace rotor
