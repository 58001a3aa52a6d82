#!/usr/bin/env bash
# Onset of quicksand in three dimensions (figure 12 of the article): figure.sh quick|full
#
# quick: the shipped bed on a fast ramp. full: ten beds of different compactness, two of 400 grains,
# three ramp rates, and the lowest gradient that, held, triggers it.
set -euo pipefail
rm -f ./*-snapshot-*.png ./*.dat ./*.grid

# water NAME OPTIONS...   run the example; what it says goes to NAME.txt
water() {
  local name=$1
  shift
  echo "$name: $*"
  mpirun -np 2 "$LMP" -in in.quicksand -log none -var out "$name" "$@" -var after 0 > "$name.txt"    # of two the first counts
}

# deposit NAME SEED FRICTION [OPTIONS...]
deposit() {
  echo "bed $1: seed $2, friction $3"
  "$LMP" -in in.deposit -log none -var bed "$1.data" -var seed "$2" -var friction "$3" "${@:4}" > "$1.deposit.txt"
}

if [ "$1" = quick ]; then
  water rate-0.50 -var start 0.9 -var rate 0.5 -var snapshots 0.05 -var after 0.1
else
  seed=0
  for friction in 0.00 0.05 0.10 0.15 0.20 0.25 0.30 0.35 0.40 0.45; do
    seed=$((seed + 1))
    deposit "bed-$seed" $seed $friction
    water "bed-$seed" -var bed "bed-$seed.data" -var start 0.9
  done
  for seed in 1 2; do
    deposit "wide-$seed" $seed 0.3 -var grains 400 -var width 4.8e-3
    water "wide-$seed" -var bed "wide-$seed.data" -var start 0.9
  done
  for rate in 0.125 0.25 0.50; do    # the shipped bed
    water "rate-$rate" -var start 0.9 -var rate $rate
  done
  for ratio in 0.92 0.94 0.96 0.98 1.00; do
    water "hold-$ratio" -var ratio $ratio -var hold 0.4 -var snapshots 0.05
    if grep -q 'bed moved' "hold-$ratio.txt"; then break; fi
  done
fi
python3 check.py
