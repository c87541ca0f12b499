#include "output/animation.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "output/picture.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

// For gnuplot: times, the number of frames and the file of data are put before it.
constexpr const char* kScene = R"(set parametric
set urange [0:2*pi]
set samples 120
set xrange [-1.1:1.1]
set yrange [-1.1:1.1]
set zrange [-1.1:1.1]
set view 65, 125
set view equal xyz
set xyplane at -1.1
set key bottom
set xlabel 'x'
set ylabel 'y'
set zlabel 'z'
do for [i = 0 : frames - 1] {
  set title 't = ' . word(times, i + 1)
  splot cos(u), sin(u), 0 linecolor 'gray80' notitle, \
        cos(u), 0, sin(u) linecolor 'gray80' notitle, \
        0, cos(u), sin(u) linecolor 'gray80' notitle, \
        data every ::0::i using 1:2:3 with lines linecolor 1 notitle, \
        data every ::0::i using 7:8:9 with lines linecolor 2 notitle, \
        data every ::i::i using (0):(0):(0):1:2:3 with vectors linecolor 1 linewidth 3 title 'axis', \
        data every ::i::i using (0):(0):(0):7:8:9 with vectors linecolor 2 linewidth 3 title 'point', \
        data every ::i::i using (0):(0):(0):4:5:6 with vectors linecolor 3 linewidth 3 title 'omega'
}
)";

struct Shot {
  double t;
  std::array<Vector, 3> arrows;  // n, omega, the point
};

std::string data_of(const std::vector<Shot>& shots) {
  std::string data;
  for (const Shot& shot : shots) {
    for (const Vector& arrow : shot.arrows) {
      for (const double x : arrow) data += text(x, 7) + " ";
    }
    data.back() = '\n';
  }
  return data;
}

}  // namespace

bool animate(const Run& run, std::span<const double> times, const Vector& point,
             const std::filesystem::path& file, const Observer& observer) {
  if (file.extension() != ".gif") {
    throw std::invalid_argument("a moving picture ends in .gif, got " + file.string());
  }
  if (times.empty()) throw std::invalid_argument("there are no times to show");
  const Vector direction = run.attitude(run.t0()).quaternion.conjugate() * unit(point);
  std::vector<Shot> shots;
  double greatest = 0;
  visit_times(times, observer, [&](double t) {
    const State state = run(t, observer);
    const Vector omega = run.omega(t);
    greatest = std::max(greatest, norm(omega));
    shots.push_back({t, {state.axis, omega, state.quaternion * direction}});
  });
  std::string list;
  for (Shot& shot : shots) {
    if (greatest > 0) shot.arrows[1] /= greatest;
    list += text(shot.t, 5) + " ";
  }
  const std::string data_file = std::filesystem::path(file).replace_extension(".dat").filename();
  const std::string script = "data = " + quoted_for_gnuplot(data_file) +
                             "\nframes = " + std::to_string(shots.size()) +
                             "\ntimes = " + quoted_for_gnuplot(list) + "\n" + kScene;
  return draw(file, script, data_of(shots), " animate delay 5 loop 0");
}

}  // namespace rotor
