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

// The contact files of potentials/: each material can be read, and its grains rebound as the file says.

#include "contact_scenes.h"

#include "force.h"
#include "pair.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

struct Entry {
  std::string file, name;
  double kn, e, mu;
};

static std::vector<Entry> entries()
{
  std::vector<Entry> all;
  const char *source = std::getenv("LBMIBB_SOURCE_DIR");
  if (!source) return all;
  for (const auto &found :
       std::filesystem::directory_iterator(std::string(source) + "/potentials")) {
    if (found.path().extension() != ".lsd") continue;
    std::ifstream file(found.path());
    std::string line;
    while (std::getline(file, line)) {
      if (line.empty() || line[0] == '#') continue;
      std::istringstream words(line);
      Entry entry{found.path().filename().string(), "", 0.0, 0.0, 0.0};
      words >> entry.name >> entry.kn >> entry.e >> entry.mu;
      all.push_back(entry);
    }
  }
  return all;
}

class Potentials : public ContactTest {};

TEST_F(Potentials, GrainsReboundAsTheFileSays)
{
  int checked = 0;
  for (const Entry &entry : entries()) {
    SCOPED_TRACE(entry.file + " " + entry.name);
    ASSERT_GT(entry.kn, 0.0);
    const bool disc = entry.name.size() > 3 && entry.name.substr(entry.name.size() - 3) == "_2d";
    Impact c;
    c.kn = entry.kn;
    c.e = entry.e;
    c.disc = disc;
    c.extra = "\npair_coeff * * file " + entry.file + " " + entry.name;
    EXPECT_NEAR(mean_restitution(c, false), entry.e, 0.002);
    int dim;
    const auto *mu = (double **) lmp->force->pair->extract("mu", dim);
    EXPECT_EQ(mu[1][1], entry.mu);
    checked++;
  }
  EXPECT_GE(checked, 7);
}

TEST_F(Potentials, EveryContactFileNamesItsSource)
{
  const char *source = std::getenv("LBMIBB_SOURCE_DIR");
  ASSERT_NE(source, nullptr);
  for (const auto &found :
       std::filesystem::directory_iterator(std::string(source) + "/potentials")) {
    if (found.path().extension() != ".lsd") continue;
    std::ifstream file(found.path());
    std::string line;
    std::getline(file, line);
    for (const char *word : {"DATE: ", "UNITS: ", "CONTRIBUTOR: ", "CITATION: "})
      EXPECT_NE(line.find(word), std::string::npos) << found.path() << " lacks " << word;
  }
}
