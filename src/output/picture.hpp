// Pictures: in characters, and as files through gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/canvas.hpp"

namespace rotor {

struct Picture {
  std::vector<double> x;
  std::vector<Series> series;
  PlotOptions look;
  bool points = false;  // one series of points in one scale; else curves
};

/// By plot, or by scatter where it is of points.
std::string in_characters(const Picture& picture);

/// Draws FILE by gnuplot: svg, png, pdf or gif, as its ending says; width and height in characters
/// play no part. Its script NAME.gp and its data NAME.dat stay beside it, to be changed and drawn
/// again. False where gnuplot is not installed: they are written all the same. Throws
/// std::invalid_argument for another ending and for nothing to draw, std::system_error if a file
/// cannot be written, std::runtime_error if gnuplot fails.
bool draw(const Picture& picture, const std::filesystem::path& file);

/// The same of a script for gnuplot that draws FILE from NAME.dat: `terminal_options` are added to
/// those of FILE's kind.
bool draw(const std::filesystem::path& file, const std::string& script, const std::string& data,
          const std::string& terminal_options = "");

/// 'text' as gnuplot reads it.
std::string quoted_for_gnuplot(const std::string& text);

}  // namespace rotor
