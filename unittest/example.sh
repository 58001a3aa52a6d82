#!/usr/bin/env bash
# An example must reach its reference: unittest/example.sh LMP FOLDER NAME quick|full
#
# Runs its figure.sh in a copy in FOLDER; every "name value low high" of results.txt must be inside.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

export LMP=$1
folder=$2 name=$3 size=$4
run_environment
rm -rf "$folder"
cp -r "$root/examples/$name" "$folder"
cd "$folder"
bash figure.sh "$size" > figure.log 2>&1 || { tail -n 30 figure.log; die "figure.sh failed"; }
cat results.txt
awk '
  function number(x) { return x ~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/ }
  NF < 4 || !number($2) { print "no number: " $0; bad++; next }
  $3 != "-" && $2 + 0 < $3 + 0 { print $1 " = " $2 " is below " $3; bad++ }
  $4 != "-" && $2 + 0 > $4 + 0 { print $1 " = " $2 " is above " $4; bad++ }
  $3 != "-" || $4 != "-" { gates++ }
  END { if (!gates) print "no gate at all"; exit bad > 0 || !gates }' results.txt
