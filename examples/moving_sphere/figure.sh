#!/usr/bin/env bash
# The runs of fig. 9: figure.sh quick|full, with LMP naming lmp. Ends with results.txt.
# The refill rule matters for the moving sphere only; the mean of two steps is taken by check.py, and
# once by the fix.
set -euo pipefail
mode=${1:-quick}
rm -f force-*.dat

# sphere MOTION COLLISION LINK REFILL AVERAGE   one run on 2 ranks
sphere() {
  mpirun -np 2 "$LMP" -in in.moving_sphere -log none -var motion "$1" -var collision "$2" -var link "$3" \
    -var refill "$4" -var average "$5" -var out "force-$1-$2-$3-$4-$5.dat" "${size[@]}" > lmp.txt 2>&1 ||
    { tail -n 20 lmp.txt; exit 1; }
  grep '^moving_sphere' lmp.txt
}

if [ "$mode" = full ]; then
  size=()                                # as in the article
  for collision in bgk trt; do
    for link in bouzidi cli halfway; do
      sphere fixed $collision $link grad no
      for refill in equilibrium grad; do sphere moving $collision $link $refill no; done
    done
  done
else
  size=(-var length 66 -var steps 700)   # 12 r along the flow, 28 cells of way
  sphere fixed bgk bouzidi grad no
  sphere moving bgk bouzidi equilibrium no
  sphere fixed bgk cli grad no
  sphere moving bgk cli grad no
fi
sphere fixed trt cli grad yes            # the defaults of the fix
sphere moving trt cli grad yes
python3 check.py "$mode"
