#!/usr/bin/env bash
# The runs behind figures 13 to 15: figure.sh quick|full, with $LMP the path of lmp.
#   quick  width/200: i = 0.9 and 1.1 i_c
#   full   width/400, as in the article; also 1.0, the lowest gradient that, held for 0.78 s, lifts the
#          bed, and a hundredth less
# Two runs at a time, one rank each: the sub-steps of 300 discs leave ranks little to share.
set -euo pipefail
rm -f ./*.dat ./*.profile ./*.grains
run() {    # run NAME option...
  local name=$1; shift
  "$LMP" -in in.quicksand2d -log "log.$name" -screen none -var out "$name" "$@" </dev/null ||
    { tail -n 3 "log.$name" >&2; exit 1; }
  grep '^quicksand2d' "log.$name"
}
case ${1:-} in
  quick)
    run i110 -var cells 200 -var ratio 1.1 -var hold 0.26 &
    run i090 -var cells 200 -var ratio 0.9 -var hold 0.195 -var still 0.065 ;;
  full)
    {
      run low -var cells 400 -var ratio 0.97 -var hold 0.78
      run i100 -var cells 400 -var ratio 1.0 -var hold 0.325
    } &
    run below -var cells 400 -var ratio 0.96 -var hold 0.78
    run i110 -var cells 400 -var ratio 1.1 -var hold 0.26
    run i090 -var cells 400 -var ratio 0.9 -var hold 0.39 -var still 0.195 ;;
  *) echo "figure.sh quick|full" >&2; exit 2 ;;
esac
wait $!
python3 check.py "$1"
