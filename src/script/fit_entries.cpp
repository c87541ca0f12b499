// Random rotations, means, and rotations from points.
#include "rotation/fit.hpp"

#include <optional>
#include <string>
#include <vector>

#include "rotation/random.hpp"
#include "script/binding.hpp"
#include "script/interrupt.hpp"
#include "script/options.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

using Points = std::vector<Vector>;

Results random_rotation(lua_State* L) {
  const auto seed = argument<std::size_t>(L, 1);
  const auto count = argument<std::optional<std::size_t>>(L, 2);
  refuse_more_arguments(L, 2);
  const std::vector<Rotation> rotations = random_rotations(seed, count.value_or(1));
  if (count) {
    Convert<std::vector<Rotation>>::push(L, rotations);
  } else {
    Convert<Rotation>::push(L, rotations.front());
  }
  return {1};
}

// In the core no weights mean equal ones; an empty list of a script is a mistake.
std::vector<double> weights_of(const Options& options) {
  const auto weights = options.get<std::vector<double>>("weights");
  if (weights && weights->empty()) throw std::invalid_argument("weights: expected one or more");
  return weights.value_or(std::vector<double>{});
}

constexpr const char* kFitRigid = "fit_rigid(X, x, {weights=, translation=}) -> rigid_fit";
Results fit_points(lua_State* L) {
  const auto reference = argument<Points>(L, 1);
  const auto current = argument<Points>(L, 2);
  const Options options(L, 3, kFitRigid);
  const bool translation = options.get<bool>("translation").value_or(true);
  Convert<RigidFit>::push(L, fit_rigid(reference, current, {weights_of(options), translation}));
  return {1};
}

Results rigidity(lua_State* L) {
  const auto reference = argument<Points>(L, 1);
  const auto current = argument<Points>(L, 2);
  const auto tolerance = argument<std::optional<double>>(L, 3);
  refuse_more_arguments(L, 3);
  const Rigidity found =
      is_rigid(reference, current, tolerance.value_or(1e-9), stop_if_interrupted);
  lua_pushboolean(L, found.rigid ? 1 : 0);
  Convert<std::string>::push(L, found.message);
  return {2};
}

constexpr const char* kMean = "mean(rotations, {weights=}) -> rotation";
Results mean_rotation(lua_State* L) {
  const auto rotations = argument<std::vector<Rotation>>(L, 1);
  const Options options(L, 2, kMean);
  Convert<Rotation>::push(L, mean(rotations, weights_of(options)));
  return {1};
}

Rotation fitted_rotation(const RigidFit& fit) { return fit.rotation; }
Vector fitted_translation(const RigidFit& fit) { return fit.translation; }
double rms(const RigidFit& fit) { return fit.rms; }
bool unique(const RigidFit& fit) { return fit.unique; }
bool mirrored(const RigidFit& fit) { return fit.mirrored; }
std::string text_of_fit(const RigidFit& fit) {
  std::string text = "rigid_fit  rms " + shown(fit.rms);
  if (fit.mirrored) text += "  mirrored: a reflection fits better";
  if (!fit.unique) {
    text += "\n  not unique   some turn is left free (points on a line, coincident, ...)";
    if (!fit.translation.isZero(0)) {
      text += "\n               if these are directions, say translation = false";
    }
  }
  return text + "\n  rotation     " +
         shown_axis_angle(fit.rotation.axis(), fit.rotation.angle(), 15) + "\n  translation  " +
         shown(fit.translation);
}

constexpr Entry kFunctions[] = {
    {"fit_rigid", bound<fit_points>, kFitRigid,
     "The rigid motion x = Q X + c [N19] of least squares from a list of points X to a list x, "
     "with a proper Q, also from mirrored points. weights: one a point. translation = false: c = "
     "0, "
     "the attitude from pairs of directions (Wahba): X as the body has them and x in space give "
     "the rotation from body to space.",
     "fit_rigid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{2, 0, 0}, {2, 1, 0}, {1, 0, 0}}).unique --> "
     "true"},
    {"is_rigid", bound<rigidity>, "is_rigid(X, x, tolerance) -> boolean, string",
     "Whether a rigid motion takes the points X to x: all distances agree [N16] to the tolerance "
     "(default 1e-9) times the greatest one, and x is not mirrored. The string says how well, or "
     "which pair differs most.",
     "is_rigid({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 2, 0}}) --> false"},
    {"mean", bound<mean_rotation>, kMean,
     "The mean of a list of operators: the rotation of least squares of the Frobenius distances of "
     "matrices (chordal L2), canonical. An error where many are as near. weights: one a rotation.",
     "mean{rotation({0, 0, 1}, 1), rotation({0, 0, 1}, 2)}.angle --> 1.5"},
};

constexpr Entry kStatics[] = {
    {"random", bound<random_rotation>, "rotation.random(seed, n) -> rotation",
     "A random rotation, uniform on all attitudes (Haar measure), canonical; with n the list of n. "
     "The seed is a whole number; the same seed gives the same rotations everywhere.",
     "#rotation.random(7, 100) --> 100"},
};

#define ROTOR_FIT "fit_rigid({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {{2, 0, 0}, {5, 0, 0}, {2, 3, 0}})"

constexpr Entry kFields[] = {
    {"rotation", bound<fitted_rotation>, "fit.rotation -> rotation",
     "Q, canonical; one of the best where they are many.",
     ROTOR_FIT ".rotation.angle < 1e-15 --> true"},
    {"translation", bound<fitted_translation>, "fit.translation -> vec", "c of x = Q X + c.",
     "norm(" ROTOR_FIT ".translation - vec(2, 0, 0)) < 1e-15 --> true"},
    {"rms", bound<rms>, "fit.rms -> number",
     "Root of the weighted mean square of the distances between x and Q X + c.",
     ROTOR_FIT ".rms < 1e-15 --> true"},
    {"unique", bound<unique>, "fit.unique -> boolean",
     "Whether the points determine Q. If not (points on a line, coincident, or mirrored and as "
     "thick "
     "every way) Q is the least turn of the longest direction of X to that of x.",
     ROTOR_FIT ".unique --> true"},
    {"mirrored", bound<mirrored>, "fit.mirrored -> boolean",
     "Whether the points are mirrored: a reflection fits them at less than half the rms.",
     ROTOR_FIT ".mirrored --> false"},
};

constexpr Entry kOperators[] = {
    {"__tostring", bound<text_of_fit>, "tostring(fit) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_FIT ") > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},
    {"rotation", Kind::kFunction, kStatics},
    {"rigid_fit", Kind::kField, kFields},
    {"rigid_fit", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> fit_groups() { return kGroups; }

}  // namespace rotor::script
