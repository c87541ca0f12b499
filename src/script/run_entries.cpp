// evolve, run, state and cost.
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "motion/run.hpp"
#include "output/animation.hpp"
#include "output/run_output.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/evolve.hpp"
#include "script/options.hpp"
#include "script/output_options.hpp"
#include "script/progress.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

Results evolve_entry(lua_State* L) {
  Convert<SharedRun>::push(L, evolve_options(L));
  return {1};
}

// run(t).
Results state_at(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  Convert<RunState>::push(L, {run, run->attitude(argument<double>(L, 2))});
  return {1};
}

constexpr const char* kSample = "run:sample{n=, every=, times=, t=} -> table";
Results sample(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const std::vector<double> times = times_option(Options(L, 2, kSample), *run);
  push_states(L, run, times);
  return {1};
}

constexpr const char* kCsv = "run:csv(file, {n=, every=, times=, t=, columns=})";
Results csv(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const std::string file = file_argument(L, 2);
  const Options options(L, 3, kCsv);
  const std::vector<double> times = times_option(options, *run);
  const auto columns = columns_option<StateColumns>(L, options);
  const bool with_json =
      write_csv(*run, times, columns, file, scene_name(L), watching(run->t0(), run->t1()));
  print_written(L, file, times.size(), with_json);
  return {0};
}

constexpr const char* kPlot =
    "run:plot(what, {n=, every=, times=, t=, title=, width=, height=, file=})";
Results plot_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const auto columns = columns_of<StateColumns>(L, argument<Names>(L, 2).list);
  const Options options(L, 3, kPlot);
  show(L, options,
       picture(*run, times_option(options, *run), columns, look_option(options),
               watching(run->t0(), run->t1())));
  return {0};
}

// From one of the times to the next, by |omega| there.
double greatest_turn(const Run& run, std::span<const double> times) {
  double greatest = 0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    greatest = std::max(greatest, norm(run.propagator().flow->generator(times[i])) *
                                      std::abs(times[i] - times[i - 1]));
  }
  return greatest;
}

constexpr const char* kAnimate = "run:animate(file, {n=, every=, times=, t=, point=})";
Results animate_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const std::string file = file_argument(L, 2);
  const Options options(L, 3, kAnimate);
  const std::vector<double> times = times_option(options, *run, 120);
  const Vector point = options.get<Vector>("point").value_or(Vector(1, 0, 0));
  if (!(norm(point) > 0 && point.allFinite())) {
    throw std::invalid_argument("point: expected a place other than 0, got " + shown(point));
  }
  if (const double turn = greatest_turn(*run, times); turn > 1) {
    warn(L, "from one frame to the next the body turns by up to " + text(turn, 2) +
                " rad: t = {from, to} shows a part of the run");
  }
  if (!say_drawn(L, file, animate(*run, times, point, file, watching(run->t0(), run->t1())))) {
    print(L, in_characters(picture(*run, times, columns_of<StateColumns>(L, {"axis"}))));
  }
  return {0};
}

constexpr const char* kSphere = "run:sphere{of=, point=, n=, every=, times=, t=, from=, width=}";
Results sphere_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const Options options(L, 2, kSphere);
  options.word("of", sphere_quantities());
  draw_on_sphere(L, run, times_option(options, *run), true);
  return {0};
}

constexpr const char* kTable = "run:table(what, {n=, every=, times=, t=})";
Results table_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  std::vector<std::string> names = argument<Names>(L, 2).list;
  names.insert(names.begin(), "t");
  const Options options(L, 3, kTable);
  print(L, table(*run, times_option(options, *run, 11), columns_of<StateColumns>(L, names),
                 precision(), watching(run->t0(), run->t1())));
  return {0};
}

double t0(const SharedRun& run) { return run->t0(); }
double t1(const SharedRun& run) { return run->t1(); }
Rotation start(const SharedRun& run) { return run->from(); }
std::string method(const SharedRun& run) { return run->propagator().method; }
std::string why(const SharedRun& run) { return run->propagator().why; }
bool complete(const SharedRun& run) { return run->complete(); }
double error_estimate(const SharedRun& run) { return run->propagator().error_estimate; }
Cost cost(const SharedRun& run) { return run->propagator().cost; }
// Made once a run, and kept with it.
Results crossings(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  if (lua_getiuservalue(L, 1, 1) == LUA_TTABLE) return {1};
  const std::vector<Crossing> list = run->crossings(watching(run->t0(), run->t1()));
  Convert<std::vector<Crossing>>::push(L, list);
  lua_pushvalue(L, -1);
  lua_setiuservalue(L, 1, 1);
  return {1};
}

double crossing_tolerance(const SharedRun& run) { return run->crossing_tolerance(); }
std::vector<std::string> notes(const SharedRun& run) {
  return run->notes(watching(run->t0(), run->t1()));
}

SharedRun from(const SharedRun& run, const Rotation& start) {
  return std::make_shared<const Run>(run->with_start(start));
}

std::string text_of_run(const SharedRun& run) {
  const Propagator& p = run->propagator();
  std::string text = "run  t " + shown(run->t0()) + " .. " + shown(run->t1()) + "  " + p.method +
                     " (" + p.why + ")\n     " + std::to_string(p.cost.steps) + " steps  " +
                     std::to_string(p.cost.omega_calls) + " omega calls  error about " +
                     rotor::text(p.error_estimate, 2);
  if (p.accuracy > 0 && p.error_estimate > p.accuracy) {
    text += ", more than the " + rotor::text(p.accuracy, 2) + " asked for";
  }
  if (!run->complete()) text += "\n     incomplete: " + p.stop->reason;
  return text;
}

// Fields of a state.
const State& full(const RunState& s) {
  if (!s.full) s.full = (*s.run)(s.attitude.t, watching(s.run->t0(), s.run->t1()));
  return *s.full;
}
double state_t(const RunState& s) { return s.attitude.t; }
double state_angle(const RunState& s) { return full(s).angle; }
Vector state_axis(const RunState& s) { return full(s).axis; }
Vector state_euler_vector(const RunState& s) { return full(s).euler_vector(); }
Rotation state_rotation(const RunState& s) { return full(s).rotation(); }
Quaternion state_quaternion(const RunState& s) { return s.attitude.quaternion; }
Matrix state_matrix(const RunState& s) { return s.attitude.matrix(); }
std::vector<Vector> state_points(const RunState& s) { return s.run->points(s.attitude.t); }
Vector state_omega(const RunState& s) { return s.run->omega(s.attitude.t); }
Vector state_body_omega(const RunState& s) { return s.run->body_omega(s.attitude.t); }
Rates rates_of(const RunState& s) { return s.run->rates(full(s), s.run->omega(s.attitude.t)); }
double state_angle_rate(const RunState& s) { return rates_of(s).angle_rate; }
Vector state_axis_rate(const RunState& s) { return rates_of(s).axis_rate; }
Vector state_euler_rate(const RunState& s) { return rates_of(s).euler_rate; }
std::string text_of_state(const RunState& s) {
  const State& state = full(s);
  if (state.axis.hasNaN()) {
    return "state  t " + shown(state.t) + "\n       angle " + shown(state.angle) +
           " rad  no axis (run.notes says why)";
  }
  return "state  t " + shown(state.t) + "\n       " + shown_axis_angle(state.axis, state.angle, 7);
}

std::size_t omega_calls(const Cost& c) { return c.omega_calls; }
std::size_t steps(const Cost& c) { return c.steps; }
std::size_t rejected(const Cost& c) { return c.rejected; }
double seconds(const Cost& c) { return c.seconds; }
std::string text_of_cost(const Cost& c) {
  return "cost  " + std::to_string(c.omega_calls) + " omega calls  " + std::to_string(c.steps) +
         " steps  " + std::to_string(c.rejected) + " rejected  " + rotor::text(c.seconds, 2) + " s";
}

#define ROTOR_RUN "evolve{omega = {0, 0, 1}, to = 10}"

constexpr Entry kFunctions[] = {
    {"evolve", bound<evolve_entry>, kEvolve,
     "Follows a body that turns with the angular velocity omega, in radians per unit of t: a "
     "vector (constant), a function of t alone that returns three numbers (fast) or a "
     "table, a spline, or a model of spin; in the space frame, or by spin.body(omega) in the "
     "body frame. from: the rotation at the start (default identity). to: the end, from t = 0; or "
     "t = {t0, t1}, backward too. accuracy: bound on the rotation error of the whole run, rad "
     "(default 1e-10). method: \"auto\" (the cheapest faithful), \"exact\" (closed "
     "forms), \"fgl\" (Fer factors on Gauss-Legendre nodes), \"dop853\" (Runge-Kutta "
     "of order 8), \"rk4\" with step. breaks: times at which omega jumps. max_step (default a 10th "
     "to a 32nd of the way): what omega does between its 15 to 64 samples a step is not seen. "
     "max_steps: default a million. equation: \"quaternion\" (default), or by rk4 and dop853 "
     "\"euler\" [P7], \"modified_gibbs\" [P8], \"gibbs\" [P10], \"axis_angle\" [P5], "
     "\"body_points\" [P1], \"generalized\" [P4] with f, an odd function of the angle: those "
     "stop where they are singular; restart = true (\"euler\", \"generalized\") goes on from "
     "E (1 - 2 pi/|E|), the same operator; singularity = \"ignore\" (\"euler\") straight on, which "
     "is wrong. points: see state; crossing_tolerance: see run. A run that stops early "
     "raises an error with .reason, .t and .run.",
     ROTOR_RUN "(7).angle --> 7.0"},
};

constexpr Entry kMethods[] = {
    {"from", bound<from>, "run:from(rotation) -> run",
     "The same motion from another start. Nothing is integrated: the motion is linear in the "
     "quaternion of the start.",
     ROTOR_RUN ":from(rotation({0, 0, 1}, 1))(2).angle --> 3.0"},
    {"sample", bound<sample>, kSample,
     "The states at n times from start to end (default 1000), at every so much, or at the given "
     "times: a list. t = {from, to}: of that part of the run alone.",
     "#" ROTOR_RUN ":sample{n = 11} --> 11"},
    {"csv", bound<csv>, kCsv,
     "Writes the states at the times (as run:sample) as CSV, and where they come from as "
     "FILE.json. columns: "
     "names of quantities (\"axis\") or components (\"axis_x\"): t, angle, axis, euler_vector, "
     "quaternion "
     "(these by default), mrp, shadow_mrp, matrix, gibbs, modified_gibbs, euler_zyx (as all twelve "
     "sequences, "
     "body axes), omega, angle_rate, axis_rate, euler_rate, divergence, invariant_density.",
     ROTOR_RUN ":csv(\"/dev/null\", {n = 11}) --> "},
    {"table", bound<table_entry>, kTable,
     "Prints quantities or components, as named for run:csv (one name or a list), at n times "
     "(default 11), at "
     "every so much, or at the given times. Digits are left out that do not fit into 80 columns; "
     "with 6 left, "
     "columns that do not fit stand below.",
     ROTOR_RUN ":table(\"angle\", {n = 3}) --> "},
    {"plot", bound<plot_entry>, kPlot,
     "Draws quantities or components over t, as named for run:csv: one name or a list of names. "
     "The curve of an "
     "Euler angle is broken where it goes on from pi to -pi. file: a picture instead, by gnuplot, "
     "\"x.svg\", .png, .pdf or .gif, with its script x.gp and its data x.dat beside it; where "
     "there is "
     "no gnuplot these are written, and the plot is printed.",
     ROTOR_RUN ":plot(\"angle\", {height = 5}) --> "},
    {"sphere", bound<sphere_entry>, kSphere,
     "Draws the way of the axis on the unit sphere in characters (as draw_sphere, with its "
     "from and width), at the times (as run:sample): what follows by less than 0.5 rad is "
     "joined. of: \"axis\" (default), or the direction of \"omega\" or of \"body_omega\"; "
     "point: instead a point of the body, by its place at the start. Where there is no "
     "direction is a gap.",
     ROTOR_RUN ":sphere{of = \"omega\", width = 30} --> "},
    {"animate", bound<animate_entry>, kAnimate,
     "Draws the motion as FILE, a .gif, by gnuplot: the axis, omega (over its greatest length) and "
     "a "
     "point of the body, by its place at the start (point=, default {1, 0, 0}), on the unit "
     "sphere, "
     "in n frames (default 120), at every so much or at the given times. The script and the data "
     "stay beside it; where there is no gnuplot the axis is plotted.",
     ROTOR_RUN ":animate(\"turn.gif\")"},
};

constexpr Entry kFields[] = {
    {"t0", bound<t0>, "run.t0 -> number", "Time of the start.", ROTOR_RUN ".t0 --> 0.0"},
    {"t1", bound<t1>, "run.t1 -> number", "Time of the end, or the time reached.",
     ROTOR_RUN ".t1 --> 10.0"},
    {"start", bound<start>, "run.start -> rotation", "The rotation at the start.",
     ROTOR_RUN ".start.angle --> 0.0"},
    {"method", bound<method>, "run.method -> string", "The method that was used.",
     ROTOR_RUN ".method --> \"exact\""},
    {"why", bound<why>, "run.why -> string", "Why this method.",
     ROTOR_RUN ".why --> \"constant omega, Theorem 4.1\""},
    {"complete", bound<complete>, "run.complete -> boolean", "Whether the run reached its end.",
     ROTOR_RUN ".complete --> true"},
    {"error_estimate", bound<error_estimate>, "run.error_estimate -> number",
     "Estimate of the rotation error anywhere in the run, rad: of the integration, with its "
     "rounding. That of rk4 knows omega at its nodes only; run:certify sees what lies between.",
     ROTOR_RUN ".error_estimate < 1e-14 --> true"},
    {"cost", bound<cost>, "run.cost -> cost",
     "What the integration took: .omega_calls .steps .rejected .seconds.",
     ROTOR_RUN ".cost.steps --> 0"},
    {"crossings", bound<crossings>, "run.crossings -> table",
     "Where the angle comes to a multiple of 2 pi, and how it goes on: a list. Looked for when it, "
     "or an axis or angle, is first asked for. A multiple that the run starts or ends at, to the "
     "rounding of the angle or to run.crossing_tolerance, is none.",
     "#" ROTOR_RUN ".crossings --> 1"},
    {"crossing_tolerance", bound<crossing_tolerance>, "run.crossing_tolerance -> number",
     "How near to 2 pi k, rad, the angle comes where it is a crossing; from four times that on (or "
     "four times the error) it is a near miss, between them undecided. At late t what the rounding "
     "of t "
     "makes of the angle is added. Twice the error estimate, "
     "or as given to evolve.",
     ROTOR_RUN ".crossing_tolerance < 1e-13 --> true"},
    {"notes", bound<notes>, "run.notes -> table",
     "What is to be said of the axis at the start, of the crossings and of the end: where the axis "
     "has no limit and why, what is undecided, where the motion and the derivatives of omega "
     "disagree. Mostly empty.",
     "#" ROTOR_RUN ".notes --> 0"},
};

constexpr Entry kOperators[] = {
    {"__call", bound<state_at>, "run(t) -> state",
     "The state at t, with axis and angle that go on continuously; t outside the run is an error. "
     "The angle "
     "counts turns where the body passes through the attitude that is angle 0; where it passes it "
     "by, the angle "
     "turns back before 2 pi and the axis swings over.",
     ROTOR_RUN "(2).angle --> 2.0"},
    {"__tostring", bound<text_of_run>, "tostring(run) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_RUN ") > 0 --> true"},
};

#define ROTOR_STATE ROTOR_RUN "(7)"

constexpr Entry kStateFields[] = {
    {"t", bound<state_t>, "state.t -> number", "The time.", ROTOR_STATE ".t --> 7.0"},
    {"angle", bound<state_angle>, "state.angle -> number",
     "Rotation angle theta, rad, continuous: turns are counted.", ROTOR_STATE ".angle --> 7.0"},
    {"axis", bound<state_axis>, "state.axis -> vec",
     "Unit axis n, continuous; nan where it has no limit (run.notes says why).",
     ROTOR_STATE ".axis --> vec(0.0, 0.0, 1.0)"},
    {"euler_vector", bound<state_euler_vector>, "state.euler_vector -> vec",
     "E = n theta, continuous.", ROTOR_STATE ".euler_vector --> vec(0.0, 0.0, 7.0)"},
    {"rotation", bound<state_rotation>, "state.rotation -> rotation",
     "The rotation (axis, angle). Its angle is rounded to a double, which limits it after many "
     "turns: the "
     "quaternion and the matrix are not.",
     ROTOR_STATE ".rotation.angle --> 7.0"},
    {"quaternion", bound<state_quaternion>, "state.quaternion -> quaternion",
     "Unit quaternion, continuous in t.", ROTOR_STATE ".quaternion.w < 0 --> true"},
    {"matrix", bound<state_matrix>, "state.matrix -> matrix", "Matrix of the operator.",
     ROTOR_STATE ".matrix[3][3] --> 1.0"},
    {"points", bound<state_points>, "state.points -> table",
     "Where the points of the body are that evolve was given by their places at the start "
     "(points=).",
     "evolve{omega = {0, 0, 1}, to = 1, points = {{0, 0, 2}}}(1).points[1] --> vec(0.0, 0.0, 2.0)"},
    {"omega", bound<state_omega>, "state.omega -> vec",
     "The angular velocity at t, in the space frame: calls omega.",
     ROTOR_STATE ".omega --> vec(0.0, 0.0, 1.0)"},
    {"body_omega", bound<state_body_omega>, "state.body_omega -> vec",
     "The angular velocity at t, in the body frame: calls omega.",
     ROTOR_STATE ".body_omega --> vec(0.0, 0.0, 1.0)"},
    {"angle_rate", bound<state_angle_rate>, "state.angle_rate -> number", "omega . n [P5].",
     ROTOR_STATE ".angle_rate --> 1.0"},
    {"axis_rate", bound<state_axis_rate>, "state.axis_rate -> vec",
     "dn/dt [P5], at a multiple of 2 pi by Lemma 5.3; nan where the axis has no limit.",
     ROTOR_STATE ".axis_rate --> vec(0.0, 0.0, 0.0)"},
    {"euler_rate", bound<state_euler_rate>, "state.euler_rate -> vec", "dE/dt [P7].",
     ROTOR_STATE ".euler_rate --> vec(0.0, 0.0, 1.0)"},
};
constexpr Entry kStateOperators[] = {
    {"__tostring", bound<text_of_state>, "tostring(state) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_STATE ") > 0 --> true"},
};

constexpr Entry kCostFields[] = {
    {"omega_calls", bound<omega_calls>, "cost.omega_calls -> number", "Calls of omega.",
     ROTOR_RUN ".cost.omega_calls --> 0"},
    {"steps", bound<steps>, "cost.steps -> number", "Steps taken.", ROTOR_RUN ".cost.steps --> 0"},
    {"rejected", bound<rejected>, "cost.rejected -> number", "Steps tried and given up.",
     ROTOR_RUN ".cost.rejected --> 0"},
    {"seconds", bound<seconds>, "cost.seconds -> number", "Seconds by the clock.",
     ROTOR_RUN ".cost.seconds < 60 --> true"},
};
constexpr Entry kCostOperators[] = {
    {"__tostring", bound<text_of_cost>, "tostring(cost) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_RUN ".cost) > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},     {"run", Kind::kField, kFields},
    {"run", Kind::kMethod, kMethods},      {"run", Kind::kOperator, kOperators},
    {"state", Kind::kField, kStateFields}, {"state", Kind::kOperator, kStateOperators},
    {"cost", Kind::kField, kCostFields},   {"cost", Kind::kOperator, kCostOperators},
};

}  // namespace

std::span<const Group> run_groups() { return kGroups; }

}  // namespace rotor::script
