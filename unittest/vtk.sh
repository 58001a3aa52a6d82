#!/usr/bin/env bash
# Long test: files of fix lb/ibb/vtk are read by VTK itself, and by ParaView where it is; a run that is
# killed at any moment leaves none that cannot be read, and goes on with the series.
#
#   unittest/vtk.sh LMP FOLDER [KILLS]    KILLS: how often it is killed (12)
#
# Works in FOLDER, on 2 ranks. Skipped (exit status 77) without VTK for Python (python3-vtk9).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
source "$(dirname "${BASH_SOURCE[0]}")/testing/killed.sh"

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

cat > in.grains <<'END_OF_GRAINS'
region box block 0 2.4e-3 0 2.0e-3 0 3.2e-3
create_box 1 box
create_atoms 1 single 0.5e-3 0.5e-3 0.6e-3
create_atoms 1 single 2.3e-3 1.5e-3 1.6e-3
END_OF_GRAINS
# shellcheck disable=SC2016  # a variable of LAMMPS
echo 'fix z all lb/ibb/vtk 4 w ${name} fields density pressure velocity solid' > in.output
write_scene
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
on_2_ranks -in in.compare -var name z || die "cannot run: $(cat run.txt)"
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

# the step of a pair of restart files that goes on, or -1
step_of() {
  local found
  found=$([ -e "$1" ] && "$lmp" -in in.go_on -log none -var pair "$1" -var steps 0 -var upto "" -var name look 2>&1 |
    sed -n 's/^Fix lb\/ibb: goes on from .*, step \([0-9]*\), .*/\1/p') || true
  echo "${found:--1}"
}

input=(-in in.run) known=0 caught=0
RANDOM=4711
for ((k = 1; k <= kills; k++)); do
  run_and_kill "${input[@]}" -var steps 1000000 -var upto upto -var name k
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
  if [ "$step" -ge 0 ]; then input=(-in in.go_on -var pair "$pair") known=$step; fi
done
[ "$known" -gt 0 ] || die "no pair of restart files was ever complete"
[ "$caught" -gt 0 ] || die "it was never killed while it wrote"

last=$((known + 8))
on_2_ranks -in in.go_on -var pair "$pair" -var steps $last -var upto upto -var name k || die "cannot end: $(cat run.txt)"
on_2_ranks -in in.run -var steps $last -var upto upto -var name through || die "cannot run through: $(cat run.txt)"
for list in fluid grains; do
  cmp <(sed 's/"through-/"k-/' "through-$list.pvd") "k-$list.pvd" || die "the list of files differs"
done
for file in through-*.vt?; do
  cmp "$file" "k${file#through}" || die "$file differs from that of a run that was killed"
done
say "killed $kills times, $caught of them while it wrote, up to step $known: the series is whole"
