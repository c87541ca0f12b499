// The locale: characters may follow it while a line is edited, numbers never do.
#pragma once

#include <lua.hpp>
#include <string>

namespace rotor::app {

/// Replaces os.setlocale by one that leaves LC_NUMERIC at "C" and answers what is then in effect.
void keep_numbers_plain(lua_State* L);

/// While it lives, characters are those of the user's locale.
class UserCharacters {
 public:
  UserCharacters();
  ~UserCharacters();
  UserCharacters(const UserCharacters&) = delete;
  UserCharacters& operator=(const UserCharacters&) = delete;

 private:
  std::string before_;
};

}  // namespace rotor::app
