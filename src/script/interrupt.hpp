// Ctrl-C: a flag for loops in C++, a debug hook for Lua code.
//
// The hook is armed only when the signal comes (a permanent count hook costs 20 to 50 %), on the
// coroutine that runs, with count 1, and stays until clear_interrupt: a pcall in a loop cannot
// swallow it. A second Ctrl-C before that (some call into C did not come back) restores the
// terminal and leaves with status 130.
#pragma once

#include <lua.hpp>

namespace rotor::script {

/// The exit status of a program that Ctrl-C ended.
constexpr int kInterruptedStatus = 130;

/// Installs the SIGINT handler for this state, and the coroutine functions that keep track of which
/// coroutine runs. Once a process, after the standard libraries are there.
void watch_interrupts(lua_State* L);

/// Gives SIGINT back to the system: before the watched state is closed.
void unwatch_interrupts();

/// Whether Ctrl-C came since the last clear_interrupt. Loops in C++ ask this and stop.
bool interrupt_pending();

/// Throws Interrupted if it did.
void stop_if_interrupted();

/// Back at the prompt: forgets the interrupt and takes the hook away.
void clear_interrupt(lua_State* L);

}  // namespace rotor::script
