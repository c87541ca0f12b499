// How numbers are written, in messages and in everything that rotor prints.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

namespace rotor {

/// The shortest text that reads back as exactly `x` (std::to_chars). Fixed form for 1e-5 <= |x| <
/// 1e15, else with an exponent; a whole number keeps ".0"; "nan", "inf", "-inf". Never depends on
/// the locale.
std::string text(double x);

/// As above with at most `digits` significant digits (1 to 17), for people; trailing zeros dropped.
std::string text(double x, int digits);

/// "(x, y, z)".
std::string text(const Eigen::Vector3d& v);

/// "(w, x, y, z)".
std::string text(const Eigen::Quaterniond& q);

/// "((a, b, c), (d, e, f), (g, h, i))", row by row.
std::string text(const Eigen::Matrix3d& m);

}  // namespace rotor
