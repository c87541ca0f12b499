// spherical_triangle: Rodrigues' construction.
#include <stdexcept>
#include <string>

#include "rotation/spherical_triangle.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/output_options.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

using Shape = SphericalTriangle::Kind;

Vector axis(const SphericalTriangle& t) { return t.product.axis(); }
double angle(const SphericalTriangle& t) { return t.product.angle(); }
Rotation product(const SphericalTriangle& t) { return t.product; }

std::string kind(const SphericalTriangle& t) {
  switch (t.kind) {
    case Shape::kParallel:
      return "parallel";
    case Shape::kOpposite:
      return "opposite";
    case Shape::kIdentity:
      return "identity";
    default:
      return "triangle";
  }
}

// Why there is no triangle, and what the product is instead; "" if there is one.
std::string why_none(Shape shape) {
  switch (shape) {
    case Shape::kParallel:
      return "p and q are parallel: the product is about p, by theta + phi";
    case Shape::kOpposite:
      return "p and q are opposite: the product is about p, by theta - phi";
    case Shape::kIdentity:
      return "both angles are 0: so is the product's, and nothing tells r";
    default:
      return "";
  }
}

const SphericalTriangle& triangle_argument(lua_State* L) {
  const SphericalTriangle& t = argument<SphericalTriangle>(L, 1);
  if (t.kind != Shape::kTriangle) throw std::invalid_argument("no triangle: " + why_none(t.kind));
  return t;
}

template <class T>
struct Named {
  const char* name;
  T value;
};

// A table of three values by their names.
template <class T>
Results push_named(lua_State* L, const Named<T>& first, const Named<T>& second,
                   const Named<T>& third) {
  lua_createtable(L, 0, 3);
  for (const auto* named : {&first, &second, &third}) {
    Convert<T>::push(L, named->value);
    lua_setfield(L, -2, named->name);
  }
  return {1};
}

Results vertices(lua_State* L) {
  const SphericalTriangle& t = triangle_argument(L);
  return push_named<Vector>(L, {"p", t.first.axis()}, {"q", t.second.axis()},
                            {"r", t.product.axis()});
}

Results arcs(lua_State* L) {
  const SphericalTriangle& t = triangle_argument(L);
  return push_named<double>(L, {"pq", t.pq}, {"qr", t.qr}, {"rp", t.rp});
}

Results half_angles(lua_State* L) {
  const SphericalTriangle& t = triangle_argument(L);
  return push_named<double>(L, {"p", t.first.angle() / 2}, {"q", t.second.angle() / 2},
                            {"r", t.product.angle() / 2});
}

constexpr const char* kPlot = "triangle:plot{from=, width=}";
Results plot(lua_State* L) {
  triangle_argument(L);
  Options(L, 2, kPlot);  // for its check of the keys
  lua_settop(L, 2);
  call_sphere(L, "draw_triangle", 2);
  return {0};
}

std::string text_of_triangle(const SphericalTriangle& t) {
  const double theta = t.first.angle();
  const double phi = t.second.angle();
  std::string text = "spherical_triangle\n  first by theta = " + shown(theta) + " about\n    p " +
                     shown(t.first.axis()) + "\n  second by phi = " + shown(phi) +
                     " about\n    q " + shown(t.second.axis());
  if (t.kind != Shape::kTriangle) {
    text += "\n  no triangle: " + why_none(t.kind);
  } else {
    text += "\n  the great circle through p and q, " + shown(t.pq) + " apart," +
            "\n    turned about p by -theta/2 = " + shown(-theta / 2) +
            "\n    turned about q by +phi/2 = " + shown(phi / 2) + "\n  meet, " + shown(t.rp) +
            " from p and " + shown(t.qr) + " from q, at\n    r " + shown(axis(t)) +
            "\n    with the exterior angle gamma/2 = " + shown(angle(t) / 2);
  }
  return text + "\n  product " + shown_axis_angle(axis(t), angle(t), 10);
}

#define ROTOR_TRIANGLE "spherical_triangle(rotation({1, 0, 0}, pi), rotation({0, 1, 0}, pi))"

constexpr Entry kFunctions[] = {
    {"spherical_triangle", bound<spherical_triangle>,
     "spherical_triangle(R, S) -> spherical_triangle",
     "Rodrigues' construction of S * R: R first, about p by theta, then S about q by phi. The "
     "great "
     "circle through p and q, turned about p by -theta/2 and about q by +phi/2, makes two that "
     "meet at the axis r of the product; half its angle is between them. The way back, for axes q "
     "and p: T:angles_about(q, p) gives {phi, theta}.",
     ROTOR_TRIANGLE ".angle --> 3.141592653589793"},
};

constexpr Entry kFields[] = {
    {"kind", bound<kind>, "triangle.kind -> string",
     "\"triangle\", or where there is none \"parallel\" or \"opposite\" (p and q, within 2e-16: "
     "the product is about p by theta + phi or theta - phi) or \"identity\" (both angles 0).",
     ROTOR_TRIANGLE ".kind --> \"triangle\""},
    {"vertices", bound<vertices>, "triangle.vertices -> table",
     "{p=, q=, r=}: the axes of R, of S and of the product. An error where there is no triangle.",
     ROTOR_TRIANGLE ".vertices.q --> vec(0.0, 1.0, 0.0)"},
    {"arcs", bound<arcs>, "triangle.arcs -> table",
     "{pq=, qr=, rp=}: the sides, each the shorter way, in [0, pi]. An error where there is no "
     "triangle.",
     ROTOR_TRIANGLE ".arcs.pq --> 1.5707963267948966"},
    {"half_angles", bound<half_angles>, "triangle.half_angles -> table",
     "{p=, q=, r=}: theta/2 and phi/2, which the sides from p and q make with pq, and gamma/2, the "
     "exterior angle at r. An error where there is no triangle.",
     ROTOR_TRIANGLE ".half_angles.p --> 1.5707963267948966"},
    {"axis", bound<axis>, "triangle.axis -> vec",
     "Axis of the product, the vertex r; e1 for an exact identity.",
     "norm(" ROTOR_TRIANGLE ".axis + vec(0, 0, 1)) < 1e-15 --> true"},
    {"angle", bound<angle>, "triangle.angle -> number", "Angle gamma of the product, in [0, 2 pi].",
     ROTOR_TRIANGLE ".angle --> 3.141592653589793"},
    {"rotation", bound<product>, "triangle.rotation -> rotation",
     "The product, about .axis by .angle: the rotation S * R.",
     ROTOR_TRIANGLE ".rotation.angle --> 3.141592653589793"},
};

constexpr Entry kMethods[] = {
    {"plot", bound<plot>, kPlot,
     "Draws the triangle on the sphere with p, q and r, as draw_sphere does; seen from above its "
     "middle if "
     "`from` is not given. A side of half a circle is left out: it could lie anywhere.",
     ROTOR_TRIANGLE ":plot{width = 30} --> "},
};

constexpr Entry kOperators[] = {
    {"__tostring", bound<text_of_triangle>, "tostring(triangle) -> string",
     "The construction, step by step.", "#tostring(" ROTOR_TRIANGLE ") > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},
    {"spherical_triangle", Kind::kField, kFields},
    {"spherical_triangle", Kind::kMethod, kMethods},
    {"spherical_triangle", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> triangle_groups() { return kGroups; }

}  // namespace rotor::script
