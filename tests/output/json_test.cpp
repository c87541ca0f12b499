#include "output/json.hpp"

#include <cstdint>
#include <limits>

#include "catch.hpp"

namespace rotor {
namespace {

std::string json(Json value) { return value.text(); }

TEST_CASE("JSON: plain values") {
  CHECK(json(nullptr) == "null");
  CHECK(json(true) == "true");
  CHECK(json(false) == "false");
  CHECK(json(0) == "0");
  CHECK(json(-7L) == "-7");
  CHECK(json(std::numeric_limits<std::uint64_t>::max()) == "18446744073709551615");
  CHECK(json(std::numeric_limits<std::int64_t>::min()) == "-9223372036854775808");
  CHECK(json(0.1) == "0.1");
  CHECK(json(1e-300) == "1e-300");
  CHECK(json(5e22) == "5e+22");
  CHECK(json(12.0) == "12");
  CHECK(json(std::numeric_limits<double>::quiet_NaN()) == "null");
  CHECK(json(-std::numeric_limits<double>::infinity()) == "null");
  CHECK(json("text") == "\"text\"");
  CHECK(json(std::string_view("text")) == "\"text\"");
  CHECK(json("") == "\"\"");
}

TEST_CASE("JSON: strings are escaped, and always UTF-8") {
  CHECK(json("say \"a\\b\"/") == R"("say \"a\\b\"/")");
  CHECK(json("a\n\t\x01\x1f\x7f") == "\"a\\u000a\\u0009\\u0001\\u001f\x7f\"");
  CHECK(json(std::string("a\0b", 3)) == "\"a\\u0000b\"");
  CHECK(json("ωθ€𝄞") == "\"ωθ€𝄞\"");
  // Lone and missing continuation, overlong forms, a surrogate, beyond U+10FFFF, no UTF-8 at all.
  CHECK(json("\x80") == R"("\ufffd")");
  CHECK(json("\xc3") == R"("\ufffd")");
  CHECK(json("\xc3(") == R"("\ufffd(")");
  CHECK(json("\xe2\x82") == R"("\ufffd\ufffd")");
  CHECK(json("\xc0\xaf") == R"("\ufffd\ufffd")");
  CHECK(json("\xe0\x9f\xbf") == R"("\ufffd\ufffd\ufffd")");
  CHECK(json("\xed\xa0\x80") == R"("\ufffd\ufffd\ufffd")");
  CHECK(json("\xf0\x8f\xbf\xbf") == R"("\ufffd\ufffd\ufffd\ufffd")");
  CHECK(json("\xf4\x90\x80\x80") == R"("\ufffd\ufffd\ufffd\ufffd")");
  CHECK(json("\xf5z") == R"("\ufffdz")");
  // The ends of the allowed ranges.
  for (const char* good : {"\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                           "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"})
    CHECK(json(good) == '"' + std::string(good) + '"');
}

TEST_CASE("JSON: arrays and objects keep their order") {
  CHECK(json(JsonArray{}) == "[]");
  CHECK(json(JsonObject{}) == "{}");
  CHECK(json(JsonArray{0, 12.5, "x", nullptr, true}) == R"([0, 12.5, "x", null, true])");
  const JsonObject cost{{"omega_calls", 1312}, {"seconds", 0.001}};
  CHECK(json(JsonObject{{"z", "last letter"},
                        {"a", JsonArray{1, 2}},
                        {"cost", cost},
                        {"none", JsonObject{}},
                        {"nested", JsonArray{JsonArray{1, 2}, JsonArray{}}}}) ==
        R"({
  "z": "last letter",
  "a": [1, 2],
  "cost": {
    "omega_calls": 1312,
    "seconds": 0.001
  },
  "none": {},
  "nested": [
    [1, 2],
    []
  ]
})");
}

}  // namespace
}  // namespace rotor
