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

#include "pair_gran_lsd_coulomb.h"

#include "atom.h"
#include "citeme.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "gran_lsd_material.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

static constexpr double BIG = 1.0e300;
static const char STYLE[] = "pair_style gran/lsd/coulomb";

static const char cite_lsd_coulomb[] =
    "pair_style gran/lsd/coulomb: https://doi.org/10.1002/nag.2556\n\n"
    "@Article{Mansouri2017,\n"
    " author =  {Mansouri, Mouloud and El Youssoufi, Moulay Sa{\\\"i}d and Nicot, Fran{\\c "
    "c}ois},\n"
    " title =   {Numerical simulation of the quicksand phenomenon by a {3D} coupled\n"
    "            {Discrete Element - Lattice Boltzmann} hydromechanical model},\n"
    " journal = {International Journal for Numerical and Analytical Methods in Geomechanics},\n"
    " year =    {2017},\n"
    " volume =  {41},\n"
    " number =  {3},\n"
    " pages =   {338--358}\n"
    "}\n\n";

/* ---------------------------------------------------------------------- */

PairGranLSDCoulomb::PairGranLSDCoulomb(LAMMPS *lmp) :
    PairGranHooke(lmp), offset(0.0), inertia_factor(GranLSD::INERTIA_SPHERE), k_n(nullptr),
    restitution(nullptr), friction(nullptr), law(nullptr), t_contact(0.0)
{
  if (lmp->citeme) lmp->citeme->add(cite_lsd_coulomb);

  // what the parent reads from its own pair_style line and is not used here

  kn = kt = gamman = gammat = xmu = 0.0;
  dampflag = 0;
  limit_damping = 0;
}

/* ---------------------------------------------------------------------- */

PairGranLSDCoulomb::~PairGranLSDCoulomb()
{
  if (copymode) return;

  memory->destroy(k_n);
  memory->destroy(restitution);
  memory->destroy(friction);
  memory->destroy(law);
}

/* ----------------------------------------------------------------------
   mass a grain answers with: its own, or that of its rigid body
------------------------------------------------------------------------- */

inline double PairGranLSDCoulomb::mass(int i) const
{
  if (fix_rigid && mass_rigid[i] > 0.0) return mass_rigid[i];
  return atom->rmass[i];
}

/* ----------------------------------------------------------------------
   contact of grains i and j, n = unit vector from j to i, r = distance.
   The contact point is in the middle of the overlap, so the arms add up to
   r and the contact conserves angular momentum.
------------------------------------------------------------------------- */

inline GranLSD::Force PairGranLSDCoulomb::contact(int i, int j, double r, double radsum,
                                                  const double *n, const GranLSD::Law &pairlaw,
                                                  double &armi, double &armj) const
{
  const double *radius = atom->radius;
  const int *mask = atom->mask;
  const double overlap = radsum - r;
  armi = radius[i] + offset - 0.5 * overlap;
  armj = radius[j] + offset - 0.5 * overlap;
  auto si =
      GranLSD::make_side(atom->v[i], atom->omega[i], radius[i], armi, mass(i), inertia_factor);
  auto sj =
      GranLSD::make_side(atom->v[j], atom->omega[j], radius[j], armj, mass(j), inertia_factor);
  if (mask[i] & freeze_group_bit) si.inv_mass = si.inv_inertia = 0.0;
  if (mask[j] & freeze_group_bit) sj.inv_mass = sj.inv_inertia = 0.0;
  return GranLSD::evaluate(pairlaw, overlap, n, si, sj, dt);
}

/* ---------------------------------------------------------------------- */

void PairGranLSDCoulomb::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);

  if (neighbor->ago == 0) {
    update_rigid_masses();
    if (!update->setupflag) check_new_grains();
  }

  double **x = atom->x;
  double **f = atom->f;
  double **torque = atom->torque;
  const double *radius = atom->radius;
  const int *type = atom->type;
  const int *mask = atom->mask;
  const int nlocal = atom->nlocal;
  const int newton_pair = force->newton_pair;
  const double *special_lj = force->special_lj;

  const int inum = list->inum;
  const int *ilist = list->ilist;
  const int *numneigh = list->numneigh;
  int **firstneigh = list->firstneigh;

  // loop over neighbors of my atoms

  for (int ii = 0; ii < inum; ii++) {
    const int i = ilist[ii];
    const double xtmp = x[i][0];
    const double ytmp = x[i][1];
    const double ztmp = x[i][2];
    const double radi = radius[i] + 2.0 * offset;
    const GranLSD::Law *lawi = law[type[i]];
    const int *jlist = firstneigh[i];
    const int jnum = numneigh[i];

    for (int jj = 0; jj < jnum; jj++) {
      int j = jlist[jj];
      const double factor_lj = special_lj[sbmask(j)];
      j &= NEIGHMASK;
      if (factor_lj == 0.0) continue;

      const double delx = xtmp - x[j][0];
      const double dely = ytmp - x[j][1];
      const double delz = ztmp - x[j][2];
      const double rsq = delx * delx + dely * dely + delz * delz;
      const double radsum = radi + radius[j];
      if (rsq >= radsum * radsum) continue;

      // two frozen grains: there is nothing to move

      if (mask[i] & mask[j] & freeze_group_bit) continue;

      const double r = sqrt(rsq);
      const double rinv = 1.0 / r;
      const double n[3] = {delx * rinv, dely * rinv, delz * rinv};
      double armi, armj;
      const auto hit = contact(i, j, r, radsum, n, lawi[type[j]], armi, armj);

      const double fx = factor_lj * (hit.fn * n[0] + hit.fs[0]);
      const double fy = factor_lj * (hit.fn * n[1] + hit.fs[1]);
      const double fz = factor_lj * (hit.fn * n[2] + hit.fs[2]);
      f[i][0] += fx;
      f[i][1] += fy;
      f[i][2] += fz;

      const double tx = factor_lj * (n[1] * hit.fs[2] - n[2] * hit.fs[1]);
      const double ty = factor_lj * (n[2] * hit.fs[0] - n[0] * hit.fs[2]);
      const double tz = factor_lj * (n[0] * hit.fs[1] - n[1] * hit.fs[0]);
      torque[i][0] -= armi * tx;
      torque[i][1] -= armi * ty;
      torque[i][2] -= armi * tz;

      if (newton_pair || j < nlocal) {
        f[j][0] -= fx;
        f[j][1] -= fy;
        f[j][2] -= fz;
        torque[j][0] -= armj * tx;
        torque[j][1] -= armj * ty;
        torque[j][2] -= armj * tz;
      }

      if (evflag) ev_tally_xyz(i, j, nlocal, newton_pair, 0.0, 0.0, fx, fy, fz, delx, dely, delz);
    }
  }

  if (vflag_fdotr) virial_fdotr_compute();
}

/* ----------------------------------------------------------------------
   masses of the rigid bodies, for own and ghost atoms
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::update_rigid_masses()
{
  if (!fix_rigid) return;

  int tmp;
  auto *body = (int *) fix_rigid->extract("body", tmp);
  auto *mass_body = (double *) fix_rigid->extract("masstotal", tmp);
  if (atom->nmax > nmax) {
    memory->destroy(mass_rigid);
    nmax = atom->nmax;
    memory->create(mass_rigid, nmax, "pair:mass_rigid");
  }
  for (int i = 0; i < atom->nlocal; i++) mass_rigid[i] = (body[i] >= 0) ? mass_body[body[i]] : 0.0;
  comm->forward_comm(this);
}

/* ---------------------------------------------------------------------- */

void PairGranLSDCoulomb::allocate()
{
  PairGranHooke::allocate();
  const int n = atom->ntypes + 1;
  memory->create(k_n, n, n, "pair:k_n");
  memory->create(restitution, n, n, "pair:restitution");
  memory->create(friction, n, n, "pair:friction");
  memory->create(law, n, n, "pair:law");
}

/* ----------------------------------------------------------------------
   global settings
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::settings(int narg, char **arg)
{
  offset = 0.0;
  limit_damping = 0;

  int iarg = 0;
  while (iarg < narg) {
    if (iarg + 2 > narg)
      utils::missing_cmd_args(FLERR, fmt::format("{} {}", STYLE, arg[iarg]), error);
    if (strcmp(arg[iarg], "offset") == 0) {
      offset = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
      if (!(offset >= 0.0) || std::isinf(offset))
        error->all(FLERR, "{}: offset {} must be 0 or positive", STYLE, offset);
    } else if (strcmp(arg[iarg], "limit_damping") == 0) {
      limit_damping = utils::logical(FLERR, arg[iarg + 1], false, lmp);
    } else {
      error->all(FLERR, "{}: unknown keyword {}, known are offset and limit_damping", STYLE,
                 arg[iarg]);
    }
    iarg += 2;
  }

  // intervals of neighbor multi know the radii only: with an offset have the
  // cutoffs of the types used instead

  finitecutflag = (offset > 0.0) ? 0 : 1;
}

/* ----------------------------------------------------------------------
   set coeffs for one or more type pairs
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::coeff(int narg, char **arg)
{
  if (narg < 2 + GranLSDMaterial::NWORDS)
    utils::missing_cmd_args(FLERR, "pair_coeff for gran/lsd/coulomb", error);
  if (narg > 2 + GranLSDMaterial::NWORDS)
    error->all(FLERR, "pair_coeff for gran/lsd/coulomb: unexpected word {} after the coefficients",
               arg[2 + GranLSDMaterial::NWORDS]);
  if (!allocated) allocate();

  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  const auto mat = GranLSDMaterial::parse(lmp, "pair_coeff for gran/lsd/coulomb", narg, arg, 2);

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
    error->all(FLERR,
               "pair_coeff for gran/lsd/coulomb: no pair of types in {} {} with the first "
               "not above the second",
               arg[0], arg[1]);
}

/* ----------------------------------------------------------------------
   init specific to this pair style
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::init_style()
{
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag)
    error->all(FLERR, "{} requires atoms with radius, mass and rotation: use atom_style sphere",
               STYLE);
  if (comm->ghost_velocity == 0)
    error->all(FLERR, "{} requires the velocities of ghost atoms: add comm_modify vel yes", STYLE);

  GranLSDMaterial::check_units(lmp, STYLE);

  // Granular neighbor lists hold the pairs closer than r_i + r_j + skin, which
  // an offset would eat up.  With one, take a list by the cutoffs of init_one(),
  // which include the offset: longer where sizes differ, but complete.

  neighbor->add_request(this, (offset > 0.0) ? NeighConst::REQ_DEFAULT : NeighConst::REQ_SIZE);

  dt = update->dt;
  inertia_factor = (domain->dimension == 2) ? GranLSD::INERTIA_DISC : GranLSD::INERTIA_SPHERE;

  // grains of fix freeze count as infinitely heavy, those of fix rigid weigh
  // what their body weighs

  auto freezes = modify->get_fix_by_style("^freeze");
  if (freezes.size() > 1)
    error->all(FLERR, "{} can be used with one fix freeze, not with {}", STYLE, freezes.size());
  freeze_group_bit = freezes.empty() ? 0 : freezes.front()->groupbit;

  fix_rigid = nullptr;
  for (const auto &ifix : modify->get_fix_list()) {
    if (!ifix->rigid_flag) continue;
    if (fix_rigid)
      error->all(FLERR, "{} can be used with one fix rigid, not with {} and {}", STYLE,
                 fix_rigid->id, ifix->id);
    fix_rigid = ifix;
  }

  // largest radius of each type, of grains that are there or will be inserted

  auto inserts = modify->get_fix_by_style("^pour");
  for (auto &ifix : modify->get_fix_by_style("^deposit")) inserts.push_back(ifix);

  for (int i = 1; i <= atom->ntypes; i++) {
    onerad_dynamic[i] = onerad_frozen[i] = 0.0;
    for (auto &ifix : inserts) {
      int itype = i;
      auto *maxrad = (double *) ifix->extract("radius", itype);
      if (maxrad) onerad_dynamic[i] = MAX(onerad_dynamic[i], *maxrad);
    }
  }

  for (int i = 0; i < atom->nlocal; i++) {
    double *onerad = (atom->mask[i] & freeze_group_bit) ? onerad_frozen : onerad_dynamic;
    onerad[atom->type[i]] = MAX(onerad[atom->type[i]], atom->radius[i]);
  }

  MPI_Allreduce(&onerad_dynamic[1], &maxrad_dynamic[1], atom->ntypes, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(&onerad_frozen[1], &maxrad_frozen[1], atom->ntypes, MPI_DOUBLE, MPI_MAX, world);
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
   before the first step of a run: is the time step short enough?
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::setup()
{
  dt = update->dt;
  update_rigid_masses();
  find_lightest();
  t_contact = shortest_contact();
  if (t_contact > 0.0 && update->whichflag == 1)
    GranLSDMaterial::check_timestep(lmp, STYLE, t_contact);
}

/* ----------------------------------------------------------------------
   smallest mass of each type that is free to move, on all ranks
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::find_lightest()
{
  const int n = atom->ntypes + 1;
  std::vector<double> mine(n, BIG);
  std::vector<int> frozen(n, 0);
  for (int i = 0; i < atom->nlocal; i++) {
    const int itype = atom->type[i];
    if (atom->mask[i] & freeze_group_bit)
      frozen[itype] = 1;
    else
      mine[itype] = MIN(mine[itype], mass(i));
  }
  lightest.resize(n);
  type_is_frozen.resize(n);
  MPI_Allreduce(mine.data(), lightest.data(), n, MPI_DOUBLE, MPI_MIN, world);
  MPI_Allreduce(frozen.data(), type_is_frozen.data(), n, MPI_INT, MPI_MAX, world);
}

/* ----------------------------------------------------------------------
   shortest contact there can be; 0 = no grain can touch another.
   Of each type two grains of the smallest mass are taken to meet.
------------------------------------------------------------------------- */

double PairGranLSDCoulomb::shortest_contact() const
{
  double shortest = BIG;
  for (int i = 1; i <= atom->ntypes; i++) {
    if (lightest[i] >= BIG) continue;
    for (int j = 1; j <= atom->ntypes; j++) {
      if (lightest[j] >= BIG && !type_is_frozen[j]) continue;
      const double inv_mj = (lightest[j] < BIG) ? 1.0 / lightest[j] : 0.0;
      const double meff = 1.0 / (1.0 / lightest[i] + inv_mj);
      const GranLSD::Material mat = {k_n[i][j], restitution[i][j], friction[i][j]};
      shortest = MIN(shortest, GranLSD::contact_time(mat, meff));
    }
  }
  return (shortest < BIG) ? shortest : 0.0;
}

/* ----------------------------------------------------------------------
   grains may be inserted or change during a run: look again, rank by rank
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::check_new_grains()
{
  if (lightest.empty()) return;
  bool lighter = false;
  for (int i = 0; i < atom->nlocal; i++) {
    if (atom->mask[i] & freeze_group_bit) continue;
    const int itype = atom->type[i];
    if (mass(i) >= lightest[itype]) continue;
    lightest[itype] = mass(i);
    lighter = true;
  }
  if (!lighter) return;
  t_contact = shortest_contact();
  GranLSDMaterial::check_timestep_one(lmp, STYLE, t_contact);
}

/* ----------------------------------------------------------------------
   the timestep command outside of a run is checked when the run begins
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::reset_dt()
{
  dt = update->dt;
  if (update->whichflag == 1 && t_contact > 0.0)
    GranLSDMaterial::check_timestep_one(lmp, STYLE, t_contact);
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
      fwrite(&k_n[i][j], sizeof(double), 1, fp);
      fwrite(&restitution[i][j], sizeof(double), 1, fp);
      fwrite(&friction[i][j], sizeof(double), 1, fp);
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

double PairGranLSDCoulomb::single(int i, int j, int itype, int jtype, double rsq,
                                  double /*factor_coul*/, double factor_lj, double &fforce)
{
  const double radsum = atom->radius[i] + atom->radius[j] + 2.0 * offset;

  fforce = 0.0;
  for (int m = 0; m < single_extra; m++) svector[m] = 0.0;
  if (rsq >= radsum * radsum) return 0.0;
  if (atom->mask[i] & atom->mask[j] & freeze_group_bit) return 0.0;

  const double r = sqrt(rsq);
  double n[3], armi, armj;
  for (int d = 0; d < 3; d++) n[d] = (atom->x[i][d] - atom->x[j][d]) / r;
  const auto hit = contact(i, j, r, radsum, n, law[itype][jtype], armi, armj);

  // force over distance; a contact has no energy of its own as it dissipates

  fforce = factor_lj * hit.fn / r;

  double fs2 = 0.0;
  for (int d = 0; d < 3; d++) {
    svector[d] = factor_lj * hit.fs[d];
    fs2 += svector[d] * svector[d];
    svector[4 + d] = hit.vn * n[d];
    svector[7 + d] = hit.slip[d];
  }
  svector[3] = sqrt(fs2);
  return 0.0;
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
