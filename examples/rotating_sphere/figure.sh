#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
# cores: 1
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f rotating_sphere.dat

spin() { "$LMP" -in in.rotating_sphere -log none "$@" > screen.txt || { tail -n 20 screen.txt; exit 1; }; }

for r in 3.08 4 5.5; do spin -var r $r; done
spin -var r 4 -var tau 0.8
spin -var r 4 -var tau 0.8 -var link bouzidi -var collision bgk
if [ "$size" = full ]; then
  spin -var r 8
  spin -var r 11 -var places 2
  for ratio in 3 4 8 12; do spin -var r 4 -var ratio $ratio; done
  for tau in 0.6 1.5; do
    spin -var r 4 -var tau $tau
    spin -var r 4 -var tau $tau -var link bouzidi -var collision bgk
  done
fi
python3 check.py "$size"
