/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// The balance of momentum of fluid and grains where nothing holds them: none of this is there in a
// box with walls, open faces or obstacles.

#include "fix_lb_ibb.h"

#include "lbm_neighbours_mpi.h"

#include "atom.h"
#include "domain.h"

using namespace LAMMPS_NS;
using lbm::Vec3;

void FixLbIbb::provide_balance()
{
  for (int d = 0; d < domain->dimension; d++)
    if (!domain->periodicity[d]) return;
  if (options.conserve && options.obstacles.empty()) balance = std::make_unique<lbm::Balance>();
}

// Volume of all grains if all of them are free, else 0; lattice units. Collective.
double FixLbIbb::free_volume() const
{
  double sums[2] = {};    // volume, grains that are held
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    sums[0] += displaced_volume(i) / units.volume();
    sums[1] += !is_driven(i) || (atom->mask[i] & set_bits);
  }
  neighbours->sum(sums, 2);
  return sums[1] > 0.0 ? 0.0 : sums[0];
}

// after a fluid step; collective
void FixLbIbb::keep_momentum()
{
  Vec3 force;
  for (int d = 0; d < 3; d++) force[d] = drive.force[d] / units.force_density();
  balance->drive(force);
  for (const lbm::Load &load : loads) balance->take(load.force);
  if (fluid_steps % options.check != 0) return;

  const double volume = free_volume();
  if (volume == 0.0) return balance->forget();
  take_survey();
  const double all = double(nodes[0]) * nodes[1] * nodes[2];
  balance->look(survey, all - volume, options.check, *neighbours);
}
