// Crossings and what is about them, against 50 digits (make_crossings.py).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "catch.hpp"
#include "crossing_table.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;
using namespace rotor::crossing_table;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kCount = Jet::kOrder + 1;

struct Course {
  Method method;
  double accuracy;
  bool jets;  // else differences
};
const std::vector<Course> kCourses = {
    {Method::kFgl, 1e-10, true},  {Method::kFgl, 1e-10, false},   {Method::kFgl, 1e-13, true},
    {Method::kFgl, 1e-13, false}, {Method::kDop853, 1e-10, true}, {Method::kDop853, 1e-10, false}};

AngularVelocity driver(const Motion& motion, bool jets) {
  const std::shared_ptr<const Polynomial> omega = motion.omega;
  if (jets) return {omega, Frame::kSpace};
  return AngularVelocity([omega](double t) { return omega->value(t); });
}

Scene scene_of(const Motion& motion, const Course& course) {
  Scene result = scene(driver(motion, course.jets), motion.t0, motion.t1, course.accuracy);
  result.method = course.method;
  return result;
}

double power(double x, std::size_t n) { return std::pow(x, static_cast<double>(n)); }

// omega(t + s) = sum_k c_k s^k by twelve of its values is a sum over Chebyshev polynomials T_n with
// coefficients of at most twice the greatest value. So where values err by one, c_k errs by what
// is here at k: of an interval of half length one, about its middle (0) or its end (1).
std::array<double, kCount> noise_of_differences(double about) {
  std::array<double, kCount> before{1}, now{about, 1}, sum{1};
  for (int n = 1; n < 12; ++n) {
    std::array<double, kCount> next{};
    for (std::size_t k = 0; k < kCount; ++k) {
      sum[k] += 2 * std::abs(now[k]);
      next[k] = 2 * about * now[k] + (k > 0 ? 2 * now[k - 1] : 0) - before[k];
    }
    before = now;
    now = next;
  }
  return sum;
}

// The least step of the run on either side of t, as far as the run goes.
double step_about(const Run& run, double t) {
  const std::vector<double> mesh = run.propagator().flow->mesh();
  double least = kInfinity;
  for (std::size_t i = 1; i < mesh.size(); ++i) {
    const double step = std::abs(mesh[i] - mesh[i - 1]);
    if (std::min(std::abs(mesh[i] - t), std::abs(mesh[i - 1] - t)) <= step) {
      least = std::min(least, step);
    }
  }
  return least;
}

// A zero of M, and how well axis and rate are known at a distance s from it by the derivatives of
// omega there. A run takes these where they say that they know more than M does: they count their
// last terms for what they leave out, and M's error without its small factors, all together four.
class AboutZero {
 public:
  AboutZero(const Motion& motion, const Run& run, bool jets, double t) : t_(t) {
    const VectorJet jet = motion.omega->jet(t);
    for (std::size_t k = 0; k < kCount; ++k) {
      c_[k] = Vector(jet[0].c[k], jet[1].c[k], jet[2].c[k]).norm();
    }
    while (c_[order_] <= motion.omega->rounding(t)) ++order_;
    // |q_k| is at most the coefficient of exp(sum_j |c_j| s^(j+1)/(2 (j+1))), less than its value
    // at 1; M begins with c_i s^(i+1)/(2 (i+1)).
    double sum = 0;
    for (std::size_t j = 0; j < kCount; ++j) sum += c_[j] / (2 * static_cast<double>(j + 1));
    growth_ = std::exp(sum) * 2 * static_cast<double>(order_ + 1) / c_[order_];
    const bool at_start = t == motion.t0;
    if (!jets) differ(*motion.omega, step_about(run, t), at_start);
    if (at_start) return;
    time_error_ = 2 * kEpsilon * std::abs(t);
    if (order_ == 0) time_error_ += time_by_m(run);
    // Where c_(i-1) + i c_i s is zero.
    if (order_ > 0) time_error_ += e_[order_ - 1] / (static_cast<double>(order_) * c_[order_]);
  }

  double t() const { return t_; }
  std::size_t order() const { return order_; }
  // When the term of M of order i, |omega^(i)| s^(i+1)/(2 (i+1)!), comes out of the error of M.
  double time_by_m(const Run& run) const {
    const double error = std::max(run.propagator().error_estimate / 2, kEpsilon);
    const auto n = static_cast<double>(order_ + 1);
    return std::pow(2 * n * (error + kEpsilon * std::abs(t_) * c_[0]) / c_[order_], 1 / n);
  }
  // P = M/s^(i+1) to s^(8-i): its last two terms, the errors of t and of the c_k, and rounding.
  // `turning` and `bend` are |n'| and |n''|.
  double axis_error(double s, double turning) const {
    double error = growth_ * power(s, 7 - order_) + turning * time_error_ + 8 * kEpsilon;
    for (std::size_t k = order_; k < kCount; ++k) error += part(k) * power(s, k - order_);
    return 4 * error;
  }
  double rate_error(double s, double turning, double bend) const {
    double error = static_cast<double>(8 - order_) * growth_ * power(s, 6 - order_) +
                   bend * time_error_ + 8 * kEpsilon * growth_ + 2 * turning * part(order_);
    for (std::size_t k = order_ + 1; k < kCount; ++k) {
      error += static_cast<double>(k - order_) * part(k) * power(s, k - order_ - 1);
    }
    return 4 * error;
  }

 private:
  // Of an error of c_k in P, over |P(0)|.
  double part(std::size_t k) const {
    return e_[k] / c_[order_] * static_cast<double>(order_ + 1) / static_cast<double>(k + 1);
  }
  // A polynomial is what differences find at every distance, and what is left is the rounding: the
  // best of ever shorter ones errs by that of the first and twice that of the second.
  void differ(const Polynomial& omega, double step, bool at_start) {
    const double half = at_start ? step / 8 : step / 2;
    double most = 0;
    for (const double t : times(t_ - step, t_ + step, 20)) {
      most = std::max(most, omega.rounding(t));
    }
    most *= 1 + (std::abs(t_) + step) / half;  // an ulp of t
    const std::array<double, kCount> noise = noise_of_differences(at_start ? 1 : 0);
    for (std::size_t k = 0; k < kCount; ++k) e_[k] = 3 * noise[k] * most / power(half, k);
  }

  double t_;
  std::array<double, kCount> c_;
  std::array<double, kCount> e_{};
  std::size_t order_ = 0;
  double growth_;
  double time_error_ = 0;
};

void check_crossing(const Run& run, const Crossing& crossing, const KnownCrossing& known,
                    const AboutZero& zero) {
  CHECK(crossing.kind == known.kind);
  CHECK(crossing.order == known.order);
  CHECK(crossing.turn_before == known.turn_before);
  CHECK(crossing.turn_after == known.turn_after);
  CHECK(crossing.multiple == std::round(run(known.t).angle / (2 * std::numbers::pi)));
  CHECK(std::abs(crossing.t - known.t) <= crossing.t_error);
  CHECK(crossing.t_error <= 2 * (zero.time_by_m(run) + kEpsilon * std::abs(known.t)));
  const double turning = known.axis_rate.norm();
  CHECK((crossing.axis - known.axis).norm() <= zero.axis_error(0, turning));
  CHECK((crossing.axis_rate - known.axis_rate).norm() <= zero.rate_error(0, turning, known.bend));
}

void check_state(const Motion& motion, const Run& run, const KnownState& known,
                 const std::vector<AboutZero>& zeros) {
  const State state = run(known.t);
  const Vector omega = run.omega(known.t);
  const Rates rates = run.rates(state, omega);
  const double rounding = motion.omega->rounding(known.t) + 1e-40;  // of omega; of the table
  const double turning = known.axis_rate.norm();
  const double rotation = rotation_tolerance(run, known.angle);
  const double m = std::abs(std::sin(known.angle / 2));
  // As in axis_tolerance. [P5], n' = (omega - n (omega . n)) cot(theta/2)/2 + omega x n/2, makes of
  // an error of n at most |omega| (1/(2|M|) + 1/2) as much, and of one of the cotangent, across n,
  // |omega|/(2|M|); of one of omega 1/(2|M|) + 1/2. All this is of first order.
  double angle = rotation;
  double axis = rotation / (2 * m);
  double rate = (1.5 * omega.norm() * axis + rounding) / m;
  if (!(axis < 0.1)) axis = rate = kInfinity;
  for (const AboutZero& zero : zeros) {
    const double s = std::abs(known.t - zero.t());
    if (s > 0.5) continue;
    const auto crossing = std::find_if(motion.crossings.begin(), motion.crossings.end(),
                                       [&](const KnownCrossing& its) { return its.t == zero.t(); });
    const double bend = crossing == motion.crossings.end() ? 0 : crossing->bend;
    axis = std::min(axis, zero.axis_error(s, turning));
    rate = std::min(rate, zero.rate_error(s, turning, bend));
    // The crossing is seen before or after t: there 2|M| is at most the error, and has the wrong
    // sign.
    if (s <= 2 * zero.time_by_m(run)) angle = 3 * rotation;
  }
  CHECK(std::abs(state.angle - known.angle) <= angle);
  CHECK((state.axis - known.axis).norm() <= axis);
  CHECK((rates.axis_rate - known.axis_rate).norm() <= rate);
  // [P7] changes by 2 |omega| as much as E (|theta| < 3), and E errs by theta/(2|M|) < 1.51 of the
  // rotation's error across n. Farther on it is n theta' + n' theta.
  const double euler = std::abs(known.angle) < 3
                           ? 5 * omega.norm() * rotation + 2 * rounding
                           : std::abs(known.angle) * rate + turning * rotation +
                                 2 * omega.norm() * axis + 2 * rounding;
  CHECK((rates.euler_rate - known.euler_rate).norm() <= euler);
}

void check(const Motion& motion, const Scene& scene, bool jets) {
  const Run run = evolve(scene, motion.from);
  INFO(motion.name << "  " << run.propagator().method << "  accuracy " << scene.accuracy
                   << "  jets " << jets);
  const std::vector<Crossing> list = run.crossings();
  REQUIRE(list.size() == motion.crossings.size());
  std::vector<AboutZero> zeros;
  if (motion.starts_on_zero()) zeros.emplace_back(motion, run, jets, motion.t0);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const KnownCrossing& known = motion.crossings[i];
    CAPTURE(known.t, list[i].t, list[i].note);
    zeros.emplace_back(motion, run, jets, known.t);
    REQUIRE(zeros.back().order() == known.order);
    check_crossing(run, list[i], known, zeros.back());
    CHECK(list[i].by_jets == jets);
  }
  REQUIRE(motion.states.size() > 1);
  for (const KnownState& known : motion.states) {
    CAPTURE(known.t);
    check_state(motion, run, known, zeros);
  }
}

}  // namespace

TEST_CASE("crossings, and axis and angle and their rates about them, are those of 50 digits") {
  std::size_t crossings = 0;
  for (const Motion& motion : motion_table()) {
    crossings += motion.crossings.size();
    for (const Course& course : kCourses) check(motion, scene_of(motion, course), course.jets);
  }
  CHECK(crossings == 55);
}

TEST_CASE("in the body frame the inverse motion crosses in the same way") {
  for (const Motion& motion : motion_table()) {
    for (const Course& course : kCourses) {
      const Motion back = inverse(motion);
      Scene s = scene_of(back, course);
      s.omega = s.omega.in_body_frame();
      check(back, s, course.jets);
    }
  }
}

TEST_CASE("a near miss as small as 1e-12 is told, and one within the error of the run is not") {
  int misses = 0;
  for (const Motion& motion : motion_table()) {
    if (motion.miss == 0) continue;
    ++misses;
    for (const Course& course : kCourses) {
      const Scene s = scene_of(motion, course);
      CAPTURE(motion.name, course.accuracy);
      CHECK(evolve(s, motion.from).crossings().empty());
      // What is less than the tolerance is a crossing, to four times that undecided.
      for (const double tolerance : {2 * motion.miss, motion.miss / 2, motion.miss / 5}) {
        CAPTURE(tolerance);
        const auto list = evolve(s, motion.from, {}, {}, tolerance).crossings();
        REQUIRE(list.size() == (tolerance == motion.miss / 5 ? 0 : 1));
        if (list.empty()) continue;
        CHECK((list[0].kind == Passage::kUndecided) == (tolerance < motion.miss));
        // It is told as 2|M|, 2 sin(miss/2).
        CHECK(std::abs(list[0].distance - motion.miss) <=
              rotation_tolerance(evolve(s, motion.from), 2 * std::numbers::pi));
      }
    }
  }
  CHECK(misses == 6);
}

TEST_CASE("about a fixed axis one integral knows the same crossings") {
  for (const Motion& motion : motion_table()) {
    if (!motion.about_fixed_axis()) continue;
    const Vector axis = motion.from.axis();
    const auto rate = [&](double t) { return motion.omega->value(t).dot(axis); };
    const auto jet = [&](double t) {
      const VectorJet omega = motion.omega->jet(t);
      return omega[0] * axis.x() + omega[1] * axis.y() + omega[2] * axis.z();
    };
    const AngularVelocity along(
        std::make_shared<const AlongSpin>(axis, ScalarFunction{rate, jet, "rate"}));
    const Run run = evolve(scene(along, motion.t0, motion.t1), motion.from);
    CAPTURE(motion.name, run.propagator().method);
    const std::vector<Crossing> list = run.crossings();
    REQUIRE(list.size() == motion.crossings.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      const KnownCrossing& known = motion.crossings[i];
      CAPTURE(list[i].t, list[i].note);
      check_crossing(run, list[i], known, AboutZero(motion, run, true, known.t));
    }
    for (const KnownState& known : motion.states) {
      CAPTURE(known.t);
      const State state = run(known.t);
      CHECK(std::abs(state.angle - known.angle) <= rotation_tolerance(run, known.angle));
      CHECK(state.axis == axis);
      CHECK(run.rates(state, run.omega(known.t)).axis_rate == Vector::Zero());
    }
  }
}

TEST_CASE("where steps are short the order is that of omega all the same") {
  // Of order 3 and 4 a crossing is uncertain by many of these steps.
  for (const Motion& motion : motion_table()) {
    if (motion.crossings.empty() || motion.crossings[0].order < 3) continue;
    const KnownCrossing& known = motion.crossings[0];
    for (const auto& [method, step] :
         {std::pair{Method::kFgl, 1e-3}, {Method::kDop853, 1e-3}, {Method::kRk4, 3e-4}}) {
      for (const bool jets : {true, false}) {
        Scene s = scene_of(motion, {method, 1e-10, jets});
        (method == Method::kRk4 ? s.step : s.max_step) = step;
        const Run run = evolve(s, motion.from);
        const std::vector<Crossing> list = run.crossings();
        INFO(motion.name << "  " << run.propagator().method << "  jets " << jets);
        REQUIRE(list.size() == 1);
        CAPTURE(list[0].t, list[0].t_error, list[0].note);
        CHECK(list[0].kind == known.kind);
        CHECK(list[0].order == known.order);
        CHECK(std::abs(list[0].t - known.t) <= list[0].t_error);
        if (!jets) continue;
        const AboutZero zero(motion, run, jets, known.t);
        CHECK((list[0].axis - known.axis).norm() <= zero.axis_error(0, known.axis_rate.norm()));
      }
    }
  }
}

TEST_CASE("a start on M = 0 far from t = 0 goes the way that omega's differences say") {
  constexpr double kLater = 1000;
  for (const Motion& motion : motion_table()) {
    if (!motion.starts_on_zero()) continue;
    const auto omega = motion.omega;
    const AngularVelocity later([omega](double t) { return omega->value(t - kLater); });
    const Run run = evolve(scene(later, motion.t0 + kLater, motion.t1 + kLater), motion.from);
    CAPTURE(motion.name, run.notes());
    for (const KnownState& known : motion.states) {
      if (known.t == motion.t0 || std::abs(known.t) < 1e-5) continue;  // t + 1000 is rounded
      CAPTURE(known.t);
      // An ulp of t is 1.1e-13, |omega| < 2.5.
      CHECK(std::abs(run(known.t + kLater).angle - known.angle) <=
            rotation_tolerance(run, known.angle) + 3e-13);
    }
  }
}
