/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   Contributing authors: LBM-IBB developers
------------------------------------------------------------------------- */

#include "gran_lsd_timestep.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "gran_lsd_grains.h"
#include "gran_lsd_law.h"
#include "update.h"

using namespace LAMMPS_NS;
using GranLSDTimestep::BIG;

// slack for a time step typed in from a printed limit

static constexpr double ROUNDING = 1.0 + 1.0e-6;

/* ---------------------------------------------------------------------- */

static bool too_long(LAMMPS *lmp, double fraction, double t_contact)
{
  return t_contact > 0.0 && lmp->update->dt > ROUNDING * fraction * t_contact;
}

/* ---------------------------------------------------------------------- */

static std::string refusal(LAMMPS *lmp, const std::string &style, double t_contact)
{
  return fmt::format("Timestep {:.6g} is more than a tenth of the shortest contact of {}, which "
                     "lasts {:.6g}: use a timestep of at most {:.6g} ({:.6g} is advised), or a "
                     "lower k_n",
                     lmp->update->dt, style, t_contact, GranLSD::STEP_LIMIT * t_contact,
                     GranLSD::STEP_GOOD * t_contact);
}

/* ---------------------------------------------------------------------- */

void GranLSDTimestep::check(LAMMPS *lmp, const std::string &style, double t_contact)
{
  if (too_long(lmp, GranLSD::STEP_LIMIT, t_contact))
    lmp->error->all(FLERR, refusal(lmp, style, t_contact));
  if (too_long(lmp, GranLSD::STEP_GOOD, t_contact) && lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        "Timestep {:.6g} is more than a fiftieth of the shortest contact of {}, "
                        "which lasts {:.6g}: the restitution will be off by more than a percent; "
                        "a timestep of {:.6g} is advised",
                        lmp->update->dt, style, t_contact, GranLSD::STEP_GOOD * t_contact);
}

/* ---------------------------------------------------------------------- */

void GranLSDTimestep::check_one(LAMMPS *lmp, const std::string &style, double t_contact)
{
  if (too_long(lmp, GranLSD::STEP_LIMIT, t_contact))
    lmp->error->one(FLERR, refusal(lmp, style, t_contact));
}

/* ---------------------------------------------------------------------- */

void GranLSDTimestep::check_reset(LAMMPS *lmp, const std::string &style, double t_contact)
{
  if (lmp->update->whichflag == 1) check_one(lmp, style, t_contact);
}

/* ---------------------------------------------------------------------- */

void GranLSDLightestGrains::find(int freeze_bit, const double *mass_rigid)
{
  const int n = atom->ntypes + 1;
  lightest.assign(n, BIG);
  has_frozen.assign(n, 0);
  find_lighter(freeze_bit, mass_rigid);
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & freeze_bit) has_frozen[atom->type[i]] = 1;
  MPI_Allreduce(MPI_IN_PLACE, lightest.data(), n, MPI_DOUBLE, MPI_MIN, world);
  MPI_Allreduce(MPI_IN_PLACE, has_frozen.data(), n, MPI_INT, MPI_MAX, world);
}

/* ---------------------------------------------------------------------- */

bool GranLSDLightestGrains::find_lighter(int freeze_bit, const double *mass_rigid)
{
  if (lightest.empty()) return false;    // find() has not been called yet
  bool lighter = false;
  for (int i = 0; i < atom->nlocal; i++) {
    if (atom->mask[i] & freeze_bit) continue;
    const double mass = GranLSDGrains::mass(i, atom->rmass, mass_rigid);
    if (mass >= lightest[atom->type[i]]) continue;
    lightest[atom->type[i]] = mass;
    lighter = true;
  }
  return lighter;
}

/* ----------------------------------------------------------------------
   of each type two grains of the smallest mass are taken to meet
------------------------------------------------------------------------- */

double GranLSDLightestGrains::shortest_contact(double **kn, double **e, double **mu) const
{
  double shortest = BIG;
  for (int i = 1; i <= atom->ntypes; i++) {
    if (lightest[i] >= BIG) continue;
    for (int j = 1; j <= atom->ntypes; j++) {
      if (lightest[j] >= BIG && !has_frozen[j]) continue;
      if (kn[i][j] <= 0.0) continue;    // of another style
      const double inv_mj = (lightest[j] < BIG) ? 1.0 / lightest[j] : 0.0;
      const double meff = 1.0 / (1.0 / lightest[i] + inv_mj);
      shortest = MIN(shortest, GranLSD::contact_time({kn[i][j], e[i][j], mu[i][j]}, meff));
    }
  }
  return (shortest < BIG) ? shortest : 0.0;
}
