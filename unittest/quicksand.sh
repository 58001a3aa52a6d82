#!/usr/bin/env bash
# What the quicksand example must show, on 2 ranks.
#
#   unittest/quicksand.sh LMP FOLDER steady          water carries dp S within 0.1 %
#   unittest/quicksand.sh LMP FOLDER hold            held at 0.90 i_c the bed stays, at 1.10 it goes
#   unittest/quicksand.sh LMP FOLDER ramp SEED       the bed lifts between 0.85 and 1.03 i_c
#   unittest/quicksand.sh LMP FOLDER lighter         the same, in dp/(rho_s - rho), for lighter grains
#
# Works in FOLDER.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

lmp=$1 folder=$2 case=$3 seed=${4:-}
run_environment
rm -rf "$folder"
cp -r "$root/examples/quicksand" "$folder"
cd "$folder"

# water OPTIONS...   run the example; its words go to $said
water() {
  local file=run-$#-${*: -1}.txt
  mpirun -np 2 "$lmp" -in in.quicksand -log none -var watch 100 "$@" > "$file" 2>&1 || { tail -n 30 "$file"; die "lmp failed: $*"; }
  said=$(grep -E '^(steady|quicksand|wall)' "$file")
  echo "$*: $said"
  # density range beyond the imposed one, in per cent, while the bed stands (later grains collide)
  read -r peak looks < <(awk '
    /^ *Step .*v_beyond/ { for (c = 1; c <= NF; c++) at[$c] = c; read = 1; next }
    $1 !~ /^[0-9]+$/ { read = 0 }
    read && $at["v_rise"] < 0.05 { n++; if ($at["v_beyond"] > most) most = $at["v_beyond"] }
    END { print (n ? most + 0 : "none"), n + 0 }' "$file")
  echo "density range beyond the imposed one: at most $peak % in $looks looks"
}

# within LOW VALUE HIGH WHAT
within() {
  awk -v low="$1" -v value="$2" -v high="$3" 'BEGIN { exit !(value ~ /^[-+0-9.e]+$/ && value + 0 >= low + 0 && value + 0 <= high + 0) }' ||
    die "$4 = $2 is not between $1 and $3"
}

# looked at every five fluid steps
density() {
  within 0 "$peak" 1.5 'density range beyond the imposed one, in per cent,'
}

carried() {
  within 0.999 "$(sed -n 's/.*dp S) = \([0-9.]*\).*/\1/p' <<< "$said")" 1.001 'sum F_z/(dp S)'
}

onset() {
  within 0.85 "$(sed -n 's/^quicksand onset i\/ic = //p' <<< "$said")" 1.03 'onset i/ic'
}

case $case in
  steady)
    water -var ratio 0.8 -var hold 0.01
    density
    carried
    [[ $said == *'bed still'* ]] || die "the bed moved at 0.8" ;;
  hold)
    water -var ratio 0.9
    density
    carried
    [[ $said == *'bed still'* ]] || die "the bed moved at 0.9"
    water -var ratio 1.1    # no bed that stands, so no gate on the density: grains collide all along
    [[ $said == *'bed moved'* ]] || die "the bed stayed at 1.1" ;;
  ramp)
    if [ -n "$seed" ]; then "$lmp" -in in.deposit -log none -var seed "$seed" > deposit.txt; fi
    water -var start 0.85
    density
    carried
    onset ;;
  lighter)
    water -var rho_s 1800
    density
    carried
    onset ;;
  *) die "unknown case $case" ;;
esac
