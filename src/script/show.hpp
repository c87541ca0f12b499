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
/// "quaternion(w, x, y, z)", x, y and z on a line of their own where it does not fit into 80
/// columns (fewer within a table).
std::string shown(const Quaternion& q);
/// "angle ... rad (... deg)  axis (...)" in one line where it fits into 80 columns (fewer within a
/// table) after `indent` columns, else the axis on the next line, `indent` columns in or fewer.
std::string shown_axis_angle(const Vector& axis, double angle, std::size_t indent);

}  // namespace rotor::script
