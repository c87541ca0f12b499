// How numbers are written.
#include "rotation/text.hpp"

#include <charconv>
#include <cstring>
#include <limits>
#include <random>

#include "catch.hpp"

using rotor::text;

namespace {

const double kInf = std::numeric_limits<double>::infinity();

double read(const std::string& s) {
  double x = 0;
  const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), x);
  CHECK(error == std::errc());
  CHECK(end == s.data() + s.size());
  return x;
}

bool has_point_or_exponent(const std::string& s) {
  return s.find_first_of(".e") != std::string::npos;
}

}  // namespace

TEST_CASE("text: every double reads back, bit for bit") {
  std::mt19937_64 engine(801);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = engine();
    double x;
    std::memcpy(&x, &bits, sizeof x);
    if (!std::isfinite(x)) continue;
    const std::string written = text(x), shortened = text(x, 17);
    if (read(written) == x && read(shortened) == x && has_point_or_exponent(written)) continue;
    FAIL_CHECK("bits " << bits << " written " << written << " and " << shortened);
  }
}

TEST_CASE("text: form") {
  CHECK(text(0) == "0.0");
  CHECK(text(-0.0) == "-0.0");
  CHECK(text(1) == "1.0");
  CHECK(text(-3) == "-3.0");
  CHECK(text(0.1) == "0.1");
  CHECK(text(1.0 / 3) == "0.3333333333333333");
  CHECK(text(123456789.0) == "123456789.0");
  CHECK(text(5e-324) == "5e-324");
  CHECK(text(1.7976931348623157e308) == "1.7976931348623157e+308");
  CHECK(text(kInf) == "inf");
  CHECK(text(-kInf) == "-inf");
  CHECK(text(std::nan("")) == "nan");
  CHECK(text(-std::nan("")) == "nan");
  CHECK(text(Eigen::Vector3d(1, -0.5, 1e22)) == "(1.0, -0.5, 1e+22)");
}

TEST_CASE("text: fixed form from 1e-5 up to 1e15") {
  CHECK(text(1e-5) == "0.00001");
  CHECK(text(-1e-5) == "-0.00001");
  CHECK(text(std::nextafter(1e-5, 0)) == "9.999999999999999e-06");
  CHECK(text(1.5e-5) == "0.000015");
  CHECK(text(1e15) == "1e+15");
  CHECK(text(-1e15) == "-1e+15");
  CHECK(text(std::nextafter(1e15, 0)) == "999999999999999.9");
  CHECK(text(1e14) == "100000000000000.0");
}

TEST_CASE("text: at most so many digits") {
  CHECK(text(1.0 / 3, 3) == "0.333");
  CHECK(text(2.0 / 3, 3) == "0.667");
  CHECK(text(0.1 + 0.2, 16) == "0.3");
  CHECK(text(0.1 + 0.2, 17) == "0.30000000000000004");
  CHECK(text(1234567, 3) == "1230000.0");
  CHECK(text(2, 5) == "2.0");
  CHECK(text(9.96, 2) == "10.0");
  CHECK(text(-0.0, 3) == "-0.0");
  CHECK(text(kInf, 3) == "inf");
  CHECK(text(std::nan(""), 3) == "nan");
  CHECK(text(5e-324, 1) == "5e-324");
}

TEST_CASE("text: the form is that of the rounded number") {
  CHECK(text(9.9999e-6, 3) == "0.00001");
  CHECK(text(9.9999e-6, 5) == "9.9999e-06");
  CHECK(text(999999999999999.9, 3) == "1e+15");
  // Rounding up leaves the range of double, not that of text.
  CHECK(text(1.7976931348623157e308, 3) == "1.8e+308");
  CHECK(text(-1.7976931348623157e308, 1) == "-2e+308");
}
