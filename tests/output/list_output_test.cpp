// Lists of rotations: their columns against the faces, and back from files.
#include "output/list_output.hpp"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "output/file.hpp"
#include "rotation/factoring.hpp"
#include "temporary.hpp"

namespace rotor {
namespace {

using Names = std::vector<std::string>;
using Rotations = std::vector<Rotation>;

constexpr double kPi = 3.141592653589793;

// Seeded ones of any turn, and those at which faces are singular or tiny.
Rotations some_rotations() {
  Rotations list = {{},
                    {{0, 0, 1}, kPi},
                    {{1, 2, 2}, 5e-324},
                    {{1, -2, 2}, -0.0},
                    {{0, 1, 0}, kPi / 2},
                    {{-1, 1, 1e-300}, 2 * kPi},
                    {{3, 1, 2}, -1e15}};
  std::mt19937_64 random(20240523);
  std::normal_distribution<double> normal;
  while (list.size() < 200)
    list.emplace_back(Vector(normal(random), normal(random), normal(random)), 5 * normal(random));
  return list;
}

std::vector<double> values_of(const Rotation& r, const std::string& name) {
  std::vector<double> values;
  RotationColumns(Names{name}).values(r, 0, values);
  return values;
}

std::vector<double> list_of(const Vector& v) { return {v.x(), v.y(), v.z()}; }

TEST_CASE("List: columns are the faces' own values, to the last bit") {
  for (const Rotation& r : some_rotations()) {
    CAPTURE(r.axis().transpose(), r.angle());
    CHECK(values_of(r, "angle_rad") == std::vector<double>{r.angle()});
    CHECK(values_of(r, "axis") == list_of(r.axis()));
    CHECK(values_of(r, "euler_vector") == list_of(r.euler_vector()));
    CHECK(values_of(r, "modified_gibbs") == list_of(r.modified_gibbs()));
    CHECK(values_of(r, "gibbs") == list_of(r.gibbs()));
    CHECK(values_of(r, "mrp") == list_of(r.mrp()));
    CHECK(values_of(r, "shadow_mrp") == list_of(r.shadow_mrp()));
    CHECK(values_of(r, "matrix_23") == std::vector<double>{r.matrix()(1, 2)});
    const Quaternion q = r.quaternion();
    CHECK(values_of(r, "quaternion") == std::vector<double>{q.w(), q.x(), q.y(), q.z()});
    CHECK(values_of(r, "euler_yzx") == euler_angles(r, "yzx").solutions.front());
  }
}

TEST_CASE("List: what only a motion has is no column of a rotation") {
  CHECK(RotationColumns(Names{"axis_y", "euler_xyx"}).headers() ==
        Names{"axis_y", "euler_xyx_1_rad", "euler_xyx_2_rad", "euler_xyx_3_rad"});
  for (const char* name : {"t", "omega", "angle_rate", "axis_rate", "euler_rate", "axes"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(RotationColumns(Names{name}), UnknownName);
  }
  CHECK_THROWS_AS(RotationColumns(Names{}), std::invalid_argument);
}

TEST_CASE("List: a file of each face reads back as the same operators") {
  const Rotations list = some_rotations();
  for (const std::string& face : face_names()) {
    CAPTURE(face);
    TemporaryDirectory here;
    const auto file = here.path / "list.csv";
    const Names columns = face == "axis_angle" ? Names{"axis", "angle"} : Names{face};
    CHECK(write_csv(list, RotationColumns(columns), file, "a test"));
    const Rotations back = rotations_of(read_csv(file));
    REQUIRE(back.size() == list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      CAPTURE(i, list[i].axis().transpose(), list[i].angle());
      if (face == "axis_angle") {
        CHECK(back[i] == list[i]);
      } else if (face == "euler_vector") {
        // |E| = theta |n|: 1e-16 each from n, which is not quite unit, E and its length. Of the
        // angle 1e15 that is more than a turn would bear: no operators here.
        CHECK(back[i].angle() == Approx(std::abs(list[i].angle())).epsilon(3.3e-16).margin(0));
      } else {
        // Components near 1 are within 5.5e-17, three to nine of them, and count twice in the
        // angle: at most 5e-16. The axis and the angle read, in [0, 2 pi], add 2e-16 and 4.5e-16;
        // three Euler angles of up to pi are 6.7e-16 at most instead of the 5e-16.
        CHECK(distance(back[i], list[i]) < 1.5e-15);
      }
    }
    const std::string json = content_of(file.string() + ".json");
    for (const char* piece : {"\"rows\": 200", "\"scene\": \"a test\"", "scalar first"})
      CHECK(json.find(piece) != std::string::npos);
  }
}

class File {
 public:
  explicit File(std::string_view content) { write_file(path(), content); }
  std::filesystem::path path() const { return here_.path / "list.csv"; }
  Rotations rotations(const std::string& face = "", const Names& names = {}) const {
    return rotations_of(read_csv(path()), face, names);
  }

 private:
  TemporaryDirectory here_;
};

TEST_CASE("List: the face that keeps most is read, or the one asked for") {
  const File file(
      "t,quaternion_w,quaternion_x,quaternion_y,quaternion_z,axis_x,axis_y,axis_z,angle\n"
      "0,1,0,0,0,0,0,2,7\n");
  CHECK(file.rotations() == Rotations{{{0, 0, 1}, 7}});
  CHECK(file.rotations("quaternion") == Rotations{{}});
  CHECK_THROWS_WITH(file.rotations("mrp"),
                    Catch::StartsWith("unknown column 'mrp_x'; there are t,"));
  CHECK_THROWS_WITH(file.rotations("quarternion"),
                    Catch::StartsWith("unknown face 'quarternion'; there are axis_angle, "));
}

TEST_CASE("List: columns of other names are told face by face") {
  const File file("qx,qy,qz,qw\n0,0,0,1\n0,0,1,0\n");
  CHECK(file.rotations("quaternion", {"qw", "qx", "qy", "qz"}) == Rotations{{}, {{0, 0, 1}, kPi}});
  CHECK_THROWS_WITH(file.rotations("quaternion", {"qw", "qx", "qy"}),
                    "columns: quaternion has 4 components, got 3 names");
  CHECK_THROWS_WITH(file.rotations("quaternion", {"q0", "qx", "qy", "qz"}),
                    "unknown column 'q0'; there are qx, qy, qz, qw");
  CHECK_THROWS_WITH(file.rotations("", {"qw", "qx", "qy", "qz"}),
                    "columns: say which face they are of, as face = \"quaternion\"");
  CHECK_THROWS_WITH(
      file.rotations(),
      file.path().string() +
          ": expected all columns of a face, as quaternion_w, quaternion_x, "
          "quaternion_y, quaternion_z; there are qx, qy, qz, qw; name them, the scalar first: "
          "{face = \"quaternion\", columns = {\"qw\", \"qx\", \"qy\", \"qz\"}}");
  CHECK_THROWS_WITH(File("t,b,c,d,e\n").rotations(),
                    Catch::EndsWith("columns = {\"b\", \"c\", \"d\", \"e\"}}"));
  CHECK_THROWS_WITH(File("b,c,d\n").rotations(),
                    Catch::EndsWith("columns = {\"q0\", \"q1\", \"q2\", \"q3\"}}"));
}

TEST_CASE("List: a row that is no rotation is named by its line") {
  const char* header = "quaternion_w,quaternion_x,quaternion_y,quaternion_z,note\n";
  const auto error = [&](const std::string& rows) -> std::string {
    try {
      File(header + rows).rotations();
    } catch (const std::invalid_argument& refused) {
      return std::string(refused.what()).substr(std::string(refused.what()).find("line"));
    }
    return "";
  };
  CHECK(error("1,0,0,0,\"two\nlines\"\n2,0,0,0,\n") ==
        "line 4: from_quaternion: expected a unit quaternion (norm 1 within 1e-06), got (2.0, 0.0, "
        "0.0, 0.0) of norm 2.0; :unit() normalises one");
  CHECK(error("nan,0,0,0,\n").starts_with("line 2: from_quaternion: expected finite numbers"));
  CHECK(error("1,0,0,0,\n1,x,0,0,\n") == "line 3: 'quaternion_x': expected a number, got \"x\"");
  CHECK(error("1,0,0,0,\n").empty());
}

TEST_CASE("List: empty lists, full devices and tables") {
  TemporaryDirectory here;
  const auto file = here.path / "list.csv";
  const RotationColumns standard(RotationColumns::standard());
  CHECK(write_csv(Rotations{}, standard, file, ""));
  CHECK(content_of(file) == "angle_rad,axis_x,axis_y,axis_z\n");
  CHECK(rotations_of(read_csv(file)).empty());
  CHECK(!write_csv(some_rotations(), standard, "/dev/null", ""));
  CHECK_THROWS_WITH(write_csv(some_rotations(), standard, "/dev/full", ""),
                    "/dev/full: No space left on device");
  CHECK(table(Rotations{{{0, 0, 1}, 7}, {{0, 3, 4}, -0.5}}, standard, 17) ==
        "i  angle_rad  axis_x  axis_y  axis_z\n"
        "-  ---------  ------  ------  ------\n"
        "1        7.0     0.0     0.0     1.0\n"
        "2       -0.5     0.0     0.6     0.8\n");
  CHECK(table(Rotations{}, standard, 17).starts_with("i  angle_rad"));
}

TEST_CASE("List: times are the column t, one for each rotation") {
  const Rotations list = {{{0, 0, 1}, 7}, {{0, 3, 4}, -0.5}};
  const std::vector<double> times = {0.25, 0.1};
  CHECK(table(list, RotationColumns(Names{"t", "angle"}, true), 17, times) ==
        "   t  angle_rad\n"
        "----  ---------\n"
        "0.25        7.0\n"
        "0.1        -0.5\n");
  const RotationColumns columns(Names{"angle", "axis", "t"}, true);
  CHECK(table(list, columns, 17, times).starts_with("i  angle_rad"));
  TemporaryDirectory here;
  const auto file = here.path / "list.csv";
  CHECK(write_csv(list, columns, file, "", times));
  const CsvTable back = read_csv(file);
  CHECK(back.numbers(back.column("t")) == times);
  CHECK(rotations_of(back) == list);
  CHECK_THROWS_WITH(write_csv(list, columns, "/dev/null", "", std::vector<double>{1}),
                    "times: expected one for each of the 2 rotations, got 1");
  CHECK_THROWS_AS(table(list, columns, 17), std::invalid_argument);
}

TEST_CASE("List: the meaning of a column tells its component") {
  const auto meaning = [](const std::string& name) {
    return RotationColumns(Names{name}).list().front().meaning;
  };
  CHECK(meaning("angle") == "rotation angle theta");
  CHECK(meaning("axis_y") == "rotation axis n: component y");
  CHECK(meaning("matrix_23") == "rotation matrix: row 2, column 3");
  CHECK(meaning("euler_zyx_2") ==
        "Euler angles about axes of the body, in this order: angle 2, about y (angle 3 is 0 where "
        "singular)");
  CHECK(meaning("euler_xzy_3").find("angle 3, about y") != std::string::npos);
}

}  // namespace
}  // namespace rotor
