#!/usr/bin/env bash
# Long test: what compilers and checkers say of our sources.
#
#   unittest/lint.sh LAMMPS-TREE EIGEN warnings | tidy | cppcheck
#
#   warnings   -Wall -Wextra -Wconversion: none; in LAMMPS's and Eigen's headers they do not count
#   tidy       clang-tidy with the checks of .clang-tidy
#   cppcheck   all of its checks but style that LAMMPS's own interfaces impose
#
# ctest counts it as skipped (exit status 77) where the checker is not installed.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

tree=$1 eigen=$2 what=$3
cd "$root"
# $TMPDIR or /tmp: checkers read a file at a time and leave nothing
mpi=()
for flag in $(mpicxx --showme:compile 2>/dev/null || mpicxx -compile_info | cut -d' ' -f2-); do
  if [[ $flag == -I* ]]; then mpi+=(-isystem "${flag#-I}"); fi
done
flags=(-std=c++17 -DEIGEN_MAX_ALIGN_BYTES=16 -I src/LBM-IBB
  -isystem "$tree/src" -isystem "$tree/src/GRANULAR" -isystem "$eigen" "${mpi[@]}")
needs() {
  have "$1" || {
    echo "SKIPPED: no $1 here"
    exit 77
  }
}
each() { printf '%s\n' src/LBM-IBB/*.cpp | xargs -P "$(nproc)" -I{} "$@"; }

case $what in
  warnings)
    # optimised: some warnings follow the flow of values
    each "${CXX:-c++}" "${flags[@]}" -O2 -S -o /dev/null -Wall -Wextra -Wconversion -Werror {} ;;
  tidy)
    needs clang-tidy
    # a diagnostic for what the compiler itself says is no check of ours
    each clang-tidy --quiet --warnings-as-errors='*' {} -- "${flags[@]}" 2>/dev/null ;;
  cppcheck)
    needs cppcheck
    cppcheck --std=c++17 --language=c++ --enable=warning,performance,portability --inline-suppr \
      --error-exitcode=1 --quiet -j "$(nproc)" -D__x86_64__ -I src/LBM-IBB \
      --suppress=missingInclude --suppress=missingIncludeSystem --suppress=unknownMacro \
      src/LBM-IBB ;;
  *) die "lint.sh knows warnings, tidy and cppcheck, not '$what'" ;;
esac
