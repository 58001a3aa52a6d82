/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// The tripwire of fix lb/ibb: a fluid that no run may go on with, found before it is shown to
// anybody. All ranks stop together with one message: place, time, nearest grain, numbers, likely
// cause, what to try.

#include "fix_lb_ibb.h"

#include "lbm_neighbours_mpi.h"
#include "lbm_rules.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using lbm::Int3;
using lbm::Vec3;

static constexpr double NOWHERE = 1e300;

// of all ranks
void FixLbIbb::find_fastest()
{
  struct {
    double speed;
    int rank;
  } most{fastest.speed, comm->me};
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  MPI_Bcast(&fastest, sizeof(fastest), MPI_BYTE, most.rank, world);
}

// collective; survey is reduced on return
void FixLbIbb::check_stability()
{
  const lbm::Survey mine = survey;
  lbm::reduce(survey, *neighbours);
  find_fastest();
  const double speed = std::max(survey.speed.value, fastest.speed);
  if (!survey.bad && lbm::mach(speed) <= (warned_of_speed ? lbm::MACH_LIMIT : lbm::MACH_WARN))
    return;

  // the first of the lattice that has it, whatever the cut
  const bool here = survey.bad ? mine.bad : mine.speed.value == survey.speed.value;
  Int3 node = survey.bad ? mine.bad_node : mine.speed.p;
  double first = NOWHERE, found[2] = {0.0, 0.0};    // density excess and speed
  if (here) {
    first = node[0] + nodes[0] * (node[1] + double(nodes[1]) * node[2]);
    const Int3 &lo = fluid->layout().lo;
    const lbm::Moments m = fluid->moments(node[0] - lo[0], node[1] - lo[1], node[2] - lo[2]);
    found[0] = m.drho;
    found[1] = std::sqrt(lbm::dot(m.u, m.u));
  }
  struct {
    double place;
    int rank;
  } from{first, comm->me};
  MPI_Allreduce(MPI_IN_PLACE, &from, 1, MPI_DOUBLE_INT, MPI_MINLOC, world);
  MPI_Bcast(node.data(), 3, MPI_INT, from.rank, world);
  MPI_Bcast(found, 2, MPI_DOUBLE, from.rank, world);

  if (survey.bad)
    stop(node,
         found[0] > -1.0 && std::isfinite(found[0])
             ? "the fluid's speed is not a finite number"
             : fmt::format("the fluid's density is {:.4g} times rho, it must be positive",
                           1.0 + found[0]),
         found[0], found[1]);
  if (lbm::mach(survey.speed.value) > lbm::MACH_LIMIT)
    stop(node,
         fmt::format("the fluid's speed is {:.4g}, Ma = {:.3g}, limit {}",
                     survey.speed.value * units.velocity(), lbm::mach(survey.speed.value),
                     lbm::MACH_LIMIT),
         found[0], found[1]);
  warn_of_speed(node);
}

// once in a run
void FixLbIbb::warn_of_speed(const Int3 &node)
{
  if (warned_of_speed) return;
  warned_of_speed = true;
  const bool grain = fastest.speed > survey.speed.value;
  Vec3 at = place_of(node);
  for (int d = 0; d < 3 && grain; d++) at[d] = domain->boxlo[d] + fastest.place[d] * units.dx;
  const double speed = grain ? fastest.speed : survey.speed.value;
  if (comm->me == 0)
    error->warning(FLERR,
                   "Fix lb/ibb: step {}: {} at ({:.6g}, {:.6g}, {:.6g}) moves at {:.4g}, {:.3g} "
                   "cells in one fluid step, Ma = {:.3g}: compressibility spoils results above {}, "
                   "the limit is {}; reduce timestep or every",
                   update->ntimestep,
                   grain ? fmt::format("the surface of grain {}", (tagint) fastest.id)
                         : "the fluid",
                   at[0], at[1], at[2], speed * units.velocity(), speed, lbm::mach(speed),
                   lbm::MACH_WARN, lbm::MACH_LIMIT);
}

Vec3 FixLbIbb::place_of(const Int3 &node) const
{
  Vec3 at;
  for (int d = 0; d < 3; d++) at[d] = domain->boxlo[d] + (node[d] + 0.5) * units.dx;
  return at;
}

bool FixLbIbb::near_open_face(const Int3 &node) const
{
  for (int d = 0; d < domain->dimension; d++)
    for (int side = 0; side < 2; side++) {
      const lbm::FaceKind kind = options.face[d][side].kind;
      if (kind != lbm::FaceKind::PRESSURE && kind != lbm::FaceKind::VELOCITY) continue;
      if ((side == 0 ? node[d] : nodes[d] - 1 - node[d]) < 3) return true;
    }
  return false;
}

struct FixLbIbb::Neighbour {
  double gap, id, radius, density, speed, surface, loose;    // lattice units
};

// collective
FixLbIbb::Neighbour FixLbIbb::nearest_grain(const Vec3 &at)
{
  Neighbour mine{};
  mine.gap = NOWHERE;
  for (int i = 0; i < atom->nlocal && atom->radius_flag; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    Vec3 away;
    for (int d = 0; d < 3; d++) {
      away[d] = atom->x[i][d] - at[d];
      if (domain->periodicity[d])
        away[d] -= domain->prd[d] * std::nearbyint(away[d] / domain->prd[d]);
    }
    if (domain->dimension == 2) away[2] = 0.0;
    const double r = hydrodynamic_radius(i);
    const double gap = (std::sqrt(lbm::dot(away, away)) - r) / units.dx;
    if (gap >= mine.gap) continue;
    const Vec3 v{atom->v[i][0], atom->v[i][1], atom->v[i][2]};
    const Vec3 spin{atom->omega[i][0], atom->omega[i][1], atom->omega[i][2]};
    const double speed = std::sqrt(lbm::dot(v, v));
    mine = {gap,
            double(atom->tag[i]),
            r / units.dx,
            density_ratio(i),
            speed / units.velocity(),
            (speed + r * std::sqrt(lbm::dot(spin, spin))) / units.velocity(),
            is_loose(i) ? 1.0 : 0.0};
  }
  struct {
    double gap;
    int rank;
  } nearest{mine.gap, comm->me};
  MPI_Allreduce(MPI_IN_PLACE, &nearest, 1, MPI_DOUBLE_INT, MPI_MINLOC, world);
  MPI_Bcast(&mine, sizeof(mine), MPI_BYTE, nearest.rank, world);
  return mine;
}

std::string FixLbIbb::likely_cause(const Int3 &node, const Neighbour &grain)
{
  const double push = std::sqrt(lbm::dot(drive.force, drive.force)) / units.force_density();
  const bool beside = grain.gap < 2.0;
  if (!(lbm::mach(push) < 0.05))
    return fmt::format(
        "accel or gradp, which change the fluid's speed by {:.3g} in one fluid step; "
        "reduce or ramp them, or reduce timestep or every",
        push * units.velocity());
  if (units.tau(options.nu) < lbm::TAU_LOW)
    return "tau too close to 1/2 for this flow; enlarge the fluid time step or refine dx";
  if (beside && lbm::mach(grain.surface) > lbm::MACH_WARN)
    return "the grain is too fast for the fluid time step, or was set in motion too suddenly; "
           "reduce timestep or every, or start it slowly";
  if (beside && grain.loose > 0.0) return cause_of_loose();
  if (near_open_face(node))
    return "the pressure or velocity of a face is too large or changes too suddenly; ramp it over "
           "several times the travel time of sound, or reduce timestep or every";
  if (beside && grain.radius < lbm::RADIUS_WARN)
    return "too few cells per radius for this flow; refine dx, or reduce timestep or every";
  return "the flow is too fast for the fluid time step, or was started too suddenly; reduce "
         "timestep or every, or ramp what drives it";
}

// the same message on every rank
void FixLbIbb::stop(const Int3 &node, const std::string &what, double drho, double speed)
{
  const Vec3 at = place_of(node);
  const Neighbour grain = nearest_grain(at);
  const double tau = units.tau(options.nu);
  std::string text =
      fmt::format("Fix lb/ibb: stopped at step {}, fluid step {}: at ({:.6g}, {:.6g}, {:.6g}), "
                  "node ({}, {}, {}), {}. There rho = {:.4g}, Ma = {:.3g}, u dx/nu = {:.3g}. ",
                  update->ntimestep, fluid_steps, at[0], at[1], at[2], node[0], node[1], node[2],
                  what, options.rho * (1.0 + drho), lbm::mach(speed), 3.0 * speed / (tau - 0.5));
  if (grain.gap < NOWHERE)
    text += fmt::format(
        "Nearest grain: {}, surface {:.3g} cells away, radius {:.3g} cells, density "
        "{:.3g} rho, speed {:.4g}. ",
        (tagint) grain.id, grain.gap, grain.radius, grain.density, grain.speed * units.velocity());
  error->all(FLERR, "{}tau = {:.4f}. Likely cause: {} (see doc/src/Howto_lbm_ibb.rst)", text, tau,
             likely_cause(node, grain));
}
