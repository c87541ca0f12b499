#include "output/picture.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "catch.hpp"
#include "output/animation.hpp"
#include "temporary.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Picture curves() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {{0, 1, 2, 3, 4},
          {{"a", {1, 2, nan, 4, 5}}, {"it's \"b\"", {0, 3, -3, 1, 1}, 5}},
          {.title = "two\ncurves", .x_label = "t"}};
}

// A PATH without any program.
class NoPrograms {
 public:
  NoPrograms() : path_(std::getenv("PATH")) { setenv("PATH", "/nonexistent", 1); }
  ~NoPrograms() { setenv("PATH", path_.c_str(), 1); }
  NoPrograms(const NoPrograms&) = delete;
  NoPrograms& operator=(const NoPrograms&) = delete;

 private:
  std::string path_;
};

}  // namespace

TEST_CASE("picture: data and script stand beside it, gaps and jumps as blank lines") {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path / "x.svg";
  const NoPrograms without;
  CHECK(!draw(curves(), file));
  CHECK(!std::filesystem::exists(file));
  CHECK(content(directory.path / "x.dat") ==
        "0.0 1.0\n1.0 2.0\n\n3.0 4.0\n4.0 5.0\n\n\n0.0 0.0\n1.0 3.0\n\n2.0 -3.0\n3.0 1.0\n4.0 "
        "1.0\n\n\n");
  const std::string script = content(directory.path / "x.gp");
  CHECK_THAT(script, Contains("set terminal svg") && Contains("set output 'x.svg'"));
  CHECK_THAT(script, Contains("set title 'two curves'") && Contains("'it''s \"b\"'"));
  CHECK_THAT(script, Contains("'x.dat' index 1 using 1:2 with lines"));
}

TEST_CASE("picture: gnuplot draws each kind, where there is one") {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) return;
  const TemporaryDirectory directory;
  const auto begins = [&](const std::string& name, const std::string& magic) {
    const std::filesystem::path file = directory.path / name;
    CHECK(draw(curves(), file));
    CHECK(content(file).substr(0, magic.size()) == magic);
  };
  begins("a.svg", "<?xml");
  begins("b c's.png", "\x89PNG");
  begins("d.pdf", "%PDF");
  begins("e.gif", "GIF8");
  Picture points{{1, 2, 3}, {{"", {1, 4, 9}}}, {}, true};
  CHECK(draw(points, directory.path / "f.png"));
  Picture logarithmic{{1, 10, 100}, {{"", {1, 1e-4, 1e-8}}}, {.log_x = true, .log_y = true}};
  CHECK(draw(logarithmic, directory.path / "g.png"));
}

TEST_CASE("picture: what cannot be drawn is refused, and what gnuplot refuses is said") {
  const TemporaryDirectory directory;
  CHECK_THROWS_WITH(draw(curves(), directory.path / "x.jpeg"),
                    Contains(".svg, .png, .pdf or .gif"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(draw(Picture{{0}, {{"", {nan}}}, {}}, directory.path / "x.png"),
                    Contains("no finite point"));
  CHECK_THROWS_AS(draw(curves(), directory.path / "no such directory" / "x.png"),
                  std::system_error);
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) return;
  CHECK_THROWS_WITH(draw(directory.path / "x.png", "print 'no such luck'\nexit status 3\n", ""),
                    Contains("gnuplot could not draw") && Contains("no such luck"));
}

TEST_CASE("animation: a frame for each time, with axis, omega and a point") {
  const TemporaryDirectory directory;
  const Run run = evolve({AngularVelocity(Vector(0, 0, 2)), 0, 3}, Rotation());
  const std::vector<double> times{0, 1, 2, 3};
  {
    const NoPrograms without;
    CHECK(!animate(run, times, Vector(2, 0, 0), directory.path / "m.gif"));
  }
  CHECK(content(directory.path / "m.dat").starts_with("0.0 0.0 1.0 0.0 0.0 1.0 1.0 0.0 0.0\n"));
  CHECK_THAT(content(directory.path / "m.gp"), Contains("frames = 4"));
  CHECK_THROWS_WITH(animate(run, times, Vector(1, 0, 0), "m.png"), Contains(".gif"));
  CHECK_THROWS_WITH(animate(run, {}, Vector(1, 0, 0), "m.gif"), Contains("no times"));
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) return;
  CHECK(animate(run, times, Vector(1, 0, 0), directory.path / "m.gif"));
  CHECK(content(directory.path / "m.gif").starts_with("GIF8"));
}
