#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
# cores: 1
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f permeability.dat

# bed OPTIONS...   one run on one rank
bed() { "$LMP" -in in.permeability -log none "$@" > screen.txt || { tail -n 20 screen.txt; exit 1; }; }

article=(-var link bouzidi -var collision bgk)
for tau in 0.6 1.0 1.5; do bed -var tau $tau; done
for tau in 0.6 1.0; do bed -var tau $tau "${article[@]}"; done
for count in 36 45; do bed -var pack pack-$count.data; done
if [ "$size" = full ]; then
  for tau in 0.55 0.8 2.0; do bed -var tau $tau; done
  for tau in 0.55 0.8 1.5 2.0; do bed -var tau $tau "${article[@]}"; done
  for tau in 0.55 0.6 0.8 1.0 1.5 2.0; do bed -var tau $tau -var link bouzidi; done
  for cells in 15 20; do
    for count in 36 45 54; do bed -var pack pack-$count.data -var cells $cells; done
  done
fi
python3 check.py "$size"
