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

#include "gran_lsd_grains.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "gran_lsd_law.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void GranLSDGrains::check_spheres(LAMMPS *lmp, const std::string &style)
{
  const Atom *atom = lmp->atom;
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag)
    lmp->error->all(
        FLERR, "{} requires atoms with radius, mass and rotation: use atom_style sphere", style);
}

/* ---------------------------------------------------------------------- */

void GranLSDGrains::check_units(LAMMPS *lmp, const std::string &style)
{
  if (lmp->force->ftm2v != 1.0)
    lmp->error->all(FLERR,
                    "{} cannot be used with units {}, in which a force is not a mass times an "
                    "acceleration: use si, cgs, micro, nano or lj",
                    style, lmp->update->unit_style);
}

/* ---------------------------------------------------------------------- */

double GranLSDGrains::inertia_factor(LAMMPS *lmp)
{
  return (lmp->domain->dimension == 2) ? GranLSD::INERTIA_DISC : GranLSD::INERTIA_SPHERE;
}

/* ---------------------------------------------------------------------- */

Fix *GranLSDGrains::find_rigid(LAMMPS *lmp, const std::string &style)
{
  Fix *found = nullptr;
  for (const auto &ifix : lmp->modify->get_fix_list()) {
    if (!ifix->rigid_flag) continue;
    if (found)
      lmp->error->all(FLERR, "{} can be used with one fix rigid, not with {} and {}", style,
                      found->id, ifix->id);
    found = ifix;
  }
  return found;
}

/* ---------------------------------------------------------------------- */

void GranLSDGrains::put_rigid_masses(Fix *fix_rigid, int nlocal, double *mass)
{
  int tmp;
  const auto *body = (int *) fix_rigid->extract("body", tmp);
  const auto *mass_body = (double *) fix_rigid->extract("masstotal", tmp);
  for (int i = 0; i < nlocal; i++)
    if (body[i] >= 0) mass[i] = mass_body[body[i]];
}

/* ---------------------------------------------------------------------- */

void GranLSDGrains::largest_radii(LAMMPS *lmp, int freeze_bit, double *moving, double *frozen)
{
  const Atom *atom = lmp->atom;
  const int ntypes = atom->ntypes;
  auto inserts = lmp->modify->get_fix_by_style("^pour");
  for (auto &ifix : lmp->modify->get_fix_by_style("^deposit")) inserts.push_back(ifix);

  for (int i = 1; i <= ntypes; i++) {
    moving[i] = frozen[i] = 0.0;
    for (auto &ifix : inserts) {
      int itype = i;
      const auto *maxrad = (double *) ifix->extract("radius", itype);
      if (maxrad) moving[i] = MAX(moving[i], *maxrad);
    }
  }

  for (int i = 0; i < atom->nlocal; i++) {
    double &largest = ((atom->mask[i] & freeze_bit) ? frozen : moving)[atom->type[i]];
    largest = MAX(largest, atom->radius[i]);
  }

  MPI_Allreduce(MPI_IN_PLACE, &moving[1], ntypes, MPI_DOUBLE, MPI_MAX, lmp->world);
  MPI_Allreduce(MPI_IN_PLACE, &frozen[1], ntypes, MPI_DOUBLE, MPI_MAX, lmp->world);
}
