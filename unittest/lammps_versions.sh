#!/usr/bin/env bash
# Long test: the quick tests with another version of LAMMPS than the usual one.
#
#   unittest/lammps_versions.sh VERSION      one that cmake/get_lammps.sh knows
#
# Exit status 77, which ctest counts as skipped, when that version cannot be obtained.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

if ! LAMMPS_DIR=$("$root/cmake/get_lammps.sh" "$1"); then
  echo "LAMMPS $1: Skipped"    # ./test shows what stands between this line and the last
  echo "LAMMPS $1 cannot be obtained: LBM-IBB is NOT TESTED with it"
  echo "[  SKIPPED ]"
  exit 77
fi
export LAMMPS_DIR    # gives ./test a build folder of its own
export LBMIBB_NO_INSTALL=1
exec "$root/test"
