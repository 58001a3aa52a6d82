/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "lb_ibb_radius.h"

#include "comm.h"
#include "error.h"
#include "tokenizer.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

using namespace LAMMPS_NS;

static constexpr const char *FILE_NAME = "lbm-ibb.radius";

// the whole table, on all ranks; empty if there is none
static std::string content(LAMMPS *lmp)
{
  std::string text;
  if (lmp->comm->me == 0) {
    const std::string path = utils::get_potential_file_path(FILE_NAME);
    std::ifstream file(path);
    if (!path.empty()) text.assign(std::istreambuf_iterator<char>(file), {});
  }
  int length = int(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, lmp->world);
  text.resize(length);
  MPI_Bcast(&text[0], length, MPI_CHAR, 0, lmp->world);
  return text;
}

// linear between rows; smaller spheres as the smallest, the error of larger ones is of second order
static double at(const std::map<double, double> &rows, double r)
{
  const auto above = rows.lower_bound(r);
  if (above == rows.begin()) return above->second;
  const auto below = std::prev(above);
  if (above == rows.end()) return below->second * below->first / r;
  const double share = (r - below->first) / (above->first - below->first);
  return below->second + share * (above->second - below->second);
}

LBRadius::LBRadius(LAMMPS *lmp, const std::string &link, double tau)
{
  const std::string text = content(lmp);
  if (text.empty()) {
    const char *folders = std::getenv("LAMMPS_POTENTIALS");
    lmp->error->all(FLERR,
                    "Fix lb/ibb keyword radius: no file {} here or in a folder of the environment "
                    "variable LAMMPS_POTENTIALS ({}): set it, or use radius given",
                    FILE_NAME, folders ? folders : "not set");
  }
  std::map<double, Rows> by_tau;    // 0: any
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    line = utils::trim(utils::trim_comment(line));
    if (line.empty()) continue;
    try {
      ValueTokenizer words(line);
      const std::string name = words.next_string(), time = words.next_string();
      const double r = words.next_double(), correction = words.next_double();
      if (words.has_next() || !(r > 0.0)) throw TokenizerException("expected four words", "");
      if (name == link) by_tau[time == "any" ? 0.0 : std::stod(time)][r] = correction;
    } catch (std::exception &) {
      lmp->error->all(FLERR, "File {}: expected link tau r correction, not: {}", FILE_NAME, line);
    }
  }
  if (by_tau.empty())
    lmp->error->all(FLERR,
                    "Fix lb/ibb keyword radius: file {} has no line of link {}: use radius given, "
                    "or link cli",
                    FILE_NAME, link);
  const auto any = by_tau.find(0.0);
  if (any != by_tau.end()) {
    low = high = any->second;
    return;
  }
  const auto above = by_tau.lower_bound(tau);
  if (above == by_tau.end() || (above == by_tau.begin() && above->first != tau))
    lmp->error->all(FLERR,
                    "Fix lb/ibb keyword radius: tau = {:.4g}, but file {} has link {} from {:g} to "
                    "{:g} alone: change the fluid time step, or use link cli",
                    tau, FILE_NAME, link, by_tau.begin()->first, by_tau.rbegin()->first);
  high = above->second;
  low = above == by_tau.begin() ? high : std::prev(above)->second;
  if (above != by_tau.begin()) {
    const double before = std::prev(above)->first;
    share = (tau - before) / (above->first - before);
  }
}

double LBRadius::drawn(double r) const
{
  return r + (1.0 - share) * at(low, r) + share * at(high, r);
}
