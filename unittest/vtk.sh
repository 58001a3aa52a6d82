#!/usr/bin/env bash
# Long test: files of fix lb/ibb/vtk are read by VTK itself, and by ParaView where it is; a run that is
# killed at any moment leaves none that cannot be read, and goes on with the series.
#
#   unittest/vtk.sh LMP FOLDER [KILLS]    KILLS: how often it is killed (12)
#
# Works in FOLDER, on 2 ranks. Skipped (exit status 77) without VTK for Python (python3-vtk9).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

lmp=$1 folder=$2 kills=${3:-12}
for python in python3 /usr/bin/python3 ''; do
  if [ -n "$python" ] && "$python" -c 'import numpy, vtk' 2>/dev/null; then break; fi
done
[ -n "$python" ] || {
  echo "SKIPPED: no VTK for Python here (python3-vtk9)"
  exit 77
}
run_environment
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
reader=$root/unittest/vtk_read.py

# grains that do not touch, so that a restart goes on bit for bit
cat > in.common <<'END_OF_COMMON'
neighbor 1e-4 bin
fix m all nve/sphere
fix w all lb/ibb dx 1e-4 nu 1e-6 rho 1000 every 2 accel 2e-4 0 0 buoyancy 0 0 -0.1 &
  face zlo wall face zhi wall ${restart}
fix z all lb/ibb/vtk 4 w ${name} fields density pressure velocity solid
thermo 1000000
END_OF_COMMON
cat > in.start <<'END_OF_START'
units si
atom_style sphere
atom_modify map array sort 0 0
boundary p p f
comm_modify vel yes
region box block 0 2.4e-3 0 2.0e-3 0 3.2e-3
create_box 1 box
create_atoms 1 single 0.5e-3 0.5e-3 0.6e-3
create_atoms 1 single 2.3e-3 1.5e-3 1.6e-3
set group all diameter 9e-4 density 1300
set atom 1 vx 2e-3 vy -1e-3
set atom 2 vz 1e-3 vy 1e-3
timestep 5e-4
variable restart string " "
include in.common
END_OF_START
cat > in.compare <<'END_OF_COMPARE'
include in.start
fix r all lb/ibb/vtk 40 w raw fields density pressure velocity solid encoding raw
fix t all lb/ibb/vtk 40 w text fields density pressure velocity solid encoding base64 stride 2
compute cell all property/grid 24 20 32 id
dump cells all grid 40 cells.dump c_cell:grid:data f_w:grid:density f_w:grid:pressure &
  f_w:grid:velocity[*] f_w:grid:solid
dump grains all custom 40 grains.dump id x y z radius vx vy vz omegax omegay omegaz f_w[*]
dump_modify cells format float %.9g
dump_modify grains format float %.9g
run 40
END_OF_COMPARE
cat > in.run <<'END_OF_RUN'
include in.start
restart 6 one two
run ${steps}
END_OF_RUN
# the pair that is read must be the last to be written over
cat > in.go_on <<'END_OF_GO_ON'
read_restart ${pair}
variable restart string "restart ${pair}"
include in.common
if "${pair} == one" then "restart 6 two one" else "restart 6 one two"
run ${steps} ${upto}
END_OF_GO_ON

mpirun -np 2 "$lmp" -in in.compare -log none -var name z > compare.txt || die "cannot run: $(cat compare.txt)"
"$python" "$reader" compare z raw text
"$python" "$reader" lists z-fluid z-grains
if have pvpython; then
  pvpython - <<'END_OF_PARAVIEW'
from paraview.simple import GetParaViewVersion, OpenDataFile
for name, arrays in (("z-fluid", "velocity"), ("z-grains", "radius"), ("text-fluid", "velocity")):
    series = OpenDataFile(name + ".pvd")
    times = list(series.TimestepValues)
    assert len(times) == (2 if name == "text-fluid" else 11), times
    series.UpdatePipeline(times[-1])
    assert series.PointData[arrays].GetRange()[1] > 0.0
print("read by ParaView", GetParaViewVersion())
END_OF_PARAVIEW
else
  say "no pvpython here: not read by ParaView itself"
fi

# the ranks of an mpirun, at once
kill_ranks() {
  local ranks
  read -r -a ranks < "/proc/$1/task/$1/children" || true
  if [ ${#ranks[@]} -gt 0 ]; then kill -KILL "${ranks[@]}" 2>/dev/null || true; fi
}

# the step of a pair of restart files that goes on, or -1
step_of() {
  local found
  found=$([ -e "$1" ] && "$lmp" -in in.go_on -log none -var pair "$1" -var steps 0 -var upto "" -var name look 2>&1 |
    sed -n 's/^Fix lb\/ibb: goes on from .*, step \([0-9]*\), .*/\1/p') || true
  echo "${found:--1}"
}

input=(-in in.run -var steps 1000000) known=0 caught=0
RANDOM=4711
for ((k = 1; k <= kills; k++)); do
  mpirun -np 2 "$lmp" "${input[@]}" -log none -var name k > run.txt 2>&1 &
  mpi=$!
  for ((t = 0; t < 600; t++)); do
    grep -q '^ *Step' run.txt && break
    kill -0 $mpi 2>/dev/null || die "the run ended by itself: $(cat run.txt)"
    sleep 0.05
  done
  sleep "0.$(printf %03d $((RANDOM % 700)))"
  kill_ranks $mpi
  wait $mpi 2>/dev/null || true
  "$python" "$reader" lists k-fluid k-grains > lists.txt || die "after kill $k: $(cat lists.txt)"
  for part in k-*.part; do
    if [ -e "$part" ]; then
      caught=$((caught + 1))
      break
    fi
  done
  one=$(step_of one) two=$(step_of two)
  pair=one step=$one
  if [ "$two" -gt "$one" ]; then pair=two step=$two; fi
  if [ "$step" -ge 0 ]; then input=(-in in.go_on -var pair "$pair" -var steps 1000000 -var upto upto) known=$step; fi
done
[ "$known" -gt 0 ] || die "no pair of restart files was ever complete"
[ "$caught" -gt 0 ] || die "it was never killed while it wrote"

last=$((known + 8))
mpirun -np 2 "$lmp" -in in.go_on -var pair "$pair" -var steps $last -var upto upto -log none -var name k > run.txt ||
  die "cannot end: $(cat run.txt)"
mpirun -np 2 "$lmp" -in in.run -var steps $last -log none -var name through > run.txt || die "cannot run through"
for list in fluid grains; do
  cmp <(sed 's/"through-/"k-/' "through-$list.pvd") "k-$list.pvd" || die "the list of files differs"
done
for file in through-*.vt?; do
  cmp "$file" "k${file#through}" || die "$file differs from that of a run that was killed"
done
say "killed $kills times, $caught of them while it wrote, up to step $known: the series is whole"
