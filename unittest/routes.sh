#!/usr/bin/env bash
# Long test: the other ways to build LAMMPS with LBM-IBB, besides our own CMakeLists.txt.
#
#   unittest/routes.sh preset | fetch | make LAMMPS-TREE FOLDER
#
#   preset   a user's own tree with cmake -C cmake/lbm-ibb.cmake, for any processor
#   fetch    our CMakeLists.txt with an archive of the tree, as CMake fetches a release
#   make     a copy of the tree with make yes-lbm-ibb and LAMMPS's traditional make
#
# Works in FOLDER; each way must end in an lmp that knows our styles.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

route=$1 tree=$2 folder=$3
jobs=$(nproc)
rm -rf "$folder"
mkdir -p "$folder"

# the cheapest of builds: this is about what is compiled and linked, not how fast it runs
unset CMAKE_BUILD_TYPE    # its flags would come after these
export CMAKE_GENERATOR=Ninja CXXFLAGS=-O0
have ccache && export CMAKE_CXX_COMPILER_LAUNCHER=ccache

case $route in
  preset)
    cmake -C "$root/cmake/lbm-ibb.cmake" -S "$tree/cmake" -B "$folder/build" \
      -D LBMIBB_ARCH=none -D LBMIBB_PCH=ON
    cmake --build "$folder/build" --parallel "$jobs" --target lmp
    if grep -q -e '-march=' "$folder/build/build.ninja"; then
      die "LBMIBB_ARCH=none, yet the compiler is told a processor"
    fi
    lmp=$folder/build/lmp ;;
  fetch)
    # FetchContent keeps the tree in the cache folder; this one goes with the test
    export LBMIBB_CACHE=$folder/cache LAMMPS_DIR=
    tar -c -f "$folder/lammps.tar" -C "$(dirname "$tree")" "$(basename "$tree")"
    cmake -S "$root" -B "$folder/build" -D LBMIBB_TESTS=OFF -D LBMIBB_LAMMPS_OPT=-O0 \
      -D LBMIBB_LAMMPS_URL="file://$folder/lammps.tar"
    rm "$folder/lammps.tar"
    cmake --build "$folder/build" --parallel "$jobs" --target lmp
    lmp=$folder/build/lmp ;;
  make)
    mkdir "$folder/lammps"
    cp -r "$tree/src" "$tree/lib" "$folder/lammps"
    cd "$folder/lammps/src"
    cp -r "$root/src/LBM-IBB" .
    make yes-granular yes-lbm-ibb
    cxx=mpicxx
    have ccache && cxx="ccache mpicxx"
    # without LAMMPS's own -g -O3, but with what the package adds for its own files
    sed -i 's/^CCFLAGS =.*/CCFLAGS = -O0 -std=c++17/' MAKE/Makefile.mpi
    make -j "$jobs" mpi CC="$cxx" > "$folder/log"
    grep -m 1 -e "-march=native .*lbm_" "$folder/log"    # our files have our flags
    lmp=$folder/lammps/src/lmp_mpi
    # and out again, leaving nothing
    make no-lbm-ibb
    if grep -i lbm Makefile.package Makefile.package.settings; then
      die "make no-lbm-ibb left something behind"
    fi
    for file in LBM-IBB/*.cpp LBM-IBB/*.h; do
      [ ! -e "$(basename "$file")" ] || die "make no-lbm-ibb left $(basename "$file") behind"
    done ;;
esac

run_environment
"$lmp" -h > "$folder/help"
for style in lb/ibb gran/lsd/coulomb wall/gran/lsd/coulomb; do
  grep -qw "$style" "$folder/help" || die "$lmp does not know $style"
done
[ "$route" = make ] || grep -qw LBM-IBB "$folder/help" || die "$lmp does not list package LBM-IBB"
"$lmp" -in "$root/bench/in.fluid" -log none -var n 16 -var steps 4 > "$folder/steps" ||
  die "$lmp cannot make a fluid step"
echo "$route: $lmp knows the package's styles"
rm -rf "$folder"
