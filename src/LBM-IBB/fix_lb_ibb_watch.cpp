/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Outputs of fix lb/ibb; none is given before the tripwire has looked at the fluid.

#include "fix_lb_ibb.h"

#include "lbm_neighbours_mpi.h"

#include "atom.h"
#include "domain.h"

#include <cmath>

using namespace LAMMPS_NS;
using lbm::Vec3;

// one pass over the fluid; every value asked for at one step comes from the same pass
void FixLbIbb::take_survey()
{
  if (survey_step == fluid_steps) return;
  survey = fluid->survey();
  check_stability();
  survey_step = fluid_steps;
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
    // all ranks have the same layers
    if (!std::isfinite(l.pressure) || !std::isfinite(l.flux)) take_survey();
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
  if (n >= NUMBERS) return obstacle_load(n - NUMBERS);
  if (n >= FIRST_OF_LEDGER) return ledger_entry(n - FIRST_OF_LEDGER);
  const double all = double(nodes[0]) * nodes[1] * nodes[2];
  if (n == 13) {
    double mine = speed();
    MPI_Bcast(&mine, 1, MPI_DOUBLE, 0, world);
    return mine;
  }
  take_survey();
  switch (n) {
    case 2:
      return std::max({survey.speed.value, fastest.speed, obstacle_speed() / units.velocity()}) *
          std::sqrt(3.0);
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
