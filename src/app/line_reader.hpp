// Lines of input, from a person or from a pipe.
//
// On a terminal: readline, with history and completion. Otherwise the prompt is printed just the
// same and the line is read as it comes; no escape codes, no history.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/history.hpp"

namespace rotor::app {

/// The words that may stand from the byte `start` of the line up to the cursor.
struct Completions {
  std::size_t start = 0;
  std::vector<std::string> words;
};

/// Called with the line and the number of its bytes before the cursor.
using Completer = std::function<Completions(const std::string& line, std::size_t cursor)>;

/// At most one lives at a time: readline is one for the process.
class LineReader {
 public:
  enum class Event { kLine, kEnd, kInterrupted };

  explicit LineReader(Completer completer);

  /// Reads one line without its end; a paste can hold several. `interrupted` is Ctrl-C: what was
  /// typed is dropped, and the interrupt is left pending.
  Event read(const std::string& prompt, std::string& line);

  bool on_terminal() const { return on_terminal_; }

  /// Keeps an entry for the arrow keys and the sessions to come.
  void remember(const std::string& entry);

 private:
  void set_up_readline();

  bool on_terminal_;
  History history_;
  std::string last_entry_;
};

}  // namespace rotor::app
