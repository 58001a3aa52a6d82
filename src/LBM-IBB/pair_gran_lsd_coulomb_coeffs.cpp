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

// Coefficients of pair style gran/lsd/coulomb: from the script and from restart files, worked out
// for each pair of types, and shown to other commands.

#include "pair_gran_lsd_coulomb.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "gran_lsd_material.h"
#include "memory.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

using namespace LAMMPS_NS;

static const char COEFF[] = "pair_coeff for gran/lsd/coulomb";

/* ---------------------------------------------------------------------- */

void PairGranLSDCoulomb::allocate()
{
  PairGranHooke::allocate();
  const int n = atom->ntypes + 1;
  memory->create(k_n, n, n, "pair:k_n");
  memory->create(restitution, n, n, "pair:restitution");
  memory->create(friction, n, n, "pair:friction");
  memory->create(law, n, n, "pair:law");
  std::fill_n(k_n[0], n * n, 0.0);    // 0 = not a pair of this style
}

/* ----------------------------------------------------------------------
   global settings
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::settings(int narg, char **arg)
{
  offset = 0.0;
  limit_damping = 0;
  std::set<std::string> given;

  for (int iarg = 0; iarg < narg; iarg += 2)
    if (!GranLSDMaterial::parse_option(lmp, STYLE, narg, arg, iarg, offset, limit_damping, given))
      error->all(FLERR,
                 "{}: unknown keyword {}, known are offset and limit_damping (see "
                 "doc/src/pair_gran_lsd_coulomb.rst)",
                 STYLE, arg[iarg]);

  // intervals of neighbor multi know the radii only: with an offset have the
  // cutoffs of the types used instead

  finitecutflag = (offset > 0.0) ? 0 : 1;
}

/* ----------------------------------------------------------------------
   set coeffs for one or more type pairs
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::coeff(int narg, char **arg)
{
  if (narg < 2 + GranLSDMaterial::NWORDS) utils::missing_cmd_args(FLERR, COEFF, error);
  if (narg > 2 + GranLSDMaterial::NWORDS)
    error->all(FLERR, "{}: unexpected word {} after the coefficients", COEFF,
               arg[2 + GranLSDMaterial::NWORDS]);
  if (!allocated) allocate();

  int ilo = 0, ihi = 0, jlo = 0, jhi = 0;
  try {
    utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
    utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  } catch (std::logic_error &) {    // of std::stol: a lone sign, too many digits
    error->all(FLERR, "{}: {} {} are no atom types or ranges of them", COEFF, arg[0], arg[1]);
  }
  const auto mat = GranLSDMaterial::parse(lmp, COEFF, narg, arg, 2);

  int count = 0;
  for (int i = ilo; i <= ihi; i++) {
    for (int j = MAX(jlo, i); j <= jhi; j++) {
      k_n[i][j] = mat.kn;
      restitution[i][j] = mat.e;
      friction[i][j] = mat.mu;
      setflag[i][j] = 1;
      count++;
    }
  }

  if (count == 0)
    error->all(FLERR, "{}: no pair of types in {} {} with the first not above the second", COEFF,
               arg[0], arg[1]);
}

/* ----------------------------------------------------------------------
   init for one type pair i,j and corresponding j,i
------------------------------------------------------------------------- */

double PairGranLSDCoulomb::init_one(int i, int j)
{
  if (setflag[i][j] == 0)
    error->all(FLERR,
               "{}: no coefficients for types {} and {}: add pair_coeff {} {}; restitution "
               "and friction belong to two materials and are not mixed",
               STYLE, i, j, i, j);

  const GranLSD::Material mat = {k_n[i][j], restitution[i][j], friction[i][j]};
  law[i][j] = law[j][i] = GranLSD::make_law(mat, limit_damping != 0);
  k_n[j][i] = mat.kn;
  restitution[j][i] = mat.e;
  friction[j][i] = mat.mu;

  return PairGranHooke::init_one(i, j) + 2.0 * offset;
}

/* ----------------------------------------------------------------------
   proc 0 writes to restart file
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::write_restart(FILE *fp)
{
  write_restart_settings(fp);

  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      fwrite(&setflag[i][j], sizeof(int), 1, fp);
      if (!setflag[i][j]) continue;
      for (double **value : {k_n, restitution, friction})
        fwrite(&value[i][j], sizeof(double), 1, fp);
    }
}

/* ----------------------------------------------------------------------
   proc 0 reads from restart file, bcasts
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();

  const int me = comm->me;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (me == 0) utils::sfread(FLERR, &setflag[i][j], sizeof(int), 1, fp, nullptr, error);
      MPI_Bcast(&setflag[i][j], 1, MPI_INT, 0, world);
      if (!setflag[i][j]) continue;
      for (double *value : {&k_n[i][j], &restitution[i][j], &friction[i][j]}) {
        if (me == 0) utils::sfread(FLERR, value, sizeof(double), 1, fp, nullptr, error);
        MPI_Bcast(value, 1, MPI_DOUBLE, 0, world);
      }
    }
}

/* ----------------------------------------------------------------------
   proc 0 writes to restart file
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::write_restart_settings(FILE *fp)
{
  fwrite(&offset, sizeof(double), 1, fp);
  fwrite(&limit_damping, sizeof(int), 1, fp);
}

/* ----------------------------------------------------------------------
   proc 0 reads from restart file, bcasts
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::read_restart_settings(FILE *fp)
{
  if (comm->me == 0) {
    utils::sfread(FLERR, &offset, sizeof(double), 1, fp, nullptr, error);
    utils::sfread(FLERR, &limit_damping, sizeof(int), 1, fp, nullptr, error);
  }
  MPI_Bcast(&offset, 1, MPI_DOUBLE, 0, world);
  MPI_Bcast(&limit_damping, 1, MPI_INT, 0, world);
  finitecutflag = (offset > 0.0) ? 0 : 1;
}

/* ---------------------------------------------------------------------- */

void *PairGranLSDCoulomb::extract(const char *str, int &dim)
{
  dim = 0;
  if (strcmp(str, "t_contact") == 0) return (void *) &t_contact;
  if (strcmp(str, "offset") == 0) return (void *) &offset;
  dim = 2;
  if (strcmp(str, "kn") == 0) return (void *) k_n;
  if (strcmp(str, "e") == 0) return (void *) restitution;
  if (strcmp(str, "mu") == 0) return (void *) friction;
  return nullptr;
}
