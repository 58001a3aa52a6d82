#!/usr/bin/env bash
# The script of doc/src/Howto_lbm_ibb.rst must run as it is printed: unittest/howto.sh LMP FOLDER
#
# Steady seepage hands the pressure's force to the grains, and a bed of spheres conducts as beds do.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

lmp=$1 folder=$2
run_environment
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
# from "# in.bed" to the first line that is not indented
sed -n '/^   # in\.bed/,/^[^ ]/p' "$root/doc/src/Howto_lbm_ibb.rst" | sed -n 's/^   //p;s/^$//p' > in.bed
[ "$(wc -l < in.bed)" -gt 50 ] || die "no script in the Howto"
"$lmp" -in in.bed -log none > screen.txt || { tail -n 5 screen.txt; die "in.bed failed"; }
if grep WARNING screen.txt; then die "in.bed warns"; fi
grep '^in.bed' screen.txt
awk '
  /^in.bed: flux/ { sub(",", "", $6); carried = $6 }
  /^in.bed: permeability/ { k = $3; carman = $6 }
  END { exit !(carried > 0.997 && carried < 1.003 && k > 0.85 * carman && k < 1.15 * carman) }' screen.txt ||
  die "carried must be 1 within 0.003, and k that of Carman-Kozeny within 15 %"
