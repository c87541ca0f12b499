#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "app/errors.hpp"
#include "app/options.hpp"
#include "app/program.hpp"
#include "script/interpreter.hpp"

namespace {

using namespace rotor;

/// At exit, however it came about: output that did not arrive is an error.
void check_output() {
  const bool failed_before = std::ferror(stdout) != 0;
  if (std::fflush(stdout) == 0 && !failed_before) return;
  const std::string why = failed_before ? "" : std::string(": ") + std::strerror(errno);
  app::print_error("rotor: cannot write to standard output" + why);
  _exit(EXIT_FAILURE);
}

int run(int argc, char** argv) {
  app::Options options;
  try {
    options = app::parse_options(argc, argv);
  } catch (const std::invalid_argument& error) {
    app::print_error(std::string("rotor: ") + error.what() + "\n" + app::usage());
    return EXIT_FAILURE;
  }
  if (options.task == app::Options::Task::kPrintHelp) {
    std::fputs(app::help_text().c_str(), stdout);
    return 0;
  }
  if (options.task == app::Options::Task::kPrintVersion) {
    std::puts(app::version_text().c_str());
    return 0;
  }
  const script::State state = script::make_state(!options.ignore_environment);
  return app::Program(options, argc, argv).run(state.get());
}

}  // namespace

int main(int argc, char** argv) {
  std::atexit(check_output);
  std::signal(SIGPIPE,
              SIG_DFL);  // a reader that goes away ends us quietly, whatever our parent ignores
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    app::print_error(std::string("rotor: ") + error.what());
    return EXIT_FAILURE;
  }
}
