// Options tables: evolve{omega = ..., to = ...}.
#pragma once

#include <cstddef>
#include <lua.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "script/convert.hpp"
#include "script/lua_value.hpp"

namespace rotor::script {

/// The table at `index`, the last argument, its keys checked against those of a signature, "f{key=,
/// other=} -> type": an unknown key is an std::invalid_argument with a "did you mean".
class Options {
 public:
  Options(lua_State* L, int index, const char* signature);

  bool has(const char* key) const;
  /// The option, if it is given. A value of the wrong type is named by its key.
  template <class T>
  std::optional<T> get(const char* key) const {
    const StackGuard guard(L_);
    lua_getfield(L_, index_, key);
    try {
      return Convert<std::optional<T>>::get(L_, lua_gettop(L_));
    } catch (const Mismatch& mismatch) {
      throw std::invalid_argument(std::string(key) + ": " + mismatch.what());
    }
  }
  /// Which of some words the option is; the first is the default.
  std::size_t word(const char* key, const std::vector<std::string>& words) const;
  /// Pushes the option (nil where it is not given).
  void push(const char* key) const { lua_getfield(L_, index_, key); }

 private:
  lua_State* L_;
  int index_;
};

}  // namespace rotor::script
