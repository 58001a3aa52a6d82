#!/usr/bin/env bash
# A run that is killed at any moment, also while it writes, goes on from its last complete pair of
# restart files, and ends as if nothing had happened.
#
#   unittest/restart.sh LMP FOLDER [KILLS]    KILLS: how often it is killed (50)
#
# Works in FOLDER, on 2 ranks.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
source "$(dirname "${BASH_SOURCE[0]}")/testing/killed.sh"

lmp=$1 folder=$2 kills=${3:-50}
run_environment
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

cat > in.grains <<'END_OF_GRAINS'
region box block 0 4.8e-3 0 4.8e-3 0 4.8e-3
create_box 1 box
create_atoms 1 single 4.7e-3 1.21e-3 1.33e-3
create_atoms 1 single 2.42e-3 0.1e-3 3.04e-3
create_atoms 1 single 1.13e-3 3.54e-3 2.45e-3
END_OF_GRAINS
: > in.output
write_scene

# sets found to the step of a pair of files, or to -1 if it is not complete
look_at() {
  found=-1
  [ -e "$1" ] || return 0
  if "$lmp" -in in.go_on -log none -var pair "$1" -var steps 0 -var upto "" > "read-$1.txt" 2>&1; then
    found=$(sed -n 's/^Fix lb\/ibb: goes on from .*, step \([0-9]*\), .*/\1/p' "read-$1.txt")
    [ -n "$found" ] || die "$1 was read without its fluid"
  elif ! grep -qE '^ERROR.*(cannot go on from|restart file)' "read-$1.txt"; then
    cat "read-$1.txt" >&2
    die "$1 is neither read nor refused"
  fi
}

# sets pair and step to the newest complete pair, step to -1 if there is none, and half to 1 if
# there is something that is not complete
look() {
  local name
  step=-1 half=0
  for name in one two; do
    look_at $name
    if [ "$found" -gt "$step" ]; then pair=$name step=$found; fi
    if [ -e $name.lbibb.part ] || { [ -e $name ] && [ "$found" = -1 ]; }; then half=1; fi
    rm -f $name.lbibb.part
  done
}

far=1000000 known=-1 caught=0 step=-1 pair=
RANDOM=4711
for ((k = 1; k <= kills; k++)); do
  if [ "$step" -ge 0 ]; then
    run_and_kill -in in.go_on -var pair "$pair" -var steps $far -var upto upto
  else
    run_and_kill -in in.run -var steps $far -var upto upto
  fi
  look
  [ "$step" -ge "$known" ] || die "step $known was complete, now there is only step $step"
  known=$step
  caught=$((caught + half))
done
[ "$known" -gt 0 ] || die "no pair was ever complete"
say "killed $kills times, $caught of them while it wrote; came to step $known"
[ "$caught" -gt 0 ] || die "it was never killed while it wrote"

last=$((known + 8))
on_2_ranks -in in.go_on -var pair "$pair" -var steps $last -var upto upto || die "cannot end"
mv last.lbibb killed.lbibb
on_2_ranks -in in.run -var steps $last -var upto upto || die "cannot run through"
cmp killed.lbibb last.lbibb || die "the fluid differs from that of a run that was not killed"
say "the fluid at step $last is that of a run that was not killed, bit for bit"
