// omega in pieces: the flows of the pieces, chained.
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "integrate/exact.hpp"
#include "integrate/legs.hpp"

namespace rotor {
namespace {

class ChainedFlow final : public Flow {
 public:
  explicit ChainedFlow(std::vector<FollowedLeg> legs)
      : legs_(std::move(legs)), forward_(legs_.back().end >= legs_.front().begin) {}

  Quaternion at(double t) const override {
    const FollowedLeg& leg = leg_at(t);
    return (leg.flow->at(t).cast<Extended>() * leg.before).cast<double>();
  }
  Vector generator(double t) const override { return leg_at(t).flow->generator(t); }

  std::vector<double> mesh() const override {
    std::vector<double> mesh{legs_.front().begin};
    for (const FollowedLeg& leg : legs_) {
      const std::vector<double> part = leg.flow->mesh();
      mesh.insert(mesh.end(), part.begin() + 1, part.end());
      require_not_too_many(mesh.size());
    }
    return mesh;
  }

  std::vector<TimeSpan> approaches(const Quaternion& target, double distance) const override {
    constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
    std::vector<TimeSpan> spans;
    for (const FollowedLeg& leg : legs_) {
      const ExtendedQuaternion aim = target.cast<Extended>() * leg.before.conjugate();
      const auto part = leg.flow->approaches(aim.cast<double>(), distance + kRounding);
      spans.insert(spans.end(), part.begin(), part.end());
      require_not_too_many(spans.size());
    }
    return spans;
  }

 private:
  static void require_not_too_many(std::size_t size) {
    if (size > 10'000'000) {
      throw std::length_error("the pieces of omega turn too far to be looked through");
    }
  }

  // The leg that starts at t, where two meet.
  const FollowedLeg& leg_at(double t) const {
    const auto after = std::upper_bound(legs_.begin() + 1, legs_.end(), t,
                                        [this](double time, const FollowedLeg& leg) {
                                          return forward_ ? time < leg.begin : time > leg.begin;
                                        });
    return *std::prev(after);
  }

  std::vector<FollowedLeg> legs_;
  bool forward_;
};

// The breaks strictly between the ends of a leg, of a list that rises.
std::vector<double> within(const std::vector<double>& breaks, double begin, double end) {
  const auto [low, high] = std::minmax(begin, end);
  return {std::upper_bound(breaks.begin(), breaks.end(), low),
          std::lower_bound(breaks.begin(), breaks.end(), high)};
}

// The pieces on the way from t0 to t1.
std::vector<Leg> legs_of(const Scene& scene, const PiecewiseSpin& omega,
                         std::vector<double> breaks) {
  std::sort(breaks.begin(), breaks.end());
  const std::vector<double>& ends = omega.ends();
  const bool forward = scene.t1 >= scene.t0;
  const auto [low, high] = std::minmax(scene.t0, scene.t1);
  // Pieces first ... last own what lies between low and high.
  const auto first = std::upper_bound(ends.begin(), ends.end(), low) - ends.begin();
  const auto last =
      std::max(first, std::lower_bound(ends.begin(), ends.end(), high) - ends.begin());
  std::vector<Leg> legs;
  legs.reserve(static_cast<std::size_t>(last - first) + 1);
  for (auto i = first; i <= last; ++i) {
    const auto piece = static_cast<std::size_t>(forward ? i : first + last - i);
    const AngularVelocity& part = omega.pieces()[piece];
    double begin = piece == static_cast<std::size_t>(first) ? low : ends[piece - 1];
    double end = piece == static_cast<std::size_t>(last) ? high : ends[piece];
    if (!forward) std::swap(begin, end);
    legs.push_back({scene.omega.frame() == Frame::kBody ? part.in_body_frame() : part, begin, end,
                    begin, within(breaks, begin, end)});
  }
  return legs;
}

}  // namespace

void follow_piecewise(const Scene& scene, const PiecewiseSpin& omega,
                      const std::vector<double>& breaks, const Observer& observer,
                      Propagator& result) {
  const std::vector<Leg> legs = legs_of(scene, omega, breaks);
  FollowedLegs done = follow_legs(scene, legs, scene.accuracy, observer);
  result.t1 = done.legs.back().end;
  result.stop = std::move(done.stop);
  result.error_estimate = done.error_estimate;
  result.cost = done.cost;
  result.accuracy = done.exact ? 0 : scene.accuracy;
  result.method = done.method;
  result.why = legs.size() == 1 ? "within one piece of omega"
                                : "omega in " + std::to_string(legs.size()) +
                                      " pieces, each by its cheapest method";
  result.flow = std::make_shared<const ChainedFlow>(std::move(done.legs));
}

}  // namespace rotor
