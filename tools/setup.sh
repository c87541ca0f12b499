# What tools/run, tools/test and .ci/run share: the Debian packages and the Release build in build/.
# Sourced with $root set to the repository. Nothing here reads stdin or writes stdout: both are rotor's.

build_packages='g++ cmake ninja-build pkgconf libeigen3-dev liblua5.4-dev libreadline-dev'
test_packages="$build_packages catch2 libboost-dev gnuplot-nox"

say() { printf 'rotor: %s\n' "$*" >&2; }

# fail LOG MESSAGE...: the end of the log, then the message, which so stays in sight.
fail() {
  log=$1
  shift
  tail -n 40 "$log" >&2
  say "$*; all of it is in $log"
  exit 1
}

may_sudo() {
  command -v sudo >/dev/null || return 1
  sudo -n true 2>/dev/null </dev/null || { [ -t 2 ] && say "sudo installs:$missing" && sudo -v; }
}

apt_get() {
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@" \
    </dev/null >>"$apt_log" 2>&1
}

# need PACKAGE...: installs those that are missing.
need() {
  command -v dpkg-query >/dev/null || return 0 # not a Debian: CMake will name what it misses
  have=$(dpkg-query -W -f '${Package}=${db:Status-Status} ' "$@" 2>/dev/null) || :
  missing=
  for package; do
    case " $have" in
    *" $package=installed "*) ;;
    *) missing="$missing $package" ;;
    esac
  done
  [ -n "$missing" ] || return 0

  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    if ! may_sudo; then
      say 'Debian packages are missing. As root (on a fresh machine after an apt-get update), run'
      printf '\napt-get install --no-install-recommends%s\n\n' "$missing" >&2
      exit 1
    fi
    as_root=sudo
  fi
  say "installing$missing"
  mkdir -p "$root/build"
  apt_log=$root/build/apt.log
  : >"$apt_log"
  apt_get update || : # a server that is down matters only if a package is then not to be had
  apt_get install -y --no-install-recommends $missing && return
  if grep -q 'Failed to fetch' "$apt_log"; then
    say "cannot reach Debian's package servers: is there a network? (see $apt_log) needed:$missing"
    exit 1
  fi
  fail "$apt_log" "apt-get could not install$missing"
}

cached() { grep -qxF "$1" build/CMakeCache.txt 2>/dev/null; }

# On a terminal the count of ninja's steps, elsewhere one line, and neither if there is nothing to do.
show_steps() {
  shown=
  while IFS= read -r line; do
    case $line in
    \[[1-9]*/*\]*)
      if [ -t 2 ]; then
        printf '\rrotor: building %s]' "${line%%]*}" >&2
      elif [ -z "$shown" ]; then
        printf 'rotor: building' >&2
      fi
      shown=yes
      ;;
    esac
  done
  [ -z "$shown" ] || echo >&2
}

# build TARGET ON|OFF: brings the target up to date in build/, with the tests configured or not. A tree that
# has the tests keeps them: going to and fro between tools/run and tools/test configures nothing anew.
build() (
  cd "$root"
  log=$root/build/build.log
  mkdir -p build
  # The tree of another directory or generator, or one that was never completed, starts afresh.
  [ -f build/build.ninja ] && cached "CMAKE_HOME_DIRECTORY:INTERNAL=$root" || rm -f build/CMakeCache.txt
  if ! cached CMAKE_BUILD_TYPE:STRING=Release || { [ "$2" = ON ] && ! cached BUILD_TESTING:BOOL=ON; }; then
    cmake --preset release -DBUILD_TESTING="$2" </dev/null >"$log" 2>&1 ||
      fail "$log" 'CMake could not configure the build'
  fi
  # The status of ninja comes out of the pipe by way of descriptor 3.
  status=$({ { ninja -C build "$1" </dev/null 2>&1 || echo "$?" >&3; } | tee "$log" | show_steps; } 3>&1)
  [ -z "$status" ] || fail "$log" 'the build failed'
)
