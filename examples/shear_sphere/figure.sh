#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f shear_sphere.dat

shear() { "$LMP" -in in.shear_sphere -log none "$@" > screen.txt || { tail -n 20 screen.txt; exit 1; }; }

for ratio in 5 6 8; do shear -var r 4 -var ratio $ratio; done
if [ "$size" = full ]; then
  for r in 3.08 5.5 8; do shear -var r $r; done
  shear -var r 4 -var shift 0.3
  shear -var r 4 -var ratio 12
  shear -var r 4 -var hold yes
  shear -var r 4 -var ratio 12 -var hold yes
  for Re in 0.1 0.2 0.5 1.0; do shear -var r 4 -var Re $Re -var tau 0.7; done
fi
python3 check.py "$size"
