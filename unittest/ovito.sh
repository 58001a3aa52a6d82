#!/usr/bin/env bash
# Files of fix lb/ibb/vtk with encoding base64, and LAMMPS's dumps of grid and grains, are such as OVITO's readers
# take, and all show the same. OVITO itself is not needed: ovito_read.py and ovito_dump.py have its sources' rules.
#
#   unittest/ovito.sh LMP FOLDER
#
# Works in FOLDER, on 1 and on 2 ranks. Python alone will do, without NumPy or VTK.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

lmp=$1 folder=$2
run_environment
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

cat > in.ovito <<'END_OF_SCENE'
units si
atom_style sphere
atom_modify map array
boundary p p f
processors ${ranks} 1 1
comm_modify vel yes
region box block 0 2.4e-3 0 2.0e-3 0 3.2e-3
create_box 2 box
create_atoms 1 single 0.1e-3 0.5e-3 0.6e-3
create_atoms 2 single 2.3e-3 1.5e-3 1.6e-3
set group all diameter 9e-4 density 1300
set atom 1 vx -8e-3 vy -1e-3
set atom 2 vz 1e-3 vx 8e-3
timestep 5e-4
neighbor 1e-4 bin
fix m all nve/sphere
fix w all lb/ibb dx 1e-4 nu 1e-6 rho 1000 every 2 accel 2e-4 0 0 buoyancy 0 0 -0.002 face zlo wall face zhi wall
region plane block INF INF 1.0e-3 1.1e-3 INF INF
fix text    all lb/ibb/vtk 20 w text fields density pressure velocity solid encoding base64
fix half    all lb/ibb/vtk 20 w half fields density pressure velocity solid encoding base64 stride 2 grains no
fix plane   all lb/ibb/vtk 20 w plane region plane encoding base64 grains no
fix raw     all lb/ibb/vtk 20 w raw encoding raw
fix default all lb/ibb/vtk 20 w default
dump sorted all grid 20 sorted.grid f_w:grid:density f_w:grid:pressure f_w:grid:velocity[*] f_w:grid:solid
dump plain  all grid 20 plain.grid f_w:grid:solid
dump grains all custom 20 grains.atoms id type x y z radius vx vy vz omegax omegay omegaz f_w[*]
dump_modify sorted sort id time yes format float %.9g
dump_modify grains time yes units yes format float %.9g
thermo 1000
run 40
END_OF_SCENE
for ranks in 1 2; do
  mkdir $ranks
  cd $ranks
  mpirun -np $ranks "$lmp" -in ../in.ovito -log none -var ranks $ranks > run.txt 2>&1 ||
    die "cannot run: $(cat run.txt)"
  python3 "$root/unittest/ovito_compare.py" $ranks
  cd ..
done
