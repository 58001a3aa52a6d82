#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
# cores: 1
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f ./*.dat ./*.grid ./*.series

# flow NAME OPTIONS...   one run on one rank
flow() {
  local name=$1; shift
  "$LMP" -in in.cylinder_channel -log none -var out "$name" "$@" > screen.txt || { tail -n 20 screen.txt; exit 1; }
}
for cells in 10 20; do flow steady$cells -var cells $cells; done
flow staircase20 -var link halfway
flow street20 -var case 2 -var tau 0.53 -var seconds 13 -var gather 3
if [ "$size" = full ]; then
  flow steady40 -var cells 40
fi
python3 check.py "$size"
