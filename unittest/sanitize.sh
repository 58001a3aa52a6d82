#!/usr/bin/env bash
# Long test: hostile input, and every example, under AddressSanitizer and UBSan.
#
#   unittest/sanitize.sh LAMMPS-TREE FOLDER inputs [SEED [COUNT]]    the fuzzer, 100,000 inputs of seed 1
#   unittest/sanitize.sh LAMMPS-TREE FOLDER examples [SECONDS]       15 s of each, on 1 rank and on 4
#
# Our sources and tests are compiled with both sanitizers, LAMMPS as in every other build, which
# ccache then has: its memory is watched too where it is allocated, used by us, or copied.
# LBMIBB_SANITIZE_ALL=1 compiles LAMMPS with AddressSanitizer as well (half an hour).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

tree=$1 folder=$2 what=$3
build=$folder/build
mkdir -p "$folder"
lock "$folder/lock"
unset CMAKE_BUILD_TYPE
export CMAKE_GENERATOR=Ninja LAMMPS_DIR=$tree
sanitize="-fsanitize=address,undefined"
options=(-D LBMIBB_ARCH=none -D CMAKE_EXE_LINKER_FLAGS="$sanitize" -D CMAKE_SHARED_LINKER_FLAGS="$sanitize"
  -D LBMIBB_CXX_FLAGS="-O1 -g1 -fno-omit-frame-pointer $sanitize -fno-sanitize-recover=undefined")
if [ -n "${LBMIBB_SANITIZE_ALL:-}" ]; then
  options+=(-D LBMIBB_LAMMPS_OPT=-O1 -D CMAKE_CXX_FLAGS="-fsanitize=address -fno-omit-frame-pointer")
fi
cmake -S "$root" -B "$build" "${options[@]}" > "$folder/configure.log"
target=lmp
if [ "$what" = inputs ]; then target=lammps_fuzz; fi
cmake --build "$build" --parallel "$(nproc)" --target $target > "$folder/build.log"
unlock

run_environment
# Vectors that LAMMPS fills without the sanitizer look overflown; an allocation that fails must reach
# us as std::bad_alloc. Errors that LAMMPS throws from constructors leak a few words each.
export UBSAN_OPTIONS=print_stacktrace=1
asan=detect_container_overflow=0:allocator_may_return_null=1:detect_stack_use_after_return=1
reports='ERROR: AddressSanitizer|runtime error:'

if [ "$what" = inputs ]; then
  cd "$folder"
  export ASAN_OPTIONS=$asan:detect_leaks=0 LBMIBB_SOURCE_DIR=$root
  export LBMIBB_FUZZ_SEED=${4:-1} LBMIBB_FUZZ_INPUTS=${5:-100000}
  "$build/unittest/lammps_fuzz" 2>&1 | tail -n 60
  exit
fi

# Leaks count here, if our code allocated: MPI and the modules it loads leave much behind, and LAMMPS's
# formulas some words
export ASAN_OPTIONS=$asan:detect_leaks=1:exitcode=0
leaks() {    # LOG
  awk -v RS= '/leak of/ && /src\/LBM-IBB|lbm::|LbIbb|GranLSD/ && !/Variable::/' "$1"
}
status=0
seconds=${4:-15}
# every input script with a fluid in it
mapfile -t inputs < <(grep -lE '^[^#]*lb/(ibb|plan)' "$root"/examples/*/in.*)
[ ${#inputs[@]} -ge 20 ] || die "found ${#inputs[@]} inputs in examples"
for input in "${inputs[@]}"; do
  example=$(basename "$(dirname "$input")") script=$(basename "$input")
  name=$example/$script
  for ranks in 1 4; do
    rm -rf "${folder:?}/examples"
    cp -r "$root/examples" "$folder/examples"    # all: some read a file of another
    cd "$folder/examples/$example"
    printf 'timer timeout 0:00:%02d every 10\ninclude %s\n' "$seconds" "$script" > in.short
    # LAMMPS may find results missing after a run that was cut short: only reports count
    mpirun -np $ranks "$build/lmp" -in in.short -log none > log 2>&1 </dev/null || true
    if grep -aE -A 30 "$reports" log || leaks log | grep -a .; then
      echo "$name on $ranks ranks: reported"
      status=1
    elif ! grep -aqE 'fluid steps, |Fix lb/ibb: |lb/plan: ' log; then
      echo "$name on $ranks ranks: no fluid step"
      grep -aA 1 ERROR log || tail -n 5 log
      status=1
    else
      echo "$name on $ranks ranks: $(grep -aoE '[0-9]+ fluid steps' log | tail -n 1), clean"
    fi
  done
done
rm -rf "${folder:?}/examples"
exit $status
