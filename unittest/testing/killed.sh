# shellcheck shell=bash
# What tests of runs that are killed share: a scene that goes on from restart files bit for bit, and
# the killing. Sourced after cmake/setup.sh, with the program in $lmp.
# shellcheck disable=SC2154

# write_scene   in the present folder, beside in.grains (box and grains) and in.output (what is written):
#   in.start    the scene from its start
#   in.run      ${steps} ${upto} of it, with restart files one and two in turn, and last at the end
#   in.go_on    the same from the restart file ${pair}
write_scene() {
  # grains that do not touch: a restart leaves the forces of contacts with dashpots different; so slow
  # that none is out of the box however far a run comes between the kills
  cat > in.common <<'END_OF_COMMON'
neighbor 1e-4 bin
variable p equal 1e-3*sin(step/50)
fix m all nve/sphere
fix w all lb/ibb dx 1e-4 nu 1e-6 rho 1000 every 2 accel 2e-4 0 0 buoyancy 0 0 -0.002 &
  face zlo wall face zhi pressure v_p ${restart}
include in.output
thermo 1000000
END_OF_COMMON
  cat > in.start <<'END_OF_START'
units si
atom_style sphere
atom_modify map array sort 0 0
boundary p p f
comm_modify vel yes
include in.grains
set group all diameter 9e-4 density 1300
set atom 1 vx 2e-3 vy -1e-3
set atom 2 vz 1e-3 vy 1e-3
timestep 5e-4
variable restart string " "
include in.common
END_OF_START
  cat > in.run <<'END_OF_RUN'
include in.start
restart 6 one two
run ${steps} ${upto}
write_restart last
END_OF_RUN
  # the pair that is read must be the last to be written over
  cat > in.go_on <<'END_OF_GO_ON'
read_restart ${pair}
variable restart string "restart ${pair}"
include in.common
if "${pair} == one" then "restart 6 two one" else "restart 6 one two"
run ${steps} ${upto}
if "${steps} > 0" then "write_restart last"
END_OF_GO_ON
}

# on_2_ranks OPTION...   of lmp; output to run.txt
on_2_ranks() { mpirun -np 2 "$lmp" -log none "$@" > run.txt 2>&1; }

# the ranks of an mpirun, at once
kill_ranks() {
  local ranks
  read -r -a ranks < "/proc/$1/task/$1/children" || true
  if [ ${#ranks[@]} -gt 0 ]; then kill -KILL "${ranks[@]}" 2>/dev/null || true; fi
}

# run_and_kill OPTION...   up to 0.7 s after the run is under way
run_and_kill() {
  local mpi t
  mpirun -np 2 "$lmp" -log none "$@" > run.txt 2>&1 &
  mpi=$!
  for ((t = 0; t < 600; t++)); do
    grep -q '^ *Step' run.txt && break
    kill -0 $mpi 2>/dev/null || die "the run ended by itself: $(cat run.txt)"
    sleep 0.05
  done
  sleep "0.$(printf %03d $((RANDOM % 700)))"
  kill_ranks $mpi
  wait $mpi 2>/dev/null || true
}
