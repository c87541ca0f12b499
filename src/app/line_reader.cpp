#include "app/line_reader.hpp"

#include <cstdio>  // readline.h needs FILE

#include <poll.h>
#include <readline/history.h>
#include <readline/readline.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>

#include "app/errors.hpp"
#include "app/locale.hpp"
#include "script/interrupt.hpp"

namespace rotor::app {
namespace {

constexpr const char* kIndent = "  ";

// What readline's callbacks, plain functions, work on.
Completer completer;
std::vector<std::string> matches;  // of the completion under way
std::size_t next_match = 0;
bool line_finished = false;
volatile std::sig_atomic_t resumed = 0;    // after Ctrl-Z
std::optional<std::string> finished_line;  // none: the end of the input

void on_line(char* text) {
  line_finished = true;
  finished_line = text == nullptr ? std::nullopt : std::optional<std::string>(text);
  std::free(text);
  rl_callback_handler_remove();
}

char* give_match(const char*, int state) {
  if (state == 0) next_match = 0;
  return next_match < matches.size() ? strdup(matches[next_match++].c_str()) : nullptr;
}

/// Readline wants words that stand where its own idea of the word starts.
char** complete(const char* word, int start, int) {
  rl_attempted_completion_over = 1;  // no file names
  rl_completion_append_character = '\0';
  const std::string line(rl_line_buffer, static_cast<std::size_t>(rl_end));
  const Completions found = completer(line, static_cast<std::size_t>(rl_point));
  const std::string before = line.substr(0, std::min(found.start, line.size()));
  const auto from = static_cast<std::size_t>(start);
  matches.clear();
  for (const std::string& candidate : found.words) {
    const std::string completed = before + candidate;
    if (completed.size() > from) matches.push_back(completed.substr(from));
  }
  return matches.empty() ? nullptr : rl_completion_matches(word, give_match);
}

/// TAB completes, but indents where there is nothing yet to complete.
int on_tab(int count, int key) {
  const char* end = rl_line_buffer + rl_point;
  const bool blank = std::all_of(static_cast<const char*>(rl_line_buffer), end,
                                 [](char c) { return c == ' ' || c == '\n'; });
  if (!blank) {
    if (rl_last_func == on_tab) rl_last_func = rl_complete;  // the second in a row lists
    return rl_complete(count, key);
  }
  rl_insert_text(kIndent);
  return 0;
}

/// Readline adds a newline at the end of input, but only with bracketed paste: the caller does it
/// always.
void release_terminal() {
  rl_eof_found = 0;
  rl_deprep_terminal();
}

bool escape_codes_wanted() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* term = std::getenv("TERM");
  return (no_color == nullptr || *no_color == '\0') && term != nullptr &&
         std::strcmp(term, "dumb") != 0;
}

/// Waits for a key or a signal. Signals come through only inside ppoll, so that Ctrl-C cannot fall
/// between the look and the wait.
bool key_comes() {
  sigset_t interrupt;
  sigset_t before;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  sigprocmask(SIG_BLOCK, &interrupt, &before);
  rl_check_signals();  // readline's handler only notes a signal; this passes it on to ours
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  const bool comes =
      !script::interrupt_pending() && !resumed && ppoll(&input, 1, nullptr, &before) > 0;
  sigprocmask(SIG_SETMASK, &before, nullptr);
  return comes;
}

LineReader::Event edit_line(const std::string& prompt, std::string& line) {
  const UserCharacters characters;
  line_finished = false;
  resumed = 0;
  rl_callback_handler_install(prompt.c_str(), on_line);
  while (!line_finished) {
    if (key_comes()) rl_callback_read_char();
    if (resumed) {
      resumed = 0;
      rl_forced_update_display();
    }
    if (script::interrupt_pending() && !line_finished) {
      rl_callback_handler_remove();
      std::fputs("\n", stdout);
      return LineReader::Event::kInterrupted;
    }
  }
  if (!finished_line) return LineReader::Event::kEnd;
  line = *std::move(finished_line);
  return LineReader::Event::kLine;
}

LineReader::Event read_plainly(const std::string& prompt, std::string& line) {
  std::fwrite(prompt.data(), 1, prompt.size(), stdout);
  std::fflush(stdout);
  char* text = nullptr;
  std::size_t capacity = 0;
  const ssize_t length = getline(&text, &capacity, stdin);
  const std::unique_ptr<char, decltype(&std::free)> owner(text, &std::free);
  if (script::interrupt_pending()) {
    std::clearerr(stdin);
    std::fputs("\n", stdout);
    return LineReader::Event::kInterrupted;
  }
  if (length < 0) return LineReader::Event::kEnd;
  line.assign(text, static_cast<std::size_t>(length));
  if (line.ends_with('\n')) line.pop_back();
  if (line.ends_with('\r')) line.pop_back();
  return LineReader::Event::kLine;
}

}  // namespace

LineReader::LineReader(Completer words)
    : on_terminal_(isatty(STDIN_FILENO) && isatty(STDOUT_FILENO)),
      history_(History::from_environment()) {
  if (!on_terminal_) return;
  completer = std::move(words);
  set_up_readline();
  for (const std::string& entry : history_.load()) {
    add_history(entry.c_str());
    last_entry_ = entry;
  }
}

void LineReader::set_up_readline() {
  const UserCharacters characters;
  rl_readline_name = "rotor";
  rl_persistent_signal_handlers = 1;  // they must be there while we wait in ppoll
  rl_initialize();
  if (!escape_codes_wanted()) {
    rl_variable_bind("enable-bracketed-paste", "off");
    rl_variable_bind("enable-meta-key", "off");
  }
  rl_deprep_term_function = release_terminal;
  rl_attempted_completion_function = complete;
  rl_completer_word_break_characters = const_cast<char*>(" \t\n\"\\'><=;+-*/%^~#&|(){}[].:,?");
  rl_bind_key('\t', on_tab);
  rl_completion_query_items = -1;  // called back, readline asks but does not wait for the answer
  std::signal(SIGCONT, [](int) { resumed = 1; });
}

LineReader::Event LineReader::read(const std::string& prompt, std::string& line) {
  return on_terminal_ ? edit_line(prompt, line) : read_plainly(prompt, line);
}

void LineReader::remember(const std::string& entry) {
  if (!on_terminal_ || entry == last_entry_) return;
  last_entry_ = entry;
  add_history(entry.c_str());
  if (!history_.append(entry)) {
    print_error("history is not kept: cannot write " + history_.path().string() + ": " +
                std::strerror(errno));
    history_ = History::none();
  }
}

}  // namespace rotor::app
