// How values are written for people: the same text for tostring and for the terminal.
#pragma once

#include <lua.hpp>
#include <string>

#include "rotation/rotation.hpp"

namespace rotor::script {

/// Significant digits of numbers in rotor's own output; 17 is the shortest text that reads back
/// exactly.
constexpr int kFullPrecision = 17;
int precision();
void set_precision(int digits);

/// A number at that precision.
std::string shown(double x);
/// "(x, y, z)" of it.
std::string shown(const Vector& v);
/// "axis (...)  angle ... rad (... deg)" in one line where it fits into 80 columns after `indent`
/// columns.
std::string shown_axis_angle(const Vector& axis, double angle, std::size_t indent);

}  // namespace rotor::script
