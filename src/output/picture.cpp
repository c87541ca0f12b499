#include "output/picture.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "output/file.hpp"
#include "output/scatter.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kTerminals = {
    {{".svg", "svg size 960,600"},
     {".png", "pngcairo size 960,600"},
     {".pdf", "pdfcairo size 16cm,10cm"},
     {".gif", "gif size 720,720"}}};

std::string_view terminal_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  for (const auto& [known, terminal] : kTerminals) {
    if (ending == known) return terminal;
  }
  throw std::invalid_argument("a picture ends in .svg, .png, .pdf or .gif, got " + file.string());
}

// Curves are blocks, two blank lines apart; gaps and jumps are one.
std::string data_of(const Picture& picture) {
  std::string data;
  bool any = false;
  for (const Series& one : picture.series) {
    double last = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < one.y.size(); ++i) {
      const double y = one.y[i];
      if (!std::isfinite(y) || !std::isfinite(picture.x[i])) {
        if (std::isfinite(last)) data += "\n";
      } else {
        if (std::abs(y - last) > one.jump) data += "\n";
        data += text(picture.x[i]) + " " + text(y) + "\n";
        any = true;
      }
      last = y;
    }
    data += "\n\n";
  }
  if (!any) throw std::invalid_argument("plot: no finite point to draw");
  return data;
}

std::string script_of(const Picture& picture, const std::string& data_file) {
  const auto line = [](const std::string& command, const std::string& words) {
    return words.empty() ? ""
                         : "set " + command + " " + quoted_for_gnuplot(words) + " noenhanced\n";
  };
  const PlotOptions& look = picture.look;
  const bool named = picture.series.size() > 1;
  std::string script =
      line("title", look.title) + line("xlabel", look.x_label) +
      line("ylabel", look.y_label.empty() && !named ? picture.series.front().name : look.y_label);
  if (look.log_x) script += "set logscale x\n";
  if (look.log_y) script += "set logscale y\n";
  if (look.log_x || look.log_y) script += "set format '%g'\n";
  script += "set grid\n";
  if (picture.points) script += "set size ratio -1\n";
  for (std::size_t i = 0; i < picture.series.size(); ++i) {
    script += (i == 0 ? "plot " : ", \\\n     ") + quoted_for_gnuplot(data_file) + " index " +
              std::to_string(i) + " using 1:2 with " +
              (picture.points ? "points pointtype 7 pointsize 0.4" : "lines") +
              (named ? " title " + quoted_for_gnuplot(picture.series[i].name) + " noenhanced"
                     : " notitle");
  }
  return script + "\n";
}

std::string rest_of(int pipe) {
  std::string all;
  std::array<char, 4096> part{};
  for (;;) {
    const ssize_t count = read(pipe, part.data(), part.size());
    if (count == 0 || (count < 0 && errno != EINTR)) return all;
    if (count > 0) all.append(part.data(), static_cast<std::size_t>(count));
  }
}

// Whether there is a gnuplot to run; throws, with what it says, where it fails.
bool run_gnuplot(const std::filesystem::path& script) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::filesystem::path directory = script.parent_path();
  if (!directory.empty()) {
    posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  }
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::string program = "gnuplot";
  std::string name = script.filename().string();
  std::array<char*, 3> arguments = {program.data(), name.data(), nullptr};
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  const std::string said = error == 0 ? rest_of(ends[0]) : "";
  close(ends[0]);
  if (error == ENOENT) return false;
  if (error != 0) throw std::system_error(error, std::generic_category(), program);
  int status = 0;
  while (waitpid(child, &status, 0) == -1 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("gnuplot could not draw what " + script.string() + " says:\n" + said);
  }
  return true;
}

}  // namespace

std::string quoted_for_gnuplot(const std::string& words) {
  std::string quoted = "'";
  for (const char c : words) {
    if (c == '\'') quoted += '\'';
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + "'";
}

std::string in_characters(const Picture& picture) {
  return picture.points ? scatter(picture.x, picture.series.front().y, picture.look)
                        : plot(picture.x, picture.series, picture.look);
}

bool draw(const Picture& picture, const std::filesystem::path& file) {
  const std::string data_file = std::filesystem::path(file).replace_extension(".dat").filename();
  return draw(file, script_of(picture, data_file), data_of(picture));
}

bool draw(const std::filesystem::path& file, const std::string& script, const std::string& data,
          const std::string& terminal_options) {
  const std::string terminal = std::string(terminal_of(file)) + terminal_options;
  const std::filesystem::path script_file = std::filesystem::path(file).replace_extension(".gp");
  write_file(std::filesystem::path(file).replace_extension(".dat"), data);
  write_file(script_file, "set terminal " + terminal + "\nset output " +
                              quoted_for_gnuplot(file.filename()) + "\n" + script);
  if (!run_gnuplot(script_file)) return false;
  std::error_code none;
  if (!(std::filesystem::is_regular_file(file, none) && std::filesystem::file_size(file, none) > 0))
    throw std::runtime_error("gnuplot has written nothing to " + file.string());
  return true;
}

}  // namespace rotor
