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

TEST_F(FluidCuts, BalancedBeforeTheFirstRunOnly)
{
  const std::string cut = "balance 1.0 x 0.2 0.4 0.6";
  const std::string scene =
      box({20, 12, 12}, "p p p", "processors 4 1 1") +
      grain(1, {6, 6, 6}, 3.6) + fluid("accel 1e-3 0 0") + frozen();
  script(scene + "\n" + cut + run(20));
  const double flux = out(9);
  EXPECT_EQ(out(12), all_nodes() - covered({6, 6, 6}, 3.6));
  EXPECT_ERROR("balance 1.0 x 0.3 0.5 0.7",
               "the fluid cannot follow new sub-domains once it has moved");
  start();
  script(scene + run(20));
  EXPECT_NEAR(out(9), flux, 1e-12 * flux);
}
