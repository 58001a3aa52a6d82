/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "lb_ibb_accuracy.h"

#include "comm.h"
#include "error.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace LAMMPS_NS;

lbm::Accuracy LAMMPS_NS::read_accuracy(LAMMPS *lmp, std::string &why)
{
  std::string path, content;
  if (lmp->comm->me == 0) {
    path = utils::get_potential_file_path(LB_ACCURACY_FILE);
    std::ostringstream all;
    if (!path.empty()) all << std::ifstream(path).rdbuf();
    content = all.str();
  }
  int length = int(content.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, lmp->world);
  content.resize(length);
  MPI_Bcast(&content[0], length, MPI_CHAR, 0, lmp->world);

  lbm::Accuracy accuracy;
  std::istringstream lines(content);
  std::string line;
  while (std::getline(lines, line)) {
    const std::string problem = accuracy.read(line);
    if (!problem.empty()) lmp->error->all(FLERR, "File {}: {}", LB_ACCURACY_FILE, problem);
  }
  if (accuracy.empty()) {
    const char *folders = std::getenv("LAMMPS_POTENTIALS");
    why = fmt::format("no file {} here or in a folder of LAMMPS_POTENTIALS ({})", LB_ACCURACY_FILE,
                      folders ? folders : "not set");
  }
  return accuracy;
}
