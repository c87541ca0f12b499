#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <boost/numeric/odeint.hpp>
#include <memory>
#include <utility>

#include "solver.hpp"

namespace rotor::bench {
namespace {

namespace odeint = boost::numeric::odeint;

using Four = std::array<double, 4>;  // w, x, y, z

struct GaveUp {};

void quaternion_rate(const Components& omega, const double* q, double* rate) {
  const auto [x, y, z] = omega;
  rate[0] = -0.5 * (x * q[1] + y * q[2] + z * q[3]);
  rate[1] = 0.5 * (x * q[0] + y * q[3] - z * q[2]);
  rate[2] = 0.5 * (y * q[0] + z * q[1] - x * q[3]);
  rate[3] = 0.5 * (z * q[0] + x * q[2] - y * q[1]);
}

/// q' = (0, omega) q / 2, counting.
template <class Omega>
struct System {
  const Omega& omega;
  std::size_t& calls;
  void operator()(const Four& q, Four& rate, double t) const {
    if (++calls > kMostCalls) throw GaveUp();
    quaternion_rate(omega(t), q.data(), rate.data());
  }
};

Four start_of_peers() {
  const Quaternion q = start().quaternion();
  return {q.w(), q.x(), q.y(), q.z()};
}

Quaternion quaternion_of(const double* q) { return {q[0], q[1], q[2], q[3]}; }

constexpr double kFirstStep = 0.01;

template <class Stepper, class Omega>
void run_odeint(Stepper stepper, const Omega& omega, const Problem& problem, Result& result) {
  std::vector<double> times = problem.times;
  const bool with_start = times.front() == 0;
  if (!with_start) times.insert(times.begin(), 0);
  Four q = start_of_peers();
  odeint::integrate_times(stepper, System<Omega>{omega, result.omega_calls}, q, times.begin(),
                          times.end(), kFirstStep, [&](const Four& state, double t) {
                            if (with_start || t > 0)
                              result.samples.push_back(quaternion_of(state.data()));
                          });
}

template <class Omega>
int gsl_rate(double t, const double q[], double rate[], void* system) {
  const auto& [omega, calls] = *static_cast<const System<Omega>*>(system);
  if (++calls > kMostCalls) return GSL_EBADFUNC;
  quaternion_rate(omega(t), q, rate);
  return GSL_SUCCESS;
}

template <class Omega>
void run_gsl(double tolerance, const Omega& omega, const Problem& problem, Result& result) {
  gsl_set_error_handler_off();
  System<Omega> counted{omega, result.omega_calls};
  gsl_odeiv2_system system{gsl_rate<Omega>, nullptr, 4, &counted};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, kFirstStep, tolerance,
                                    tolerance),
      gsl_odeiv2_driver_free);
  Four q = start_of_peers();
  double t = 0;
  for (const double next : problem.times) {
    if (gsl_odeiv2_driver_apply(driver.get(), &t, next, q.data()) != GSL_SUCCESS) return;
    result.samples.push_back(quaternion_of(q.data()));
  }
}

/// `run(omega, result)` with the omega of that kind, as its own type.
template <class Run>
Result with_omega(const Problem& problem, Kind kind, const Run& run) {
  Result result;
  result.samples.reserve(problem.times.size());
  try {
    if (kind == Kind::kLua) {
      run(problem.lua, result);
    } else {
      std::visit([&](const auto& omega) { run(omega, result); }, problem.native);
    }
  } catch (const GaveUp&) {                // the samples are missing
  } catch (const odeint::odeint_error&) {  // as where no step is small enough for the tolerance
  }
  return result;
}

/// A solver of Odeint; `make` gives its stepper for a tolerance.
template <class Make>
Solver odeint_solver(std::string name, Make make) {
  return {std::move(name), true, [make](const Problem& problem, Kind kind, double tolerance) {
            return with_omega(problem, kind, [&](const auto& omega, Result& result) {
              run_odeint(make(tolerance), omega, problem, result);
            });
          }};
}

/// [P7] E' = omega - (omega |E|^2 - E (omega.E)) (1 - g)/|E|^2 + omega x E/2,
/// g = theta/2 cot theta/2.
Vector euler_rate(const Vector& omega, const Vector& e) {
  const double square = e.squaredNorm();
  const double half = std::sqrt(square) / 2;
  const double g = half / std::tan(half);
  return omega - (omega * square - e * omega.dot(e)) * ((1 - g) / square) + omega.cross(e) / 2;
}

template <class Omega>
void run_rk4(double step, const Omega& omega, const Problem& problem, Result& result) {
  const auto at = [&](double t) {
    ++result.omega_calls;
    const auto [x, y, z] = omega(t);
    return Vector(x, y, z);
  };
  const auto steps = static_cast<std::size_t>(std::lround(problem.times.front() / step));
  Vector e = start().euler_vector();
  for (std::size_t i = 0; i < steps * problem.times.size(); ++i) {
    const double t = static_cast<double>(i) * step;
    const Vector middle = at(t + step / 2);
    const Vector k1 = euler_rate(at(t), e);
    const Vector k2 = euler_rate(middle, e + step / 2 * k1);
    const Vector k3 = euler_rate(middle, e + step / 2 * k2);
    const Vector k4 = euler_rate(at(t + step), e + step * k3);
    e += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if ((i + 1) % steps == 0) result.samples.push_back(from_euler_vector(e).quaternion());
  }
}

}  // namespace

std::vector<Solver> peers() {
  return {odeint_solver("Odeint rkf78",
                        [](double tolerance) {
                          return odeint::make_controlled<odeint::runge_kutta_fehlberg78<Four>>(
                              tolerance, tolerance);
                        }),
          odeint_solver(
              "Odeint Bulirsch-Stoer",
              [](double tolerance) { return odeint::bulirsch_stoer<Four>(tolerance, tolerance); }),
          odeint_solver("Odeint dopri5",
                        [](double tolerance) {
                          return odeint::make_controlled<odeint::runge_kutta_dopri5<Four>>(
                              tolerance, tolerance);
                        }),
          {"GSL rk8pd", true, [](const Problem& problem, Kind kind, double tolerance) {
             return with_omega(problem, kind, [&](const auto& omega, Result& result) {
               run_gsl(tolerance, omega, problem, result);
             });
           }}};
}

Solver dense_peer() {
  return odeint_solver("Odeint dopri5, dense", [](double tolerance) {
    return odeint::make_dense_output<odeint::runge_kutta_dopri5<Four>>(tolerance, tolerance);
  });
}

Solver rk4_on_euler_vector() {
  return {"RK4 on [P7]", true, [](const Problem& problem, Kind kind, double step) {
            return with_omega(problem, kind, [&](const auto& omega, Result& result) {
              run_rk4(step, omega, problem, result);
            });
          }};
}

}  // namespace rotor::bench
