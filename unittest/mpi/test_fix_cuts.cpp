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

// ctest: RANKS 4
// How the box may be cut among four ranks, and when.

#include "../lammps/fluid_scenes.h"

using FluidCuts = FluidTest;

TEST_F(FluidCuts, MoreRanksThanNodes)
{
  EXPECT_ERROR(box({3, 8, 8}, "p p p", "processors 4 1 1") + fluid() + run(0),
               "4 x 1 x 1 ranks are too many for 3 x 8 x 8 lattice nodes: each needs at least one");
}

TEST_F(FluidCuts, BalancedBeforeTheFirstRun)
{
  const std::string cut = "balance 1.0 x 0.2 0.4 0.6";
  const std::string scene = box({20, 12, 12}, "p p p", "processors 4 1 1") +
      grain(1, {6, 6, 6}, 3.6) + fluid("accel 1e-3 0 0") + frozen();
  script(scene + "\n" + cut + run(20));
  const double flux = out(9);
  EXPECT_EQ(out(12), all_nodes() - covered({6, 6, 6}, 3.6));
  start();
  script(scene + run(20));
  EXPECT_NEAR(out(9), flux, 1e-12 * flux);
}

TEST_F(FluidCuts, BalancedUntilARankHasNoNodes)
{
  script(box({20, 12, 12}, "p p p", "processors 4 1 1") + fluid("accel 1e-3 0 0") + run(5));
  EXPECT_ERROR("balance 1.0 x 0.3 0.51 0.52",
               "4 x 1 x 1 ranks are too many for 20 x 12 x 12 lattice nodes: each needs at least");
}

// tiled messages between the same sub-domains; those of recursive bisection are refused
TEST_F(FluidCuts, Tiled)
{
  const std::string scene = box({20, 12, 12}) + grain(1, {6, 6, 6}, 3.6) +
      grain(2, {19.5, 11.8, 6}, 3.6) + fluid("accel 1e-3 0 0") + "\n";
  script(scene + run(20));
  const double flux = out(9), force = out(6);
  ASSERT_GT(flux, 0.0);
  start();
  script(scene + "comm_style tiled" + run(20));
  EXPECT_NEAR(out(9), flux, 1e-12 * flux);
  EXPECT_NEAR(out(6), force, 1e-12 * force);
  start();
  EXPECT_ERROR(scene + "run 5 post no\ncomm_style tiled\nbalance 1.0 rcb",
               "needs sub-domains in rows and columns, not those of balance rcb");
}

// which LAMMPS would crash on
TEST_F(FluidCuts, AveragesOfFields)
{
  const std::string scene = box({20, 12, 12}, "p p p", "processors 4 1 1") +
      grain(1, {6, 6, 6}, 3.6) + fluid("accel 1e-3 0 0") +
      "\nfix mean all ave/grid 1 5 5 20 12 12 f_w:grid:pressure";
  EXPECT_ERROR(scene + "\nfix cut all balance 10 1.0 shift x 10 1.0" + run(20),
               "fix mean (ave/grid) of LAMMPS crashes when sub-domains change: unfix it");
  start();
  script(scene + run(20));
  EXPECT_ERROR("balance 1.0 x 0.2 0.4 0.6", "fix mean (ave/grid) of LAMMPS crashes");
}
