// JSON, as much of it as provenance files need.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rotor {

class Json;
using JsonArray = std::vector<Json>;
/// Members in the order in which they are written.
using JsonObject = std::vector<std::pair<std::string, Json>>;

/// A JSON value, for instance JsonObject{{"method", "dop853"}, {"steps", 41}, {"t",
/// JsonArray{0, 12.5}}}.
class Json {
 public:
  Json(std::nullptr_t = nullptr) {}
  /// A number in shortest round-trip form; JSON has no nan and no inf: they become null.
  Json(double x);
  template <std::integral T>
  requires(!std::same_as<T, bool>) Json(T x) : value_(Number{std::to_string(x)}) {}
  Json(std::same_as<bool> auto x) : value_(x) {}
  /// UTF-8; a byte that is not becomes U+FFFD.
  Json(std::string text) : value_(std::move(text)) {}
  Json(std::string_view text) : Json(std::string(text)) {}
  Json(const char* text) : Json(std::string(text)) {}
  Json(JsonArray elements) : value_(std::move(elements)) {}
  Json(JsonObject members) : value_(std::move(members)) {}

  /// Indented by two blanks a level, arrays of plain values on one line; no line end after it.
  std::string text() const;

 private:
  struct Number {
    std::string digits;
  };
  void write(std::string& out, std::size_t indent) const;

  std::variant<std::nullptr_t, bool, Number, std::string, JsonArray, JsonObject> value_;
};

}  // namespace rotor
