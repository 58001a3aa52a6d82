# shellcheck shell=bash
# What ./run, ./test and get_lammps.sh share: messages, the cache folder, the packages of
# the machine, configuring and building.  Sourced by bash with "set -euo pipefail".
#
# Environment, all optional:
#   LAMMPS_DIR             LAMMPS source tree of yours to build with
#   LBMIBB_LAMMPS_URL      archive of LAMMPS's sources to build with; file:// works
#   LBMIBB_CACHE           folder of downloads and builds (default: ~/.cache/lbm-ibb)
#   LBMIBB_CMAKE_OPTIONS   options for cmake, e.g. "-D LBMIBB_ARCH=none -D PKG_VTK=ON"
#   LBMIBB_NO_INSTALL=1    take the machine as it is: look for no packages, install none
#   LBMIBB_JOBS            compilers at once (default: number of cores)
#   LBMIBB_DEBIAN_MIRROR   Debian archive to take LAMMPS from (default: the system's)

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# progress goes to standard error: standard output belongs to lmp and to --which
say() { printf '== %s\n' "$*" >&2; }
die() {
  printf 'Error: %s\n' "$*" >&2
  exit 1
}
have() { command -v "$1" >/dev/null; }

cache_folder() {
  local folder=${LBMIBB_CACHE:-${XDG_CACHE_HOME:-${HOME:?}/.cache}/lbm-ibb}
  mkdir -p "$folder"
  (cd "$folder" && pwd)
}

# lock FILE ... unlock: one process at a time; the lock must not outlive us in a child
lock() {
  have flock || return 0
  exec 9> "$1"
  flock --nonblock 9 || {
    say "waiting for another build to finish ($1)"
    flock 9
  }
}
unlock() { exec 9>&-; }

# ---- packages of the machine -------------------------------------------------------------

# Debian's names of what is missing.  Programs and headers are looked for, not packages:
# they may come from elsewhere.
missing_packages() {    # required | optional
  if [ "$1" = required ]; then
    have cmake || echo cmake
    have ninja || echo ninja-build
    have "${CXX:-c++}" || echo g++
    have mpicxx || echo libopenmpi-dev
    have mpirun || echo openmpi-bin
    have python3 || echo python3
    have xz || echo xz-utils
    missing_headers Eigen/Core eigen3/Eigen/Core libeigen3-dev
  else
    have ccache || echo ccache
    missing_headers png.h libpng/png.h libpng-dev \
      gtest/gtest.h gtest/gtest.h libgtest-dev \
      benchmark/benchmark.h benchmark/benchmark.h libbenchmark-dev
  fi
}

# missing_headers {HEADER OTHER-PLACE PACKAGE}...   one call of the preprocessor for all
missing_headers() {
  have "${CXX:-c++}" || {
    while [ $# -ge 3 ]; do
      echo "$3"
      shift 3
    done
    return 0
  }
  while [ $# -ge 3 ]; do
    printf '#if !__has_include(<%s>) && !__has_include(<%s>)\nmissing %s\n#endif\n' "$1" "$2" "$3"
    shift 3
  done | "${CXX:-c++}" -std=c++17 -E -P -x c++ - | sed -n 's/^missing //p'
}

# install PACKAGE...   false when we may not, or it does not work
install_packages() {
  local as_root=()
  [ $# != 0 ] || return 0
  have apt-get || return 1
  if [ "$(id -u)" != 0 ]; then
    { have sudo && sudo -n true 2>/dev/null; } || return 1
    as_root=(sudo -n)
  fi
  say "installing $*"
  {
    "${as_root[@]}" apt-get -q update || true    # an unreachable extra source is no obstacle
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get -q install -y --no-install-recommends "$@"
  } >&2 </dev/null || {
    say "apt-get could not install: $*"
    return 1
  }
}

# installed PACKAGE   as far as Debian's package manager knows, if there is one
installed() {
  have dpkg-query || return 0
  [ "$(dpkg-query --show --showformat '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# prepare_machine [PACKAGE...]   installs what is missing, or says what that is and stops;
# the packages named are needed beyond those that building always needs (?NAME: only wanted)
prepare_machine() {
  [ -z "${LBMIBB_NO_INSTALL:-}" ] || return 0
  local required optional extra
  mapfile -t required < <(missing_packages required)
  mapfile -t optional < <(missing_packages optional)
  for extra in "$@"; do
    if installed "${extra#\?}"; then continue; fi
    if [[ $extra == \?* ]]; then optional+=("${extra#\?}"); else required+=("$extra"); fi
  done
  if [ $((${#required[@]} + ${#optional[@]})) = 0 ]; then return; fi
  if install_packages "${required[@]}" "${optional[@]}"; then return; fi
  if [ ${#required[@]} != 0 ] && ! install_packages "${required[@]}"; then
    die "these are missing, and cannot be installed from here (that takes apt, and root or" \
      "passwordless sudo). Install them, or what your system calls them:" \
      $'\n\n   sudo apt-get install' "${required[@]}" "${optional[@]}" \
      $'\n\nIf all is there in unusual places, set LBMIBB_NO_INSTALL=1 (and CMAKE_PREFIX_PATH).'
  fi
  say "going on without ${optional[*]} (for pictures, tests, benchmarks, fast rebuilds)"
}

# ---- building ----------------------------------------------------------------------------

# The build folder: outside the clone, one for each clone, LAMMPS tree, set of options,
# compiler and processor (the home folder may be shared by machines that differ).
build_folder() {
  local key
  key=$({
    echo "$root:${LAMMPS_DIR:-}:${LBMIBB_LAMMPS_URL:-}:${LBMIBB_CMAKE_OPTIONS:-}"
    "${CXX:-c++}" -march=native -x c++ -E -v - 2>&1 </dev/null || true
  } | sha256sum)
  echo "$(cache_folder)/build/$(basename "$root")-${key:0:10}"
}

# build TARGET...   configures when need be; sets $build
build() {
  build=$(build_folder)
  mkdir -p "$build"
  lock "$build/lock"
  local options=(-G Ninja -S "$root" -B "$build") state
  # shellcheck disable=SC2206  # options are words
  options+=(${LBMIBB_CMAKE_OPTIONS:-})
  # what CMake finds on the machine may have changed since
  state="${options[*]}: without $(missing_packages optional | tr '\n' ' ')"
  if have ffmpeg; then state+=' with ffmpeg'; fi
  if [ ! -e "$build/build.ninja" ] || [ "$state" != "$(cat "$build/state" 2>/dev/null)" ]; then
    say "configuring in $build"
    # pictures and movies: LAMMPS keeps what it found the first time, and must look again
    LBMIBB_CACHE=$(cache_folder) cmake -U WITH_PNG -U WITH_FFMPEG "${options[@]}" >&2 9>&-
    echo "$state" > "$build/state"
    say "building; the first time takes some minutes"
  fi
  NINJA_STATUS='[%f/%t, %es] ' ninja -C "$build" -j "${LBMIBB_JOBS:-$(nproc)}" "$@" >&2 9>&-
  unlock
}

# the environment in which LAMMPS is started; what the user has set stays
run_environment() {
  local name value
  while IFS='=' read -r name value; do
    case $name in '#'* | '') continue ;; esac
    export "$name=${!name:-$value}"
  done < "$root/cmake/mpi.env"
  export LAMMPS_POTENTIALS="$root/potentials${LAMMPS_POTENTIALS:+:$LAMMPS_POTENTIALS}"
}
