/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */
#include "lb_ibb_table.h"

#include "comm.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace LAMMPS_NS;

std::string LAMMPS_NS::read_table(LAMMPS *lmp, const std::string &name)
{
  std::string text;
  if (lmp->comm->me == 0) {
    const std::string path = utils::get_potential_file_path(name);
    std::ifstream file(path);
    if (!path.empty()) text.assign(std::istreambuf_iterator<char>(file), {});
  }
  int length = int(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, lmp->world);
  text.resize(length);
  MPI_Bcast(&text[0], length, MPI_CHAR, 0, lmp->world);
  return text;
}

std::string LAMMPS_NS::no_table(const std::string &name)
{
  const char *folders = std::getenv("LAMMPS_POTENTIALS");
  return fmt::format("no file {} here or in a folder of the environment variable LAMMPS_POTENTIALS "
                     "({})",
                     name, folders ? folders : "not set");
}
