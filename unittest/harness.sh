#!/usr/bin/env bash
# Long test: our tests inside LAMMPS's own harness, as doc/src/Build_lbm_ibb.rst says.
#
#   unittest/harness.sh LAMMPS-TREE FOLDER
#
# A copy of the tree, unittest dropped in, ENABLE_TESTING: a test of each kind has to be found by LAMMPS's
# ctest, built against its GoogleTest and LAMMPS, and pass.
# ctest counts it as skipped (exit status 77) where the sources of GoogleTest or libyaml are not to be had.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

tree=$1 folder=$2
skip() {
  echo "SKIPPED: $*"
  exit 77
}
prepare_machine '?googletest' '?libyaml-dev'
[ -d /usr/src/googletest ] || skip "no sources of GoogleTest (googletest)"
[ -e /usr/include/yaml.h ] || skip "no libyaml (libyaml-dev)"
rm -rf "$folder"
mkdir -p "$folder"
cp -rs "$tree" "$folder/lammps"
lammps=$folder/lammps

cp -r "$root/unittest" "$lammps/unittest/lbm-ibb"
cp "$root"/potentials/* "$lammps/potentials"
cp --remove-destination "$tree/unittest/CMakeLists.txt" "$lammps/unittest"
echo 'add_subdirectory(lbm-ibb)' >> "$lammps/unittest/CMakeLists.txt"
if [ ! -e "$lammps/examples/COUPLE/simple/CMakeLists.txt" ]; then    # not in every copy of the tree
  mkdir -p "$lammps/examples/COUPLE/simple"
  echo 'add_executable(simpleC EXCLUDE_FROM_ALL none.cpp)
add_executable(simpleCC EXCLUDE_FROM_ALL none.cpp)' > "$lammps/examples/COUPLE/simple/CMakeLists.txt"
  echo 'int main() { return 0; }' > "$lammps/examples/COUPLE/simple/none.cpp"
fi
tar -c -z -f "$folder/googletest.tar.gz" -C /usr/src --transform 's,^googletest,googletest-offline,' googletest
read -r md5 _ < <(md5sum "$folder/googletest.tar.gz")
read -r sha256 _ < <(sha256sum "$folder/googletest.tar.gz")

# the cheapest of builds: this is about what is found and linked
unset CMAKE_BUILD_TYPE
export CMAKE_GENERATOR=Ninja CXXFLAGS=-O0
have ccache && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
cmake -C "$root/cmake/lbm-ibb.cmake" -S "$lammps/cmake" -B "$folder/build" -D LBMIBB_PCH=ON -D LBMIBB_ARCH=none \
  -D CMAKE_Fortran_COMPILER=NOTFOUND -D ENABLE_TESTING=ON -D GTEST_URL="file://$folder/googletest.tar.gz" -D GTEST_MD5="$md5" -D GTEST_SHA256="$sha256"
cmake --build "$folder/build" --parallel "$(nproc)" \
  --target lmp core_lattice core_faces lammps_library lammps_potentials mpi_profile_ranks
cd "$folder/build"
run_environment
ctest --no-tests=error --output-on-failure -R '^(core_lattice|core_faces|lammps_library|lammps_potentials|mpi_profile_ranks)\.'
ctest -N | tail -n 1
ctest -N -R '^RunLammps' | grep -q RunLammps || die "LAMMPS's own tests are not there"
rm -rf "$folder"
