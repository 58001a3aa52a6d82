/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "lb_plan_granular.h"

#include "domain.h"
#include "input.h"
#include "platform.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

using namespace LAMMPS_NS;

static constexpr double BUDGET = 0.03;    // seconds
static constexpr double MOST = 8000.0;    // grains; beyond, time is proportional to them

double LAMMPS_NS::seconds_of_granular_step(LAMMPS *lmp, double grains)
{
  const int D = lmp->domain->dimension;
  const int n = std::max(2, (int) std::ceil(std::pow(std::min(grains, MOST), 1.0 / D) - 1.0e-6));
  const std::string high = D == 2 ? "-0.5 0.5" : fmt::format("0 {}", n);

  const char *words[] = {"granular", "-log", "none", "-screen", "none", "-nocite"};
  LAMMPS granular((int) (sizeof(words) / sizeof(*words)), const_cast<char **>(words), lmp->world);
  // a simple array whose neighbors overlap by a thousandth; nothing of the scene but the number
  std::istringstream lines(fmt::format("units lj\n"
                                       "dimension {0}\n"
                                       "atom_style sphere\n"
                                       "comm_modify vel yes\n"
                                       "lattice {1} 1.0\n"
                                       "region box block 0 {2} 0 {2} {3}\n"
                                       "create_box 1 box\n"
                                       "create_atoms 1 box\n"
                                       "set group all diameter 1.001\n"
                                       "set group all {4} 1.0\n"
                                       "pair_style gran/lsd/coulomb\n"
                                       "pair_coeff * * 1000.0 0.9 0.4\n"
                                       "neighbor 0.1 bin\n"
                                       "neigh_modify delay 0 every 1 check yes\n"
                                       "timestep 1.0e-4\n"
                                       "fix move all nve/sphere{5}\n"
                                       "fix weight all gravity 1.0e-9 vector 0 -1 0\n"
                                       "run 3 post no",
                                       D, D == 2 ? "sq" : "sc", n, high,
                                       D == 2 ? "density/disc" : "density", D == 2 ? " disc" : ""));
  std::string line;
  while (std::getline(lines, line)) granular.input->one(line);

  auto timed = [&](int steps) {
    const double start = platform::walltime();
    granular.input->one(fmt::format("run {} pre no post no", steps));
    double seconds = (platform::walltime() - start) / steps;
    MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
    return seconds;
  };
  const double seconds = timed((int) std::clamp(BUDGET / timed(3), 3.0, 5000.0));
  return seconds * std::max(1.0, grains / std::pow(n, D));
}
