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
#include "gran_lsd_grains.h"
#include "lb_ibb_citation.h"
#include "math_extra.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairGranLSDCoulomb::PairGranLSDCoulomb(LAMMPS *lmp) :
    PairGranHooke(lmp), offset(0.0), inertia_factor(GranLSD::INERTIA_SPHERE), k_n(nullptr),
    restitution(nullptr), friction(nullptr), law(nullptr), t_contact(0.0), lightest(lmp)
{
  if (lmp->citeme) lmp->citeme->add(LB_IBB_CITATION);

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
  const double massi = GranLSDGrains::mass(i, atom->rmass, mass_rigid);
  const double massj = GranLSDGrains::mass(j, atom->rmass, mass_rigid);
  armi = radius[i] + offset - 0.5 * overlap;
  armj = radius[j] + offset - 0.5 * overlap;
  auto si = GranLSD::make_side(atom->v[i], atom->omega[i], radius[i], armi, massi, inertia_factor);
  auto sj = GranLSD::make_side(atom->v[j], atom->omega[j], radius[j], armj, massj, inertia_factor);
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

    // grains may be inserted or change during a run: look again, rank by rank

    if (!update->setupflag && lightest.find_lighter(freeze_group_bit, mass_rigid)) {
      t_contact = lightest.shortest_contact(k_n, restitution, friction);
      GranLSDTimestep::check_one(lmp, STYLE, t_contact);
    }
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
    const double xi[3] = {x[i][0], x[i][1], x[i][2]};
    const double radi = radius[i] + 2.0 * offset;
    const GranLSD::Law *lawi = law[type[i]];
    const int *jlist = firstneigh[i];
    const int jnum = numneigh[i];

    for (int jj = 0; jj < jnum; jj++) {
      int j = jlist[jj];
      const double factor_lj = special_lj[sbmask(j)];
      j &= NEIGHMASK;
      if (factor_lj == 0.0) continue;

      const double del[3] = {xi[0] - x[j][0], xi[1] - x[j][1], xi[2] - x[j][2]};
      const double rsq = MathExtra::lensq3(del);
      const double radsum = radi + radius[j];
      if (rsq >= radsum * radsum) continue;

      // two frozen grains: there is nothing to move

      if (mask[i] & mask[j] & freeze_group_bit) continue;

      const double r = sqrt(rsq);
      const double rinv = 1.0 / r;
      const double n[3] = {del[0] * rinv, del[1] * rinv, del[2] * rinv};
      double armi, armj;
      const auto hit = contact(i, j, r, radsum, n, lawi[type[j]], armi, armj);

      double force_i[3], turn[3];
      MathExtra::cross3(n, hit.fs, turn);
      for (int d = 0; d < 3; d++) {
        force_i[d] = factor_lj * (hit.fn * n[d] + hit.fs[d]);
        turn[d] *= factor_lj;
        f[i][d] += force_i[d];
        torque[i][d] -= armi * turn[d];
      }
      if (newton_pair || j < nlocal) {
        for (int d = 0; d < 3; d++) {
          f[j][d] -= force_i[d];
          torque[j][d] -= armj * turn[d];
        }
      }

      if (evflag)
        ev_tally_xyz(i, j, nlocal, newton_pair, 0.0, 0.0, force_i[0], force_i[1], force_i[2],
                     del[0], del[1], del[2]);
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

  if (atom->nmax > nmax) {
    memory->destroy(mass_rigid);
    nmax = atom->nmax;
    memory->create(mass_rigid, nmax, "pair:mass_rigid");
  }
  std::fill(mass_rigid, mass_rigid + atom->nlocal, 0.0);
  GranLSDGrains::put_rigid_masses(fix_rigid, atom->nlocal, mass_rigid);
  comm->forward_comm(this);
}

/* ----------------------------------------------------------------------
   init specific to this pair style
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::init_style()
{
  GranLSDGrains::check_spheres(lmp, STYLE);
  if (comm->ghost_velocity == 0)
    error->all(FLERR, "{} requires the velocities of ghost atoms: add comm_modify vel yes", STYLE);

  GranLSDGrains::check_units(lmp, STYLE);

  dt = update->dt;
  inertia_factor = GranLSDGrains::inertia_factor(lmp);

  // grains of fix freeze count as infinitely heavy, those of fix rigid weigh
  // what their body weighs

  auto freezes = modify->get_fix_by_style("^freeze");
  if (freezes.size() > 1)
    error->all(FLERR, "{} can be used with one fix freeze, not with {}", STYLE, freezes.size());
  freeze_group_bit = freezes.empty() ? 0 : freezes.front()->groupbit;

  fix_rigid = GranLSDGrains::find_rigid(lmp, STYLE);
  if (!fix_rigid) {
    memory->destroy(mass_rigid);
    nmax = 0;
  }

  GranLSDGrains::largest_radii(lmp, freeze_group_bit, maxrad_dynamic, maxrad_frozen);
  check_offset();

  // Granular neighbor lists hold the pairs closer than r_i + r_j + skin, which
  // an offset would eat up.  With one, take a list by the cutoffs of init_one(),
  // which include the offset: longer where sizes differ, but complete.  Last of
  // all: a request of a style that ends in an error would outlive it.

  neighbor->add_request(this, (offset > 0.0) ? NeighConst::REQ_DEFAULT : NeighConst::REQ_SIZE);
}

/* ----------------------------------------------------------------------
   cutoffs contain the offset: a huge one would fill memory with ghost atoms
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::check_offset() const
{
  double limit = 0.0;
  for (int i = 1; i <= atom->ntypes; i++)
    limit = MAX(limit, MAX(maxrad_dynamic[i], maxrad_frozen[i]));
  const char *what = "the largest radius";
  if (limit <= 0.0) {    // grains may come later
    limit = 0.5 * MIN(domain->prd[0], domain->prd[1]);
    what = "half of the box";
  }
  if (offset > limit)
    error->all(FLERR, "{}: offset {} is larger than {}, {}: offsets are small parts of radii",
               STYLE, offset, what, limit);
}

/* ----------------------------------------------------------------------
   before the first step of a run: is the time step short enough?
------------------------------------------------------------------------- */

void PairGranLSDCoulomb::setup()
{
  dt = update->dt;
  update_rigid_masses();
  lightest.find(freeze_group_bit, mass_rigid);
  t_contact = lightest.shortest_contact(k_n, restitution, friction);
  if (update->whichflag == 1) GranLSDTimestep::check(lmp, STYLE, t_contact);
}

/* ---------------------------------------------------------------------- */

void PairGranLSDCoulomb::reset_dt()
{
  dt = update->dt;
  GranLSDTimestep::check_reset(lmp, STYLE, t_contact);
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
