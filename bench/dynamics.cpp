// Goals 9 to 12: the motion as a dynamical system.
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

#include "dynamics/lyapunov.hpp"
#include "dynamics/pair_distances.hpp"
#include "dynamics/recurrence.hpp"
#include "dynamics/spectrum.hpp"
#include "dynamics/strobe.hpp"
#include "measure.hpp"
#include "motion/times.hpp"
#include "scratch.hpp"
#include "spin/models.hpp"

namespace rotor::bench {
namespace {

constexpr double kPeriod = 40;
constexpr std::size_t kPoints = 10'000;
constexpr double kRate = 0.01;

// What was measured, and the number that came out.
struct Timed {
  double seconds;
  double value;
};

Timed timed(const std::function<double()>& work) {
  const double begin = cpu_seconds();
  const double value = work();
  return {cpu_seconds() - begin, value};
}

// The motion of the paper, [P15]; periodic: of a function that is not known to turn.
Run motion(double t1, bool periodic) {
  const double rate = 2 * std::numbers::pi / kPeriod;
  const Turning turning{rate};
  const auto omega = [turning](double t) -> Vector {
    const Components w = turning(t);
    return {w[0], w[1], w[2]};
  };
  const AngularVelocity spin =
      periodic
          ? AngularVelocity(std::make_shared<PeriodicSpin>(kPeriod, AngularVelocity(omega)))
          : AngularVelocity(std::make_shared<TurningSpin>(Vector(1, 0, 0), Vector(0, 0, 1), rate));
  return evolve({.omega = spin, .t1 = t1}, from_euler_vector(Vector(1, 1, 1) / std::sqrt(3)));
}

double strobe() {
  const Run run = motion(42'000, true);
  const std::vector<double> times = strobe_times(run, kPeriod);
  double sum = plane_of_m(run, times).off + strobe_circle(run, times).rotation_number;
  for (const double t : times) sum += run(t).angle;
  return sum;
}

// By the linearised [P7], with as many times as Figure 8 has.
double largest_log(double t1, std::size_t times) {
  const LyapunovSpectrum spectrum = lyapunov_spectrum(motion(t1, false), times_in(0, t1, times + 1),
                                                      Chart::kEulerVector, LyapunovMethod::kQr);
  return spectrum.history.back()(0) * t1;
}

double pairs_within(const PointSequence& points, double distance) {
  std::size_t count = 0;
  visit_neighbours(points, distance, [&](std::size_t, std::span<const std::uint32_t> row) {
    count += row.size();
    return true;
  });
  return static_cast<double>(count);
}

double density_sum(const std::vector<double>& signal) {
  double sum = 0;
  for (const double s : power_spectral_density(signal, 1).density) sum += s;
  return sum;
}

void write(const std::filesystem::path& file, const std::vector<double>& values) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(double)));
}

struct Peers {
  Timed lyapunov;
  Timed pairs;
  Timed density;
};

// Debian's NumPy and SciPy are those of its own Python.
Peers peers(const std::string& arguments) {
  const std::string command =
      "/usr/bin/python3 " ROTOR_SOURCE "/bench/dynamics_peers.py " + arguments;
  const std::string said = output_of(command);
  Peers result{};
  if (std::sscanf(said.c_str(), "%lf %lf %lf %lf %lf %lf", &result.lyapunov.seconds,
                  &result.lyapunov.value, &result.pairs.seconds, &result.pairs.value,
                  &result.density.seconds, &result.density.value) != 6) {
    throw std::runtime_error(command + ": expected six numbers, got " + said);
  }
  return result;
}

void must_agree(const char* what, double rotor, double peer, double tolerance) {
  if (!(std::abs(rotor - peer) <= tolerance * std::abs(peer))) {
    throw std::runtime_error(std::string(what) + ": rotor has " + std::to_string(rotor) +
                             ", the peer " + std::to_string(peer));
  }
}

double wall_seconds_of_figures() {
  const auto begin = std::chrono::steady_clock::now();
  output_of(ROTOR_BINARY " " ROTOR_SOURCE "/examples/paper/figures.lua");
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

void judge_dynamics(int rounds, Goals& goals) {
  const Scratch scratch;
  const Run run = motion(4200, false);
  const PointSequence points =
      recurrence_points(run, times_in(0, 4200, kPoints), Chart::kEulerVector);
  const double distance = threshold_of_rate(points, kRate);
  std::vector<double> coordinates;
  for (const auto& p : points.points)
    coordinates.insert(coordinates.end(), p.begin(), p.begin() + 3);
  std::vector<double> signal;
  for (const double t : times_in(0, 4200, 1 << 18))
    signal.push_back(run.attitude(t).quaternion.w());
  write(scratch / "points", coordinates);
  write(scratch / "signal", signal);
  const std::string arguments = (scratch / "points").string() + " " +
                                (scratch / "signal").string() + " " + std::to_string(distance);

  std::map<std::string, std::vector<double>> ms;
  const auto measure = [&ms](const std::string& what, const Timed& result, double scale = 1) {
    ms[what].push_back(1e3 * scale * result.seconds);
    return result.value;
  };
  for (int round = 0; round < rounds; ++round) {
    const Peers peer = peers(arguments);
    measure("peer's exponents", peer.lyapunov, 1e5 / 400);
    measure("peer's pairs", peer.pairs);
    measure("peer's density", peer.density);
    measure("strobe", timed(strobe));
    measure("exponents", timed([] { return largest_log(1e5, 1000); }));
    // The peer keeps to 1e-11 a step, some 1e-8 in all.
    must_agree("the sum of logarithms at t = 400", largest_log(400, 4), peer.lyapunov.value, 1e-6);
    // The distance was printed to 1e-6 for the peer.
    must_agree("pairs", measure("pairs", timed([&] { return pairs_within(points, distance); })),
               peer.pairs.value, 1e-4);
    measure("recurrence", timed([&] {
              return static_cast<double>(recurrence(points, distance, {}).measures.pairs);
            }));
    must_agree("density", measure("density", timed([&] { return density_sum(signal); })),
               peer.density.value, 1e-9);
  }
  std::map<std::string, double> middle;
  for (const auto& [what, values] : ms) middle[what] = median(values);
  std::printf("\nthe motion of the paper as a dynamical system, CPU ms, rotor and NumPy/SciPy\n");
  const auto row = [&middle](const char* what, const char* key, const char* peer) {
    std::printf("  %-52s %10s %10s\n", what, three_digits(middle[key]).c_str(),
                peer == nullptr ? "" : three_digits(middle[peer]).c_str());
  };
  row("strobe to t = 42000, with its circle and plane", "strobe", nullptr);
  row("Lyapunov exponents to t = 1e5 by QR, in E", "exponents", "peer's exponents");
  row("pairs of 1e4 points, at a rate of 1 %", "pairs", "peer's pairs");
  row("  with their quantification", "recurrence", nullptr);
  row("spectral density of 2^18 samples", "density", "peer's density");
  goals.at_most(9, "ms for the strobe to t = 42000", middle["strobe"], 10);
  goals.at_most(10, "ms for Lyapunov exponents to t = 1e5 by QR", middle["exponents"], 1000);
  goals.at_least(10, "times faster than by SciPy's DOP853 (its time to t = 400, 250 times)",
                 middle["peer's exponents"] / middle["exponents"], 50);
  goals.at_least(11, "pairs of 1e4 points, times faster than cKDTree",
                 middle["peer's pairs"] / middle["pairs"], 3);
  goals.at_most(12, "seconds for all figures", wall_seconds_of_figures(), 60);
}

}  // namespace rotor::bench
