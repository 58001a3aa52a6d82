#!/usr/bin/env bash
# Long test: LAMMPS's own DEM verification cases with our contact law.
#
#   unittest/granular.sh BUILD FOLDER
#
# LAMMPS 4 Jul 2026 brings a harness, unittest/granular: cases as YAML files, drivers that compare them with
# analytic solutions. Its drivers are compiled here, as they are, against the LAMMPS of BUILD; each of its cases
# 01 to 05 and 09 that has an analytic solution and the stock linear law with restitution is rewritten for
# pair_style gran/lsd/coulomb and its wall, and has to meet the same solution within the same tolerance.
# Recorded trajectories, which belong to the stock law, are left out. Case 05 is the solution of hard spheres,
# which turn with the arm r; our friction acts on the wall, at r less the overlap, 0.9 % of r there. So it is run
# with ten times the stiffness, and a quarter of the timestep.
# ctest counts it as skipped (exit status 77) where that LAMMPS, GoogleMock or libyaml is not to be had.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

build=$1 folder=$2
skip() {
  echo "SKIPPED: $*"
  exit 77
}
prepare_machine '?libgmock-dev' '?libyaml-dev'
if ! harness=${LBMIBB_GRANULAR:-$("$root/cmake/get_lammps.sh" 20260704)}; then skip "no LAMMPS 4 Jul 2026 here"; fi
harness=$harness/unittest
[ -e "$harness/granular/test_main.cpp" ] || skip "no unittest/granular in $harness"
echo '#include <gmock/gmock.h>
#include <yaml.h>' | c++ -std=c++17 -fsyntax-only -x c++ - 2>/dev/null || skip "no GoogleMock or libyaml (libgmock-dev libyaml-dev)"
ninja -C "$build" lammps_shared > /dev/null
tree=$(sed -n 's,^lammps_SOURCE_DIR:STATIC=\(.*\)/cmake$,\1,p' "$build/CMakeCache.txt")
run_environment
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

# ---- the drivers, as LAMMPS's CMakeLists.txt builds them
mpi=()
read -r -a mpi <<< "$(mpicxx --showme:compile 2>/dev/null || mpicxx -compile_info | cut -d' ' -f2-)"
flags=(-std=c++17 -O1 "-DTEST_INPUT_FOLDER=$harness/granular/tests" -I "$tree/src" -I "$harness" "${mpi[@]}")
support=("$harness"/{error_stats,yaml_writer}.cpp
  "$harness"/granular/test_{config_reader,analytic_models,dem_common,main}.cpp)
drivers=()
for number in 01 02 03 04 05 09; do drivers+=("$harness/granular/test_dem_$number.cpp"); done
printf '%s\n' "${support[@]}" "${drivers[@]}" | xargs -P "${LBMIBB_JOBS:-2}" -I{} c++ "${flags[@]}" -c {}
for number in 01 02 03 04 05 09; do
  mpicxx "test_dem_$number.o" {error_stats,yaml_writer,test_config_reader,test_analytic_models,test_dem_common,test_main}.o \
    -o "test_dem_$number" -L "$build/python" -Wl,-rpath,"$build/python" -llammps -lgmock -lgtest -lyaml -lpthread
done

# ---- the cases
count=0 bad=0
for case in "$harness"/granular/tests/dem0[123459]-*.yaml; do
  grep -q '^analytic_enable: yes' "$case" || continue
  name=$(basename "$case")
  # shellcheck disable=SC2016  # ${...} are variables of LAMMPS
  sed -E '
    s,^  pair granular$,  pair gran/lsd/coulomb,
    s,^pair_style: granular$,pair_style: gran/lsd/coulomb,
    s,^  \* \* hooke \$\{knorm\} \$\{en\} tangential .*damping coeff_restitution$,  * * ${knorm} ${en} ${xmu},
    s,wall/gran granular hooke \$\{knorm\} \$\{en\} tangential .*damping coeff_restitution,wall/gran/lsd/coulomb ${knorm} ${en} ${xmu},
    /^run_(pos|vel|torque|omega)/,/^(run_|\.\.\.)/{ /^run_(pos|vel|torque|omega)/d; /^ /d }' "$case" > "$name"
  if grep -qE 'gran/hooke|granular hooke|hertz|mindlin' "$name"; then
    rm "$name"    # another law
    continue
  fi
  if [[ $name == dem05-* ]]; then
    sed -i 's/^  knorm 1.0e4$/  knorm 1.0e5/; s/^  timestep 2.0e-4$/  timestep 5.0e-5/; s/^  400 400$/  1600 1600/' "$name"
    grep -q '^  1600 1600' "$name" || die "$name is not as expected"
  fi
  grep -q 'gran/lsd/coulomb' "$name" || die "$name was not rewritten"
  if "./test_dem_${name:3:2}" "$name" -v > "$name.txt" 2>&1; then
    echo "$name: $(sed -n 's/^analytic_model: //p' "$name") within $(sed -n 's/^analytic_tol: //p' "$name")"
  else
    echo "$name FAILED"
    grep -A3 ': Failure' "$name.txt"
    bad=$((bad + 1))
  fi
  grep -q 'PASSED  \] [12] test' "$name.txt" || bad=$((bad + 1))    # not merely skipped
  count=$((count + 1))
done
echo "$count cases of LAMMPS's harness, $bad failed"
[ "$count" -ge 8 ] && [ "$bad" = 0 ]
