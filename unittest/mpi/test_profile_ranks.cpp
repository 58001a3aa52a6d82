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

// compute lb/ibb/profile is the same on any brick of ranks.

#include "../lammps/fluid_scenes.h"

#include "compute.h"

class ProfileRanks : public FluidTest {
 protected:
  std::vector<double> profile(const std::string &brick, const std::string &axis, MPI_Comm comm)
  {
    start(comm);
    const std::string floor = brick.empty() ? "" : "processors " + brick;
    script(
        box({12, 12, 12}, "p p f", floor) + grain(1, {2.3, 6.1, 3.2}, 3.1, {2e-3, 0, 1e-3}) +
        grain(2, {8.2, 0.3, 8.8}, 2.7) + "\nfix m all nve/sphere" +
        fluid(
            "accel 1e-3 0 0 buoyancy -0.03 0.02 -0.1 face zlo pressure 0.005 face zhi pressure 0") +
        "\ncompute p all lb/ibb/profile w " + axis + run(40));
    auto *compute = lmp->modify->get_compute_by_id("p");
    compute->compute_array();
    std::vector<double> all;
    for (int k = 0; k < compute->size_array_rows; k++)
      all.insert(all.end(), compute->array[k], compute->array[k] + compute->size_array_cols);
    return all;
  }
};

TEST_F(ProfileRanks, TheSameOnAnyBrick)
{
  int nprocs;
  MPI_Comm_size(MPI_COMM_WORLD, &nprocs);
  std::vector<std::string> bricks{"1 1 1"};
  if (nprocs == 2) bricks = {"2 1 1", "1 2 1", "1 1 2"};
  if (nprocs == 4) bricks = {"4 1 1", "1 4 1", "1 1 4", "2 2 1", "2 1 2", "1 2 2"};
  for (const std::string axis : {"x layers 4", "y layers 6", "z layers 12", "z width 6e-4"}) {
    const auto alone = profile("", axis, MPI_COMM_SELF);
    for (const std::string &brick : bricks) {
      SCOPED_TRACE(axis + ", " + brick);
      const auto together = profile(brick, axis, MPI_COMM_WORLD);
      ASSERT_EQ(together.size(), alone.size());
      for (int c = 0; c < 8; c++) {
        double size = 0.0;    // of the column
        for (std::size_t k = c; k < alone.size(); k += 8)
          size = std::max(size, std::fabs(alone[k]));
        EXPECT_GT(size, 0.0);
        for (std::size_t k = c; k < alone.size(); k += 8)
          EXPECT_NEAR(together[k], alone[k], 1e-12 * size) << "row " << k / 8 << " column " << c;
      }
    }
  }
}
