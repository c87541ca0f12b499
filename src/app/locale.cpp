#include "app/locale.hpp"

#include <clocale>

namespace rotor::app {
namespace {

int set_locale(lua_State* L) {
  static const int categories[] = {LC_ALL, LC_COLLATE, LC_CTYPE, LC_MONETARY, LC_NUMERIC, LC_TIME};
  static const char* const names[] = {"all",     "collate", "ctype", "monetary",
                                      "numeric", "time",    nullptr};
  const char* locale = luaL_optstring(L, 1, nullptr);
  const int category = categories[luaL_checkoption(L, 2, "all", names)];
  const bool accepted = std::setlocale(category, locale) != nullptr;
  std::setlocale(LC_NUMERIC, "C");
  lua_pushstring(L, accepted ? std::setlocale(category, nullptr) : nullptr);
  return 1;
}

}  // namespace

void keep_numbers_plain(lua_State* L) {
  lua_getglobal(L, LUA_OSLIBNAME);
  lua_pushcfunction(L, set_locale);
  lua_setfield(L, -2, "setlocale");
  lua_pop(L, 1);
}

UserCharacters::UserCharacters() : before_(std::setlocale(LC_CTYPE, nullptr)) {
  std::setlocale(LC_CTYPE, "");
}

UserCharacters::~UserCharacters() { std::setlocale(LC_CTYPE, before_.c_str()); }

}  // namespace rotor::app
