#include "script/interrupt.hpp"

#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

#include "integrate/loop.hpp"

namespace rotor::script {
namespace {

// What the signal handler reads and writes: lock-free atomics only.
std::atomic<bool> pending = false;
std::atomic<lua_State*> running = nullptr;
static_assert(std::atomic<lua_State*>::is_always_lock_free);

termios terminal_at_start;
bool has_terminal = false;

void stop_running_code(lua_State* L, lua_Debug*) {
  if (pending) luaL_error(L, "interrupted");
  // A coroutine that slept through the interrupt, or was made during it, still has the hook.
  lua_sethook(L, nullptr, 0, 0);
}

// Count hooks alone: they fire between instructions of Lua code only. A call hook would also fire
// in message handlers and turn every report into an error in error handling.
void arm(lua_State* L) { lua_sethook(L, stop_running_code, LUA_MASKCOUNT, 1); }

void on_sigint(int) {
  if (pending.exchange(true)) {
    if (has_terminal) {
      tcsetattr(STDIN_FILENO, TCSANOW, &terminal_at_start);
      [[maybe_unused]] const ssize_t written = write(STDOUT_FILENO, "\n", 1);
    }
    _exit(kInterruptedStatus);
  }
  arm(running);
}

/// While it lives, `co` is the coroutine that runs. The signal may come on either side of each
/// switch and arm the coroutine that does not run, hence the look at `pending` after it.
class Running {
 public:
  explicit Running(lua_State* co) : before_(running.exchange(co)) { arm_if_pending(); }
  ~Running() {
    running = before_;
    arm_if_pending();
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  static void arm_if_pending() {
    if (pending) arm(running);
  }
  lua_State* before_;
};

lua_State* check_coroutine(lua_State* L) {
  lua_State* co = lua_tothread(L, 1);
  luaL_argexpected(L, co != nullptr, 1, "thread");
  return co;
}

constexpr int kFailed = -1;

/// Resumes `co` with the `arguments` values on top of L. Returns how many values it left on L, or
/// kFailed with the error value there.
int resume(lua_State* L, lua_State* co, int arguments) {
  if (!lua_checkstack(co, arguments)) {
    lua_pushliteral(L, "too many arguments to resume");
    return kFailed;
  }
  lua_xmove(L, co, arguments);
  int results = 0;
  int status = LUA_OK;
  {
    const Running now(co);
    status = lua_resume(co, L, arguments, &results);
  }
  if (status != LUA_OK && status != LUA_YIELD) {
    lua_xmove(co, L, 1);
    return kFailed;
  }
  if (!lua_checkstack(L, results + 1)) {
    lua_pop(co, results);
    lua_pushliteral(L, "too many results to resume");
    return kFailed;
  }
  lua_xmove(co, L, results);
  return results;
}

/// Closes `co`, whose pending __close metamethods run in it.
int close(lua_State* co) {
  const Running now(co);
  return lua_resetthread(co);
}

// coroutine.resume, .wrap and .close as Lua's manual has them; Lua's own cannot say what they
// resume.

int coroutine_resume(lua_State* L) {
  lua_State* co = check_coroutine(L);
  const int results = resume(L, co, lua_gettop(L) - 1);
  const bool failed = results == kFailed;
  lua_pushboolean(L, !failed);
  const int values = failed ? 1 : results;
  lua_insert(L, -(values + 1));
  return values + 1;
}

int call_wrapped(lua_State* L) {
  lua_State* co = lua_tothread(L, lua_upvalueindex(1));
  const int results = resume(L, co, lua_gettop(L));
  if (results != kFailed) return results;
  int status = lua_status(co);
  if (status != LUA_OK && status != LUA_YIELD) {  // it died: closing it may bring another error
    status = close(co);
    lua_xmove(co, L, 1);
  }
  if (status != LUA_ERRMEM && lua_type(L, -1) == LUA_TSTRING) {
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
  }
  return lua_error(L);
}

int coroutine_wrap(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_State* co = lua_newthread(L);
  lua_pushvalue(L, 1);
  lua_xmove(L, co, 1);
  lua_pushcclosure(L, call_wrapped, 1);
  return 1;
}

/// The state of `co` as coroutine.status names it, for the message of close.
const char* status_name(lua_State* L, lua_State* co) {
  if (L == co) return "running";
  const int status = lua_status(co);
  if (status == LUA_YIELD) return "suspended";
  if (status != LUA_OK) return "dead";
  lua_Debug frame;
  if (lua_getstack(co, 0, &frame)) return "normal";
  return lua_gettop(co) == 0 ? "dead" : "suspended";
}

int coroutine_close(lua_State* L) {
  lua_State* co = check_coroutine(L);
  const char* state = status_name(L, co);
  if (*state == 'r' || *state == 'n') return luaL_error(L, "cannot close a %s coroutine", state);
  const bool good = close(co) == LUA_OK;
  lua_pushboolean(L, good);
  if (good) return 1;
  lua_xmove(co, L, 1);
  return 2;
}

void track_coroutines(lua_State* L) {
  const luaL_Reg functions[] = {{"resume", coroutine_resume},
                                {"wrap", coroutine_wrap},
                                {"close", coroutine_close},
                                {nullptr, nullptr}};
  lua_getglobal(L, LUA_COLIBNAME);
  luaL_setfuncs(L, functions, 0);
  lua_pop(L, 1);
}

}  // namespace

void watch_interrupts(lua_State* L) {
  track_coroutines(L);
  running = L;
  has_terminal = tcgetattr(STDIN_FILENO, &terminal_at_start) == 0;
  struct sigaction action = {};
  action.sa_handler = on_sigint;  // without SA_RESTART: a read that waits comes back
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
}

void unwatch_interrupts() { std::signal(SIGINT, SIG_DFL); }

bool interrupt_pending() { return pending; }

void stop_if_interrupted() {
  if (pending) throw Interrupted();
}

void clear_interrupt(lua_State* L) {
  pending = false;
  lua_sethook(L, nullptr, 0, 0);
}

}  // namespace rotor::script
