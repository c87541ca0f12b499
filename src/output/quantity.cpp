#include "output/quantity.hpp"

#include <cmath>

#include "rotation/factoring.hpp"

namespace rotor {

const State& StateRow::attitude() {
  if (!attitude_) attitude_ = run_.attitude(t_);
  return *attitude_;
}

const State& StateRow::state() {
  if (!state_) state_ = run_(t_);
  return *state_;
}

const Vector& StateRow::omega() {
  if (!omega_) omega_ = run_.omega(t_);
  return *omega_;
}

const Rates& StateRow::rates() {
  if (!rates_) rates_ = run_.rates(state(), omega());
  return *rates_;
}

std::vector<std::string> Quantity::parts() const {
  const std::string letters = components;
  if (letters.empty()) return {name};
  const std::size_t width = letters.size() == 18 ? 2 : 1;
  std::vector<std::string> list;
  for (std::size_t i = 0; i < letters.size(); i += width) {
    list.push_back(std::string(name) + "_" + letters.substr(i, width));
  }
  return list;
}

std::string Quantity::meaning_of(std::size_t component) const {
  const std::string part = parts()[component];
  const std::string start = std::string(meaning) + ": ";
  if (part == name) return meaning;
  if (is_euler()) {
    const char axis = name[std::string_view("euler_").size() + component];
    return start + "angle " + part.back() + ", about " + axis + " (angle 3 is 0 where singular)";
  }
  const std::string place = part.substr(std::string_view(name).size() + 1);
  if (place.size() == 2) return start + "row " + place[0] + ", column " + place[1];
  return start + "component " + place;
}

namespace {

using Values = Quantity::Values;

Values of(double x) { return {x}; }
Values of(const Vector& v) { return {v.x(), v.y(), v.z()}; }
Values of(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Values of(const Matrix& m) {
  Values values;
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data()) = m;
  return values;
}

// What a state keeps and a rotation computes, or the other way round.
double angle(const State& s) { return s.angle; }
double angle(const Rotation& r) { return r.angle(); }
Vector axis(const State& s) { return s.axis; }
Vector axis(const Rotation& r) { return r.axis(); }
Quaternion quaternion(const State& s) { return s.quaternion; }
Quaternion quaternion(const Rotation& r) { return r.quaternion(); }

Vector shadow_mrp(State s) {
  s.quaternion.coeffs() *= -1;
  return s.mrp();
}
Vector shadow_mrp(const Rotation& r) { return r.shadow_mrp(); }
// What Euler angles are taken of: the angle of a state, which is rounded, has no part in it.
Rotation without_turns(const State& s) { return from_quaternion(s.quaternion); }
const Rotation& without_turns(const Rotation& r) { return r; }

Rotation quaternion_to_rotation(const Values& v) {
  return from_quaternion({v[0], v[1], v[2], v[3]});
}
Rotation matrix_to_rotation(const Values& v) {
  return from_matrix(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(v.data()));
}
template <Rotation (*From)(const Vector&)>
Rotation vector_to_rotation(const Values& v) {
  return From({v[0], v[1], v[2]});
}

constexpr Quantity of_motion(const char* name, const char* components, const char* meaning,
                             Values (*values)(StateRow&)) {
  return {name, components, "", meaning, values, nullptr, nullptr};
}

// A face of states and rotations that the quaternion alone determines: `values` takes either.
template <class F>
constexpr Quantity face(const char* name, const char* components, const char* unit,
                        const char* meaning, F values, Rotation (*rotation)(const Values&)) {
  return {name,   components, unit, meaning, [](StateRow& row) { return F{}(row.attitude()); },
          values, rotation};
}
// One of axis and angle, which know how the motion went.
template <class F>
constexpr Quantity turning_face(const char* name, const char* components, const char* unit,
                                const char* meaning, F values,
                                Rotation (*rotation)(const Values&)) {
  return {name,   components, unit, meaning, [](StateRow& row) { return F{}(row.state()); },
          values, rotation};
}

template <char... Axes>
constexpr char kEulerName[] = {'e', 'u', 'l', 'e', 'r', '_', Axes..., '\0'};

template <char... Axes>
constexpr Quantity euler() {
  return face(
      kEulerName<Axes...>, "123", "_rad", "Euler angles about axes of the body, in this order",
      [](const auto& r) {
        const auto angles = euler_angles(without_turns(r), {Axes...}).solutions.front();
        return Values{angles[0], angles[1], angles[2]};
      },
      [](const Values& v) {
        return from_euler_angles({Axes...}, {v[0], v[1], v[2]});
      });
}

constexpr std::array kQuantities = {
    of_motion("t", "", "time", [](StateRow& r) { return of(r.t()); }),
    turning_face(
        "angle", "", "_rad", "rotation angle theta", [](const auto& r) { return of(angle(r)); },
        nullptr),
    turning_face(
        "axis", "xyz", "", "rotation axis n", [](const auto& r) { return of(axis(r)); }, nullptr),
    turning_face(
        "euler_vector", "xyz", "_rad", "Euler vector E = n theta",
        [](const auto& r) { return of(r.euler_vector()); }, vector_to_rotation<from_euler_vector>),
    face(
        "quaternion", "wxyz", "", "unit quaternion (cos theta/2, n sin theta/2)",
        [](const auto& r) { return of(quaternion(r)); }, quaternion_to_rotation),
    face(
        "mrp", "xyz", "", "modified Rodrigues parameters n tan(theta/4)",
        [](const auto& r) { return of(r.mrp()); }, vector_to_rotation<from_mrp>),
    face(
        "shadow_mrp", "xyz", "", "modified Rodrigues parameters of the opposite quaternion",
        [](const auto& r) { return of(shadow_mrp(r)); }, nullptr),
    face(
        "matrix", "111213212223313233", "", "rotation matrix",
        [](const auto& r) { return of(r.matrix()); }, matrix_to_rotation),
    face(
        "gibbs", "xyz", "", "Gibbs vector G = n tan(theta/2)",
        [](const auto& r) { return of(r.gibbs()); }, vector_to_rotation<from_gibbs>),
    face(
        "modified_gibbs", "xyz", "", "modified Gibbs vector M = n sin(theta/2)",
        [](const auto& r) { return of(r.modified_gibbs()); },
        nullptr),  // it does not carry the sign of cos(theta/2)
    euler<'z', 'y', 'x'>(),
    euler<'z', 'x', 'y'>(),
    euler<'y', 'z', 'x'>(),
    euler<'y', 'x', 'z'>(),
    euler<'x', 'z', 'y'>(),
    euler<'x', 'y', 'z'>(),
    euler<'z', 'x', 'z'>(),
    euler<'z', 'y', 'z'>(),
    euler<'y', 'x', 'y'>(),
    euler<'y', 'z', 'y'>(),
    euler<'x', 'y', 'x'>(),
    euler<'x', 'z', 'x'>(),
    of_motion("omega", "xyz", "angular velocity in the space frame, rad per unit of t",
              [](StateRow& r) { return of(r.omega()); }),
    of_motion(
        "body_omega", "xyz", "angular velocity in the body frame, rad per unit of t",
        [](StateRow& r) { return of(Vector(r.attitude().quaternion.conjugate() * r.omega())); }),
    of_motion("angle_rate", "", "d theta/dt, rad per unit of t",
              [](StateRow& r) { return of(r.rates().angle_rate); }),
    of_motion("axis_rate", "xyz", "dn/dt per unit of t",
              [](StateRow& r) { return of(r.rates().axis_rate); }),
    of_motion("euler_rate", "xyz", "dE/dt, rad per unit of t",
              [](StateRow& r) { return of(r.rates().euler_rate); }),
    of_motion("divergence", "", "2 omega . G, of the field by which G moves [P13], per unit of t",
              [](StateRow& r) { return of(2 * r.omega().dot(r.attitude().gibbs())); }),
    of_motion("invariant_density", "", "(1 + |G|^2)^-2, the density of G that all motions keep",
              [](StateRow& r) { return of(std::pow(r.attitude().quaternion.w(), 4)); }),
};

}  // namespace

std::span<const Quantity> quantities() { return kQuantities; }

}  // namespace rotor
