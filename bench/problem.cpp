#include "problem.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "integrate/closed_forms.hpp"
#include "mixed_reference.hpp"
#include "motion/times.hpp"
#include "rotation/text.hpp"

namespace rotor::bench {
namespace {

ExtendedQuaternion extended_start() { return half_angle_quaternion(start()); }

template <class Truth>
Problem problem(std::string name, std::string statement, NativeOmega native,
                const std::string& code, double t1, Truth truth, std::vector<double> times = {}) {
  if (times.empty()) {
    times = times_in(0, t1, 101);
    times.erase(times.begin());
  }
  std::vector<ExtendedQuaternion> motion;
  motion.reserve(times.size());
  for (const double t : times) motion.push_back(truth(t) * extended_start());
  return {std::move(name),  std::move(statement), native, code, LuaOmega(code), t1,
          std::move(times), std::move(motion)};
}

std::string turning_code(double a) {
  return "local cos, sin, a = math.cos, math.sin, " + text(a) +
         "\nreturn function(t) return cos(a*t), sin(a*t), 0 end";
}

Problem turning(std::string name, const std::string& a_text, double a, double t1,
                std::vector<double> times = {}) {
  return problem(std::move(name), "(cos at, sin at, 0), a = " + a_text + ", t <= " + text(t1),
                 Turning{a}, turning_code(a), t1, closed_form::Turning{a}, std::move(times));
}

constexpr double kSlow = 2 * std::numbers::pi / 40;

}  // namespace

LuaOmega::LuaOmega(const std::string& code) : state_(luaL_newstate(), lua_close) {
  luaL_openlibs(state_.get());
  if (luaL_dostring(state_.get(), code.c_str()) != LUA_OK) fail();
}

void LuaOmega::fail() const { throw std::runtime_error(lua_tostring(state_.get(), -1)); }

Rotation start() { return {Vector(1, 1, 1), 1}; }

const Problem& p1() {
  static const Problem p = turning("P1", "2 pi/40", kSlow, 4200);
  return p;
}
const Problem& p2() {
  static const Problem p = turning("P2", "2", 2, 4200);
  return p;
}
const Problem& p3() {
  static const Problem p = turning("P3", "100", 100, 100);
  return p;
}
const Problem& p5() {
  static const Problem p = turning("P5", "2 pi/40", kSlow, 4200, times_in(0, 4200, 420'001));
  return p;
}
const Problem& p1_long() {
  static const Problem p = turning("P1L", "2 pi/40", kSlow, 1e6);
  return p;
}

const Problem& p4() {
  static const Problem p =
      problem("P4", "(sin 3t + 0.3 cos 17t, e^(-t/50) cos(t^2/40), log(1+t)/2), t <= 50", Mixed{},
              "local sin, cos, exp, log = math.sin, math.cos, math.exp, math.log\n"
              "return function(t)\n"
              "  return sin(3*t) + 0.3*cos(17*t), exp(-t/50)*cos(t*t/40), 0.5*log(1 + t)\n"
              "end",
              50, [](double t) {
                const auto& q = kMixedReference[std::lround(2 * t) - 1];
                return ExtendedQuaternion(q[0], q[1], q[2], q[3]);
              });
  return p;
}

const Problem& p6() {
  static constexpr Jump kJump{{2}, {3}, 100 / std::numbers::pi};
  static const Problem p =
      problem("P6", "(cos at, sin at, 0), a = 2 until t = 100/pi, then a = 3, t <= 100", kJump,
              "local cos, sin, jump = math.cos, math.sin, " + text(kJump.jump) +
                  "\nreturn function(t)\n  local a = t < jump and 2 or 3\n"
                  "  return cos(a*t), sin(a*t), 0\nend",
              100, [](double t) {
                const closed_form::Turning before{kJump.before.a};
                const closed_form::Turning after{kJump.after.a};
                if (t <= kJump.jump) return before(t);
                return after(t) * after(kJump.jump).conjugate() * before(kJump.jump);
              });
  return p;
}

double greatest_error(const Problem& problem, const std::vector<Quaternion>& computed) {
  if (computed.size() != problem.times.size()) return std::numeric_limits<double>::infinity();
  Extended greatest = 0;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    const auto q = computed[i].cast<Extended>().coeffs();
    const auto& truth = problem.truth[i].coeffs();
    const Extended error = std::min((q - truth).norm(), (q + truth).norm());
    if (!(error <= greatest)) greatest = error;  // NaN stays
  }
  return static_cast<double>(greatest);
}

}  // namespace rotor::bench
