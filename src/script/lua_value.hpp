// Values of Lua held by C++, and errors of Lua that travel through C++.
#pragma once

#include <exception>
#include <lua.hpp>
#include <memory>
#include <string>

namespace rotor::script {

/// Puts the stack back to its height when it goes; not when an exception passes, as the value of a
/// Lua error on its way lies on top of the stack.
class StackGuard {
 public:
  explicit StackGuard(lua_State* L)
      : L_(L), top_(lua_gettop(L)), exceptions_(std::uncaught_exceptions()) {}
  ~StackGuard() {
    if (std::uncaught_exceptions() == exceptions_) lua_settop(L_, top_);
  }
  StackGuard(const StackGuard&) = delete;
  StackGuard& operator=(const StackGuard&) = delete;

 private:
  lua_State* L_;
  int top_;
  int exceptions_;
};

/// The state (the coroutine) from which Lua last called into rotor: where a scripted function runs.
lua_State* current_state();

/// While it lives, L is the current state.
class CurrentState {
 public:
  explicit CurrentState(lua_State* L);
  ~CurrentState();
  CurrentState(const CurrentState&) = delete;
  CurrentState& operator=(const CurrentState&) = delete;

 private:
  lua_State* before_;
};

/// A Lua value kept alive from C++.
class Reference {
 public:
  /// Takes the value at `index`.
  Reference(lua_State* L, int index);
  ~Reference();
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  void push(lua_State* L) const;

 private:
  lua_State* main_;
  int key_;
};

/// An error raised by a script, on its way through C++: its own value, unharmed, and what it says.
class ScriptError : public std::exception {
 public:
  ScriptError(std::shared_ptr<const Reference> value, std::string message)
      : value_(std::move(value)), message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }
  void push(lua_State* L) const { value_->push(L); }

 private:
  std::shared_ptr<const Reference> value_;
  std::string message_;
};

/// Pushes what `require(name)` gives, even where a script has hidden `require`.
void push_module(lua_State* L, const char* name);

}  // namespace rotor::script
