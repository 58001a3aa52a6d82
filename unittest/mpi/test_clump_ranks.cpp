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

// Grains that come and go, and clumps, on any number of ranks: the bodies cross the faces between
// ranks, and the results are those of one rank alone.

#include "../lammps/fluid_scenes.h"

#include <map>

class ClumpRanks : public FluidTest {
 protected:
  // forces and torques of the fluid, and total forces, by grain; summed over ranks
  std::vector<double> result(int count)
  {
    std::vector<double> all(9 * count + 3, 0.0);
    for (int i = 0; i < lmp->atom->nlocal; i++) {
      double *values = &all[9 * (lmp->atom->tag[i] - 1)];
      for (int k = 0; k < 6; k++) values[k] = fix()->array_atom[i][k];
      for (int d = 0; d < 3; d++) values[6 + d] = lmp->atom->f[i][d];
    }
    MPI_Allreduce(MPI_IN_PLACE, all.data(), 9 * count, MPI_DOUBLE, MPI_SUM, lmp->world);
    all[9 * count] = mass();
    all[9 * count + 1] = out(12);
    all[9 * count + 2] = out(13);
    return all;
  }
  template <class Scene> void compare(int count, Scene &&scene)
  {
    start(MPI_COMM_SELF);
    scene();
    const auto alone = result(count);
    start(MPI_COMM_WORLD);
    scene();
    const auto together = result(count);
    double force = 0.0;
    for (int i = 0; i < count; i++)
      for (int d = 0; d < 3; d++) force = std::max(force, std::fabs(alone[9 * i + d]));
    ASSERT_GT(force, 0.0);
    for (int i = 0; i < count; i++)
      for (int k = 0; k < 9; k++)
        EXPECT_NEAR(together[9 * i + k], alone[9 * i + k],
                    1e-10 * force * (k >= 3 && k < 6 ? 10 * DX : 1.0))
            << i + 1 << " " << k;
    EXPECT_NEAR(together[9 * count], alone[9 * count], 1e-12 * alone[9 * count]);
    for (int k = 1; k < 3; k++) EXPECT_EQ(together[9 * count + k], alone[9 * count + k]);
  }
};

// three overlapping spheres in the corner of the box, so that every rank holds a part of them
TEST_F(ClumpRanks, AClumpAcrossAllFaces)
{
  for (const std::string style : {"rigid molecule", "rigid/small molecule"})
    compare(3, [&] {
      script(box({16, 15, 14}) + "\nfix mol all property/atom mol ghost yes" +
             grain(1, {0.3, 0.1, 13.9}, 3.2) + grain(2, {3.2, 1.3, 0.4}, 2.6) +
             grain(3, {1.4, 2.6, 1.7}, 2.9) +
             "\nset atom 1 image 0 0 -1\nset group all mol 1\nthermo_style custom step" +
             fluid("accel 2e-3 1e-3 -1e-3 buoyancy 0 0 -0.3 gradp 0 1 0") + "\nfix b all " + style +
             run(40));
    });
}

TEST_F(ClumpRanks, CreatedAndDeletedBetweenRuns)
{
  compare(3, [&] {
    script(box({16, 15, 14}) + grain(1, {4.3, 5.1, 3.9}, 2.83) + grain(2, {12.2, 9.3, 7.4}, 2.63) +
           fluid("accel 2e-3 1e-3 -1e-3") + frozen() + run(20));
    script("group gone id 1\ndelete_atoms group gone compress no" +
           grain(3, {7.9, 0.2, 13.8}, 2.93) + "\nset group all density 2600" + run(20));
  });
}
