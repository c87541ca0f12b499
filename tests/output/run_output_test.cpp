// Columns, tables and files of a run against its states.
#include "output/run_output.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hpp"
#include "motion/times.hpp"
#include "temporary.hpp"

using namespace rotor;

namespace {

Run coning(double to = 3) {
  Scene scene{.omega = AngularVelocity(
                  [](double t) { return Vector(std::cos(t), std::sin(t), 0.25); }, "coning")};
  scene.t1 = to;
  return evolve(scene, Rotation({1, 2, 2}, 1));
}

std::vector<double> values_of(const Run& run, double t, const std::vector<std::string>& names) {
  std::vector<double> values;
  StateRow row(run, t);
  StateColumns(names).values(row, values);
  return values;
}

}  // namespace

TEST_CASE("Columns are named by quantity, component or header, in the order asked for") {
  const std::vector<std::string> names = {"axis_y", "t", "quaternion", "angle_rad", "matrix"};
  CHECK(StateColumns(names).headers() ==
        std::vector<std::string>{"axis_y", "t", "quaternion_w", "quaternion_x", "quaternion_y",
                                 "quaternion_z", "angle_rad", "matrix_11", "matrix_12", "matrix_13",
                                 "matrix_21", "matrix_22", "matrix_23", "matrix_31", "matrix_32",
                                 "matrix_33"});
  const std::vector<std::string> unknown = {"axes"};
  try {
    StateColumns{unknown};
    FAIL("an unknown column is refused");
  } catch (const std::invalid_argument& error) {
    CHECK(
        std::string(error.what()).starts_with("unknown column 'axes'; there are t, angle, axis,"));
  }
  CHECK_THROWS_AS(StateColumns(std::span<const std::string>{}), std::invalid_argument);
}

TEST_CASE("Every column is what the state and the equations say") {
  const Run run = coning();
  for (const double t : {0.0, 0.7, 3.0}) {
    const State state = run(t);
    const Rotation r = state.rotation();
    const auto check = [&](const std::string& name, const Vector& expected) {
      INFO(name << " at " << t);
      const std::vector<double> v = values_of(run, t, {name});
      REQUIRE(v.size() == 3);
      // The faces of the rotation come another way, from its angle: a few roundings of numbers
      // below 4.
      CHECK((Vector(v[0], v[1], v[2]) - expected).norm() < 1e-14);
    };
    check("axis", state.axis);
    check("euler_vector", state.angle * state.axis);
    check("modified_gibbs", r.modified_gibbs());
    check("gibbs", r.gibbs());
    check("mrp", r.mrp());
    check("omega", Vector(std::cos(t), std::sin(t), 0.25));
    const std::vector<double> e = values_of(run, t, {"euler_zxz"});
    const Rotation again =
        Rotation({0, 0, 1}, e[0]) * Rotation({1, 0, 0}, e[1]) * Rotation({0, 0, 1}, e[2]);
    CHECK(distance(again, r) < 1e-14);
    const std::vector<double> m = values_of(run, t, {"matrix"});
    for (int i = 0; i < 9; ++i)
      CHECK(std::abs(m[static_cast<std::size_t>(i)] - r.matrix()(i / 3, i % 3)) < 1e-14);
    CHECK(values_of(run, t, {"t", "angle"}) == std::vector<double>{t, state.angle});
  }
}

TEST_CASE("The vectors of a state hold through all turns, where their angle is rounded") {
  Scene scene{.omega = AngularVelocity(Vector(0, 0, 1))};
  scene.t1 = 40;
  const Run run = evolve(scene, Rotation({0, 0, 1}, 0));
  for (double t = 0.1; t < 40; t += 0.7) {
    const State state = run(t);
    CAPTURE(t);
    CHECK(state.modified_gibbs().z() == Approx(std::sin(t / 2)).epsilon(0).margin(1e-14));
    CHECK(state.gibbs().z() == Approx(std::tan(t / 2)).epsilon(1e-12));
    CHECK(state.mrp().z() == Approx(std::tan(t / 4)).epsilon(1e-12));
    CHECK(values_of(run, t, {"shadow_mrp_z"})[0] == Approx(-1 / std::tan(t / 4)).epsilon(1e-12));
    CHECK(state.matrix()(1, 0) == Approx(std::sin(t)).epsilon(0).margin(1e-14));
  }
}

TEST_CASE("A CSV file has the states, to the last digit, and its JSON where they come from") {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path / "run.csv";
  const Run run = coning();
  const std::vector<double> times = times_in(0, 3, 7);
  const std::vector<std::string> names = {"t", "angle", "axis"};
  CHECK(write_csv(run, times, StateColumns(names), file, "a script"));

  std::istringstream lines(content_of(file));
  std::string line;
  std::getline(lines, line);
  CHECK(line == "t,angle_rad,axis_x,axis_y,axis_z");
  std::size_t row = 0;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    const State state = run(times.at(row++));
    for (const double expected :
         {state.t, state.angle, state.axis.x(), state.axis.y(), state.axis.z()}) {
      std::string cell;
      std::getline(cells, cell, ',');
      CHECK(std::stod(cell) == expected);
    }
  }
  CHECK(row == 7);
  const std::string json = content_of(file.string() + ".json");
  for (const char* piece : {"\"rows\": 7", "\"omega\": \"coning\"", "\"method\": \"fgl\"",
                            "\"scene\": \"a script\"", "\"complete\": true", "\"angle_rad\""}) {
    CHECK(json.find(piece) != std::string::npos);
  }
  CHECK(!write_csv(run, times, StateColumns(names), "/dev/null", ""));
}

TEST_CASE("An observer stops the writing, and the file does not appear") {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path / "run.csv";
  const std::vector<std::string> names = {"t"};
  const std::vector<double> times = times_in(0, 3, 1000);
  int calls = 0;
  const Observer tenth = [&](double) { return ++calls < 10; };
  CHECK_THROWS_AS(write_csv(coning(), times, StateColumns(names), file, "", tenth), Interrupted);
  CHECK(directory.entries() == 0);
}

TEST_CASE("A table and a plot have what is asked") {
  const Run run = coning();
  const std::vector<double> times = times_in(0, 3, 4);
  const std::vector<std::string> names = {"t", "angle"};
  const std::string text = table(run, times, StateColumns(names), 17);
  CHECK(text.starts_with("  t           angle_rad\n"));
  CHECK(std::count(text.begin(), text.end(), '\n') == 6);
  const std::vector<std::string> angle = {"angle"};
  CHECK(in_characters(picture(run, times, StateColumns(angle))).find("angle_rad") !=
        std::string::npos);
}

TEST_CASE("The curve of an Euler angle is broken where it wraps") {
  Scene scene{.omega = AngularVelocity(Vector(0, 0, 1))};
  scene.t1 = 6;
  const Run run = evolve(scene, Rotation({0, 0, 1}, 0));
  const std::vector<double> times = times_in(0, 6, 601);
  // A straight line but for the wrap: no steep part, which is what | stands for, beside the axis.
  const auto bars = [&](const char* name) {
    const std::vector<std::string> names = {name};
    const std::string text = in_characters(picture(run, times, StateColumns(names)));
    return std::count(text.begin(), text.end(), '|') - std::count(text.begin(), text.end(), '\n');
  };
  CHECK(bars("euler_zyx_1") == bars("angle"));
}
