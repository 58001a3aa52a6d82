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

#include "gran_lsd_material.h"

#include "comm.h"
#include "error.h"
#include "text_file_reader.h"
#include "tokenizer.h"
#include "update.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   send a string of rank 0 to all
------------------------------------------------------------------------- */

static void bcast(std::string &text, MPI_Comm world)
{
  int n = int(text.size());
  MPI_Bcast(&n, 1, MPI_INT, 0, world);
  text.resize(n);
  if (n > 0) MPI_Bcast(&text[0], n, MPI_CHAR, 0, world);
}

/* ----------------------------------------------------------------------
   rank 0: look for one material in a file.  Return what is wrong, or "".
------------------------------------------------------------------------- */

static std::string read_material(LAMMPS *lmp, const std::string &file, const std::string &name,
                                 GranLSD::Material &mat)
{
  const std::string path = utils::get_potential_file_path(file);
  if (path.empty()) {
    const char *dirs = std::getenv("LAMMPS_POTENTIALS");
    return fmt::format("Cannot read contact file {}: it is neither there nor in a folder of the "
                       "environment variable LAMMPS_POTENTIALS ({})",
                       file, dirs ? dirs : "not set");
  }

  const std::string units = utils::get_potential_units(path, "contact");
  const std::string mine = lmp->update->unit_style;
  if (units.empty())
    return fmt::format("Contact file {} does not name its units: its first line must contain "
                       "UNITS: and a unit style",
                       path);
  if (units != mine)
    return fmt::format("Contact file {} is in {} units but the script uses {} units: use units {} "
                       "or give k_n, e and mu on the command",
                       path, units, mine, units);

  std::string known;
  bool found = false;
  try {
    TextFileReader reader(path, "contact");
    while (const char *line = reader.next_line()) {
      ValueTokenizer words(line);
      if (words.count() != 4)
        return fmt::format("Contact file {} has a line of {} words, expected the four words "
                           "NAME k_n e mu: {}",
                           path, words.count(), utils::trim(line));
      const std::string entry = words.next_string();
      known += " " + entry;
      if (entry != name) continue;
      if (found) return fmt::format("Contact file {} defines {} twice", path, name);
      found = true;
      mat.kn = words.next_double();
      mat.e = words.next_double();
      mat.mu = words.next_double();
    }
  } catch (std::exception &except) {
    return fmt::format("Contact file {}: {}", path, except.what());
  }
  if (!found)
    return fmt::format("Contact file {} does not define {}, it has:{}", path, name, known);

  utils::logmesg(lmp, "Reading {} from contact file {} with DATE: {}\n", name, path,
                 utils::get_potential_date(path, "contact"));
  return "";
}

/* ---------------------------------------------------------------------- */

GranLSD::Material GranLSDMaterial::parse(LAMMPS *lmp, const std::string &command, int narg,
                                         char **arg, int iarg)
{
  Error *error = lmp->error;
  if (iarg + NWORDS > narg)
    error->all(FLERR, "{}: expected k_n e mu, or file NAME.lsd MATERIAL", command);

  GranLSD::Material mat = {0.0, 0.0, 0.0};
  if (strcmp(arg[iarg], "file") == 0) {
    std::string problem;
    if (lmp->comm->me == 0) problem = read_material(lmp, arg[iarg + 1], arg[iarg + 2], mat);
    bcast(problem, lmp->world);
    if (!problem.empty()) error->all(FLERR, problem);
    MPI_Bcast(&mat, sizeof(mat), MPI_BYTE, 0, lmp->world);
  } else {
    mat.kn = utils::numeric(FLERR, arg[iarg], false, lmp);
    mat.e = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
    mat.mu = utils::numeric(FLERR, arg[iarg + 2], false, lmp);
  }

  // written so that NaN is refused as well

  if (!(mat.kn > 0.0) || std::isinf(mat.kn))
    error->all(FLERR, "{}: contact stiffness k_n = {} must be positive", command, mat.kn);
  if (!(mat.e > 0.0 && mat.e <= 1.0))
    error->all(FLERR,
               "{}: coefficient of restitution e = {} must be above 0 and at most 1 (1 = no "
               "damping)",
               command, mat.e);
  if (!(mat.mu >= 0.0) || std::isinf(mat.mu))
    error->all(FLERR, "{}: coefficient of friction mu = {} must be 0 or positive", command, mat.mu);
  return mat;
}

/* ---------------------------------------------------------------------- */

bool GranLSDMaterial::parse_option(LAMMPS *lmp, const std::string &command, int narg, char **arg,
                                   int iarg, double &offset, int &limit_damping,
                                   std::set<std::string> &given)
{
  if (iarg + 2 > narg)
    utils::missing_cmd_args(FLERR, fmt::format("{} {}", command, arg[iarg]), lmp->error);
  if (strcmp(arg[iarg], "offset") != 0 && strcmp(arg[iarg], "limit_damping") != 0) return false;
  if (!given.insert(arg[iarg]).second)
    lmp->error->all(FLERR, "{}: {} is given twice: remove one of them", command, arg[iarg]);
  if (strcmp(arg[iarg], "offset") == 0) {
    offset = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
    if (!(offset >= 0.0) || std::isinf(offset))
      lmp->error->all(FLERR, "{}: offset {} must be 0 or positive", command, offset);
  } else {
    limit_damping = utils::logical(FLERR, arg[iarg + 1], false, lmp);
  }
  return true;
}
