// run:certify and certificate.
#include <string>

#include "integrate/certify.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/progress.hpp"

namespace rotor::script {
namespace {

constexpr const char* kCertify = "run:certify{n=, noise=, bias=} -> certificate";
Results certify_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const Options given(L, 2, kCertify);
  CertifyOptions options;
  options.n = given.get<std::size_t>("n").value_or(options.n);
  options.noise = given.get<double>("noise").value_or(options.noise);
  options.bias = given.get<double>("bias").value_or(options.bias);
  Convert<Certificate>::push(
      L, certify(*run->propagator().flow, run->driver(), options, watching(run->t0(), run->t1())));
  return {1};
}

double estimate(const Certificate& c) { return c.estimate; }
double bound_of(const Certificate& c) { return c.bound; }
Vector error(const Certificate& c) { return c.error; }
double rounding(const Certificate& c) { return c.rounding; }
bool at_rounding(const Certificate& c) { return c.at_rounding; }
std::size_t omega_calls(const Certificate& c) { return c.omega_calls; }
std::string text_of_certificate(const Certificate& c) {
  const std::string found = c.at_rounding ? "no error above rounding, " + text(c.rounding, 2)
                                          : "error " + text(c.estimate, 5);
  return "certificate  " + found + " rad  bound " + text(c.bound, 2) + " rad\n             " +
         std::to_string(c.omega_calls) + " omega calls";
}

#define ROTOR_CERTIFICATE "evolve{omega = {0, 0, 1}, to = 10}:certify()"

constexpr Entry kMethods[] = {
    {"certify", bound<certify_entry>, kCertify,
     "The run's error, measured on the run itself, whatever the method and without a reference: "
     "the angular velocity that the motion really has, less omega, at n Gauss points (3 to 64, "
     "default 20) and the ends of every interval of the run, which is halved where they are too "
     "few. It calls "
     "omega. noise, bias: bounds in rad per unit of t on what omega may be wrong by; times the "
     "length of the run they are added to .bound. What omega does between all points is not seen; "
     "a run of more than ten million intervals is refused.",
     ROTOR_CERTIFICATE ".at_rounding --> true"},
};

constexpr Entry kFields[] = {
    {"estimate", bound<estimate>, "certificate.estimate -> number",
     "The greatest rotation error on the way, rad, to first order; never below .rounding.",
     ROTOR_CERTIFICATE ".estimate < 1e-14 --> true"},
    {"bound", bound<bound_of>, "certificate.bound -> number",
     "What the rotation error cannot exceed, rad: the integral of |what the motion has - omega|.",
     ROTOR_CERTIFICATE ".bound < 1e-13 --> true"},
    {"error", bound<error>, "certificate.error -> vec",
     "The error at the end, a rotation vector: rotation.from_euler_vector(-error) * "
     "run(run.t1).rotation is the attitude without it, to first order (in the body frame the other "
     "way round: it stands on the right).",
     "norm(" ROTOR_CERTIFICATE ".error) < 1e-14 --> true"},
    {"rounding", bound<rounding>, "certificate.rounding -> number",
     "What rounding, of omega and of the motion, may be responsible for, rad.",
     ROTOR_CERTIFICATE ".rounding < 1e-14 --> true"},
    {"at_rounding", bound<at_rounding>, "certificate.at_rounding -> boolean",
     "Whether no error was found above .rounding.", ROTOR_CERTIFICATE ".at_rounding --> true"},
    {"omega_calls", bound<omega_calls>, "certificate.omega_calls -> number",
     "Calls of omega that it took.", ROTOR_CERTIFICATE ".omega_calls --> 44"},
};

constexpr Entry kOperators[] = {
    {"__tostring", bound<text_of_certificate>, "tostring(certificate) -> string",
     "The text under which the terminal shows it.",
     "#tostring(" ROTOR_CERTIFICATE ") > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"run", Kind::kMethod, kMethods},
    {"certificate", Kind::kField, kFields},
    {"certificate", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> certify_groups() { return kGroups; }

}  // namespace rotor::script
