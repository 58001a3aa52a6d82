#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
# cores: 1
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f fluidised_bed*.dat

bed() { "$LMP" -in in.fluidised_bed -log none "$@" > screen.txt || { tail -n 20 screen.txt; exit 1; }; }

if [ "$size" = quick ]; then
  for phi in 0.1 0.3; do bed -var phi $phi -var box 4 -var rest 4 -var mean 8; done
else
  for phi in 0.1 0.2 0.3 0.4; do
    for seed in 1 2; do bed -var phi $phi -var seed $seed; done
  done
fi
python3 check.py "$size"
