#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
# cores: 1
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f shear_sphere.dat

shear() { "$LMP" -in in.shear_sphere -log none "$@" > screen.txt || { tail -n 20 screen.txt; exit 1; }; }

# the mean over places on the lattice counts
places() { for shift in 0 0.2 0.4 0.6; do shear -var shift $shift "$@"; done; }

for ratio in 5 6 8; do places -var r 4 -var ratio $ratio; done
if [ "$size" = full ]; then
  places -var r 3.08
  places -var r 5.5
  places -var r 8
  places -var r 4 -var ratio 12
  places -var r 4 -var hold yes
  for Re in 0.1 0.2 0.5 1.0; do shear -var r 4 -var Re $Re -var tau 0.7; done
fi
python3 check.py "$size"
