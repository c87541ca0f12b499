// What a call is refused with.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hpp"

/// The message of the std::invalid_argument or std::out_of_range that `call` throws; "(accepted)"
/// if it throws none.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const std::logic_error& e) {
    return e.what();
  }
  return "(accepted)";
}

/// Checks that `call` is refused, with each of the words in the message.
template <class Call>
void refused(const Call& call, const std::vector<std::string>& words) {
  const std::string message = refusal(call);
  CAPTURE(message);
  CHECK(message != "(accepted)");
  for (const std::string& word : words) CHECK(message.find(word) != std::string::npos);
}
