// Goal 8.
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "measure.hpp"

extern char** environ;

namespace rotor::bench {
namespace {

/// Wall milliseconds from start to end of `program -e ""`.
double start(const char* program) {
  const std::string words[] = {program, "-e", ""};
  char* arguments[] = {const_cast<char*>(words[0].c_str()), const_cast<char*>(words[1].c_str()),
                       const_cast<char*>(words[2].c_str()), nullptr};
  const auto begin = std::chrono::steady_clock::now();
  pid_t child = 0;
  int status = 0;
  if (posix_spawnp(&child, program, nullptr, nullptr, arguments, environ) != 0 ||
      waitpid(child, &status, 0) != child || status != 0) {
    throw std::runtime_error(std::string("cannot run ") + program + " -e \"\"");
  }
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

}  // namespace

void judge_start_up(std::size_t starts, Goals& goals) {
  std::vector<double> rotor;
  std::vector<double> lua;
  rotor.reserve(starts);
  lua.reserve(starts);
  for (std::size_t i = 0; i < starts; ++i) {
    rotor.push_back(start(ROTOR_BINARY));
    lua.push_back(start("lua5.4"));
  }
  const double lua_ms = median(lua);
  const double rotor_ms = median(rotor);
  std::printf("\nstart-up, wall ms, medians of %zu: rotor %s, lua5.4 %s\n", starts,
              three_digits(rotor_ms).c_str(), three_digits(lua_ms).c_str());
  goals.at_most(8, "ms to start and end, lua5.4 takes " + three_digits(lua_ms), rotor_ms,
                2 * lua_ms + 3);
}

}  // namespace rotor::bench
