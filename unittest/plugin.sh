#!/usr/bin/env bash
# Long test: the package as a plugin of a LAMMPS that was built without it.
#
#   unittest/plugin.sh LAMMPS-TREE|VERSION LMP FOLDER
#
#   VERSION   one that cmake/get_lammps.sh knows; exit status 77, skipped, if it cannot be obtained
#   LMP       has the package built in: it must give the same numbers
#
# Works in FOLDER.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

tree=$1 builtin=$2 folder=$3
if [ ! -d "$tree" ]; then
  version=$tree
  tree=$("$root/cmake/get_lammps.sh" "$version") || {
    echo "SKIPPED: LAMMPS $version cannot be obtained: the plugin is NOT TESTED with it"
    exit 77
  }
fi
jobs=$(nproc)
# kept where LMP_HOST names one that is built already
host=${LMP_HOST:-$folder/host/lmp}
rm -rf "$folder"
mkdir -p "$folder"

unset CMAKE_BUILD_TYPE    # its flags would come after these
export CMAKE_GENERATOR=Ninja CXXFLAGS=-O0
have ccache && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
if [ ! -x "$host" ]; then
  cmake -S "$tree/cmake" -B "$folder/host" -D PKG_GRANULAR=on -D PKG_PLUGIN=on > "$folder/cmake.txt"
  cmake --build "$folder/host" --parallel "$jobs" --target lmp > "$folder/host.txt" || die "$(tail "$folder/host.txt")"
fi
# plugin NAME SOURCES TARGET OPTIONS...   builds one in $folder/NAME
plugin() {
  cmake -S "$root/cmake/plugin" -B "$folder/$1" -D LAMMPS_SOURCE_DIR="$2" -D LBMIBB_ARCH=none \
    -D LBMIBB_CXX_FLAGS=-O1 "${@:4}" > "$folder/cmake.txt"
  cmake --build "$folder/$1" --parallel "$jobs" --target "$3" > "$folder/$1.txt" || die "$(tail "$folder/$1.txt")"
}
plugin good "$tree/src" all
run_environment
cd "$folder"

# ---- it brings all styles, and they do what they do when built in

cat > in.scene <<'END_OF_SCENE'
units si
atom_style sphere
atom_modify map array sort 0 0
boundary p p f
comm_modify vel yes
region box block 0 2.4e-3 0 2.0e-3 0 3.2e-3
create_box 1 box
create_atoms 1 single 0.5e-3 0.5e-3 0.46e-3
create_atoms 1 single 1.41e-3 0.5e-3 0.46e-3
set group all diameter 9e-4 density 1300
set atom 1 vx 4e-3 vy -1e-3 vz -4e-3
pair_style gran/lsd/coulomb
pair_coeff * * 10.0 0.9 0.4
neighbor 1e-4 bin
timestep 8e-6
fix m all nve/sphere
fix w all lb/ibb dx 1e-4 nu 1e-6 rho 1000 every 50 accel 2e-2 0 0 face zlo wall face zhi wall
fix g all wall/gran/lsd/coulomb 10.0 0.9 0.4 zplane 0 3.2e-3
fix z all lb/ibb/vtk 100 w scene
compute p all lb/ibb/profile w z layers 4
thermo 100
thermo_style custom step f_w[6] f_w[9] f_w[13] c_p[1][6] ke
thermo_modify format float %.8g
run 800
END_OF_SCENE
echo "plugin load $folder/good/lbmibbplugin.so" | cat - in.scene > in.loaded
{ echo "plugin list"; echo "clear"; } > in.list
"$host" -in in.loaded -log none > loaded.txt || die "it cannot run: $(tail loaded.txt)"
mpirun -np 2 -x LAMMPS_PLUGIN_PATH="$folder/good" "$host" -in in.scene -log none > path.txt ||
  die "it cannot run by way of LAMMPS_PLUGIN_PATH: $(tail path.txt)"
"$builtin" -in in.scene -log none > builtin.txt
numbers() { awk '$1 == 800 && NF == 6' "$1"; }
numbers builtin.txt | grep -q . || die "no numbers: $(tail builtin.txt)"
for way in loaded path; do
  paste <(numbers builtin.txt) <(numbers $way.txt) | awk '
    NF != 12 { exit 1 }
    { for (k = 2; k <= 6; k++) { d = $k - $(k + 6); if (d * d > 1e-12 * $k * $k) exit 1 } }' ||
    die "$way: $(numbers $way.txt), built in: $(numbers builtin.txt)"
done
LAMMPS_PLUGIN_PATH=$folder/good "$host" -in in.list -log none > list.txt
for style in $(sed -n 's/^ *[A-Z][a-z]*Style(\([a-z/]*\),.*/\1/p' "$root"/src/LBM-IBB/*.h); do
  grep -q "style plugin $style\$" list.txt || die "style $style is not among those that it brings"
done

# ---- where it does not belong it says so, and stops before anything of it is touched

# refused NAME SENTENCE
refused() {
  echo "plugin load $folder/$1/lbmibbplugin.so" | cat - in.scene > in.refused
  if "$host" -in in.refused -log none > "$1.out" 2>&1; then die "$1: loaded all the same"; fi
  grep -qF "ERROR: Plugin LBM-IBB is not loaded: $2" "$1.out" || die "$1 says: $(cat "$1.out")"
  if grep -q 'Loading plugin' "$1.out"; then die "$1: loaded before it was refused"; fi
}
running=$(sed -n 's/.*LAMMPS_VERSION "\(.*\)".*/\1/p' "$tree/src/version.h")
mkdir old old/GRANULAR
cp "$tree"/src/*.h old
echo '#define LAMMPS_VERSION "29 Sep 2021"' > old/version.h
plugin other "$folder/old" lbmibbplugin
refused other "compiled for LAMMPS 29 Sep 2021, but this is LAMMPS $running: build it with this one's sources"
plugin wide "$tree/src" lbmibbplugin -D LAMMPS_SIZES=bigbig
refused wide "compiled for other sizes of integers than this LAMMPS: build it with -D LAMMPS_SIZES=smallbig"
mkdir alone
cp good/lbmibbplugin.so alone
refused alone "cannot open $folder/alone/liblbmibb.so"
say "plugin for LAMMPS $running: all styles, the numbers of the package built in, and refused elsewhere"
[ "$host" != "$folder/host/lmp" ] || rm -rf host
