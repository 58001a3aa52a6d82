/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "pair_lubricate_lb_ibb.h"

#include "atom.h"
#include "citeme.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_lb_ibb.h"
#include "force.h"
#include "gran_lsd_grains.h"
#include "lb_ibb_citation.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using lbm::Vec3;

static const char STYLE[] = "Pair style lubricate/lb/ibb";

PairLubricateLbIbb::PairLubricateLbIbb(LAMMPS *lmp) :
    Pair(lmp), least(0.0), normal_cells(2.0 / 3.0), shear_cells(0.5), with_walls(1),
    fluid(nullptr), film{}, largest(nullptr), largest_frozen(nullptr)
{
  if (lmp->citeme) lmp->citeme->add(LB_IBB_CITATION);
  single_enable = 1;
  no_virial_fdotr_compute = 1;    // walls are in the forces, and not among the pairs
}

PairLubricateLbIbb::~PairLubricateLbIbb()
{
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
  memory->destroy(largest);
  memory->destroy(largest_frozen);
}

// on i, from j; n points from i to j
bool PairLubricateLbIbb::film_between(int i, int j, double rsq, Vec3 &n, lbm::FilmLoad &load) const
{
  const double ri = fluid->hydrodynamic_radius(i), rj = fluid->hydrodynamic_radius(j);
  const double reach = ri + rj + film.reach();
  if (rsq >= reach * reach || rsq <= (ri + rj) * (ri + rj)) return false;
  const double r = std::sqrt(rsq);
  Vec3 w, spin_i, spin_j;
  for (int d = 0; d < 3; d++) {
    n[d] = (atom->x[j][d] - atom->x[i][d]) / r;
    w[d] = atom->v[j][d] - atom->v[i][d];
    spin_i[d] = atom->omega[i][d];
    spin_j[d] = atom->omega[j][d];
  }
  load = lbm::film_of_spheres(film, ri, rj, n, r - ri - rj, w, spin_i, spin_j);
  return true;
}

void PairLubricateLbIbb::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  double **x = atom->x, **f = atom->f, **torque = atom->torque;
  const int *mask = atom->mask, group = fluid->groupbit, nlocal = atom->nlocal;

  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    if (!(mask[i] & group)) continue;
    const int *jlist = list->firstneigh[i];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = jlist[jj] & NEIGHMASK;
      if (!(mask[j] & group)) continue;
      double del[3], rsq = 0.0;
      for (int d = 0; d < 3; d++) {
        del[d] = x[i][d] - x[j][d];
        rsq += del[d] * del[d];
      }
      Vec3 n;
      lbm::FilmLoad load;
      if (!film_between(i, j, rsq, n, load)) continue;
      const bool both = force->newton_pair || j < nlocal;
      for (int d = 0; d < 3; d++) {
        f[i][d] += load.force[d];
        torque[i][d] += load.torque1[d];
        if (both) {
          f[j][d] -= load.force[d];
          torque[j][d] += load.torque2[d];
        }
      }
      if (evflag)
        ev_tally_xyz(i, j, nlocal, force->newton_pair, 0.0, 0.0, load.force[0], load.force[1],
                     load.force[2], del[0], del[1], del[2]);
    }
  }
  if (with_walls) compute_walls();
}

// walls are planes half a spacing outside the outermost nodes: the faces of the box
void PairLubricateLbIbb::compute_walls()
{
  for (int d = 0; d < 3; d++)
    for (int side = 0; side < 2; side++) {
      if (!fluid->has_wall(d, side)) continue;
      const double plane = side == 0 ? domain->boxlo[d] : domain->boxhi[d];
      const Vec3 &velocity = fluid->face_velocity(d, side);
      Vec3 n{};
      n[d] = side == 0 ? -1.0 : 1.0;
      for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & fluid->groupbit)) continue;
        const double a = fluid->hydrodynamic_radius(i), gap = std::abs(plane - atom->x[i][d]) - a;
        if (gap <= 0.0 || gap >= film.reach()) continue;
        Vec3 w, spin;
        for (int k = 0; k < 3; k++) {
          w[k] = velocity[k] - atom->v[i][k];
          spin[k] = atom->omega[i][k];
        }
        const lbm::FilmLoad load = lbm::film_at_wall(film, a, n, gap, w, spin);
        for (int k = 0; k < 3; k++) {
          atom->f[i][k] += load.force[k];
          atom->torque[i][k] += load.torque1[k];
        }
      }
    }
}

void PairLubricateLbIbb::allocate()
{
  allocated = 1;
  const int n = atom->ntypes + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  memory->create(largest, n, "pair:largest");
  memory->create(largest_frozen, n, "pair:largest_frozen");
  std::fill_n(setflag[0], n * n, 0);
}

// pair_style lubricate/lb/ibb gap keyword value ...
void PairLubricateLbIbb::settings(int narg, char **arg)
{
  if (narg < 1) utils::missing_cmd_args(FLERR, "pair_style lubricate/lb/ibb", error);
  least = utils::numeric(FLERR, arg[0], false, lmp);
  if (!(least > 0.0) || !std::isfinite(least))
    error->all(FLERR, "{}: the smallest gap is {}: it must be larger than 0, say 0.001 radii",
               STYLE, arg[0]);
  normal_cells = 2.0 / 3.0;
  shear_cells = 0.5;
  with_walls = 1;
  for (int k = 1; k < narg; k += 2) {
    if (k + 1 == narg) utils::missing_cmd_args(FLERR, std::string(STYLE) + " " + arg[k], error);
    if (strcmp(arg[k], "walls") == 0) {
      with_walls = utils::logical(FLERR, arg[k + 1], false, lmp);
      continue;
    }
    const bool normal = strcmp(arg[k], "normal") == 0;
    if (!normal && strcmp(arg[k], "shear") != 0)
      error->all(FLERR, "{}: unknown keyword {}, known are normal, shear and walls", STYLE, arg[k]);
    double &cells = normal ? normal_cells : shear_cells;
    cells = utils::numeric(FLERR, arg[k + 1], false, lmp);
    if (!(cells >= 0.0 && cells <= 3.0))
      error->all(FLERR, "{}: cut-off {} {} is not between 0 and 3 cells", STYLE, arg[k],
                 arg[k + 1]);
  }
}

void PairLubricateLbIbb::coeff(int narg, char **arg)
{
  if (narg != 2) error->all(FLERR, "{}: pair_coeff takes two types and nothing else", STYLE);
  if (!allocated) allocate();
  int ilo, ihi, jlo, jhi, count = 0;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  for (int i = ilo; i <= ihi; i++)
    for (int j = std::max(jlo, i); j <= jhi; j++, count++) setflag[i][j] = 1;
  if (count == 0)
    error->all(FLERR, "{}: no pair of types in {} {} with the first not above the second", STYLE,
               arg[0], arg[1]);
}

void PairLubricateLbIbb::init_style()
{
  GranLSDGrains::check_spheres(lmp, STYLE);
  GranLSDGrains::check_units(lmp, STYLE);
  if (domain->dimension == 2)
    error->all(FLERR, "{}: its films are those between spheres: it cannot be used in 2d", STYLE);
  if (comm->ghost_velocity == 0)
    error->all(FLERR, "{} requires the velocities of ghost atoms: add comm_modify vel yes", STYLE);
  const auto fluids = modify->get_fix_by_style("^lb/ibb$");
  if (fluids.empty())
    error->all(FLERR, "{}: there is no fix lb/ibb, from which it takes viscosity and spacing",
               STYLE);
  fluid = dynamic_cast<FixLbIbb *>(fluids.front());
  const double dx = fluid->spacing();
  film = {fluid->viscosity() * fluid->density(), normal_cells * dx, shear_cells * dx, least};
  if (least >= film.reach())
    error->all(
        FLERR,
        "{}: the smallest gap {} is not below the cut-offs, {} and {}: there is no film left",
        STYLE, least, film.normal, film.shear);
  GranLSDGrains::largest_radii(lmp, 0, largest, largest_frozen);
  neighbor->add_request(this);    // complete up to the cut-off, which lists by size are not
}

double PairLubricateLbIbb::init_one(int i, int j)
{
  if (setflag[i][j] == 0)
    error->all(FLERR, "{}: no pair_coeff for types {} and {}: add pair_coeff {} {}", STYLE, i, j, i,
               j);
  return largest[i] + largest[j] + film.reach();
}

void PairLubricateLbIbb::setup()
{
  check_step();
}

// The film is integrated explicitly: it must not stop a grain faster than within a step
void PairLubricateLbIbb::check_step()
{
  if (update->whichflag != 1) return;
  double rate = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & fluid->groupbit) && fluid->is_driven(i))
      rate = std::max(rate, lbm::film_rate(film, fluid->hydrodynamic_radius(i), atom->rmass[i]));
  MPI_Allreduce(&rate, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  if (all * update->dt <= 1.0) return;
  error->all(
      FLERR,
      "{}: a film of gap {:.6g} stops the lightest grain in {:.6g}, less than the timestep of "
      "{:.6g}, which would be unstable: use a timestep <= {:.6g}, or a smallest gap >= {:.6g}",
      STYLE, least, 1.0 / all, update->dt, 1.0 / all,
      1.0 / (1.0 / film.normal + (1.0 / least - 1.0 / film.normal) / (all * update->dt)));
}

void PairLubricateLbIbb::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) fwrite(&setflag[i][j], sizeof(int), 1, fp);
}

void PairLubricateLbIbb::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (comm->me == 0) utils::sfread(FLERR, &setflag[i][j], sizeof(int), 1, fp, nullptr, error);
      MPI_Bcast(&setflag[i][j], 1, MPI_INT, 0, world);
    }
}

void PairLubricateLbIbb::write_restart_settings(FILE *fp)
{
  for (const double *value : {&least, &normal_cells, &shear_cells})
    fwrite(value, sizeof(double), 1, fp);
  fwrite(&with_walls, sizeof(int), 1, fp);
}

void PairLubricateLbIbb::read_restart_settings(FILE *fp)
{
  for (double *value : {&least, &normal_cells, &shear_cells}) {
    if (comm->me == 0) utils::sfread(FLERR, value, sizeof(double), 1, fp, nullptr, error);
    MPI_Bcast(value, 1, MPI_DOUBLE, 0, world);
  }
  if (comm->me == 0) utils::sfread(FLERR, &with_walls, sizeof(int), 1, fp, nullptr, error);
  MPI_Bcast(&with_walls, 1, MPI_INT, 0, world);
}

// of the force, what acts along the line of centres; a film has no energy
double PairLubricateLbIbb::single(int i, int j, int, int, double rsq, double, double,
                                  double &fforce)
{
  Vec3 n;
  lbm::FilmLoad load;
  fforce = 0.0;
  if (film_between(i, j, rsq, n, load)) fforce = -lbm::dot(load.force, n) / std::sqrt(rsq);
  return 0.0;
}
