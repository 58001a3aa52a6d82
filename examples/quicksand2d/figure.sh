#!/bin/bash
# Figures 13-15 of the article: figure.sh quick|full, in a copy of this folder; LMP is lmp.
# quick: width/200, i = 0.9 and 1.1 i_c. full: width/400, also 1.0 and a slow rise until the bed lifts.
set -e
run() { # name, options
  local name=$1
  shift
  mpirun -np "${NP:-2}" "$LMP" -in in.quicksand2d -var out "$name" -log "log.$name" "$@" >"$name.out" 2>&1 ||
    { tail -3 "$name.out"; exit 1; }
  tail -2 "$name.out"
}
case ${1:-quick} in
  quick)
    run i090 -var cells 200 -var ratio 0.9 -var hold 0.195 -var still 0.065
    run i110 -var cells 200 -var ratio 1.1 -var hold 0.26
    ;;
  full)
    run i090 -var cells 400 -var ratio 0.9 -var hold 0.39 -var still 0.195
    run i110 -var cells 400 -var ratio 1.1 -var hold 0.26
    run i100 -var cells 400 -var ratio 1.0 -var hold 0.325
    run low -var cells 400 -var start 0.95 -var rate 0.1 -var after 0.39
    ;;
  *) echo "figure.sh quick|full" && exit 2 ;;
esac
python3 check.py "${1:-quick}"
