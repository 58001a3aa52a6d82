/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "lb_ibb_radius.h"

#include "lb_ibb_table.h"

#include "error.h"
#include "tokenizer.h"

#include <iterator>
#include <sstream>

using namespace LAMMPS_NS;

static constexpr const char *FILE_NAME = "lbm-ibb.radius";

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
  const std::string text = read_table(lmp, FILE_NAME);
  if (text.empty())
    lmp->error->all(FLERR, "Fix lb/ibb keyword radius: {}: set it, or use radius given",
                    no_table(FILE_NAME));
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
