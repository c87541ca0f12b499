// crossing: one of run.crossings.
#include <numbers>
#include <optional>
#include <string>

#include "integrate/charts.hpp"
#include "motion/crossings.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

double t(const Crossing& c) { return c.t; }
double t_error(const Crossing& c) { return c.t_error; }
double angle(const Crossing& c) { return 2 * std::numbers::pi * c.multiple; }
// An integer, where Lua has it.
Results push_turn(lua_State* L, double turn) {
  lua_Integer whole = 0;
  if (lua_numbertointeger(turn, &whole)) {
    lua_pushinteger(L, whole);
  } else {
    lua_pushnumber(L, turn);
  }
  return {1};
}
Results turn_before(lua_State* L) { return push_turn(L, argument<Crossing>(L, 1).turn_before); }
Results turn_after(lua_State* L) { return push_turn(L, argument<Crossing>(L, 1).turn_after); }
double distance(const Crossing& c) { return c.distance; }
std::string kind(const Crossing& c) {
  switch (c.kind) {
    case Passage::kThrough:
      return "through";
    case Passage::kBack:
      return "back";
    default:
      return "undecided";
  }
}

// nil where there is none.
template <class T>
std::optional<T> only_if(bool is, const T& value) {
  return is ? std::optional<T>(value) : std::nullopt;
}
std::optional<Vector> axis(const Crossing& c) { return only_if(!c.axis.hasNaN(), c.axis); }
std::optional<Vector> axis_rate(const Crossing& c) {
  return only_if(!c.axis_rate.hasNaN(), c.axis_rate);
}
std::optional<std::size_t> order(const Crossing& c) { return c.order; }
std::optional<std::string> order_by(const Crossing& c) {
  return only_if<std::string>(c.order.has_value(), c.by_jets ? "jets" : "differences");
}
std::optional<Vector> derivative(const Crossing& c) {
  return only_if(c.order.has_value(), c.derivative);
}
std::optional<double> derivative_error(const Crossing& c) {
  return only_if(c.order.has_value(), c.derivative_error);
}
std::optional<std::string> note(const Crossing& c) { return only_if(!c.note.empty(), c.note); }

std::string turn_text(double turn) {
  const std::string with_point = rotor::text(turn);
  return with_point.ends_with(".0") ? with_point.substr(0, with_point.size() - 2) : with_point;
}

std::string text_of_crossing(const Crossing& c) {
  std::string result = "crossing  " + kind(c) + "  angle " + full_turns_text(angle(c)) + "  t " +
                       shown(c.t) + " +- " + rotor::text(c.t_error, 2) + "  order " +
                       (c.order ? std::to_string(*c.order) : "unknown") + "\n          turn " +
                       turn_text(c.turn_before) + " to " + turn_text(c.turn_after) +
                       (c.axis.hasNaN() ? "  no axis" : "  axis " + shown(c.axis));
  if (!c.note.empty()) result += "\n          " + c.note;
  return result;
}

#define ROTOR_CROSSING "evolve{omega = {0, 0, 1}, to = 10}.crossings[1]"

constexpr Entry kFields[] = {
    {"t", bound<t>, "crossing.t -> number",
     "The time at which M = n sin(theta/2) is zero, or nearest to it.",
     ROTOR_CROSSING ".t --> 6.283185307179586"},
    {"t_error", bound<t_error>, "crossing.t_error -> number",
     "What t may be wrong by: (2 (i+1)! e/|omega^(i)|)^(1/(i+1)) for order i, e the error of M.",
     ROTOR_CROSSING ".t_error < 1e-14 --> true"},
    {"angle", bound<angle>, "crossing.angle -> number", "The multiple of 2 pi that it is at.",
     ROTOR_CROSSING ".angle --> 6.283185307179586"},
    {"kind", bound<kind>, "crossing.kind -> string",
     "\"through\": into the next interval of the angle; \"back\": it turned back; \"undecided\": "
     "note says why, and back is what is followed.",
     ROTOR_CROSSING ".kind --> \"through\""},
    {"order", bound<order>, "crossing.order -> integer",
     "The order of the first derivative of omega that is not zero there: even goes through, odd "
     "turns back [Lemma 5.3]. nil where none is known.",
     ROTOR_CROSSING ".order --> 0"},
    {"order_by", bound<order_by>, "crossing.order_by -> string",
     "How that was found: by \"jets\" (exact derivatives) or \"differences\"; nil without an "
     "order.",
     ROTOR_CROSSING ".order_by --> \"jets\""},
    {"derivative", bound<derivative>, "crossing.derivative -> vec",
     "That derivative, in the frame of omega; nil without an order.",
     ROTOR_CROSSING ".derivative --> vec(0.0, 0.0, 1.0)"},
    {"derivative_error", bound<derivative_error>, "crossing.derivative_error -> number",
     "What it may be wrong by: beside it, how sure the order is.",
     ROTOR_CROSSING ".derivative_error < 1e-14 --> true"},
    {"axis", bound<axis>, "crossing.axis -> vec", "The limit of the axis; nil where there is none.",
     ROTOR_CROSSING ".axis --> vec(0.0, 0.0, 1.0)"},
    {"axis_rate", bound<axis_rate>, "crossing.axis_rate -> vec",
     "The limit of dn/dt [Lemma 5.3, with 1/(i+2)]; nil where there is none.",
     ROTOR_CROSSING ".axis_rate --> vec(0.0, 0.0, 0.0)"},
    {"turn_before", bound<turn_before>, "crossing.turn_before -> integer",
     "The l with 2 pi l <= angle <= 2 pi (l + 1) before.", ROTOR_CROSSING ".turn_before --> 0"},
    {"turn_after", bound<turn_after>, "crossing.turn_after -> integer", "The same after.",
     ROTOR_CROSSING ".turn_after --> 1"},
    {"distance", bound<distance>, "crossing.distance -> number",
     "How near the angle came to 2 pi k as computed, rad: to be compared with "
     "run.crossing_tolerance.",
     ROTOR_CROSSING ".distance --> 0.0"},
    {"note", bound<note>, "crossing.note -> string",
     "What else is to be said: why it is undecided, why the axis has no limit.",
     ROTOR_CROSSING ".note --> nil"},
};

constexpr Entry kOperators[] = {
    {"__tostring", bound<text_of_crossing>, "tostring(crossing) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_CROSSING ") > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"crossing", Kind::kField, kFields},
    {"crossing", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> crossing_groups() { return kGroups; }

}  // namespace rotor::script
