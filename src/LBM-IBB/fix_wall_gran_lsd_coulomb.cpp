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

#include "fix_wall_gran_lsd_coulomb.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "gran_lsd_grains.h"
#include "gran_lsd_material.h"
#include "gran_lsd_timestep.h"
#include "math_const.h"
#include "neighbor.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

static const char STYLE[] = "fix wall/gran/lsd/coulomb";

/* ---------------------------------------------------------------------- */

FixWallGranLSDCoulomb::FixWallGranLSDCoulomb(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), offset(0.0), inertia_factor(GranLSD::INERTIA_SPHERE),
    normal(0), has_wall{false, false}, place{0.0, 0.0}, motion(STILL), along(0), speed(0.0),
    amplitude(0.0), period(1.0), t_contact(0.0), fix_rigid(nullptr), total{}, total_all{},
    reduced(-1)
{
  if (narg < 3 + GranLSDMaterial::NWORDS + 3) utils::missing_cmd_args(FLERR, STYLE, error);

  GranLSDGrains::check_spheres(lmp, STYLE);

  scalar_flag = vector_flag = 1;
  size_vector = 6;
  extscalar = extvector = 1;
  global_freq = 1;
  dynamic_group_allow = 1;

  int iarg = 3;
  material = GranLSDMaterial::parse(lmp, STYLE, narg, arg, iarg);
  iarg += GranLSDMaterial::NWORDS;
  iarg = parse_planes(iarg, narg, arg);

  int limit_damping = 0;
  std::set<std::string> given;
  while (iarg < narg) {
    if (GranLSDMaterial::parse_option(lmp, STYLE, narg, arg, iarg, offset, limit_damping, given))
      iarg += 2;
    else if (strcmp(arg[iarg], "shear") == 0 || strcmp(arg[iarg], "wiggle") == 0)
      iarg = parse_motion(iarg, narg, arg);
    else
      error->all(FLERR,
                 "{}: unknown keyword {}, known are offset, limit_damping, shear and wiggle (see "
                 "doc/src/fix_wall_gran_lsd_coulomb.rst)",
                 STYLE, arg[iarg]);
  }

  law = GranLSD::make_law(material, limit_damping != 0);
  time_origin = update->ntimestep;
}

/* ---------------------------------------------------------------------- */

int FixWallGranLSDCoulomb::parse_planes(int iarg, int narg, char **arg)
{
  static const char *const planes[] = {"xplane", "yplane", "zplane"};
  normal = 0;
  while (normal < 3 && strcmp(arg[iarg], planes[normal]) != 0) normal++;
  if (normal == 3)
    error->all(FLERR,
               "{}: expected xplane, yplane or zplane, not {}; walls of other shapes: fix "
               "wall/gran and fix wall/gran/region",
               STYLE, arg[iarg]);
  if (iarg + 3 > narg)
    utils::missing_cmd_args(FLERR, fmt::format("{} {}", STYLE, arg[iarg]), error);
  if (normal == 2 && domain->dimension == 2)
    error->all(FLERR, "{}: zplane has no meaning in 2d, use xplane or yplane", STYLE);
  if (domain->periodicity[normal])
    error->all(FLERR, "{}: {} needs a non-periodic direction, but {} is periodic: see boundary",
               STYLE, arg[iarg], "xyz"[normal]);

  for (int w = 0; w < 2; w++) {
    has_wall[w] = (strcmp(arg[iarg + 1 + w], "NULL") != 0);
    if (has_wall[w]) place[w] = utils::numeric(FLERR, arg[iarg + 1 + w], false, lmp);
  }
  if (!has_wall[0] && !has_wall[1])
    error->all(FLERR, "{}: {} NULL NULL is no wall at all: give a place to one at least", STYLE,
               arg[iarg]);
  if (has_wall[0] && has_wall[1] && place[0] >= place[1])
    error->all(FLERR, "{}: the lower wall at {} must be below the upper wall at {}", STYLE,
               place[0], place[1]);
  return iarg + 3;
}

/* ---------------------------------------------------------------------- */

int FixWallGranLSDCoulomb::parse_axis(int iarg, char **arg) const
{
  if (strlen(arg[iarg]) != 1 || arg[iarg][0] < 'x' || arg[iarg][0] > 'z')
    error->all(FLERR, "{}: the direction of motion must be x, y or z, not {}", STYLE, arg[iarg]);
  const int axis = arg[iarg][0] - 'x';
  if (axis == 2 && domain->dimension == 2)
    error->all(FLERR, "{}: a wall cannot move along z in 2d", STYLE);
  return axis;
}

/* ---------------------------------------------------------------------- */

int FixWallGranLSDCoulomb::parse_motion(int iarg, int narg, char **arg)
{
  if (motion != STILL)
    error->all(FLERR, "{}: more than one motion given, shear and wiggle exclude each other", STYLE);

  if (strcmp(arg[iarg], "shear") == 0) {
    if (iarg + 3 > narg) utils::missing_cmd_args(FLERR, fmt::format("{} shear", STYLE), error);
    motion = SHEAR;
    along = parse_axis(iarg + 1, arg);
    speed = utils::numeric(FLERR, arg[iarg + 2], false, lmp);
    if (along == normal)
      error->all(FLERR, "{}: shear must be along the wall, {} is across it: use wiggle", STYLE,
                 arg[iarg + 1]);
    return iarg + 3;
  }

  if (iarg + 4 > narg) utils::missing_cmd_args(FLERR, fmt::format("{} wiggle", STYLE), error);
  motion = WIGGLE;
  along = parse_axis(iarg + 1, arg);
  amplitude = utils::numeric(FLERR, arg[iarg + 2], false, lmp);
  period = utils::numeric(FLERR, arg[iarg + 3], false, lmp);
  if (!(period > 0.0))
    error->all(FLERR, "{}: the period of wiggle, {}, must be positive", STYLE, period);
  return iarg + 4;
}

/* ---------------------------------------------------------------------- */

int FixWallGranLSDCoulomb::setmask()
{
  return POST_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixWallGranLSDCoulomb::init()
{
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "{} cannot be used with run_style respa: use run_style verlet", STYLE);
  GranLSDGrains::check_units(lmp, STYLE);
  inertia_factor = GranLSDGrains::inertia_factor(lmp);
  fix_rigid = GranLSDGrains::find_rigid(lmp, STYLE);
}

/* ----------------------------------------------------------------------
   before the first step of a run: is the time step short enough?
------------------------------------------------------------------------- */

void FixWallGranLSDCoulomb::setup(int vflag)
{
  find_masses();
  double lightest = lightest_own();
  MPI_Allreduce(MPI_IN_PLACE, &lightest, 1, MPI_DOUBLE, MPI_MIN, world);
  t_contact = (lightest < GranLSDTimestep::BIG) ? GranLSD::contact_time(material, lightest) : 0.0;
  GranLSDTimestep::check(lmp, STYLE, t_contact);

  post_force(vflag);
}

/* ----------------------------------------------------------------------
   smallest mass of the own grains of the group, BIG = there are none
------------------------------------------------------------------------- */

double FixWallGranLSDCoulomb::lightest_own() const
{
  double lightest = GranLSDTimestep::BIG;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) lightest = MIN(lightest, weight[i]);
  return lightest;
}

/* ---------------------------------------------------------------------- */

void FixWallGranLSDCoulomb::reset_dt()
{
  GranLSDTimestep::check_reset(lmp, STYLE, t_contact);
}

/* ----------------------------------------------------------------------
   mass each own atom answers with: its own, or that of its rigid body
------------------------------------------------------------------------- */

void FixWallGranLSDCoulomb::find_masses()
{
  weight.assign(atom->rmass, atom->rmass + atom->nlocal);
  if (fix_rigid) GranLSDGrains::put_rigid_masses(fix_rigid, atom->nlocal, weight.data());
}

/* ---------------------------------------------------------------------- */

void FixWallGranLSDCoulomb::post_force(int /*vflag*/)
{
  double **x = atom->x;
  double **v = atom->v;
  double **f = atom->f;
  double **omega = atom->omega;
  double **torque = atom->torque;
  const double *radius = atom->radius;
  const int *mask = atom->mask;
  const int nlocal = atom->nlocal;
  const double dt = update->dt;

  for (double &value : total) value = 0.0;
  reduced = -1;

  // grains come and go, and may be inserted or change during a run

  if (neighbor->ago == 0 || (int) weight.size() != nlocal) {
    find_masses();
    if (!update->setupflag) {
      const double t_own = GranLSD::contact_time(material, lightest_own());
      GranLSDTimestep::check_one(lmp, STYLE, t_own);
    }
  }

  // where the walls are and how they move

  double vwall[3] = {0.0, 0.0, 0.0};
  double shift = 0.0;
  if (motion == SHEAR) {
    vwall[along] = speed;
  } else if (motion == WIGGLE) {
    const double frequency = MathConst::MY_2PI / period;
    const double phase = frequency * dt * double(update->ntimestep - time_origin);
    vwall[along] = amplitude * frequency * sin(phase);
    if (along == normal) shift = amplitude - amplitude * cos(phase);
  }
  const double still[3] = {0.0, 0.0, 0.0};
  const GranLSD::Side wall = {vwall, still, 0.0, 0.0, 0.0};

  for (int w = 0; w < 2; w++) {
    if (!has_wall[w]) continue;

    // n points from the wall into the box

    double n[3] = {0.0, 0.0, 0.0};
    n[normal] = (w == 0) ? 1.0 : -1.0;
    const double plane = place[w] + shift;

    for (int i = 0; i < nlocal; i++) {
      if (!(mask[i] & groupbit)) continue;

      // a grain pushed half through the wall is still pushed back

      const double distance = n[normal] * (x[i][normal] - plane);
      const double overlap = radius[i] + offset - distance;
      if (overlap <= 0.0) continue;

      const double arm = MAX(distance, 0.0);
      const auto grain =
          GranLSD::make_side(v[i], omega[i], radius[i], arm, weight[i], inertia_factor);
      const auto hit = GranLSD::evaluate(law, overlap, n, grain, wall, dt);

      total[0] += 1.0;
      for (int d = 0; d < 3; d++) {
        const double force = hit.fn * n[d] + hit.fs[d];
        f[i][d] += force;
        total[1 + 3 * w + d] += force;
      }
      torque[i][0] -= arm * (n[1] * hit.fs[2] - n[2] * hit.fs[1]);
      torque[i][1] -= arm * (n[2] * hit.fs[0] - n[0] * hit.fs[2]);
      torque[i][2] -= arm * (n[0] * hit.fs[1] - n[1] * hit.fs[0]);
    }
  }
}

/* ----------------------------------------------------------------------
   number of contacts
------------------------------------------------------------------------- */

double FixWallGranLSDCoulomb::compute_scalar()
{
  if (reduced != update->ntimestep) {
    MPI_Allreduce(total, total_all, 7, MPI_DOUBLE, MPI_SUM, world);
    reduced = update->ntimestep;
  }
  return total_all[0];
}

/* ----------------------------------------------------------------------
   force of the lower wall on the grains, then of the upper wall
------------------------------------------------------------------------- */

double FixWallGranLSDCoulomb::compute_vector(int n)
{
  compute_scalar();
  return total_all[1 + n];
}

/* ---------------------------------------------------------------------- */

void *FixWallGranLSDCoulomb::extract(const char *str, int &dim)
{
  dim = 0;
  if (strcmp(str, "t_contact") == 0) return (void *) &t_contact;
  if (strcmp(str, "offset") == 0) return (void *) &offset;
  return nullptr;
}
