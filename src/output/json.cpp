#include "output/json.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "output/utf8.hpp"

namespace rotor {
namespace {

void write_string(std::string& out, std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  out += '"';
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto c = static_cast<unsigned char>(text.front());
    if (length == 0)
      out += "\\ufffd";
    else if (c < 0x20)
      out.append("\\u00").append({kHex[c / 16u], kHex[c % 16u]});
    else if (c == '"' || c == '\\')
      out.append("\\").append(text, 0, 1);
    else
      out.append(text, 0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  out += '"';
}

/// `brackets` around the items, on one line or, indented, each on its own.
template <class Items, class Write>
void write_items(std::string& out, std::string_view brackets, const Items& items, bool one_line,
                 std::size_t indent, Write write) {
  const std::string outer = one_line ? "" : std::string(1, '\n').append(indent, ' ');
  const std::string inner = one_line ? "" : outer + "  ";
  out.append(brackets, 0, 1).append(inner);
  for (const auto& item : items) {
    if (&item != &items.front()) out.append(",").append(one_line ? " " : inner);
    write(item);
  }
  out.append(outer).append(brackets, 1, 1);
}

}  // namespace

Json::Json(double x) {
  if (!std::isfinite(x)) return;
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.begin(), buffer.end(), x);
  value_ = Number{std::string(buffer.begin(), end.ptr)};
}

std::string Json::text() const {
  std::string out;
  write(out, 0);
  return out;
}

void Json::write(std::string& out, std::size_t indent) const {
  if (const auto* flag = std::get_if<bool>(&value_)) {
    out += *flag ? "true" : "false";
  } else if (const auto* number = std::get_if<Number>(&value_)) {
    out += number->digits;
  } else if (const auto* string = std::get_if<std::string>(&value_)) {
    write_string(out, *string);
  } else if (const auto* array = std::get_if<JsonArray>(&value_)) {
    const bool plain = std::all_of(array->begin(), array->end(), [](const Json& element) {
      return !std::holds_alternative<JsonArray>(element.value_) &&
             !std::holds_alternative<JsonObject>(element.value_);
    });
    write_items(out, "[]", *array, plain, indent,
                [&](const Json& element) { element.write(out, indent + 2); });
  } else if (const auto* object = std::get_if<JsonObject>(&value_)) {
    write_items(out, "{}", *object, object->empty(), indent, [&](const auto& member) {
      write_string(out, member.first);
      out += ": ";
      member.second.write(out, indent + 2);
    });
  } else {
    out += "null";
  }
}

}  // namespace rotor
