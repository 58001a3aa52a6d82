#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f ensemble*.dat

seeds="1 2 3 4"
if [ "$size" = full ]; then seeds=$(seq -s ' ' 1 24); fi
mpirun -np 2 "$LMP" -partition 2x1 -log none -plog none -pscreen none -in in.ensemble -var list "$seeds" > screen.txt ||
  { tail -n 20 screen.txt; exit 1; }
# the first one alone, without partitions: the same number
"$LMP" -log none -screen none -in in.ensemble -var list 1 -var out ensemble-alone.dat
python3 check.py "$size"
