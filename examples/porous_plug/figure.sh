#!/usr/bin/env bash
# figure.sh quick|full: run $LMP as often as the figure needs, in the folder of this file, and check.
# cores: 1
set -euo pipefail
cd "$(dirname "$0")"
rm -f porous_plug.dat

plug() { "$LMP" -in in.porous_plug -log none "$@" > screen.txt || { tail -n 20 screen.txt; exit 1; }; }
for conserve in yes no; do
  for solid in region grains; do plug -var solid $solid -var conserve $conserve; done
done
plug -var sand 1
python3 check.py
