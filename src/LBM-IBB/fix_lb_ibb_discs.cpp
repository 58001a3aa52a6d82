/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// In two dimensions grains are discs to the fluid: what fix lb/ibb asks of their inertia and mass.

#include "fix_lb_ibb.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_nh_sphere.h"
#include "fix_nve_sphere.h"
#include "math_const.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace {

// limits of the density of a grain, in units of that of the fluid
constexpr double LIGHT = 0.2, HEAVY = 100.0;

// Prefactor of the moment of inertia, 0.4 or with keyword disc 0.5, 0 for fixes of another kind: a
// protected member, which a derived class may name.
template <class Style> struct Inertia : Style {
  static double of(const Fix *fix)
  {
    auto *style = dynamic_cast<const Style *>(fix);
    return style ? style->*(&Inertia::inertia) : 0.0;
  }
};

}    // namespace

// At the start of a run and when grains have changed: an inertia of spheres is refused, masses that
// look like those of spheres are warned of once a run. Collective.
void FixLbIbb::check_discs()
{
  if (domain->dimension != 2 || !atom->rmass_flag || !atom->radius_flag) return;
  for (auto *other : modify->get_fix_list()) {
    const double inertia =
        std::max(Inertia<FixNVESphere>::of(other), Inertia<FixNHSphere>::of(other));
    if (inertia == 0.0 || inertia == 0.5) continue;
    tagint first = MAXTAGINT, grain;
    for (int i = 0; i < atom->nlocal; i++)
      if ((atom->mask[i] & groupbit) && (atom->mask[i] & other->groupbit) && is_driven(i))
        first = std::min(first, atom->tag[i]);
    MPI_Allreduce(&first, &grain, 1, MPI_LMP_TAGINT, MPI_MIN, world);
    if (grain < MAXTAGINT)
      error->all(
          FLERR,
          "Fix lb/ibb: fix {} ({}) turns grain {} with the inertia of a sphere, {} m r^2, in "
          "2d it must be that of a disc, 0.5 m r^2: add keyword disc to fix {}",
          other->id, other->style, grain, inertia, other->id);
  }
  if (!warned_of_masses) check_disc_masses();
}

void FixLbIbb::check_disc_masses()
{
  // each as the largest of x and of -x: density as discs, as spheres, radius
  double range[6];
  std::fill_n(range, 6, -1e300);
  struct {
    double off;
    int rank;
  } worst{0.0, comm->me};
  double grain[2] = {0.0, 0.0};    // ID and density of the worst
  for (int i = 0; i < atom->nlocal; i++) {
    const double m = atom->rmass[i], r = atom->radius[i];
    if (!(atom->mask[i] & groupbit) || !(r > 0.0) || !(m > 0.0)) continue;
    if (!is_driven(i)) continue;
    const double disc = m / (MathConst::MY_PI * r * r) / options.rho;
    const double each[3] = {disc, disc / r, r};
    for (int k = 0; k < 3; k++) {
      range[k] = std::max(range[k], each[k]);
      range[3 + k] = std::max(range[3 + k], -each[k]);
    }
    const double off = std::max(LIGHT / disc, disc / HEAVY);
    if (off > worst.off) {
      worst.off = off;
      grain[0] = double(atom->tag[i]);
      grain[1] = disc;
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, range, 6, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  MPI_Bcast(grain, 2, MPI_DOUBLE, worst.rank, world);
  if (worst.off == 0.0) return;    // no grain

  // of spheres of one density, m / r^3 is one number, whatever their radii
  auto spread = [&](int k) {
    return 1.0 + range[3 + k] / range[k];
  };
  const bool as_spheres = spread(2) > 1e-3 && spread(1) < 1e-9;
  if (worst.off <= 1.0 && !as_spheres) return;
  warned_of_masses = true;
  if (comm->me) return;
  const std::string remedy = "masses in 2d are those of discs per unit of depth, pi r^2 times the "
                             "density: use set group all density/disc";
  if (worst.off > 1.0)
    error->warning(FLERR,
                   "Fix lb/ibb: grain {} has the density {:.4g} by m/(pi r^2) at step {}, {:.4g} "
                   "times that of the fluid, limits {} and {}: {}",
                   (tagint) grain[0], grain[1] * options.rho, update->ntimestep, grain[1], LIGHT,
                   HEAVY, remedy);
  else
    error->warning(FLERR,
                   "Fix lb/ibb: the masses of the grains are those of spheres of density {:.4g}, "
                   "for all radii from {:.4g} to {:.4g}: {}",
                   0.75 * range[1] * options.rho, -range[5], range[2], remedy);
}
