// The command line, read into one value. Nothing is run here.
#pragma once

#include <string>
#include <vector>

namespace rotor::app {

/// One of -e, -l, -W: done in the order given, before the script.
struct Preparation {
  enum class Kind { kExecute, kRequire, kWarnings } kind;
  std::string text;
};

struct Options {
  enum class Task { kRun, kTest, kPrintHelp, kPrintVersion, kPrintReference, kPrintStub };

  Task task = Task::kRun;
  bool interactive = false;         // -i
  bool show_version = false;        // -v
  bool quiet = false;               // -q
  bool ignore_environment = false;  // -E
  std::vector<Preparation> preparations;
  int script = 0;                  // its index in argv; 0: none. "-" is standard input
  std::vector<std::string> tests;  // what --test is to run
  std::string filter;              // of which theorems; empty: all

  bool executes() const;  // whether there is an -e
};

/// Throws std::invalid_argument, with what is wrong, for a command line that has no meaning.
Options parse_options(int argc, const char* const* argv);

std::string usage();         // what is said after a wrong option
std::string help_text();     // the text of --help
std::string version_text();  // "rotor 0.1.0  (Lua 5.4)"

}  // namespace rotor::app
