#!/usr/bin/env bash
# What lb/plan predicts against what examples give, on the scenes of examples/plan/scenes.txt:
# unittest/plan.sh LMP FOLDER quick|full
#
# quick: errors of the two that are small; full: all errors, and seconds. Works in FOLDER.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

lmp=$1 folder=$2 size=$3
run_environment
rm -rf "$folder"
cp -r "$root/examples/plan" "$folder"
rm -f "$folder"/log.*
cd "$folder"
here=$PWD

# example RANKS NAME RUN OPTIONS...   an example, in its own folder; its log and tables come here
example() {
  (cd "$root/examples/$2" &&
    mpirun -np "$1" "$lmp" -in "in.$2" -log "$here/log.$3" "${@:4}" > "$here/screen.txt" 2>&1) ||
    { tail -n 20 screen.txt; die "lmp failed: $*"; }
}

# Seconds are compared as medians of three, each run with its prediction right after it: what else the machine has to
# do changes in between.
times=1
if [ "$size" = full ]; then times=3; fi
array=(-var phi 0.3 -var table "$here/array.dat")
for k in $(seq "$times"); do
  example 2 permeability "bed.$k" -var pack pack-45.data -var cells 8.3333333333333 -var table "$here/bed.dat"
  example 1 periodic_arrays "array.$k" "${array[@]}" -var cells 10
  example 1 periodic_arrays "array-fine.$k" "${array[@]}" -var cells 32 -var places 1
  if [ "$size" = full ]; then
    example 2 settling_sphere "sphere.$k" -var case E3 -var cells 9 -var out "$here/sphere"
  fi
  python3 check.py "$size" times > times.txt
  while read -r ranks scene time options; do
    read -r -a words <<< "$options"
    mpirun -np "$ranks" "$lmp" -in in.scenes -log none -var scene "$scene" -var time "$time" \
      "${words[@]}" > screen.txt 2>&1 < /dev/null || { tail -n 20 screen.txt; die "no plan of $scene"; }
    if [ "$k" = 1 ]; then grep -A 20 '^lb/plan: ' screen.txt; fi
  done < times.txt
done
python3 check.py "$size"
