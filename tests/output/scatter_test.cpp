#include "output/scatter.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <vector>

#include "catch.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;

struct Cloud {
  std::vector<double> x;
  std::vector<double> y;
};

Cloud circle(int n, double radius) {
  Cloud cloud;
  for (int i = 0; i < n; ++i) {
    cloud.x.push_back(radius * std::cos(2 * std::numbers::pi * i / n));
    cloud.y.push_back(radius * std::sin(2 * std::numbers::pi * i / n));
  }
  return cloud;
}

struct Size {
  std::size_t columns = 0;
  std::size_t rows = 0;
};

// Of what is marked.
Size marked(const std::string& picture) {
  std::istringstream in(picture);
  std::size_t first = picture.size();
  std::size_t last = 0;
  Size size;
  for (std::string line; std::getline(in, line);) {
    const std::size_t rule = line.find('|');
    if (rule == line.npos) continue;
    const std::size_t begin = line.find_first_not_of(' ', rule + 1);
    if (begin == line.npos) continue;
    first = std::min(first, begin);
    last = std::max(last, line.find_last_not_of(' '));
    ++size.rows;
  }
  size.columns = last - first + 1;
  return size;
}

}  // namespace

TEST_CASE("scatter: a circle is as wide as high, in cells twice as high as wide") {
  for (const int height : {8, 12, 20, 40}) {
    const Cloud cloud = circle(2000, 3.7);
    const Size size = marked(scatter(cloud.x, cloud.y, {.width = 100, .height = height}));
    CAPTURE(height, size.columns, size.rows);
    // To a cell at either end.
    CHECK(std::abs(static_cast<double>(size.columns) - 2 * static_cast<double>(size.rows)) <= 4);
  }
}

TEST_CASE("scatter: what is wide takes fewer rows, and never more columns than there are") {
  Cloud flat;
  for (int i = 0; i <= 1000; ++i) {
    flat.x.push_back(i);
    flat.y.push_back(100 * std::sin(i * 0.01));
  }
  std::istringstream in(scatter(flat.x, flat.y, {.width = 60, .height = 20}));
  for (std::string line; std::getline(in, line);) CHECK(line.size() <= 60);
}

TEST_CASE("scatter: a line along either axis is drawn") {
  Cloud line;
  for (int i = 0; i < 50; ++i) {
    line.x.push_back(0.1 * i);
    line.y.push_back(1e-17 * i);
  }
  for (const int width : {30, 60, 80, 200}) {
    CHECK(marked(scatter(line.x, line.y, {.width = width})).rows == 1);
    CHECK(marked(scatter(line.y, line.x, {.width = width})).columns <= 2);
  }
}

TEST_CASE("scatter: single points are stars, the more in a cell the denser the mark") {
  const std::vector<double> x{0, 1, 2, 3};
  CHECK_THAT(scatter(x, x), Contains("*") && !Contains("@"));
  Cloud heap = circle(20, 1);
  for (int i = 0; i < 1000; ++i) {
    heap.x.push_back(0);
    heap.y.push_back(0);
  }
  const std::string picture = scatter(heap.x, heap.y);
  CHECK_THAT(picture, Contains("@") && Contains("."));
}

TEST_CASE("scatter: one point, equal points, gaps; and what cannot be drawn") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(scatter(std::vector<double>{5}, std::vector<double>{-3}), Contains("*"));
  CHECK_THAT(scatter(std::vector<double>{0, 0}, std::vector<double>{0, 0}),
             Contains("@") || Contains(":"));
  CHECK_THAT(scatter(std::vector<double>{1e300, nan}, std::vector<double>{-1e300, 1}),
             Contains("*"));
  const std::vector<double> none{nan};
  CHECK_THROWS_WITH(scatter(none, none), Contains("no finite point"));
  CHECK_THROWS_WITH(scatter(std::vector<double>{1, 2}, none),
                    Contains("2 values of x, but 1 of y"));
  CHECK_THROWS_WITH(scatter(std::vector<double>{1, 2}, std::vector<double>{1, 2}, {.width = 8}),
                    Contains("no room"));
}
