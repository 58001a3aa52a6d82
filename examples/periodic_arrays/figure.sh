#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
# cores: 1
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f periodic_arrays.dat

# array OPTIONS...   one mean over places, on one rank
array() { "$LMP" -in in.periodic_arrays -log none "$@" > screen.txt || { tail -n 20 screen.txt; exit 1; }; }

# about 7.5 cells per diameter, times $1
sweep() {
  local phi cells
  while read -r phi cells; do array -var phi "$phi" -var cells $((cells * $1)); done <<< "0.027 20
0.064 15
0.125 12
0.216 10
0.343 9
0.45 8
0.5236 8"
}

sweep 1
for tau in 0.6 1.5; do
  array -var tau $tau
  array -var tau $tau -var link bouzidi
  array -var tau $tau -var link bouzidi -var collision bgk
done
if [ "$size" = full ]; then
  sweep 2
  array -var phi 0.008 -var cells 30
  array -var array bcc -var count 2 -var phi 0.027 -var cells 26
  array -var array fcc -var count 4 -var phi 0.027 -var cells 32
  for cells in 8 9 10 16 20 32 40; do array -var cells $cells; done
  for tau in 0.55 0.8 1.0; do
    array -var tau $tau
    array -var tau $tau -var link bouzidi
    array -var tau $tau -var link bouzidi -var collision bgk
  done
fi
python3 check.py "$size"
