// The terminal as a person meets it, on a pseudo-terminal.
#include <string>

#include "app/pty.hpp"
#include "catch.hpp"
#include "temporary.hpp"

namespace {

const std::string kPrompt = "rotor> ";
const std::string kContinuation = "   ..> ";
const std::string kCtrlC = "\x03";
const std::string kCtrlD = "\x04";
const std::string kUp = "\x1b[A";
// Before what is typed is run, readline turns bracketed paste off.
const std::string kPasteOff = "\x1b[?2004l\r";
const std::string kAnswer = "\r\n" + kPasteOff;

/// Waits for what must appear next; where it does not, the failure shows the screen.
void expect(Pty& rotor, const std::string& text) {
  const bool shown = rotor.shows(text);
  INFO(rotor.screen());
  CAPTURE(text);
  REQUIRE(shown);
}

/// Types a line and sees it answered so.
void ask(Pty& rotor, const std::string& line, const std::string& answer) {
  rotor.type_line(line);
  expect(rotor, kAnswer + answer + "\r\n");
  expect(rotor, kPrompt);
}

/// Starts Lua code that never ends, and waits until it runs.
void start(Pty& rotor, const std::string& code) {
  expect(rotor, kPrompt);
  rotor.type_line("print('run' .. 'ning') " + code);
  expect(rotor, "running\r\n");
}

}  // namespace

TEST_CASE("the terminal opens with a banner and shows the value of an expression") {
  Pty rotor(std::vector<std::string>{});
  expect(rotor, "Ctrl-D quit");
  expect(rotor, kPrompt);
  ask(rotor, "1 + 2", "3");
  ask(rotor, "ans + 1", "4");
}

TEST_CASE("an input that is not finished goes on in the next line") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type_line("2 +");
  expect(rotor, kContinuation);
  ask(rotor, "5", "7");
}

TEST_CASE("Ctrl-C at the prompt clears the line") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type("error('unwanted')");
  expect(rotor, "unwanted')");
  rotor.type(kCtrlC);
  expect(rotor, kPrompt);
  ask(rotor, "6 * 7", "42");
}

TEST_CASE("Ctrl-C again and again at the prompt does not leave") {
  Pty rotor;
  for (int i = 0; i < 5; ++i) {
    expect(rotor, kPrompt);
    rotor.type(kCtrlC);
  }
  expect(rotor, kPrompt);
  ask(rotor, "6 * 7", "42");
}

TEST_CASE("Ctrl-C drops the lines before, too") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type_line("for i = 1, 3 do");
  expect(rotor, kContinuation);
  rotor.type("print(i)");
  expect(rotor, "print(i)");
  rotor.type(kCtrlC);
  expect(rotor, kPrompt);
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
  expect(rotor, "interrupted\r\n");
  expect(rotor, kPrompt);
  ask(rotor, "6 * 7", "42");
  rotor.type(kCtrlD);
  CHECK(rotor.status() == 0);
}

TEST_CASE("Ctrl-C in evolve keeps the run so far as the answer") {
  Pty rotor;
  expect(rotor, kPrompt);
  // It must be under way when Ctrl-C comes.
  rotor.type_line(
      "evolve{to = 1e12, omega = function(t) if t > 1 and not told then told = true "
      "print('run' .. 'ning') end return cos(t), sin(t), 0 end}");
  expect(rotor, "running\r\n");
  rotor.type(kCtrlC);
  expect(rotor, "the run up to t = ");
  expect(rotor, " is in ans\r\n");
  expect(rotor, kPrompt);
  ask(rotor, "ans.complete", "false");
}

TEST_CASE("a coroutine that slept through an interrupt works on") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type_line(
      "sleeper = coroutine.wrap(function() while true do coroutine.yield('up') end end)");
  expect(rotor, kPrompt);
  rotor.type_line("first = sleeper()");  // before "running": it must not be the one interrupted
  start(rotor, "while true do end");
  rotor.type(kCtrlC);
  expect(rotor, "interrupted\r\n");
  expect(rotor, kPrompt);
  ask(rotor, "print(sleeper())", "up");
  ask(rotor, "print(sleeper())", "up");
}

TEST_CASE("when one Ctrl-C does not help, the next leaves") {
  Pty rotor;
  expect(rotor, kPrompt);
  // Lua lets no hook into a finalizer.
  rotor.type_line(
      "setmetatable({}, {__gc = function() print('run' .. 'ning') while true do end end}) "
      "collectgarbage()");
  expect(rotor, "running\r\n");
  CHECK(rotor.status_after_interrupts() == 130);
}

TEST_CASE("an interrupted script ends with 130") {
  Pty rotor(
      {"-e", "print('run' .. 'ning') while true do pcall(function() while true do end end) end"});
  expect(rotor, "running");
  rotor.type(kCtrlC);
  expect(rotor, "interrupted");
  CHECK(rotor.status() == 130);
}

TEST_CASE("Ctrl-D leaves with a newline, and only from an empty line") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type("6" + kCtrlD + " * 7\r");
  expect(rotor, kAnswer + "42\r\n");
  expect(rotor, kPrompt);
  rotor.type(kCtrlD);
  CHECK(rotor.status() == 0);
  CHECK(rotor.screen().ends_with(kPrompt + kPasteOff + "\r\n"));
}

TEST_CASE("Ctrl-D in an unfinished input says what is missing and stays") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type_line("if true then");
  expect(rotor, kContinuation);
  rotor.type(kCtrlD);
  expect(rotor, kPasteOff + "\r\n'end' expected near <eof>");
  expect(rotor, kPrompt);
  ask(rotor, "6 * 7", "42");
}

TEST_CASE("history is kept from session to session, an input of several lines as one entry") {
  const TemporaryDirectory directory;
  const std::string file = directory.file("state/rotor/history");
  {
    Pty rotor({"-q"}, {{"ROTOR_HISTORY", file}});
    expect(rotor, kPrompt);
    rotor.type_line("print('a\\\\b' ..");
    expect(rotor, kContinuation);
    ask(rotor, "'c')", "a\\bc");
    rotor.type(kCtrlD);
    REQUIRE(rotor.status() == 0);
  }
  CHECK(content_of(file) == "print('a\\\\\\\\b' ..\\n'c')\n");
  Pty rotor({"-q"}, {{"ROTOR_HISTORY", file}});
  expect(rotor, kPrompt);
  ask(rotor, kUp, "a\\bc");
  CHECK(content_of(file) ==
        "print('a\\\\\\\\b' ..\\n'c')\n");  // the same entry again is not kept twice
}

TEST_CASE("history goes where XDG_STATE_HOME says, else into the home directory") {
  const TemporaryDirectory directory;
  const auto session = [](const std::string& assignments) {
    Pty rotor({"-c", "env -u ROTOR_HISTORY " + assignments + " " ROTOR_BINARY " -q"}, {},
              "/bin/sh");
    expect(rotor, kPrompt);
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
  expect(rotor, kPrompt);
  CHECK(content_of(file) == long_history.substr(2));  // without the first
}

TEST_CASE("a history that cannot be written is said once and harms nothing") {
  const TemporaryDirectory directory;
  const std::string file = directory.write("file", "") + "/history";
  Pty rotor({"-q"}, {{"ROTOR_HISTORY", file}});
  expect(rotor, kPrompt);
  rotor.type_line("6 * 7");
  expect(rotor, kAnswer + "history is not kept: cannot write " + file);
  expect(rotor, "\r\n42\r\n");
  ask(rotor, "6 * 8", "48");
  CHECK(rotor.screen().find("history", rotor.screen().find("\n42\r\n")) == std::string::npos);
}

TEST_CASE("TAB completes a name and a field") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type_line("my_long_table = {my_long_field = 42}");
  expect(rotor, kPrompt);
  ask(rotor, "my_lo\t.my_lo\t", "42");
  ask(rotor, "1 + (my_long_table.my_lo\t)", "43");
}

TEST_CASE("TAB TAB lists what may stand at the cursor") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type_line("my_table = {apple = 1, cherry = 2}");
  expect(rotor, kPrompt);
  rotor.type("my_table.\t\t");
  expect(rotor, "\r\napple ");
  expect(rotor, "cherry");
  expect(rotor, kPrompt + "my_table.");
  rotor.type("c\t\r");
  expect(rotor, kAnswer + "2\r\n");
}

TEST_CASE("a list too long for the screen is shown without a question") {
  Pty rotor({"-c", "stty rows 10 cols 80; exec " ROTOR_BINARY " -q"}, {}, "/bin/sh");
  expect(rotor, kPrompt);
  rotor.type_line("t = {} for i = 100, 400 do t['n' .. i] = i end");
  expect(rotor, kPrompt);
  rotor.type("t.n\t\t");
  expect(rotor, "n400");
  expect(rotor, kPrompt + "t.n");
  CHECK(rotor.screen().find("(y or n)") == std::string::npos);
}

TEST_CASE("TAB indents where there is nothing to complete") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type("\t7");
  expect(rotor, "  7");
}

TEST_CASE("a paste of several lines") {
  Pty rotor;
  const auto paste = [&](const std::string& text) {
    rotor.type("\x1b[200~" + text + "\x1b[201~\r");
  };
  expect(rotor, kPrompt);
  SECTION("is one input where it can be: locals are known to all of it") {
    paste("local x = 20\nprint(x + 1)");
    expect(rotor, kAnswer + "21\r\n");
  }
  SECTION("is taken line by line otherwise") {
    paste("x = 20\nx + 1\nx + 2");
    expect(rotor, kAnswer + "21\r\n22\r\n");
  }
  SECTION("ends at the first line that goes wrong") {
    paste("y.z\ny = 1\ny");
    expect(rotor, "attempt to index");
    expect(rotor, kPrompt);
    ask(rotor, "y", "nil");
  }
}

TEST_CASE("of a session that is pasted with its prompts, what was typed is run") {
  Pty rotor;
  expect(rotor, kPrompt);
  // The inputs are apart: as one chunk, x + 1 would be the start of a call.
  rotor.type(
      "\x1b[200~rotor> x = 20\nrotor> x + 1\n21\nrotor> for i = 1, 1 do\n   ..>\n"
      "   ..>   print(x + i + 1)\n   ..> end\n22\nrotor> x + 3\nnot (Lua\x1b[201~\r");
  expect(rotor, kAnswer + "21\r\n22\r\n23\r\n");
  expect(rotor, kPrompt);
  ask(rotor, kPrompt + "6 * 7", "42");
}

TEST_CASE("at the prompt, messages break between words at the terminal's width") {
  Pty rotor({"-c", "stty cols 30; exec " ROTOR_BINARY " -q"}, {}, "/bin/sh");
  expect(rotor, kPrompt);
  rotor.type_line("q = ('ω'):rep(9)");
  expect(rotor, kPrompt);
  // Three words and two spaces take 29 columns and, as bytes, 56; then a word that cannot fit.
  rotor.type_line("w = q:rep(5, ' ')");
  expect(rotor, kPrompt);
  rotor.type_line("z = (' z'):rep(2)");
  expect(rotor, kPrompt);
  rotor.type_line("error(w .. z, 0)");
  const std::string q = "ωωωωωωωωω";
  expect(rotor, kAnswer + q + " " + q + " " + q + "\r\n" + q + " " + q + " z z\r\n");
  expect(rotor, kPrompt);
  rotor.type_line("z = ('z'):rep(40)");
  expect(rotor, kPrompt);
  rotor.type_line("error('a ' .. z .. ' b', 0)");
  expect(rotor, kAnswer + "a\r\n" + std::string(40, 'z') + "\r\nb\r\n");
}

TEST_CASE("a pipe that breaks does not end the session") {
  Pty rotor;
  expect(rotor, kPrompt);
  rotor.type_line("p = io.popen('exit', 'w') p:setvbuf('no') repeat until not p:write('x')");
  expect(rotor, kPrompt);
  ask(rotor, "6 * 7", "42");
}

TEST_CASE("no escape codes with TERM=dumb or NO_COLOR") {
  const std::string variable = GENERATE(as<std::string>{}, "TERM=dumb", "NO_COLOR=1");
  CAPTURE(variable);
  const std::size_t equals = variable.find('=');
  Pty rotor({}, {{variable.substr(0, equals), variable.substr(equals + 1)}});
  expect(rotor, "Ctrl-D quit");
  expect(rotor, kPrompt);
  rotor.type_line("1 + 2");
  expect(rotor, "\r\n3\r\n");
  expect(rotor, kPrompt);
  rotor.type(kCtrlD);
  REQUIRE(rotor.status() == 0);
  CHECK(rotor.screen().find('\x1b') == std::string::npos);
}
