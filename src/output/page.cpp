#include "output/page.hpp"

#include <algorithm>
#include <vector>

#include "output/utf8.hpp"

namespace rotor {

void Page::line(std::string_view content) {
  content = utf8_prefix(content, width_);
  text_.append(content, 0, content.find_last_not_of(' ') + 1).append("\n");
}

void Page::centred(std::string_view content, std::size_t margin) {
  if (content.empty()) return;
  const std::size_t size = std::min(utf8_count(content), width_);
  const std::size_t room = width_ - margin;
  const std::size_t start = size <= room ? margin + (room - size) / 2 : width_ - size;
  line(std::string(start, ' ').append(content));
}

void Page::frame(const VerticalScale& up, const HorizontalScale& across,
                 const std::function<std::string(int)>& row) {
  const std::size_t margin = margin_of(up);
  std::vector<std::string> labels(static_cast<std::size_t>(up.rows));
  for (std::size_t i = 0; i < up.labels.size(); ++i)
    labels[static_cast<std::size_t>(up.tick_rows[i])] = up.labels[i];
  for (int r = up.rows - 1; r >= 0; --r) {
    const std::string& label = labels[static_cast<std::size_t>(r)];
    line(std::string(margin - 2 - label.size(), ' ') + label + " |" + row(r));
  }
  const BottomAxis axis = bottom_axis(across, margin);
  line(std::string(margin - 1, ' ') + '+' + axis.line);
  line(axis.labels);
}

std::size_t margin_of(const VerticalScale& up) {
  std::size_t longest = 0;
  for (const std::string& label : up.labels) longest = std::max(longest, label.size());
  return longest + 2;
}

}  // namespace rotor
