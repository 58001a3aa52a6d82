/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Outputs of fix lb/ibb, and the tripwire that stops a run before it prints nonsense.

#include "fix_lb_ibb.h"

#include "lbm_neighbours_mpi.h"
#include "lbm_rules.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "platform.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;
using lbm::Int3;
using lbm::Vec3;

// one pass over the fluid; every value asked for at one step comes from the same pass
void FixLbIbb::take_survey()
{
  if (survey_step == fluid_steps) return;
  survey = fluid->survey();
  check_stability();
  survey_step = fluid_steps;
}

// collective: a rank that has something wrong tells the others; survey is reduced on return
void FixLbIbb::check_stability()
{
  const lbm::Survey mine = survey;
  lbm::reduce(survey, *neighbours);
  find_fastest();

  const double limit = lbm::MACH_LIMIT / std::sqrt(3.0);
  if (survey.bad || survey.speed.value > limit) {
    // the lowest rank that has it speaks
    const bool here = survey.bad ? mine.bad : mine.speed.value == survey.speed.value;
    int first = here ? comm->me : comm->nprocs, rank;
    MPI_Allreduce(&first, &rank, 1, MPI_INT, MPI_MIN, world);
    Int3 node = survey.bad ? mine.bad_node : mine.speed.p;
    double drho = mine.bad_drho;
    MPI_Bcast(node.data(), 3, MPI_INT, rank, world);
    MPI_Bcast(&drho, 1, MPI_DOUBLE, rank, world);
    if (survey.bad)
      stop(node,
           drho > -1.0 && std::isfinite(drho)
               ? "the fluid's speed is not a finite number"
               : fmt::format("the fluid's density is {:.4g} times rho, it must be positive",
                             1.0 + drho));
    stop(node,
         fmt::format("the fluid's speed is {:.4g}, Ma = {:.3g}, limit {}",
                     survey.speed.value * units.velocity(), survey.speed.value * std::sqrt(3.0),
                     lbm::MACH_LIMIT));
  }
  if (fastest.speed > limit) {
    double at[3];
    for (int d = 0; d < 3; d++) at[d] = domain->boxlo[d] + fastest.place[d] * units.dx;
    error->all(
        FLERR,
        "Fix lb/ibb: stopped at step {}, fluid step {}: grain {} at ({:.6g}, {:.6g}, {:.6g}) "
        "has a surface that moves at {:.4g}, Ma = {:.3g}, limit {}. Likely cause: the grain "
        "is too fast for the fluid time step; reduce timestep or every",
        update->ntimestep, fluid_steps, (tagint) fastest.id, at[0], at[1], at[2],
        fastest.speed * units.velocity(), fastest.speed * std::sqrt(3.0), lbm::MACH_LIMIT);
  }
}

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

// the same message on every rank: place, time, nearest grain, numbers that matter, likely cause
void FixLbIbb::stop(const Int3 &node, const std::string &what)
{
  double at[3];
  for (int d = 0; d < 3; d++) at[d] = domain->boxlo[d] + (node[d] + 0.5) * units.dx;

  struct {
    double gap;
    int rank;
  } nearest{1e300, comm->me};
  double grain[3] = {0.0, 0.0, 0.0};    // id, radius in cells, speed
  for (int i = 0; i < atom->nlocal && atom->radius_flag; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    Vec3 away;
    for (int d = 0; d < 3; d++) {
      away[d] = atom->x[i][d] - at[d];
      if (domain->periodicity[d])
        away[d] -= domain->prd[d] * std::nearbyint(away[d] / domain->prd[d]);
    }
    if (domain->dimension == 2) away[2] = 0.0;
    const double gap = std::sqrt(lbm::dot(away, away)) - hydrodynamic_radius(i);
    if (gap >= nearest.gap) continue;
    const Vec3 v{atom->v[i][0], atom->v[i][1], atom->v[i][2]};
    nearest.gap = gap;
    grain[0] = atom->tag[i];
    grain[1] = hydrodynamic_radius(i) / units.dx;
    grain[2] = std::sqrt(lbm::dot(v, v));
  }
  MPI_Allreduce(MPI_IN_PLACE, &nearest, 1, MPI_DOUBLE_INT, MPI_MINLOC, world);
  MPI_Bcast(grain, 3, MPI_DOUBLE, nearest.rank, world);

  const double tau = units.tau(options.nu);
  std::string text = fmt::format(
      "Fix lb/ibb: stopped at step {}, fluid step {}: at ({:.6g}, {:.6g}, {:.6g}), "
      "node ({}, {}, {}), {}. ",
      update->ntimestep, fluid_steps, at[0], at[1], at[2], node[0], node[1], node[2], what);
  if (nearest.gap < 1e300)
    text += fmt::format(
        "Nearest grain: {}, surface {:.3g} cells away, radius {:.3g} cells, speed {:.4g}. ",
        (tagint) grain[0], nearest.gap / units.dx, grain[1], grain[2]);
  text += fmt::format("tau = {:.4f}. Likely cause: ", tau);
  if (tau < lbm::TAU_LOW)
    text += "tau too close to 1/2 for this flow; enlarge the fluid time step or refine dx";
  else if (nearest.gap < 2.0 * units.dx && grain[2] / units.velocity() > 0.1)
    text += "the grain is too fast for the fluid time step; reduce timestep or every";
  else if (nearest.gap < 2.0 * units.dx)
    text += "light or few-celled grain, or a stiff contact, coupled too loosely; refine dx, reduce "
            "timestep or every";
  else
    text += "the flow is too fast for the fluid time step, or was started too suddenly; reduce "
            "timestep or every, or ramp pressures and velocities";
  error->all(FLERR, text);
}

// ---------------------------------------------------------------------- numbers for the user

std::vector<lbm::Layer> FixLbIbb::profile(int axis, int width)
{
  lbm::Planes sums = fluid->planes(axis, nodes[axis]);
  lbm::reduce(sums, *neighbours);
  const double across = double(nodes[0]) * nodes[1] * nodes[2] / nodes[axis];
  const double force = drive.force[axis] / units.force_density();
  auto all = lbm::layers(sums, across, width, domain->periodicity[axis] == 1, force);
  for (lbm::Layer &l : all) {
    l.pressure *= units.pressure();
    l.flux *= units.velocity();
    l.gradient *= units.force_density();
    l.length *= units.dx;
  }
  return all;
}

Vec3 FixLbIbb::total_force()
{
  Vec3 mine{}, all;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      for (int d = 0; d < 3; d++) mine[d] += array_atom[i][FORCE + d];
  MPI_Allreduce(mine.data(), all.data(), 3, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

// mass of the fluid
double FixLbIbb::compute_scalar()
{
  if (!fluid) return 0.0;
  take_survey();
  return survey.mass * units.mass();
}

double FixLbIbb::compute_vector(int n)
{
  if (n == 0) return units.tau(options.nu);
  if (n == 1) return units.dt;
  if (!fluid) return 0.0;
  if (n >= 5 && n <= 7) return total_force()[n - 5];
  if (n == 12) {
    double links = fluid->links();
    neighbours->sum(&links, 1);
    return links;
  }
  const double all = double(nodes[0]) * nodes[1] * nodes[2];
  if (n == 13) {
    double mine = speed();
    MPI_Bcast(&mine, 1, MPI_DOUBLE, 0, world);
    return mine;
  }
  take_survey();
  switch (n) {
    case 2:
      return std::max(survey.speed.value, fastest.speed) * std::sqrt(3.0);
    case 3:
      return 1.0 + survey.drho_min.value;
    case 4:
      return 1.0 + survey.drho_max.value;
    case 8:
    case 9:
    case 10:
      return survey.velocity[n - 8] / all * units.velocity();
    case 11:
      return survey.fluid_nodes;
  }
  return 0.0;
}
