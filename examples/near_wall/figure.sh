#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
# cores: 1
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f near_wall.dat

near() { "$LMP" -in in.near_wall -log none "$@" > screen.txt || { tail -n 20 screen.txt; exit 1; }; }

for film in yes no; do
  near -var film $film
  for gap in 0.8 0.3 0.1 0.03; do near -var film $film -var slide yes -var gap $gap; done
done
if [ "$size" = full ]; then
  for r in 4 9; do near -var r $r; done
  for link in bouzidi halfway; do near -var link $link; done
fi
python3 check.py
