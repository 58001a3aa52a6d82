#!/usr/bin/env bash
# The runs behind figures 10 and 11: figure.sh quick|full, with $LMP the path of lmp.
#   quick  coarse lattice (5 cells per radius) at Ma < 0.1, and the article's own case until 2.6 s
#   full   default, twice finer, and the article's rules at its tau and at Ma < 0.1
# Two runs at a time, one rank each: two discs need many small steps, and ranks would wait for them.
set -euo pipefail
rm -f ./{dkt2d,fine,coarse,paper,paper-slow}.dat ./*.grid
run() {    # run NAME option...
  local name=$1; shift
  "$LMP" -in in.dkt2d -log "log.$name" -screen none -var out "$name" "$@" </dev/null ||
    { tail -n 3 "log.$name" >&2; exit 1; }
}
case ${1:-} in
  quick)
    run paper -var tau 0.75 -var scheme paper -var last 2.6 &
    run coarse -var dx 0.02 -var tau 0.54 -var last 3.4 -var fields yes ;;
  full)
    run fine -var dx 0.005 -var tau 0.65 -var last 2.8 &
    run dkt2d -var fields yes
    run paper -var tau 0.75 -var scheme paper
    run paper-slow -var scheme paper ;;
  *) echo "figure.sh quick|full" >&2; exit 2 ;;
esac
wait $!
python3 check.py "$1"
