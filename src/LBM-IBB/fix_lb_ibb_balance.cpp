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

// Are all grains free? Their volume, lattice units. Collective.
bool FixLbIbb::nothing_holds(double &volume) const
{
  double sums[3] = {};    // volume, grains, those that are held
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    sums[0] += displaced_volume(i) / units.volume();
    sums[1] += 1.0;
    sums[2] += !is_driven(i) || (atom->mask[i] & set_bits);
  }
  neighbours->sum(sums, 3);
  volume = sums[0];
  return sums[1] > 0.0 && sums[2] == 0.0;
}

bool FixLbIbb::keeps_momentum() const
{
  double volume;
  return balance && nothing_holds(volume);
}

// after a fluid step; collective
void FixLbIbb::keep_momentum()
{
  for (const lbm::Load &load : loads) balance->take(load.force);
  if (fluid_steps % options.check != 0) return;
  double volume;
  if (!nothing_holds(volume)) return balance->forget();
  take_survey();
  const double all = double(nodes[0]) * nodes[1] * nodes[2];
  balance->look(survey, all - volume, options.check, *neighbours);
}
