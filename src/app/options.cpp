#include "app/options.hpp"

#include <algorithm>
#include <lua.hpp>
#include <stdexcept>
#include <string_view>

namespace rotor::app {
namespace {

using Task = Options::Task;

struct LongOption {
  std::string_view name;
  Task task;
};

constexpr LongOption kLongOptions[] = {{"--help", Task::kPrintHelp},
                                       {"--version", Task::kPrintVersion},
                                       {"--reference", Task::kPrintReference},
                                       {"--stub", Task::kPrintStub}};

[[noreturn]] void reject(std::string_view option) {
  throw std::invalid_argument("unrecognized option '" + std::string(option) + "'");
}

void set_flag(Options& options, std::string_view option) {
  if (option.size() != 2) reject(option);
  switch (option[1]) {
    case 'i':
      options.interactive = true;
      break;
    case 'v':
      options.show_version = true;
      break;
    case 'q':
      options.quiet = true;
      break;
    case 'E':
      options.ignore_environment = true;
      break;
    case 'W':
      options.preparations.push_back({Preparation::Kind::kWarnings, ""});
      break;
    default:
      reject(option);
  }
}

/// What follows --test: paths, and before, between or after them --filter TEXT.
void read_tests(Options& options, int index, int argc, const char* const* argv) {
  options.task = Options::Task::kTest;
  for (; index < argc; ++index) {
    if (std::string_view(argv[index]) != "--filter") {
      options.tests.emplace_back(argv[index]);
      continue;
    }
    if (!options.filter.empty()) throw std::invalid_argument("'--filter' is given twice");
    if (++index == argc || *argv[index] == '\0') {
      throw std::invalid_argument("'--filter' needs a part of the names of theorems");
    }
    options.filter = argv[index];
  }
  if (options.tests.empty()) throw std::invalid_argument("'--test' needs files or directories");
}

/// "--name". Returns whether options go on after it.
bool set_task(Options& options, int index, int argc, const char* const* argv) {
  const std::string_view option = argv[index];
  if (option == "--test") {
    read_tests(options, index + 1, argc, argv);
    return false;
  }
  if (option == "--filter") {
    throw std::invalid_argument("'--filter' is for --test: rotor --test --filter TEXT files");
  }
  const auto* found =
      std::find_if(std::begin(kLongOptions), std::end(kLongOptions),
                   [&](const LongOption& candidate) { return candidate.name == option; });
  if (found == std::end(kLongOptions)) reject(option);
  options.task = found->task;
  return true;
}

/// "-e stat", "-estat", and the same for -l. Returns the index of the last argument it took.
int add_preparation(Options& options, int index, int argc, const char* const* argv) {
  const std::string_view option = argv[index];
  const auto kind = option[1] == 'e' ? Preparation::Kind::kExecute : Preparation::Kind::kRequire;
  if (option.size() > 2) {
    options.preparations.push_back({kind, std::string(option.substr(2))});
    return index;
  }
  if (index + 1 >= argc || argv[index + 1][0] == '-') {
    throw std::invalid_argument("'" + std::string(option) + "' needs an argument");
  }
  options.preparations.push_back({kind, argv[index + 1]});
  return index + 1;
}

}  // namespace

bool Options::executes() const {
  return std::any_of(preparations.begin(), preparations.end(),
                     [](const Preparation& p) { return p.kind == Preparation::Kind::kExecute; });
}

Options parse_options(int argc, const char* const* argv) {
  Options options;
  int index = 1;
  for (; index < argc; ++index) {
    const std::string_view option = argv[index];
    if (option.empty() || option[0] != '-' || option == "-") break;
    if (option == "--") {
      ++index;
      break;
    }
    if (option.starts_with("--")) {
      if (!set_task(options, index, argc, argv)) return options;
    } else if (option[1] == 'e' || option[1] == 'l') {
      index = add_preparation(options, index, argc, argv);
    } else {
      set_flag(options, option);
    }
  }
  if (index < argc) options.script = index;
  return options;
}

std::string usage() {
  return "usage: rotor [options] [script [arguments]]\n"
         "       rotor --test [--filter TEXT] files or directories\n"
         "rotor --help says more.";
}

std::string version_text() {
  return "rotor " ROTOR_VERSION "  (Lua " LUA_VERSION_MAJOR "." LUA_VERSION_MINOR ")";
}

std::string help_text() {
  return R"(usage: rotor [options] [script [arguments]]
       rotor --test [--filter TEXT] files or directories

The calculator for rotations in motion. Without a script: the terminal, or, when
standard input is no terminal, what comes from there as one script.

  -e STAT       run the statement STAT
  -i            the terminal, after everything else
  -l MOD        require the module MOD into the global MOD
  -l G=MOD      require the module MOD into the global G
  -v            print the version
  -q            no banner
  -W            turn warnings on
  -E            ignore LUA_INIT, LUA_PATH and LUA_CPATH
  --            no more options
  -             no more options; run standard input
  --test PATHS  run scripted tests, *.lua in directories, and print TAP; status 0
                if all passed
  --filter TEXT after --test: only theorems with TEXT in their names, plain
                text, in capitals or not
  --version     print the version and leave
  --help        print this and leave
  --reference   print the reference of all functions, as Markdown
  --stub        print the definitions for editors (---@meta)

In a script the table arg holds the command line, the script at arg[0]. The
options are those of lua5.4, with two differences: an error in piped input ends
with status 1, and os.setlocale never changes how numbers are read and written.

Environment:
  LUA_INIT, LUA_INIT_5_4  a statement, or @FILE, to run first
  LUA_PATH, LUA_CPATH     where require looks
  ROTOR_HISTORY           the file of the terminal's history; empty: none is
                          kept. Otherwise it is rotor/history in
                          XDG_STATE_HOME, or in ~/.local/state
  NO_COLOR, TERM=dumb     no escape codes

Status: 0, or 1 after an error, or 130 when interrupted.
)";
}

}  // namespace rotor::app
