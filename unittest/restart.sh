#!/usr/bin/env bash
# A run that is killed at any moment, also while it writes, goes on from its last complete pair of
# restart files, and ends as if nothing had happened.
#
#   unittest/restart.sh LMP FOLDER [KILLS]    KILLS: how often it is killed (50)
#
# Works in FOLDER, on 2 ranks.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

lmp=$1 folder=$2 kills=${3:-50}
run_environment
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

# grains that do not touch: a restart leaves the forces of contacts with dashpots different
cat > in.common <<'END_OF_COMMON'
neighbor 1e-4 bin
variable p equal 1e-3*sin(step/50)
fix m all nve/sphere
fix w all lb/ibb dx 1e-4 nu 1e-6 rho 1000 every 2 accel 2e-4 0 0 buoyancy 0 0 -0.1 &
  face zlo wall face zhi pressure v_p ${restart}
restart 6 ${pairs}
thermo 1000000
END_OF_COMMON
cat > in.start <<'END_OF_START'
units si
atom_style sphere
atom_modify map array sort 0 0
boundary p p f
comm_modify vel yes
region box block 0 4.8e-3 0 4.8e-3 0 4.8e-3
create_box 1 box
create_atoms 1 single 4.7e-3 1.21e-3 1.33e-3
create_atoms 1 single 2.42e-3 0.1e-3 3.04e-3
create_atoms 1 single 1.13e-3 3.54e-3 2.45e-3
set group all diameter 9e-4 density 1300
set atom 1 vx 2e-3 vy -1e-3
set atom 2 vz 1e-3 vy 1e-3
timestep 5e-4
variable restart string " "
variable pairs string "one two"
include in.common
run ${steps} ${upto}
write_restart last
END_OF_START
# the pair that is read must be the last to be written over
cat > in.go_on <<'END_OF_GO_ON'
read_restart ${pair}
variable restart string "restart ${pair}"
if "${pair} == one" then "variable pairs string 'two one'" else "variable pairs string 'one two'"
include in.common
run ${steps} ${upto}
if "${steps} > 0" then "write_restart last"
END_OF_GO_ON

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

# the ranks of an mpirun, at once
kill_ranks() {
  local ranks
  read -r -a ranks < "/proc/$1/task/$1/children" || true
  if [ ${#ranks[@]} -gt 0 ]; then kill -KILL "${ranks[@]}" 2>/dev/null || true; fi
}

far=1000000 known=-1 caught=0 step=-1 pair=
RANDOM=4711
for ((k = 1; k <= kills; k++)); do
  if [ "$step" -ge 0 ]; then
    mpirun -np 2 "$lmp" -in in.go_on -log none -var pair "$pair" -var steps $far -var upto upto > run.txt 2>&1 &
  else
    mpirun -np 2 "$lmp" -in in.start -log none -var steps $far -var upto upto > run.txt 2>&1 &
  fi
  mpi=$!
  # from when the run is under way, anything up to 0.7 s
  for ((t = 0; t < 600; t++)); do
    grep -q '^ *Step' run.txt && break
    kill -0 $mpi 2>/dev/null || { cat run.txt; die "the run ended by itself"; }
    sleep 0.05
  done
  sleep "0.$(printf %03d $((RANDOM % 700)))"
  kill_ranks $mpi
  wait $mpi 2>/dev/null || true
  look
  [ "$step" -ge "$known" ] || die "step $known was complete, now there is only step $step"
  known=$step
  caught=$((caught + half))
done
[ "$known" -gt 0 ] || die "no pair was ever complete"
say "killed $kills times, $caught of them while it wrote; came to step $known"
[ "$caught" -gt 0 ] || die "it was never killed while it wrote"

last=$((known + 8))
mpirun -np 2 "$lmp" -in in.go_on -log none -var pair "$pair" -var steps $last -var upto upto > run.txt 2>&1 || die "cannot end"
mv last.lbibb killed.lbibb
mpirun -np 2 "$lmp" -in in.start -log none -var steps $last -var upto upto > run.txt 2>&1 || die "cannot run through"
cmp killed.lbibb last.lbibb || die "the fluid differs from that of a run that was not killed"
say "the fluid at step $last is that of a run that was not killed, bit for bit"
