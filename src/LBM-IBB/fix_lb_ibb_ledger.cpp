/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// The mass ledger of fix lb/ibb for the user, and the fluid that grains enclose.

#include "fix_lb_ibb.h"

#include "lbm_neighbours_mpi.h"

using namespace LAMMPS_NS;
using lbm::Ledger;

// gained since the fluid began, at rest density everywhere
double FixLbIbb::unaccounted(const Ledger &ledger)
{
  take_survey();
  return survey.mass - double(nodes[0]) * nodes[1] * nodes[2] - ledger.total();
}

double FixLbIbb::ledger_entry(int n)
{
  if (n == UNACCOUNTED + 1) return fluid->enclosed_sets();
  if (n == UNACCOUNTED + 2) return fluid->enclosed_nodes();
  const Ledger ledger = fluid->ledger();
  return units.mass() * (n == UNACCOUNTED ? unaccounted(ledger) : ledger.gain(n));
}

std::string FixLbIbb::ledger_report() const
{
  static const char *name[] = {"covered",    "uncovered", "displaced", "swallowed",
                               "given back", "pockets",   "restored"};
  const Ledger ledger = fluid->ledger();
  std::string text;
  for (int k = 0; k < Ledger::FACES; k++)
    text += fmt::format("{} {:.4g}, ", name[k], ledger.gain(k) * units.mass());
  double faces = 0.0;
  for (int k = Ledger::FACES; k < Ledger::ACCOUNTS; k++) faces += ledger.gain(k);
  return fmt::format("  mass gained so far: {}through faces {:.4g}; {:.0f} enclosed pockets with "
                     "{:.0f} nodes\n",
                     text, faces * units.mass(), fluid->enclosed_sets(), fluid->enclosed_nodes());
}
