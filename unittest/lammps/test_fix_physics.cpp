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

// SI in, SI out: what drives the fluid of fix lb/ibb comes back as force on the grains, flows between
// walls and faces are those of the books, and the outputs of the fix say so.

#include "fluid_scenes.h"

using Physics = FluidTest;

/* ---- grains in a driven periodic box ---- */

// what the fluid gains is what drives it less what the grains take, at every step
TEST_F(Physics, MomentumBalanceOfAFixedSphere)
{
  const Triple a{2.0e-3, -1.0e-3, 5.0e-4};
  for (const std::string options : {"", "link bouzidi", "collision bgk link halfway"}) {
    start();
    script(box({12, 11, 10}) + grain(1, {5.3, 6.1, 4.9}, 3.6) +
           fluid("average no accel " + nums(a) + " " + options) + frozen() + run(20));
    for (int step = 0; step < 3; step++) {
      const Triple before = momentum();
      script(run(1));
      const Triple after = momentum();
      const double volume = out(12) * cell_volume();
      for (int d = 0; d < 3; d++)
        EXPECT_NEAR((after[d] - before[d]) / DT + force(1)[d], RHO * a[d] * volume,
                    1e-10 * RHO * 2.0e-3 * volume)
            << options;
    }
  }
}

// what interpolated links swallow comes back, unless it is not wanted; half-way links swallow nothing
TEST_F(Physics, MassOfAPeriodicBedIsConserved)
{
  std::string bed;
  for (int k = 0; k < 8; k++)
    bed += grain(k + 1, {0.3 + 7.0 * (k & 1), 0.6 + 7.0 * (k >> 1 & 1), 0.1 + 7.0 * (k >> 2)}, 3.6);
  auto drift = [&](const std::string &options) {
    start();
    script(box({14, 14, 14}) + bed + fluid("accel 0.02 0.01 0.03 " + options) + frozen() + run(100));
    const double before = mass();
    script(run(500));
    return std::fabs(mass() / before - 1.0);
  };
  const double lost = drift("conserve no");
  EXPECT_GT(lost, 1e-6);
  EXPECT_LT(drift(""), 0.05 * lost);
  EXPECT_LT(drift("conserve no link halfway"), 1e-12);
}

// the same flow to the digits that single precision has, in half the memory
TEST_F(Physics, SinglePrecision)
{
  Triple load[2], u[2];
  for (int single = 0; single < 2; single++) {
    start();
    script(box({12, 11, 10}) + grain(1, {5.3, 6.1, 4.9}, 3.6) +
           fluid(std::string("accel 2e-3 -1e-3 5e-4 precision ") + (single ? "single" : "double")) +
           frozen() + run(500));
    for (int d = 0; d < 3; d++) {
      load[single][d] = force(1)[d];
      u[single][d] = out(9 + d);
    }
  }
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(load[1][d], load[0][d], 3e-6 * std::fabs(load[0][0]));
    EXPECT_NEAR(u[1][d], u[0][d], 3e-6 * std::fabs(u[0][0]));
    EXPECT_NE(load[1][d], load[0][d]);
  }
}

TEST_F(Physics, SteadyForceIsTheDrivingForce)
{
  const Triple a{2.0e-3, -1.0e-3, 5.0e-4};
  script(box({12, 11, 10}) + grain(1, {5.3, 6.1, 4.9}, 3.6) +
         fluid("link halfway accel " + nums(a)) + frozen() + run(1500));
  const double volume = out(12) * cell_volume();
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(force(1)[d], RHO * a[d] * volume, 1e-10 * RHO * 2.0e-3 * volume);
    EXPECT_DOUBLE_EQ(out(6 + d), force(1)[d]);
  }
}

// grad p pushes the fluid by -grad p and the grain by -V grad p
TEST_F(Physics, PressureGradientPushesFluidAndGrain)
{
  const double r = 3.6;
  const Triple g{2.0, -1.0, 0.5};
  script(box({12, 11, 10}) + grain(1, {5.3, 6.1, 4.9}, r) + fluid("link halfway gradp " + nums(g)) +
         frozen() + run(1500));
  const double volume = out(12) * cell_volume() + grain_volume(r);
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(force(1)[d], -g[d] * volume, 1e-10 * 2.0 * volume);
    EXPECT_DOUBLE_EQ(out(6 + d), force(1)[d]);
  }
  // the fluid feels no difference to the acceleration -grad p / rho
  const Triple flux{out(9), out(10), out(11)};
  start();
  script(box({12, 11, 10}) + grain(1, {5.3, 6.1, 4.9}, r) +
         fluid("link halfway accel " + nums({-g[0] / RHO, -g[1] / RHO, -g[2] / RHO})) + frozen() +
         run(1500));
  for (int d = 0; d < 3; d++) EXPECT_NEAR(out(9 + d), flux[d], 1e-12 * std::fabs(flux[0]));
}

TEST_F(Physics, OutputsWithAGrain)
{
  const double r = 3.6;
  const Triple c{5.3, 6.1, 1.2};
  script(box({12, 11, 10}) + grain(1, c, r) + fluid("accel 2e-3 0 0 average no") + frozen() +
         run(30));
  EXPECT_EQ(out(12), all_nodes() - covered(c, r));
  EXPECT_EQ(out(13), cut_links());

  double sum = 0.0, fastest = 0.0, low = 1e300, high = 0.0;
  Triple flux{};
  const auto rho = values("density"), pressure = values("pressure"), solid = values("solid");
  const std::vector<double> u[3] = {values("velocity", 0), values("velocity", 1),
                                    values("velocity", 2)};
  for (std::size_t k = 0; k < rho.size(); k++) {
    const double speed = std::sqrt(u[0][k] * u[0][k] + u[1][k] * u[1][k] + u[2][k] * u[2][k]);
    if (solid[k] == 1.0) {
      EXPECT_EQ(speed, 0.0);
      continue;
    }
    EXPECT_NEAR(pressure[k], SOUND * SOUND * (rho[k] - RHO), 1e-9);
    sum += rho[k] * cell_volume();
    low = std::min(low, rho[k]);
    high = std::max(high, rho[k]);
    fastest = std::max(fastest, speed);
    for (int d = 0; d < 3; d++) flux[d] += u[d][k] / all_nodes();
  }
  EXPECT_NEAR(mass(), sum, 1e-13 * sum);
  EXPECT_NEAR(out(3), fastest / SOUND, 1e-12 * fastest / SOUND);
  EXPECT_NEAR(out(4), low / RHO, 1e-14);
  EXPECT_NEAR(out(5), high / RHO, 1e-14);
  for (int d = 0; d < 3; d++) EXPECT_NEAR(out(9 + d), flux[d], 1e-14 * fastest);
}

/* ---- flow without grains: no atom at all, no pair style ---- */

TEST_F(Physics, PoiseuilleAndItsOutputs)
{
  const double a = 0.02, H = 10 * DX;
  script(box({4, 10, 3}, "p f p") + fluid("face ylo wall face yhi wall accel 0.02 0 0") +
         run(3000));
  double mean = 0.0, fastest = 0.0;
  for (int j = 0; j < 10; j++) {
    const double y = (j + 0.5) * DX, u = a / (2.0 * NU) * y * (H - y);
    for (int x = 0; x < 4; x++) EXPECT_NEAR(field("velocity", {x, j, 1}, 0), u, 1e-10 * u);
    mean += u / 10;
    fastest = std::max(fastest, u);
  }
  EXPECT_NEAR(out(1), TAU, 1e-14);
  EXPECT_NEAR(out(2), DT, 1e-18);
  EXPECT_NEAR(out(3), fastest / SOUND, 1e-10);
  EXPECT_NEAR(out(4), 1.0, 1e-12);
  EXPECT_NEAR(out(5), 1.0, 1e-12);
  for (int i : {6, 7, 8, 10, 11, 13}) EXPECT_NEAR(out(i), 0.0, 1e-15) << i;
  EXPECT_NEAR(out(9), mean, 1e-10 * mean);
  EXPECT_EQ(out(12), 120.0);
  EXPECT_GT(out(14), 0.0);
  EXPECT_NEAR(mass(), RHO * 120 * cell_volume(), 1e-12 * mass());
}

TEST_F(Physics, CouetteBetweenMovingWalls)
{
  script(box({3, 8, 4}, "p f p") +
         fluid("face ylo wall -1e-3 0 5e-4 face yhi wall 2e-3 0 v_w collision bgk") +
         "\nvariable w equal -1e-3" + run(2500));
  for (int j = 0; j < 8; j++) {
    const double s = (j + 0.5) / 8;
    EXPECT_NEAR(field("velocity", {1, j, 2}, 0), -1e-3 + 3e-3 * s, 1e-13);
    EXPECT_NEAR(field("velocity", {1, j, 2}, 1), 0.0, 1e-13);
    EXPECT_NEAR(field("velocity", {1, j, 2}, 2), 5e-4 - 1.5e-3 * s, 1e-13);
  }
}

// planes of given pressure are the first and last nodes: the gradient is dp/(L - dx)
TEST_F(Physics, PressureFaces)
{
  const double p = 4.0e-3, H = 8 * DX;    // p/(rho c_s^2) is 1.2e-6
  script(box({17, 8, 1}, "f f p") +
         fluid("face xlo pressure 4e-3 face xhi pressure -4e-3 face ylo wall face yhi wall") +
         run(4000));
  const double gradient = 2.0 * p / (16 * DX);
  for (int j = 1; j < 7; j++) {    // the walls win at the edges
    EXPECT_NEAR(field("pressure", {0, j, 0}), p, 1e-10 * p);
    EXPECT_NEAR(field("pressure", {16, j, 0}), -p, 1e-10 * p);
    EXPECT_NEAR(field("pressure", {8, j, 0}), 0.0, 1e-3 * p);
    const double y = (j + 0.5) * DX, u = gradient / (2.0 * RHO * NU) * y * (H - y);
    EXPECT_NEAR(field("velocity", {8, j, 0}, 0), u, 0.035 * u);    // over L it were 6 % less
  }
  EXPECT_NEAR(out(4), 1.0 - p / (RHO * SOUND * SOUND), 1e-12);
  EXPECT_NEAR(out(5), 1.0 + p / (RHO * SOUND * SOUND), 1e-12);
}

TEST_F(Physics, VelocityFace)
{
  script(box({4, 3, 12}, "p p f") + fluid("face zlo velocity 0 0 v_u face zhi pressure 0") +
         "\nvariable u equal 1e-3*(1-exp(-step/200))" + run(4000));
  const double u = 1e-3 * (1.0 - std::exp(-20.0));
  for (int k = 0; k < 12; k++) EXPECT_NEAR(field("velocity", {2, 1, k}, 2), u, 1e-4 * u);
  EXPECT_NEAR(field("velocity", {2, 1, 0}, 2), u, 1e-12 * u);
  EXPECT_NEAR(field("pressure", {2, 1, 11}), 0.0, 1e-12);
  EXPECT_NEAR(out(11), u, 1e-4 * u);
}

/* ---- variables ---- */

// a free fluid adds up what it is given, evaluated once a fluid step
TEST_F(Physics, VariablesAreEvaluatedEveryFluidStep)
{
  const double a = 1.0e-4;
  script(box({4, 3, 5}) + "\ntimestep " + num(DT / 2) +
         fluid("every 2 accel v_a 0 0 gradp 0 v_p 0") + "\nvariable a equal 1e-4*step" +
         "\nvariable p equal -0.1*step" + run(21));
  double sum = 0.0;
  for (int step = 2; step <= 20; step += 2) sum += step;
  const double u = DT * (sum + 0.5 * 20);    // half of the last push is in the velocity already
  EXPECT_NEAR(field("velocity", {1, 1, 1}, 0), a * u, 1e-12 * a * u);
  EXPECT_NEAR(field("velocity", {1, 1, 1}, 1), 0.1 / RHO * u, 1e-12 * a * u);
  EXPECT_NEAR(out(9), a * u, 1e-12 * a * u);
}

// started at rest, the fluid has the velocity a t, not that of half a step more
TEST_F(Physics, FluidStartsAtRest)
{
  script(box({4, 3, 5}) + fluid("accel 1e-3 0 0") + run(0));
  EXPECT_NEAR(out(9), 0.0, 1e-18);
  script(run(10));
  EXPECT_NEAR(out(9), 1e-3 * 10 * DT, 1e-15);
}

TEST_F(Physics, VariableThatUsesTheFluidItself)
{
  // a controller: the acceleration falls as the flux nears its goal
  script(box({4, 3, 5}) + fluid("accel v_a 0 0") + "\nvariable a equal 0.1*(1e-3-f_w[9])" +
         run(1000));
  EXPECT_NEAR(out(9), 1e-3 * (1.0 - std::exp(-0.1)), 2e-6);
}
