#!/usr/bin/env bash
# The solver core on other processors of the kind: compiled for ARCH, it must equal the plain solver.
#
#   unittest/arch.sh FOLDER ARCH [FLAG...]    ARCH: x86-64 (no AVX), x86-64-v3 (AVX2), x86-64-v4
#
# ctest counts it as skipped (exit status 77) where this machine cannot run it.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

folder=$1 arch=$2
shift 2
needs=(x86-64:sse2 x86-64-v3:avx2 x86-64-v4:avx512vl)
for need in "${needs[@]}"; do
  if [ "$arch" = "${need%:*}" ] && ! grep -qw "${need#*:}" /proc/cpuinfo; then
    echo "SKIPPED: this processor has no ${need#*:}"
    exit 77
  fi
done
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

flags=(-std=c++17 "-march=$arch" "$@"
  -I "$root/src/LBM-IBB" -I "$root/unittest/testing")
printf '%s\n' "$root"/src/LBM-IBB/lbm_*.cpp "$root"/unittest/core/test_{reference,lattice,simd,planes,pockets}.cpp \
  "$root/unittest/testing/main.cpp" |
  xargs -P 2 -I{} mpicxx "${flags[@]}" -c {}
mpicxx ./*.o -o core -lgtest
./core --gtest_brief=1
