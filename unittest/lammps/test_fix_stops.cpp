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

// What stops a run with fix lb/ibb: message with place, time, grain and likely cause.

#include "fluid_scenes.h"

using Stops = FluidTest;

TEST_F(Stops, FluidTooFast)
{
  script(box({8, 8, 8}) + grain(1, {4, 4, 4}, 2.6) + fluid("accel 1.0 0 0 check 5") + frozen());
  const std::string message = error_of(run(100));
  EXPECT_IN(message, "Fix lb/ibb: stopped at step ");
  EXPECT_IN(message, "fluid step ");
  EXPECT_IN(message, "node (");
  EXPECT_IN(message, "the fluid's speed is ");
  EXPECT_IN(message, ", limit 0.3. There rho = ");
  EXPECT_IN(message, ". Nearest grain: 1, surface ");
  EXPECT_IN(message, "density 2.6 rho, speed 0. tau = 0.8000. Likely cause: ");
}

TEST_F(Stops, FluidTooFastWithoutGrains)
{
  script(box({8, 8, 8}) + fluid("accel 1.0 0 0 check 5"));
  const std::string message = error_of(run(100));
  EXPECT_IN(message, "stopped at step 20, fluid step 20: at (5e-05, 5e-05, 5e-05), node (0, 0, 0)");
  EXPECT_IN(message, "Ma = 0.346, limit 0.3. There rho = 1000, Ma = 0.346, u dx/nu = 2.");
  EXPECT_IN(message, "Likely cause: the flow is too fast for the fluid time step");
}

// the stability check comes before every output, whatever its own interval
TEST_F(Stops, CheckBeforeOutput)
{
  script(box({8, 8, 8}) + fluid("accel 1.0 0 0 check 100000") + "\nthermo 30");
  EXPECT_ERROR(run(100), "stopped at step 30, fluid step 30:");
}

// thrown off a wall so fast that nothing is left there: the strongest drive that a run may start with
TEST_F(Stops, DensityBelowZero)
{
  script(box({8, 8, 8}, "p p f") + fluid("accel 0 0 34 face zlo wall face zhi wall check 5"));
  const std::string message = error_of(run(20));
  EXPECT_IN(message, "stopped at step 5, fluid step 5: at (5e-05, 5e-05, 5e-05), node (0, 0, 0), ");
  EXPECT_IN(message, "the fluid's density is -3.");
  EXPECT_IN(message, " times rho, it must be positive");
}

TEST_F(Stops, ValuesThatAreNoNumbers)
{
  script(box({8, 8, 8}) + fluid("check 3 accel v_a 0 0") + "\nvariable a equal 1e300*(step>3)");
  const std::string message = error_of(run(20));
  EXPECT_IN(message, "stopped at step 6, fluid step 6: at (5e-05, 5e-05, 5e-05), node (0, 0, 0), ");
  EXPECT_IN(message, "the fluid's density is ");
  EXPECT_IN(message, "nan times rho, it must be positive");
}

TEST_F(Stops, VariableThatIsNoNumber)
{
  script(box({8, 8, 8}) + fluid("accel v_a 0 0") + "\nvariable a equal exp(100*step)");
  EXPECT_ERROR(run(20), "Fix lb/ibb: variable a is inf at step 8");
}

TEST_F(Stops, PressureRampGoesTooFar)
{
  script(box({8, 8, 8}, "p p f") + fluid("face zlo pressure v_p face zhi pressure 0 check 1000") +
         "\nvariable p equal 0.01*step\nthermo 1000");
  EXPECT_ERROR(run(100),
               "stopped at step 67, fluid step 66: pressure difference 0.67 between faces "
               "changes the density by 20.1 %, limit 20 %");
}

TEST_F(Stops, WallRampGoesTooFar)
{
  script(box({8, 8, 8}, "p p f") + fluid("face zlo wall v_u 0 0 face zhi wall check 1000") +
         "\nvariable u equal 1e-3*step\nthermo 1000");
  EXPECT_ERROR(run(100),
               "stopped at step 18, fluid step 17: speed 0.018 prescribed at a face is Ma");
}

// at rest when the fluid saw it last
TEST_F(Stops, GrainMovesMoreThanACell)
{
  script(box({16, 12, 12}) + grain(1, {6, 6, 6}, 3.6) + fluid("check 1000") +
         "\nthermo 1000\nfix m all nve/sphere" + run(2));
  const std::string message = error_of("velocity all set 0.15 0 0" + run(10));
  EXPECT_IN(message, "stopped at step 3, fluid step 3: grain 1 at (");
  EXPECT_IN(message,
            "moved 1.5 cells in one fluid step, limit 1; its speed is 0.15, radius 3.6 "
            "cells, density 2.6 rho; tau = 0.8000. ");
  EXPECT_IN(message, "Likely cause: it is too fast for the fluid time step");
}

TEST_F(Stops, GrainPlacedAnewBetweenRuns)
{
  script(box({16, 12, 12}) + grain(1, {6, 6, 6}, 3.6) + fluid() + frozen() + run(5));
  const std::string message = error_of("displace_atoms all move 3e-4 0 0" + run(5));
  EXPECT_IN(message, "moved 3 cells in one fluid step, limit 1; its speed is 0, ");
  EXPECT_IN(message, "Likely cause: it was placed anew; delete a grain and create it instead");
}

TEST_F(Stops, SurfaceOfAGrainTooFast)
{
  script(box({16, 12, 12}) + grain(1, {6, 6, 6}, 3.6) + "\nset atom 1 omega 0 0 50" +
         fluid("check 1000") + "\nthermo 1000\nfix m all move linear 0 0 0");
  const std::string message = error_of(run(10));
  EXPECT_IN(message, "stopped at step 1, fluid step 1: grain 1 at (");
  EXPECT_IN(message, "has a surface that moves at 0.018, Ma = 0.312, limit 0.3");
  EXPECT_IN(message, "Likely cause: it spins too fast for the fluid time step");
}

// warned of once in a run, where the error grows but nothing breaks yet
TEST_F(Stops, WarnsAboveATenthOfTheSpeedOfSound)
{
  const double u = 0.11 * SOUND;
  const std::string scene = box({16, 12, 12}) + grain(1, {6, 6, 6}, 3.6) + "\nvelocity all set " +
      num(u) + " 0 0" + fluid("check 1") + "\nfix m all move linear ";
  script(scene + num(0.8 * u) + " 0 0" + run(3));
  const int before = warnings();
  script("unfix m\nfix m all move linear " + num(u) + " 0 0");
  const std::string log = log_of(run(3));
  EXPECT_IN(log, "WARNING: Fix lb/ibb: step 4: ");
  EXPECT_IN(log, "cells in one fluid step, Ma = 0.1");
  EXPECT_EQ(warnings(), before + 1);
}

TEST_F(Stops, BalancingOneRankIsHarmless)
{
  // on one rank nothing moves, so balancing is harmless
  script(box({16, 12, 12}) + grain(1, {6, 6, 6}, 3.6) + fluid() + frozen() + run(5));
  EXPECT_EQ(error_of("balance 1.0 shift x 5 1.0" + run(5)), "");
}
