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

// Grains in the fluid of fix lb/ibb: invariance, motion, groups, coupling in time.

#include "fluid_scenes.h"

using Grains = FluidTest;

/* ---- where a grain is does not matter ---- */

TEST_F(Grains, TranslationByWholeCellsAcrossPeriodicFaces)
{
  const Triple a{2e-3, -1e-3, 5e-4}, c{6.3, 5.1, 4.9};
  Triple F{}, T{};
  for (const Cells shift : {Cells{0, 0, 0}, Cells{6, 0, 0}, Cells{5, 6, 0}, Cells{6, 6, 5}}) {
    start();
    script(box({12, 11, 10}) +
           grain(1,
                 {fmod(c[0] + shift[0], 12), fmod(c[1] + shift[1], 11), fmod(c[2] + shift[2], 10)},
                 3.6) +
           fluid("accel " + nums(a)) + frozen() + run(60));
    for (int d = 0; d < 3; d++) {
      if (shift == Cells{0, 0, 0}) {
        F[d] = load(1)[d];
        T[d] = load(1)[3 + d];
      } else {
        EXPECT_NEAR(load(1)[d], F[d], 1e-12 * std::fabs(F[0]));
        EXPECT_NEAR(load(1)[3 + d], T[d], 1e-12 * std::fabs(F[0]) * DX);
      }
    }
  }
}

// the drag of a grain does not change if grain and fluid drift together
TEST_F(Grains, DragIsThatOfTheRelativeVelocity)
{
  const double U = 2e-3;
  auto mean_drag = [&](double drift) {
    start();
    const int first = 300, steps = 100;
    // the fluid is set in motion in the first step
    script(box({20, 16, 16}) + grain(1, {5.3, 8.1, 7.9}, 4.2) + "\nvariable a equal " +
           num(drift / DT) + "*(step==1)\nfix m all move linear " + num(U + drift) + " 0 0" +
           fluid("accel v_a 0 0") + run(first));
    script("fix mean all ave/time 1 " + std::to_string(steps) + " " +
           std::to_string(first + steps) + " f_w[6]");
    script(run(steps));
    return lmp->modify->get_fix_by_id("mean")->compute_scalar();
  };
  const double still = mean_drag(0.0);
  // somewhat less than 6 pi mu a U: the fluid has begun to follow
  EXPECT_LT(still, -0.4 * 6.0 * PI_ * RHO * NU * 4.2 * DX * U);
  EXPECT_NEAR(mean_drag(3e-3), still, 0.02 * std::fabs(still));
  EXPECT_NEAR(mean_drag(-4e-3), still, 0.02 * std::fabs(still));
}

TEST_F(Grains, TouchingGrainsInFluidAtRestFeelNothing)
{
  script(box({20, 12, 12}) + grain(1, {6.2, 6.0, 6.1}, 3.5) + grain(2, {13.3, 6.0, 6.1}, 3.5) +
         fluid() + frozen() + run(20));
  for (int k = 0; k < 6; k++) {
    EXPECT_EQ(load(1)[k], 0.0);
    EXPECT_EQ(load(2)[k], 0.0);
  }
  EXPECT_EQ(out(3), 0.0);
}

// two grains whose links meet in gaps of one node share the driving force
TEST_F(Grains, TwoGrainsWhoseLinksMeet)
{
  const Triple a{0, 2e-3, 0};
  script(box({20, 12, 12}) + grain(1, {5.75, 6.0, 6.0}, 3.5) + grain(2, {14.25, 6.0, 6.0}, 3.5) +
         fluid("link halfway accel " + nums(a)) + frozen() + run(2500));
  const double volume = out(12) * cell_volume(), whole = RHO * a[1] * volume;
  EXPECT_NEAR(force(1)[1] + force(2)[1], whole, 1e-10 * whole);
  EXPECT_NEAR(force(1)[1], force(2)[1], 1e-9 * whole);    // mirror images
  EXPECT_NEAR(force(1)[0], -force(2)[0], 1e-9 * whole);
  EXPECT_EQ(out(13), cut_links());
}

/* ---- what is added to a grain ---- */

TEST_F(Grains, BuoyancyAndShrink)
{
  const double r = 4.0, shrink = 0.33;
  for (int dimension : {2, 3}) {
    start();
    const Triple c{6.2, 6.1, 6.3};
    script(dimension == 3 ? box({12, 12, 12}) + grain(1, c, r) : box({12, 12, 1}) + disc(1, c, r));
    script(fluid("buoyancy 1.5 -9.81 0 shrink " + num(shrink * DX)) + run(0));
    const double lift = RHO * grain_volume(r - shrink);
    EXPECT_NEAR(f(1)[0], -lift * 1.5, 1e-13 * lift);
    EXPECT_NEAR(f(1)[1], lift * 9.81, 1e-13 * lift);
    script("fix ice all setforce 0 0 0" + run(5));
    EXPECT_EQ(f(1)[1], 0.0);
    for (int k = 0; k < 6; k++) EXPECT_EQ(load(1)[k], 0.0);    // buoyancy is not in the outputs
    EXPECT_EQ(out(7), 0.0);
    EXPECT_EQ(out(12), all_nodes() - covered(c, r - shrink));
  }
}

TEST_F(Grains, ShrunkGrainIsASmallerGrainForTheFluid)
{
  Triple F[2];
  for (int i = 0; i < 2; i++) {
    start();
    script(box({12, 12, 12}) + grain(1, {6.2, 6.1, 6.3}, i ? 4.0 : 3.5) +
           fluid(std::string("accel 1e-3 0 0 gradp 1 2 3 shrink ") + (i ? "0.5e-4" : "0")) +
           frozen() + run(30));
    F[i] = force(1);
  }
  for (int d = 0; d < 3; d++) EXPECT_NEAR(F[1][d], F[0][d], 1e-12 * std::fabs(F[0][d]));
}

TEST_F(Grains, AverageIsTheMeanOfTwoSteps)
{
  std::vector<Triple> plain;
  for (const std::string average : {"no", "yes"}) {
    start();
    script(box({10, 9, 8}) + grain(1, {5.2, 4.1, 4.3}, 2.7) +
           fluid("average " + average + " accel 1e-3 2e-3 0 gradp 0 0 1") + frozen());
    for (int step = 1; step <= 6; step++) {
      script(run(1));
      if (average == "no") {
        plain.push_back(force(1));
        continue;
      }
      // of the first step there is only one; the part of gradp is not averaged but the same
      const Triple now = plain[step - 1], last = plain[step == 1 ? 0 : step - 2];
      for (int d = 0; d < 3; d++)
        EXPECT_NEAR(force(1)[d], 0.5 * (now[d] + last[d]), 1e-14 * std::fabs(plain[5][d]));
    }
  }
}

TEST_F(Grains, ForceIsHeldBetweenFluidSteps)
{
  // four granular steps a fluid step, and runs that end anywhere
  script(box({10, 9, 8}) + grain(1, {5.2, 4.1, 4.3}, 2.7) + "\ntimestep " + num(DT / 4) +
         fluid("every 4 accel 1e-3 2e-3 0"));
  script("fix free all nve/sphere" + run(3));
  EXPECT_EQ(force(1)[0], 0.0);
  EXPECT_NEAR(out(2), DT, 1e-18);
  EXPECT_NEAR(out(1), TAU, 1e-14);
  Triple held{};
  for (int step = 4; step < 17; step++) {
    const double v0 = v(1)[0];
    script(run(1));
    // at a fluid step the force of the last one was still used, and the new one stands ready
    if (step % 4 == 0)
      EXPECT_NE(force(1)[0], held[0]);
    else
      EXPECT_EQ(force(1)[0], held[0]);
    if (step % 4 != 0) {
      EXPECT_EQ(f(1)[0], held[0]);
      if (step % 4 > 1) EXPECT_NEAR(v(1)[0] - v0, held[0] / LammpsTest::mass(1) * DT / 4, 1e-18);
    }
    held = force(1);
  }
}

/* ---- motion ---- */

TEST_F(Grains, SettlingSphereReachesATerminalVelocity)
{
  const double r = 3.6;
  script(box({16, 16, 40}, "f f f") + grain(1, {8.2, 7.9, 30.1}, r) + "\ntimestep " + num(DT / 4) +
         "\nfix free all nve/sphere\nfix g all gravity 0.05 vector 0 0 -1" +
         fluid("every 4 buoyancy 0 0 -0.05 face xlo wall face xhi wall face ylo wall face yhi wall "
               "face zlo wall face zhi wall"));
  std::vector<double> speed;
  for (int k = 0; k < 6; k++) {
    script(run(1200));
    speed.push_back(-v(1)[2]);
  }
  // Stokes's speed, a quarter of it or so between walls at 2.2 radii: 0.22 in a round tube
  // (Faxen), more in a square one
  const double stokes = 2.0 / 9.0 * (SOLID / RHO - 1.0) * 0.05 * r * DX * r * DX / NU;
  for (int k = 1; k < 4; k++) EXPECT_GT(speed[k], 0.999 * speed[k - 1]);
  EXPECT_NEAR(speed[3], speed[2], 0.01 * speed[2]);
  EXPECT_GT(speed[2], 0.22 * stokes);
  EXPECT_LT(speed[2], 0.35 * stokes);
  // at its terminal velocity the fluid carries the submerged weight
  const double weight = (SOLID - RHO) * grain_volume(r) * 0.05;
  EXPECT_NEAR(force(1)[2], weight, 0.05 * weight);
}

TEST_F(Grains, SpinningGrainFeelsATorqueOnly)
{
  // 8 pi mu a^3 w, a little more in a box that ends
  const double r = 5.3, w = 2.0;
  script(box({24, 24, 24}, "f f f") + grain(1, {12, 12, 12}, r) + "\nset atom 1 omega 0 0 " +
         num(w) +
         fluid("face xlo wall face xhi wall face ylo wall face yhi wall face zlo wall face zhi "
               "wall") +
         "\nfix m all move linear 0 0 0" + run(1500));
  const double T = 8.0 * PI_ * RHO * NU * std::pow(r * DX, 3) * w;
  EXPECT_NEAR(load(1)[5], -1.09 * T, 0.05 * T);
  EXPECT_NEAR(load(1)[0], 0.0, 1e-8 * T / DX);
  EXPECT_NEAR(out(3), w * r * DX / SOUND, 1e-12);    // the fastest is the surface
}

/* ---- group ---- */

TEST_F(Grains, OutsideTheGroupTheFluidSeesNothing)
{
  script(
      box({12, 11, 10}) + grain(1, {5.3, 6.1, 4.9}, 2.65) + grain(2, {10.1, 3.1, 2.0}, 2.2) +
      "\ngroup wet id 1\nfix w wet lb/ibb dx 1e-4 nu 1e-6 rho 1000 accel 2e-3 0 0 buoyancy 0 0 -9" +
      "\nfix still all setforce NULL NULL NULL" + run(20));
  EXPECT_EQ(out(12), all_nodes() - covered({5.3, 6.1, 4.9}, 2.65));
  EXPECT_NE(force(1)[0], 0.0);
  EXPECT_EQ(force(2)[0], 0.0);
  EXPECT_EQ(f(2)[2], 0.0);
  EXPECT_DOUBLE_EQ(out(6), force(1)[0]);
  // out of the group and into it
  script("group wet clear\ngroup wet id 2" + run(1));
  EXPECT_EQ(force(1)[0], 0.0);
  EXPECT_NE(force(2)[0], 0.0);
  EXPECT_EQ(out(12), all_nodes() - covered({10.1, 3.1, 2.0}, 2.2));
}

TEST_F(Grains, FreezeComesAfter)
{
  const std::string scene = box({12, 11, 10}) + grain(1, {5.3, 6.1, 4.9}, 2.6);
  const std::string warning = "is defined before fix lb/ibb and does not see its forces";
  EXPECT_NOT_IN(log_of(scene + fluid("accel 2e-3 0 0") + frozen() + run(10)), warning);
  EXPECT_EQ(f(1)[0], 0.0);
  EXPECT_GT(force(1)[0], 0.0);
  start();
  EXPECT_IN(log_of(scene + frozen() + fluid("accel 2e-3 0 0") + run(10)),
            "Fix ice (freeze) " + warning + ": define it after");
  EXPECT_GT(f(1)[0], 0.0);
}
