/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// What words of the command line that are right by themselves may say against each other.

#include "lb_ibb_options.h"

#include "domain.h"
#include "error.h"

using namespace LAMMPS_NS;
using lbm::FaceKind;

void LBOptionsParser::check_faces() const
{
  auto open = [&](int d, int side) {
    return o.face[d][side].kind == FaceKind::PRESSURE || o.face[d][side].kind == FaceKind::VELOCITY;
  };
  for (int d = 0; d < domain->dimension; d++) {
    check_flux(d);
    for (int side = 0; side < 2; side++) {
      if (!domain->periodicity[d] && o.face[d][side].kind == FaceKind::PERIODIC)
        error->all(FLERR,
                   "Fix lb/ibb: face {} is missing: every face of a non-periodic direction must "
                   "be a wall, a pressure or a velocity face, or the direction periodic",
                   LBOptions::FACES[d][side]);
      if (o.face[d][side].parabolic && !meets_walls(d))
        error->all(
            FLERR,
            "Fix lb/ibb: face {} is parabolic and lies between no two walls: make a direction "
            "along it walls on both sides, or the velocity uniform",
            LBOptions::FACES[d][side]);
      for (int other = d + 1; other < domain->dimension; other++)
        for (int s = 0; s < 2; s++)
          if (open(d, side) && open(other, s))
            error->all(FLERR,
                       "Fix lb/ibb: open faces {} and {} meet in an edge, where the flow is "
                       "undefined: make one direction periodic or walls",
                       LBOptions::FACES[d][side], LBOptions::FACES[other][s]);
    }
  }
}

// Where no pressure face lets the fluid leave as it likes, what enters must leave: otherwise the
// density would rise or fall without end. Variables are the user's affair.
void LBOptionsParser::check_flux(int d) const
{
  const LBFace &lo = o.face[d][0], &hi = o.face[d][1];
  auto given = [&](const LBFace &f) {
    return (f.kind == FaceKind::WALL || f.kind == FaceKind::VELOCITY) && f.u[d].variable.empty();
  };
  if (given(lo) && given(hi) && lo.u[d].constant != hi.u[d].constant)
    error->all(FLERR,
               "Fix lb/ibb: faces {} and {} contradict each other: the fluid moves with {} through "
               "one and {} through the other: make them equal, or one a pressure face",
               LBOptions::FACES[d][0], LBOptions::FACES[d][1], lo.u[d].constant, hi.u[d].constant);
  if (given(lo) && given(hi) && lo.u[d].constant != 0.0 && lo.parabolic != hi.parabolic)
    error->all(FLERR,
               "Fix lb/ibb: of faces {} and {} one is parabolic and lets less through than the "
               "other: make both parabolic, or one a pressure face",
               LBOptions::FACES[d][0], LBOptions::FACES[d][1]);
}

// are there walls at both ends of a direction along this face?
bool LBOptionsParser::meets_walls(int d) const
{
  for (int t = 0; t < domain->dimension; t++)
    if (t != d && o.face[t][0].kind == FaceKind::WALL && o.face[t][1].kind == FaceKind::WALL)
      return true;
  return false;
}

// the table of radii was measured with spheres and two relaxation times
void LBOptionsParser::check_radius() const
{
  if (!o.calibrated) return;
  if (domain->dimension == 2)
    error->all(FLERR, "Fix lb/ibb keyword radius: there is no table for discs: use radius given");
  if (o.bgk || o.regularised || o.magic != LBOptions{}.magic)
    error->all(FLERR,
               "Fix lb/ibb keyword radius: the table is of collision trt {}: use that, or radius "
               "given",
               LBOptions{}.magic);
}
