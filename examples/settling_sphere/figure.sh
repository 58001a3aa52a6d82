#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
set -euo pipefail
cd "$(dirname "$0")"
size=${1:-quick}
rm -f settling-*.dat
run() { mpirun -np 2 "$LMP" -in in.settling_sphere -log "log.$2.$4" -var case "$2" -var cells "$4" > "screen.$2.$4"; }

if [ "$size" = quick ]; then
  run case E4 cells 9
else
  for case in E4 E3 E2 E1; do run case "$case" cells 15; done
fi
python3 check.py "$size"
