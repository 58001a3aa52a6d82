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

// Regions as solids do not know how the lattice is cut: nodes, fractions of links, loads, with grains
// that move among them.

#include "fluid_ranks.h"

class ObstacleRanks : public FluidRanks {
 protected:
  // over a corner of the periodic box and across the cuts, one of them turning
  static std::string regions()
  {
    return "\nregion ball sphere " + at({9.1, 8.2, 8.4}) + " " + num(3.7 * DX) +
        "\nregion rod cylinder x " + num(1.2 * DX) + " " + num(15.1 * DX) + " " + num(2.6 * DX) +
        " INF INF";
  }
};

TEST_F(ObstacleRanks, Alone)
{
  for (const std::string rule : {"cli", "bouzidi conserve no"})
    compare([&](const std::string &brick) {
      return box({18, 17, 18}, "p p p", brick) + regions() +
          fluid("accel 2e-3 -1e-3 5e-4 obstacle ball obstacle rod link " + rule) + run(40);
    });
}

TEST_F(ObstacleRanks, WithGrainsThatMove)
{
  compare([&](const std::string &brick) {
    return box({18, 17, 24}, "p p f", brick) + regions() +
        "\nregion floor block INF INF INF INF INF " + num(2.3 * DX) +
        grain(1, {9.3, 8.4, 14.2}, 2.6, {1e-3, -2e-3, -4e-3}) +
        grain(2, {3.1, 12.6, 12.0}, 2.3, {0, 3e-3, -2e-3}) + "\nfix m all nve/sphere" +
        fluid("accel 2e-3 0 0 face zlo wall face zhi wall obstacle ball omega 0 0 20 about " +
              at({9.1, 8.2, 8.4}) + " obstacle rod velocity 2e-3 0 0 obstacle floor") +
        run(60);
  });
}

TEST_F(ObstacleRanks, InTwoDimensions)
{
  compare([&](const std::string &brick) {
    return box({24, 20, 1}, "p f p", brick) + "\nregion rod cylinder z " + num(11.7 * DX) + " " +
        num(9.1 * DX) + " " + num(4.2 * DX) + " INF INF" +
        disc(1, {3.3, 12.1, 0}, 2.6, {4e-3, 0, 0}) + "\nfix m all nve/sphere disc" +
        fluid("accel 2e-3 0 0 face ylo wall face yhi wall obstacle rod omega 0 0 5 about " +
              at({11.7, 9.1, 0})) +
        "\nfix flat all enforce2d" + run(50);
  });
}

TEST_F(ObstacleRanks, Balanced)
{
  compare([&](const std::string &brick) {
    return box({24, 24, 24}, "p p p", brick) + regions() + grain(1, {0.3, 3.1, 17.2}, 3.3) +
        grain(2, {5.1, 8.2, 20.4}, 2.6) + grain(3, {17.1, 5.2, 19.4}, 4.1) +
        "\nfix m all move linear 4e-3 -3.9e-3 1e-3" +
        fluid("accel 1e-3 0 0 obstacle ball obstacle rod") + run(21) +
        (brick.empty() ? "" : "\nbalance 1.0 shift xyz 20 1.0") + run(21) +
        (brick.empty() ? "" : "\nbalance 1.0 x uniform y uniform z uniform") + run(21);
  });
}

// what is refused is refused by all alike
TEST_F(ObstacleRanks, RefusedAlike)
{
  start();
  EXPECT_ERROR(box({18, 17, 18}) + regions() + fluid("obstacle ball velocity 0 0 1e-3") + run(0),
               "would take its surface elsewhere");
  EXPECT_NOT_IN(error_of(run(0)), "on proc");
}
