// The command line: lua5.4's meanings, and rotor's own options.
#include <sys/wait.h>

#include <cstdio>
#include <sstream>
#include <string>

#include "catch.hpp"
#include "temporary.hpp"

namespace {

struct Outcome {
  std::string output;  // both streams, in the order written
  int status;
};

/// Runs a line of shell in which "rotor" is the binary. Nothing of the caller's environment
/// interferes.
Outcome shell(const std::string& line) {
  const std::string command =
      "exec 2>&1 </dev/null; unset LUA_INIT LUA_INIT_5_4 LUA_PATH LUA_CPATH\n"
      "rotor() { '" ROTOR_BINARY "' \"$@\"; }\n" +
      line;
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  char buffer[4096];
  while (const std::size_t count = fread(buffer, 1, sizeof buffer, pipe)) {
    outcome.output.append(buffer, count);
  }
  outcome.status = WEXITSTATUS(pclose(pipe));
  return outcome;
}

void check(const std::string& line, const std::string& output, int status = 0) {
  CAPTURE(line);
  const Outcome outcome = shell(line);
  CHECK(outcome.output == output);
  CHECK(outcome.status == status);
}

void check_contains(const std::string& line, const std::string& part, int status) {
  CAPTURE(line);
  const Outcome outcome = shell(line);
  CAPTURE(outcome.output);
  CHECK(outcome.output.find(part) != std::string::npos);
  CHECK(outcome.status == status);
}

const std::string kVersion = "rotor " ROTOR_VERSION "  (Lua 5.4)\n";

}  // namespace

TEST_CASE("option -e runs statements in the order given") {
  check("rotor -e 'x = 1' -e'print(x)'", "1\n");
  check_contains("rotor -e", "rotor: '-e' needs an argument\nusage: rotor", 1);
  check_contains("rotor -e -v", "'-e' needs an argument", 1);
}

TEST_CASE("an error goes to stderr with prefix, place and traceback, and ends with 1") {
  check("rotor -e 'error(\"no\")' 2>&1 >/dev/null",
        "rotor: (command line):1: no\nstack traceback:\n\t[C]: in function 'error'\n"
        "\t(command line):1: in main chunk\n\t[C]: in ?\n",
        1);
  check("rotor -e 'error({})'", "rotor: (error object is a table value)\n", 1);
  check("rotor -e 'error(setmetatable({}, {__tostring = function() return \"said\" end}))'",
        "rotor: said\n", 1);
  check("rotor -e 'error(setmetatable({}, {__tostring = error}))'",
        "rotor: (error object whose __tostring fails)\n", 1);
  check_contains("rotor -e 'x ='", "rotor: (command line):1: unexpected symbol near <eof>", 1);
  check("rotor -e 'error(\"first\")' -e 'print(2)' 2>/dev/null | grep -c 2", "0\n", 1);
}

TEST_CASE("a singular factoring is told on stderr, in one line, unless it is to be silent") {
  const std::string locked = "R = rotation({0, 1, 0}, pi/2) ";
  const std::string told = "only a - c is determined, c = 0 is taken\n";
  check("rotor -e '" + locked + "print(#{R:euler_angles \"zyx\"})'",
        "rotor: (command line):1: euler_angles: singular: " + told + "3\n");
  check("rotor -e '" + locked + "print(#R:angles_about({0, 0, 1}, {0, 1, 0}, {1, 0, 0}))'",
        "rotor: (command line):1: angles_about: singular: " + told + "1\n");
  check("rotor -e '" + locked + R"(R:euler_angles("zyx", {singular = "silent"})')", "");
  check("rotor -e '" + locked +
            R"(R:angles_about({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {singular = "silent"})')",
        "");
}

TEST_CASE("option -l requires a module into a global") {
  const TemporaryDirectory directory;
  directory.write("my_module.lua", "print('loaded as', ...) return {answer = 42}");
  const std::string path = "LUA_PATH='" + directory.file("?.lua") + "' ";
  const std::string loaded = "loaded as\tmy_module\t" + directory.file("my_module.lua") + "\n42\n";
  check(path + "rotor -l my_module -e 'print(my_module.answer)'", loaded);
  check(path + "rotor -lmy_module -e 'print(my_module.answer)'", loaded);
  check(path + "rotor -l m=my_module -e 'print(m.answer)'", loaded);
  check_contains("rotor -l no_such", "rotor: module 'no_such' not found", 1);
  check_contains("rotor -l", "'-l' needs an argument", 1);
}

TEST_CASE("options -v --version --help") {
  check("rotor -v", kVersion);
  check("rotor --version", kVersion);
  check("rotor -v -e 'print(1)'", kVersion + "1\n");
  check_contains("rotor --help", "usage: rotor [options] [script [arguments]]", 0);
  check("rotor --help 2>/dev/null | grep -c -e --test", "3\n");
}

TEST_CASE("an option that does not exist") {
  const std::string option = GENERATE(as<std::string>{}, "-x", "--nothing", "-ie", "-vv", "-qx");
  check_contains("rotor " + option, "rotor: unrecognized option '" + option + "'\nusage:", 1);
}

TEST_CASE("option -W turns warnings on") {
  check("rotor -e 'warn(\"careful\")'", "");
  check("rotor -W -e 'warn(\"careful\")'", "Lua warning: careful\n");
}

TEST_CASE("LUA_INIT") {
  const TemporaryDirectory directory;
  const std::string file = directory.write("init.lua", "print('from file')");
  check("LUA_INIT='print(1)' rotor -e 'print(2)'", "1\n2\n");
  check("LUA_INIT='print(1)' LUA_INIT_5_4='print(3)' rotor -e 'print(2)'", "3\n2\n");
  check("LUA_INIT='@" + file + "' rotor -e 'print(2)'", "from file\n2\n");
  check("LUA_INIT='print(1)' rotor -E -e 'print(2)'", "2\n");
  check_contains("LUA_INIT='error(\"no\")' rotor -e 'print(2)'", "rotor: LUA_INIT:1: no", 1);
}

TEST_CASE("option -E ignores LUA_PATH") {
  check("LUA_PATH=here rotor -e 'print(package.path)'", "here\n");
  check("LUA_PATH=here rotor -E -e 'print(package.path == \"here\")'", "false\n");
}

TEST_CASE("a script and its arguments") {
  const TemporaryDirectory directory;
  const std::string script = directory.write(
      "script.lua",
      "print(...) print(arg[-3], arg[-2], arg[-1], arg[0], arg[1], arg[2], arg[3], #arg)");
  const std::string binary = ROTOR_BINARY;
  check("rotor " + script + " a 'b c'",
        "a\tb c\nnil\tnil\t" + binary + "\t" + script + "\ta\tb c\tnil\t2\n");
  check("rotor -e 'x = 1' " + script + " -v",
        "-v\n" + binary + "\t-e\tx = 1\t" + script + "\t-v\tnil\tnil\t1\n");
  check("rotor -- " + script, "\nnil\t" + binary + "\t--\t" + script + "\tnil\tnil\tnil\t0\n");
  check("rotor -e 'print(arg[0], arg[1], arg[2])'",
        binary + "\t-e\tprint(arg[0], arg[1], arg[2])\n");
  check("rotor -e 'arg = nil' " + script, "rotor: 'arg' is not a table\n", 1);
  check("rotor -e 'arg = {7, 8}' " + script + " | head -1", "7\t8\n");
  check("rotor no_such.lua", "rotor: cannot open no_such.lua: No such file or directory\n", 1);
}

TEST_CASE("an error in a script names the script and its line") {
  const TemporaryDirectory directory;
  const std::string script = directory.write("script.lua", "#!/usr/bin/rotor\n\nnowhere.x = 1\n");
  check_contains(
      "rotor " + script,
      "script.lua:3: attempt to index a nil value (global 'nowhere')\nstack traceback:", 1);
}

TEST_CASE("an error about a global that is not there names the one that may be meant") {
  check_contains("rotor -e 'eovlve{}'",
                 "(global 'eovlve'); did you mean 'evolve'?\nstack traceback:", 1);
  check_contains("rotor -e 'my_value = 1 x = my_vlaue + 1'", "; did you mean 'my_value'?\n", 1);
  check_contains("rotor -e 'unlike_anything()'", "(global 'unlike_anything')\nstack", 1);
  check("rotor -e 'print(getmetatable(_G), eovlve)'", "nil\tnil\n");
}

TEST_CASE("a traceback leaves out the inside of rotor's modules") {
  check("rotor -e 'local function f() near(1, 2, 0.5) end f()'",
        "rotor: (command line):1: near: the value: predicted 1, measured 2, difference 1.0e+00, "
        "tolerance 5.0e-01\nstack traceback:\n\t(command line):1: in local 'f'\n"
        "\t(command line):1: in main chunk\n\t[C]: in ?\n",
        1);
  const TemporaryDirectory directory;
  directory.write("rotor.lua", "error('mine')");
  check_contains("cd " + directory.file("") + " && rotor rotor.lua",
                 "\trotor.lua:1: in main chunk\n", 1);
}

TEST_CASE("the banner fits into 80 columns") {
  std::istringstream lines(shell("rotor -i").output);
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    CHECK(line.size() <= 80);
  }
}

TEST_CASE("standard input is one chunk") {
  check("printf 'local x = 1\\nprint(x)\\n' | rotor", "1\n");
  check("printf 'print(...)' | rotor - a b", "a\tb\n");
  check("printf 'print(1)' | rotor -e 'print(2)' -", "2\n1\n");
  check("printf 'print(1)' | rotor -W", "1\n");
  check("printf 'print(1)' | rotor -e 'print(2)'", "2\n");
  check_contains("printf '\\nerror(\"no\")' | rotor", "rotor: stdin:2: no\nstack traceback:", 1);
  check_contains("printf 'x =' | rotor", "rotor: stdin:1: unexpected symbol near <eof>", 1);
}

TEST_CASE("option -i opens the terminal after the rest, without a terminal too") {
  const TemporaryDirectory directory;
  const std::string script = directory.write("script.lua", "print('script') x = 20");
  check("echo 'x + 1' | rotor -q -i " + script, "script\nrotor> 21\nrotor> \n");
  check("echo 'x + 1' | rotor -q -i -e 'x = 1'", "rotor> 2\nrotor> \n");
  check("echo 'if true then' | rotor -q -i",
        "rotor>    ..> \n'end' expected near <eof>\nrotor> \n");
  check_contains("echo | rotor -i", kVersion.substr(0, kVersion.size() - 1) + "   ? help", 0);
  check_contains("echo 1 | rotor -q -i no_such.lua", "rotor: cannot open no_such.lua", 1);
}

TEST_CASE("at the prompt, ? is help") {
  check_contains("echo '?' | rotor -q -i", "slerp", 0);
  check_contains("echo ' ? slerp ' | rotor -q -i", "rotor> slerp(", 0);
  check_contains("echo '?rotation.from_mrp' | rotor -q -i", "rotor> rotation.from_mrp(", 0);
  CHECK(shell("echo 'help ' | rotor -q -i").output == shell("echo '?' | rotor -q -i").output);
  check("printf 'help = 5\\nhelp\\n' | rotor -q -i", "rotor> rotor> 5\nrotor> \n");
}

TEST_CASE("at the prompt, quit and exit tell how to leave, unless they are variables") {
  check("printf 'quit\\nexit \\n' | rotor -q -i",
        "rotor> Ctrl-D quits\nrotor> Ctrl-D quits\nrotor> \n");
  check("printf 'quit = 5\\nquit\\n' | rotor -q -i", "rotor> rotor> 5\nrotor> \n");
}

TEST_CASE("at the prompt, a line may begin with a prompt") {
  check("printf '  rotor> 1 +\\n   ..>\\n   ..> 2\\nrotor>\\n' | rotor -q -i",
        "rotor>    ..>    ..> 3\nrotor> rotor> \n");
}

TEST_CASE("what does not reach standard output is an error") {
  const std::string message = "rotor: cannot write to standard output";
  check("rotor -e 'print(1)' 2>&1 >/dev/full", message + "\n", 1);
  check("rotor -e 'print(1) os.exit(0)' 2>&1 >/dev/full", message + "\n", 1);
  check("rotor -e 'for i = 1, 1e5 do print(i) end' 2>&1 >/dev/full", message + "\n", 1);
  check("rotor -e 'io.write(1)' 2>&1 >/dev/full", message + ": No space left on device\n", 1);
  check("rotor --help 2>&1 >/dev/full", message + ": No space left on device\n", 1);
}

TEST_CASE("a reader that goes away ends the program quietly") {
  check("rotor -e 'for i = 1, 1e6 do print(i) end' | head -n 1", "1\n");
  check("trap '' PIPE; rotor -e 'for i = 1, 1e5 do print(i) end' | head -n 1", "1\n");
}

TEST_CASE("os.exit flushes and gives its status") {
  check("rotor -e 'io.write(1) os.exit(7)'", "1", 7);
  check("rotor -e 'io.write(1) os.exit(true, true)'", "1", 0);
  check("rotor -e 'coroutine.wrap(function() os.exit(3, true) end)()'", "", 3);
}

TEST_CASE("the coroutine functions that keep track of what runs behave as Lua's own") {
  check("rotor " ROTOR_SOURCE_DIR "/tests/app/coroutines.lua", "ok\n");
}

TEST_CASE("os.setlocale never changes numbers") {
  check(
      "rotor -e 'print(os.setlocale(nil, \"numeric\"), os.setlocale(\"C\"), "
      "os.setlocale(\"no_such\"))'",
      "C\tC\tnil\n");
  check_contains("rotor -e 'os.setlocale(\"C\", \"colour\")'", "bad argument #2 to 'setlocale'", 1);
  // The locale de_DE need not be installed; where it is, its decimal comma must not show.
  check("LC_ALL=de_DE.UTF-8 rotor -e 'os.setlocale(\"\") print(1.5, tonumber(\"2.5\"))'",
        "1.5\t2.5\n");
  check("LC_ALL=de_DE.UTF-8 rotor -e 'os.setlocale(\"\", \"numeric\") print(1.5)'", "1.5\n");
}

TEST_CASE("option --test runs files and directories, sorted") {
  const TemporaryDirectory directory;
  const std::string passing = "theorem('T', function() holds(true, 'it') end)\n";
  directory.write("tests/b.lua", passing);
  directory.write("tests/a.lua", passing);
  directory.write("tests/deep/c.lua", passing);
  directory.write("tests/notes.txt", "no Lua");
  directory.write("empty/notes.txt", "no Lua");
  const std::string failing =
      directory.write("failing.lua", "theorem('F', function() holds(false, 'it') end)\n");
  check("cd " + directory.file("") + " && rotor --test tests | grep ^ok | sed 's/ # time=.*ms$//'",
        "ok 1 - tests/a.lua: T\nok 2 - tests/b.lua: T\nok 3 - tests/deep/c.lua: T\n");
  check("rotor --test " + directory.file("tests/a.lua") + " >/dev/null", "", 0);
  check("rotor --test " + directory.file("tests") + " " + failing + " >/dev/null", "", 1);
  check_contains("rotor --test", "rotor: '--test' needs files or directories", 1);
  check_contains("rotor --test /no/such", "rotor: --test: there is no '/no/such'", 1);
  check_contains("rotor --test " + directory.file("empty"), "rotor: --test: no file *.lua in", 1);
}

TEST_CASE("option --filter runs the theorems with a text in their names") {
  const TemporaryDirectory directory;
  const std::string file = directory.write("both.lua",
                                           "theorem('Right', function() holds(true) end)\n"
                                           "theorem('Wrong', function() holds(false) end)\n");
  check("rotor --test --filter right " + file + " | grep -c ok", "1\n");
  check("rotor --test --filter RIGHT " + file + " >/dev/null", "", 0);
  check("rotor --test " + file + " --filter wrong >/dev/null", "", 1);
  check_contains("rotor --test --filter '(x' " + file,
                 "rotor: --test: of 2 theorems none has \"(x\" in its name\n", 1);
  check_contains("rotor --filter right " + file, "rotor: '--filter' is for --test: rotor --test",
                 1);
  check_contains("rotor --test --filter", "rotor: '--filter' needs a part of the names", 1);
  check_contains("rotor --test --filter '' " + file, "rotor: '--filter' needs a part of", 1);
  check_contains("rotor --test --filter a --filter b " + file, "'--filter' is given twice", 1);
  check_contains("rotor --test --filter a", "rotor: '--test' needs files or directories", 1);
}

TEST_CASE("a script with theorems ends with their sum, and with 1 if one failed") {
  const std::string theorem = "theorem('T', function() holds(";
  check_contains("echo \"" + theorem + "true, 'it') end)\" | rotor",
                 "1 theorem: all passed (1 check)  ", 0);
  check_contains("echo \"" + theorem + "false, 'it') end)\" | rotor", "1 theorem: 1 failed", 1);
}

TEST_CASE("options --reference and --stub print what editors and readers want") {
  check_contains("rotor --reference", "# ", 0);
  check_contains("rotor --stub", "---@meta", 0);
}
