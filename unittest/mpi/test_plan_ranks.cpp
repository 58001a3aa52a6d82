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

// lb/plan on several ranks: the numbers are those of one, and all ranks have the same.

#include "../lammps/fluid_scenes.h"

class PlanRanks : public FluidTest {
 protected:
  std::vector<double> values(const std::string &words, MPI_Comm comm)
  {
    start(comm);
    script(box({20, 20, 30}) + grain(1, {5, 5, 5}, 4.0) + grain(2, {14, 5, 15}, 5.0) +
           grain(3, {5, 14, 25}, 4.5) + "\nlb/plan nu 1e-6 rho 1000 group all " + words);
    std::vector<double> all;
    for (const char *name : {"dx", "dt", "every", "tau", "mach", "excess", "error", "diffusion",
                             "steps", "nodes", "memory", "seconds"})
      all.push_back(thermo("v_lb_" + std::string(name)));
    return all;
  }
};

TEST_F(PlanRanks, TheSameNumbersOnAllRanks)
{
  int nprocs;
  MPI_Comm_size(MPI_COMM_WORLD, &nprocs);
  for (const std::string words :
       {"dx 1e-4 speed 0.02 pressure 0.5 contact 1e3 0.9 0.4 time 1", "error 0.03 speed 0.01 measure no"}) {
    SCOPED_TRACE(words);
    const auto together = values(words, MPI_COMM_WORLD);
    auto least = together, most = together;
    const int n = int(together.size());
    MPI_Allreduce(MPI_IN_PLACE, least.data(), n, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
    MPI_Allreduce(MPI_IN_PLACE, most.data(), n, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    EXPECT_EQ(least, most);
    // all but memory and seconds, which may be anything less or more
    const auto alone =
        values(words + (words.find("measure") < words.size() ? "" : " measure no"), MPI_COMM_SELF);
    for (int k = 0; k < n - 2; k++) EXPECT_NEAR(together[k], alone[k], 1e-12 * alone[k]) << k;
    if (words.find("measure") >= words.size()) {
      EXPECT_GT(together[n - 2], 0.0);
      EXPECT_GT(together[n - 1], 0.0);
    }
  }
}
