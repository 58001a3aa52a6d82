/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "lb_ibb_accuracy.h"

#include "lb_ibb_table.h"

#include "error.h"

#include <sstream>

using namespace LAMMPS_NS;

lbm::Accuracy LAMMPS_NS::read_accuracy(LAMMPS *lmp, std::string &why)
{
  lbm::Accuracy accuracy;
  std::istringstream lines(read_table(lmp, LB_ACCURACY_FILE));
  std::string line;
  while (std::getline(lines, line)) {
    const std::string problem = accuracy.read(line);
    if (!problem.empty()) lmp->error->all(FLERR, "File {}: {}", LB_ACCURACY_FILE, problem);
  }
  if (accuracy.empty()) why = no_table(LB_ACCURACY_FILE);
  return accuracy;
}
