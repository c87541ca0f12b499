// The terminal as a person meets it, on a pseudo-terminal.
#include <string>

#include "app/pty.hpp"
#include "app/temporary.hpp"
#include "catch.hpp"

namespace {

const std::string kPrompt = "rotor> ";
const std::string kContinuation = "   ..> ";
const std::string kCtrlC = "\x03";
const std::string kCtrlD = "\x04";
const std::string kUp = "\x1b[A";
// Before what is typed is run, readline turns bracketed paste off.
const std::string kPasteOff = "\x1b[?2004l\r";
const std::string kAnswer = "\r\n" + kPasteOff;

/// Types a line and sees it answered so.
void ask(Pty& rotor, const std::string& line, const std::string& answer) {
  INFO(rotor.screen());
  rotor.type_line(line);
  REQUIRE(rotor.shows(kAnswer + answer + "\r\n"));
  REQUIRE(rotor.shows(kPrompt));
}

/// Starts Lua code that never ends, and waits until it runs.
void start(Pty& rotor, const std::string& code) {
  REQUIRE(rotor.shows(kPrompt));
  rotor.type_line("print('run' .. 'ning') " + code);
  REQUIRE(rotor.shows("running\r\n"));
}

}  // namespace

TEST_CASE("the terminal opens with a banner and shows the value of an expression") {
  Pty rotor(std::vector<std::string>{});
  REQUIRE(rotor.shows("Ctrl-D quit"));
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, "1 + 2", "3");
  ask(rotor, "ans + 1", "4");
}

TEST_CASE("an input that is not finished goes on in the next line") {
  Pty rotor;
  REQUIRE(rotor.shows(kPrompt));
  rotor.type_line("2 +");
  REQUIRE(rotor.shows(kContinuation));
  ask(rotor, "5", "7");
}

TEST_CASE("Ctrl-C at the prompt clears the line") {
  Pty rotor;
  REQUIRE(rotor.shows(kPrompt));
  rotor.type("error('unwanted')");
  REQUIRE(rotor.shows("unwanted')"));
  rotor.type(kCtrlC);
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, "6 * 7", "42");
}

TEST_CASE("Ctrl-C again and again at the prompt does not leave") {
  Pty rotor;
  for (int i = 0; i < 5; ++i) {
    REQUIRE(rotor.shows(kPrompt));
    rotor.type(kCtrlC);
  }
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, "6 * 7", "42");
}

TEST_CASE("Ctrl-C drops the lines before, too") {
  Pty rotor;
  REQUIRE(rotor.shows(kPrompt));
  rotor.type_line("for i = 1, 3 do");
  REQUIRE(rotor.shows(kContinuation));
  rotor.type("print(i)");
  REQUIRE(rotor.shows("print(i)"));
  rotor.type(kCtrlC);
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, "6 * 7", "42");
}

TEST_CASE("Ctrl-C stops Lua code wherever it runs") {
  const std::string code = GENERATE(
      as<std::string>{}, "while true do end",
      "while true do pcall(function() while true do end end) end",
      "while true do xpcall(function() while true do end end, debug.traceback) end",
      "coroutine.wrap(function() while true do end end)()",
      "while true do coroutine.resume(coroutine.create(function() while true do end end)) end",
      "local w = coroutine.wrap(function() while true do coroutine.yield() end end) "
      "while true do w() end",
      "local co = coroutine.create(function() local x <close> = setmetatable({}, "
      "{__close = function() while true do end end}) coroutine.yield() end) "
      "coroutine.resume(co) coroutine.close(co)",
      "string.gsub(('a'):rep(1000), '.', function() while true do end end)",
      "table.sort({3, 2, 1}, function() while true do end end)");
  CAPTURE(code);
  Pty rotor;
  start(rotor, code);
  rotor.type(kCtrlC);
  INFO(rotor.screen());
  REQUIRE(rotor.shows("interrupted\r\n"));
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, "6 * 7", "42");
  rotor.type(kCtrlD);
  CHECK(rotor.status() == 0);
}

TEST_CASE("a coroutine that slept through an interrupt works on") {
  Pty rotor;
  REQUIRE(rotor.shows(kPrompt));
  rotor.type_line(
      "sleeper = coroutine.wrap(function() while true do coroutine.yield('up') end end)");
  start(rotor, "sleeper() while true do end");
  rotor.type(kCtrlC);
  REQUIRE(rotor.shows("interrupted\r\n"));
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, "print(sleeper())", "up");
  ask(rotor, "print(sleeper())", "up");
}

TEST_CASE("when one Ctrl-C does not help, the next leaves") {
  Pty rotor;
  // One call of the matcher takes 2^60 steps: no Lua instruction comes by to be stopped at.
  start(rotor, "string.find(('a'):rep(60), ('a?'):rep(60) .. ('a'):rep(60))");
  CHECK(rotor.status_after_interrupts() == 130);
}

TEST_CASE("an interrupted script ends with 130") {
  Pty rotor(
      {"-e", "print('run' .. 'ning') while true do pcall(function() while true do end end) end"});
  REQUIRE(rotor.shows("running"));
  rotor.type(kCtrlC);
  CHECK(rotor.shows("interrupted"));
  CHECK(rotor.status() == 130);
}

TEST_CASE("Ctrl-D leaves with a newline, and only from an empty line") {
  Pty rotor;
  REQUIRE(rotor.shows(kPrompt));
  rotor.type("6" + kCtrlD + " * 7\r");
  REQUIRE(rotor.shows(kAnswer + "42\r\n"));
  REQUIRE(rotor.shows(kPrompt));
  rotor.type(kCtrlD);
  CHECK(rotor.status() == 0);
  CHECK(rotor.screen().ends_with(kPrompt + kPasteOff + "\r\n"));
}

TEST_CASE("Ctrl-D in an unfinished input says what is missing and stays") {
  Pty rotor;
  REQUIRE(rotor.shows(kPrompt));
  rotor.type_line("if true then");
  REQUIRE(rotor.shows(kContinuation));
  rotor.type(kCtrlD);
  REQUIRE(rotor.shows(kPasteOff + "\r\n'end' expected near <eof>"));
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, "6 * 7", "42");
}

TEST_CASE("history is kept from session to session, an input of several lines as one entry") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("state/rotor/history");
  {
    Pty rotor({"-q"}, {{"ROTOR_HISTORY", file}});
    REQUIRE(rotor.shows(kPrompt));
    rotor.type_line("print('a\\\\b' ..");
    REQUIRE(rotor.shows(kContinuation));
    ask(rotor, "'c')", "a\\bc");
    rotor.type(kCtrlD);
    REQUIRE(rotor.status() == 0);
  }
  CHECK(content_of(file) == "print('a\\\\\\\\b' ..\\n'c')\n");
  Pty rotor({"-q"}, {{"ROTOR_HISTORY", file}});
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, kUp, "a\\bc");
  CHECK(content_of(file) ==
        "print('a\\\\\\\\b' ..\\n'c')\n");  // the same entry again is not kept twice
}

TEST_CASE("history goes where XDG_STATE_HOME says, else into the home directory") {
  const TemporaryDirectory directory;
  const auto session = [](const std::string& assignments) {
    Pty rotor({"-c", "env -u ROTOR_HISTORY " + assignments + " " ROTOR_BINARY " -q"}, {},
              "/bin/sh");
    REQUIRE(rotor.shows(kPrompt));
    ask(rotor, "1 + 1", "2");
  };
  session("XDG_STATE_HOME=" + directory.file("state"));
  CHECK(content_of(directory.file("state/rotor/history")) == "1 + 1\n");
  session("-u XDG_STATE_HOME HOME=" + directory.file("home"));
  CHECK(content_of(directory.file("home/.local/state/rotor/history")) == "1 + 1\n");
}

TEST_CASE("the history file is bounded") {
  const TemporaryDirectory directory;
  std::string long_history;
  for (int i = 1; i <= 10'001; ++i) long_history += std::to_string(i) + "\n";
  const std::string file = directory.write("history", long_history);
  Pty rotor({"-q"}, {{"ROTOR_HISTORY", file}});
  REQUIRE(rotor.shows(kPrompt));
  CHECK(content_of(file) == long_history.substr(2));  // without the first
}

TEST_CASE("a history that cannot be written is said once and harms nothing") {
  const TemporaryDirectory directory;
  const std::string file = directory.write("file", "") + "/history";
  Pty rotor({"-q"}, {{"ROTOR_HISTORY", file}});
  REQUIRE(rotor.shows(kPrompt));
  rotor.type_line("6 * 7");
  REQUIRE(rotor.shows(kAnswer + "history is not kept: cannot write " + file));
  REQUIRE(rotor.shows("\r\n42\r\n"));
  ask(rotor, "6 * 8", "48");
  CHECK(rotor.screen().find("history", rotor.screen().find("\n42\r\n")) == std::string::npos);
}

TEST_CASE("TAB completes a name and a field") {
  Pty rotor;
  REQUIRE(rotor.shows(kPrompt));
  rotor.type_line("my_long_table = {my_long_field = 42}");
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, "my_lo\t.my_lo\t", "42");
  ask(rotor, "1 + (my_long_table.my_lo\t)", "43");
}

TEST_CASE("TAB indents where there is nothing to complete") {
  Pty rotor;
  REQUIRE(rotor.shows(kPrompt));
  rotor.type("\t7");
  CHECK(rotor.shows("  7"));
}

TEST_CASE("a paste of several lines") {
  Pty rotor;
  const auto paste = [&](const std::string& text) {
    rotor.type("\x1b[200~" + text + "\x1b[201~\r");
  };
  REQUIRE(rotor.shows(kPrompt));
  SECTION("is one input where it can be: locals are known to all of it") {
    paste("local x = 20\nprint(x + 1)");
    CHECK(rotor.shows(kAnswer + "21\r\n"));
  }
  SECTION("is taken line by line otherwise") {
    paste("x = 20\nx + 1\nx + 2");
    CHECK(rotor.shows(kAnswer + "21\r\n22\r\n"));
  }
  SECTION("ends at the first line that goes wrong") {
    paste("y.z\ny = 1\ny");
    CHECK(rotor.shows("attempt to index"));
    REQUIRE(rotor.shows(kPrompt));
    ask(rotor, "y", "nil");
  }
}

TEST_CASE("a pipe that breaks does not end the session") {
  Pty rotor;
  REQUIRE(rotor.shows(kPrompt));
  rotor.type_line("p = io.popen('exit', 'w') p:setvbuf('no') repeat until not p:write('x')");
  REQUIRE(rotor.shows(kPrompt));
  ask(rotor, "6 * 7", "42");
}

TEST_CASE("no escape codes with TERM=dumb or NO_COLOR") {
  const std::string variable = GENERATE(as<std::string>{}, "TERM=dumb", "NO_COLOR=1");
  CAPTURE(variable);
  const std::size_t equals = variable.find('=');
  Pty rotor({}, {{variable.substr(0, equals), variable.substr(equals + 1)}});
  REQUIRE(rotor.shows("Ctrl-D quit"));
  REQUIRE(rotor.shows(kPrompt));
  rotor.type_line("1 + 2");
  REQUIRE(rotor.shows("\r\n3\r\n"));
  REQUIRE(rotor.shows(kPrompt));
  rotor.type(kCtrlD);
  REQUIRE(rotor.status() == 0);
  CHECK(rotor.screen().find('\x1b') == std::string::npos);
}
