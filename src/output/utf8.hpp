// Names and cells are UTF-8; what fits is counted in characters.
#pragma once

#include <cstddef>
#include <string_view>

namespace rotor {

/// The length in bytes of the character that `text` begins with; 0 if it begins with none (Unicode,
/// table 3-7).
std::size_t utf8_length(std::string_view text);

/// The first `count` characters, or all if there are no more; a byte that is no character counts as
/// one.
std::string_view utf8_prefix(std::string_view text, std::size_t count);

/// The number of characters.
std::size_t utf8_count(std::string_view text);

}  // namespace rotor
