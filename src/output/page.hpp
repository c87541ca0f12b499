// The lines of a picture.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "output/scale.hpp"

namespace rotor {

/// Lines of at most `width` characters without blanks at their ends.
class Page {
 public:
  explicit Page(std::size_t width) : width_(width) {}

  std::size_t width() const { return width_; }
  void line(std::string_view content);
  /// In the middle of what is right of `margin` columns, if there is any content.
  void centred(std::string_view content, std::size_t margin);
  /// The rows, 0 the lowest, from the top, with labels and rule at their left and the bottom axis.
  void frame(const VerticalScale& up, const HorizontalScale& across,
             const std::function<std::string(int)>& row);
  std::string take() { return std::move(text_); }

 private:
  std::size_t width_;
  std::string text_;
};

/// The columns that the labels of a frame and its rule take.
std::size_t margin_of(const VerticalScale& up);

}  // namespace rotor
