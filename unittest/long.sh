#!/usr/bin/env bash
# A long run: a fluidised bed for a million granular steps without drift of mass, of memory or of the
# balance of momentum.
#
#   unittest/long.sh LMP FOLDER [STEPS]    STEPS: granular steps (1000000)
#
# Works in FOLDER, on 2 ranks.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

lmp=$1 folder=$2 steps=${3:-1000000}
run_environment
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
cp "$root/examples/fluidised_bed/in.fluidised_bed" .

# the example writes every 880 steps, once for each d/U_t
every=880
mpirun -np 2 "$lmp" -in in.fluidised_bed -log none -var rest 10 -var mean $((steps / every)) > screen.txt &
job=$!
while kill -0 $job 2>/dev/null; do    # memory in use, kB, of both ranks
  { cat /proc/[0-9]*/stat 2>/dev/null || true; } |
    awk -v parent=$job '$4 == parent { pages += $24; n++ } END { if (n == 2) print 4 * pages }' >> memory.txt
  sleep 1
done
wait $job || { tail -n 20 screen.txt; die "the run failed"; }

awk '
  /^fluidised_bed solid fraction/ { solid = $4 + 0; fall = $8 / 1000 }
  $1 == "Step" { on = 1; next }
  /^Fix lb\/ibb: .* fluid steps/ { on = 0 }
  on && NF == 8 { step[++n] = $1; slip[n] = $3; beads[n] = $4; water[n] = $5; loss[n] = $7 }
  function tenth(k,   i, sum, m) {    # mean momentum of the whole per volume in the k-th tenth
    for (i = int(n * (k - 1) / 10) + 1; i <= int(n * k / 10); i++) {
      sum += 1000 * water[i] + 2500 * solid * beads[i]
      m++
    }
    return sum / m
  }
  function gate(name, value, most) {
    printf "%s %.3g, at most %g\n", name, value, most
    if (!(value * value <= most * most)) bad++
  }
  END {
    if (n < 20) { print "too few lines: " n; exit 1 }
    fluid_steps = (step[n] - step[1]) / 5
    printf "%d granular steps, %d fluid steps\n", step[n], fluid_steps
    gate("drift of mass per 1000 fluid steps", (loss[n] - loss[1]) / fluid_steps * 1000, 1e-6)
    # a drift of the whole, of the velocity between water and beads; what is on its way between the two
    # is not in it, but stays as it is
    whole = 2500 * solid + 1000 * (1 - solid)
    gate("drift of the whole / U", (tenth(10) - tenth(2)) / (whole * slip[n] * fall), 0.05)
    exit bad > 0
  }' screen.txt
awk '{ m[NR] = $1 }
  END {
    if (NR < 10) { print "memory: too few samples"; exit 1 }
    early = m[int(NR / 5) + 1]; late = m[NR - 1]
    printf "memory of both ranks: %.1f MiB after a fifth, %.1f MiB at the end\n", early / 1024, late / 1024
    exit !(late <= 1.01 * early)
  }' memory.txt
