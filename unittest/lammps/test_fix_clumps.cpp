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

// Clumps: spheres that touch or overlap, held together by fix rigid, in creeping flow and in motion.

#include "fluid_scenes.h"

// a single body has fewer degrees of freedom than compute temp, of thermo, takes off
static const std::string COLD = "\nthermo_style custom step";

class Clumps : public FluidTest {
 protected:
  // a body without motion: nothing integrates it
  struct Ball {
    Triple c;
    double r;
  };
  struct Flow {
    Triple u, F;
  };

  // Flow past a fixed body in a periodic box of side^3 cells: superficial velocity times 6 pi mu
  // cell, and force on the body, whose ratio is its mobility. Flow along x begins near the steady one, with the
  // expected mobility, lest it take the ten thousand steps in which the body stops a whole box.
  Flow flow(int side, const std::vector<Ball> &balls, double expected)
  {
    start();
    const double tau = 2.0, dt = (tau - 0.5) * DX * DX / (3.0 * NU), g = 1e-3;
    const double unit = 6.0 * PI_ * RHO * NU * DX, whole = g * std::pow(side * DX, 3);
    std::string scene = box({side, side, side});
    for (std::size_t i = 0; i < balls.size(); i++) scene += grain(i + 1, balls[i].c, balls[i].r);
    script(scene + "\ntimestep " + num(dt) + "\nvariable a equal " +
           num(expected * whole / unit / dt) + "*(step==1)" +
           fluid("check 1000 accel v_a 0 0 gradp " + num(-g) + " 0 0") + frozen() + run(800));
    Triple sum{};
    for (std::size_t i = 0; i < balls.size(); i++)
      for (int d = 0; d < 3; d++) sum[d] += force(i + 1)[d];
    EXPECT_NEAR(sum[0], whole, 0.05 * whole);    // not far from steady
    EXPECT_LT(out(9) * balls[0].r * DX / NU, 0.02);
    return {{out(9) * unit, out(10) * unit, out(11) * unit}, sum};
  }
  double mobility(int side, const std::vector<Ball> &balls, double expected)
  {
    const Flow now = flow(side, balls, expected);
    return now.u[0] / now.F[0];
  }
  // spheres of radius r that touch in the middle of the box, one behind the other along `axis`
  static std::vector<Ball> doublet(double middle, double r, const Triple &axis)
  {
    Triple lo, hi;
    for (int d = 0; d < 3; d++) {
      lo[d] = middle - r * axis[d];
      hi[d] = middle + r * axis[d];
    }
    return {{lo, r}, {hi, r}};
  }

  // what fix rigid b has summed: force (0-2) and torque (3-5) on its first body, its centre (6-8)
  std::array<double, 9> body(const std::string &small = "")
  {
    std::array<double, 9> all{};
    if (small.empty()) {
      auto *b = lmp->modify->get_fix_by_id("b");
      for (int k = 0; k < 6; k++) all[k] = b->compute_array(0, 6 + k);
      for (int k = 0; k < 3; k++) all[6 + k] = b->compute_array(0, k);
    }
    return all;
  }
};

/* ---- a doublet in creeping flow ---- */

// Two touching spheres that move as one: drag of each, by that of a single one, .645 along their axis
// and .7243 across it (Happel & Brenner, Low Reynolds Number Hydrodynamics, 1983, section 6-4;
// Goldman, Cox & Brenner, Chem. Eng. Sci. 21, 1151 (1966)).
// In a periodic box of edge L the mobility of any body falls by 2.8373/(6 pi mu L) (Hasimoto, J. Fluid
// Mech. 5, 317 (1959)): the same for one sphere and two, so that the difference of their mobilities in
// one box is that in free space, but for terms of order a^2/L^3. With half of the force at each
// centre these are the mean of 0 and the value at 2 a n of the regular part of the periodic Stokeslet,
//   (A r^2 + B (r.F)r + D (x^2, y^2, z^2)) / (mu L^3),  4 A - 2 B = 2/3, 2 A + 4 B + 2 D = 0,
// the equations of motion and of continuity; D = 12 b with b = 175/(48 56 pi) sum h(R)/R^3 over the
// lattice, h = (X^4 + Y^4 + Z^4)/R^4 - 3/5, the harmonic of degree 4 of -r/(8 pi) summed over images.
// The sum is 1.9, so that A = .04, B = -.26, D = .47.
// 1.5 % are left for the lattice, where 12 % are between along and across, and 35 % to spheres
// that do not see each other.
TEST_F(Clumps, DragOfADoublet)
{
  const double a = 4.2, middle = 21.0;
  const int side = 42;
  const double hasimoto = (1.0 - 2.8373 * a / side + 4.19 * std::pow(a / side, 3)) / a;
  const double single = mobility(side, {{{middle, middle, middle}, a}}, hasimoto);
  EXPECT_NEAR(single, hasimoto, 0.02 / a);
  // expected of two whose drag is `factor` each
  auto two = [&](double factor) {
    return hasimoto + (0.5 / factor - 1.0) / a;
  };
  const double along = mobility(side, doublet(middle, a, {1, 0, 0}), two(0.645));
  const double across = mobility(side, doublet(middle, a, {0, 1, 0}), two(0.724));
  // drag of each sphere, in units of 6 pi mu a, free space
  const double A = 0.04, B = -0.26, D = 0.47, images = 6.0 * PI_ * std::pow(a / side, 3);
  const double factor_along = 0.5 / (a * (along - single) - images * 2 * (A + B + D) + 1.0);
  const double factor_across = 0.5 / (a * (across - single) - images * 2 * A + 1.0);
  EXPECT_NEAR(factor_along, 0.6451, 0.015 * 0.6451);
  EXPECT_NEAR(factor_across, 0.7243, 0.015 * 0.7243);
  ::testing::Test::RecordProperty("along", std::to_string(factor_along));
  ::testing::Test::RecordProperty("across", std::to_string(factor_across));
  // aslant, in a plane of the box, it drifts sideways: mobility is a tensor with the axis as a
  // principal one, and that of the images has no D off its diagonal
  const double s = std::sqrt(0.5), mean = 0.5 * (along + across);
  const double off = 0.5 * (along - across) - images * D / a;
  const Flow aslant = flow(side, doublet(middle, a, {s, s, 0}), two(0.68));
  EXPECT_NEAR(aslant.u[0], mean * aslant.F[0] + off * aslant.F[1], 0.01 * aslant.u[0]);
  EXPECT_NEAR(aslant.u[1], off * aslant.F[0] + mean * aslant.F[1], 0.1 * off * aslant.F[0]);
  EXPECT_NEAR(aslant.u[2], 0.0, 1e-3 * aslant.u[0]);
}

// Two touching spheres that turn about their common axis: torque of each 3/4 zeta(3) of that of a
// single one (Majumdar, Mathematika 14, 43 (1967)). No net force: what the images add is of the order of
// the solid fraction, .8 %, and is the same for one and two up to their number.
TEST_F(Clumps, TorqueOfADoubletAboutItsAxis)
{
  const double a = 4.2, spin = 1.0, middle = 18.0;
  auto torque = [&](const std::vector<Ball> &balls) {
    start();
    std::string scene = box({36, 36, 36});
    for (std::size_t i = 0; i < balls.size(); i++) scene += grain(i + 1, balls[i].c, balls[i].r);
    script(scene + "\ntimestep " + num(DX * DX / (3.0 * NU)) + fluid("check 1000") +
           "\nset group all omega " + num(spin) + " 0 0\nfix m all move linear 0 0 0" + run(700));
    return -load(1)[3] / (8.0 * PI_ * RHO * NU * std::pow(a * DX, 3) * spin);
  };
  const double single = torque({{{middle, middle, middle}, a}});
  EXPECT_NEAR(single, 1.0, 0.03);
  EXPECT_NEAR(torque(doublet(middle, a, {1, 0, 0})) / single, 0.75 * 1.2020569, 0.02);
}

/* ---- spheres that overlap ---- */

// three overlapping spheres in an oblique flow: whatever their order, and whoever owns a link
TEST_F(Clumps, SumDoesNotDependOnTheOrderOfSpheres)
{
  const std::vector<Ball> balls = {
      {{6.3, 6.1, 5.9}, 3.2}, {{9.2, 7.3, 6.4}, 2.6}, {{7.4, 8.6, 7.7}, 2.9}};
  std::array<double, 6> sums[3];
  const int order[3][3] = {{0, 1, 2}, {2, 0, 1}, {1, 0, 2}};
  for (int k = 0; k < 3; k++) {
    start();
    std::string scene = box({16, 15, 14});
    for (int i = 0; i < 3; i++) scene += grain(i + 1, balls[order[k][i]].c, balls[order[k][i]].r);
    script(scene + fluid("accel 2e-3 1e-3 -1e-3") + frozen() + run(150));
    sums[k] = {};
    for (int i = 1; i <= 3; i++) {
      const double *F = load(i), *X = x(i);
      for (int d = 0; d < 3; d++) sums[k][d] += F[d];
      for (int d = 0; d < 3; d++) {
        const int p = (d + 1) % 3, q = (d + 2) % 3;
        sums[k][3 + d] += F[3 + d] + X[p] * F[q] - X[q] * F[p];
      }
    }
    EXPECT_EQ(out(13), cut_links());    // each link once
  }
  for (int k = 1; k < 3; k++)
    for (int j = 0; j < 6; j++)
      EXPECT_NEAR(sums[k][j], sums[0][j], 1e-11 * std::fabs(sums[0][0]) * (j < 3 ? 1.0 : 10 * DX));
}

// one in place of the other: nothing is counted twice, buoyancy and pressure gradient included
TEST_F(Clumps, TwoSpheresAtOnePlaceAreOne)
{
  std::array<double, 6> sums[2];
  Triple total[2];
  for (const int count : {1, 2}) {
    start();
    std::string scene = box({14, 13, 12});
    for (int i = 1; i <= count; i++) scene += grain(i, {6.3, 6.1, 5.9}, 3.2);
    script(scene + fluid("accel 2e-3 1e-3 -1e-3 gradp 1 2 3 buoyancy 0 0 -9.81") +
           (count == 2 ? COLD + "\nfix b all rigid single force 1 off off off torque 1 off off off"
                       : "") +
           run(2));
    sums[count - 1] = {};
    total[count - 1] = {};
    for (int i = 1; i <= count; i++) {
      for (int j = 0; j < 6; j++) sums[count - 1][j] += load(i)[j];
      for (int d = 0; d < 3; d++) total[count - 1][d] += f(i)[d];
    }
  }
  for (int j = 0; j < 6; j++)
    EXPECT_NEAR(sums[1][j], sums[0][j], 1e-13 * std::fabs(sums[0][0]) * (j < 3 ? 1.0 : 10 * DX));
  for (int d = 0; d < 3; d++)
    EXPECT_NEAR(total[1][d], total[0][d], 1e-13 * std::fabs(total[0][2])) << d;
}

// a sphere that changes between two parts of a run, the number of atoms being the same: buoyancy is
// that of the union then
TEST_F(Clumps, VolumeFollowsRadii)
{
  const double outer = 3.2, inner = 2.2, g = 9.81;
  script(box({14, 13, 12}) + grain(1, {6.3, 6.1, 5.9}, outer) + grain(2, {6.3, 6.1, 5.9}, outer) +
         fluid("every 4 buoyancy 0 0 " + num(-g)) + COLD +
         "\nfix b all rigid single force 1 off off off torque 1 off off off" + run(2));
  // not by command set, which LAMMPS 4 Jul 2026 does not survive beside fix rigid
  lmp->atom->radius[lmp->atom->map(1)] = inner * DX;
  script("run 4 pre no post no");
  double lift = 0.0;    // the loads are those of step 4, as are the forces in f
  for (int i = 1; i <= 2; i++) lift += f(i)[2] - load(i)[2];
  EXPECT_NEAR(lift, RHO * g * grain_volume(outer), 1e-9 * lift);
}

// as bodies in motion: a sphere made of two half as heavy falls, drifts and turns as one
TEST_F(Clumps, TwoSpheresAtOnePlaceMoveAsOne)
{
  const std::string scene = "face ylo wall face yhi wall 4e-3 0 0 buoyancy 0 0 -0.5 every 4";
  std::array<double, 9> end[2];
  for (const bool doubled : {false, true}) {
    start();
    script(box({16, 14, 16}, "p f p") + grain(1, {6.3, 6.1, 9.9}, 3.3) +
           (doubled ? grain(2, {6.3, 6.1, 9.9}, 3.3) + "\nset group all density 1300" : "") +
           "\ntimestep " + num(DT / 4) + "\nfix g all gravity 0.5 vector 0 0 -1" + fluid(scene) +
           (doubled ? COLD + "\nfix b all rigid single" : "\nfix free all nve/sphere") + run(400));
    for (int d = 0; d < 3; d++) {
      end[doubled][d] = x(1)[d] - Triple{6.3e-4, 6.1e-4, 9.9e-4}[d];
      end[doubled][3 + d] = v(1)[d];
      end[doubled][6 + d] = omega(1)[d];
    }
  }
  EXPECT_GT(std::fabs(end[0][2]), 0.2 * DX);
  EXPECT_GT(std::fabs(end[0][8]), 0.5);
  for (int k = 0; k < 9; k++)
    EXPECT_NEAR(end[1][k], end[0][k], 1e-7 * std::fabs(end[0][k < 3 ? 2 : k < 6 ? 5 : 8])) << k;
}

/* ---- what fix rigid sees ---- */

// force and torque about the body's centre are the sums of those of its spheres: the force of the
// fluid step before is the one it moved with
TEST_F(Clumps, FixRigidSumsTheForceOfTheFluid)
{
  script(box({18, 16, 16}) + grain(1, {6.3, 6.1, 5.9}, 3.2) + grain(2, {9.9, 8.3, 6.4}, 2.6) +
         fluid("accel 2e-3 1e-3 -1e-3") + COLD + "\nfix b all rigid single" + run(30));
  for (int k = 0; k < 3; k++) {
    std::vector<std::array<double, 6>> before(3);
    for (int i = 1; i <= 2; i++) std::copy_n(load(i), 6, before[i].begin());
    script(run(1));
    const auto b = body();
    Triple F{}, T{};
    for (int i = 1; i <= 2; i++)
      for (int d = 0; d < 3; d++) {
        const int p = (d + 1) % 3, q = (d + 2) % 3;
        F[d] += before[i][d];
        T[d] += before[i][3 + d] + (x(i)[p] - b[6 + p]) * before[i][q] -
            (x(i)[q] - b[6 + q]) * before[i][p];
      }
    for (int d = 0; d < 3; d++) {
      EXPECT_NE(F[d], 0.0);
      EXPECT_NEAR(b[d], F[d], 1e-12 * std::fabs(F[0]));
      EXPECT_NEAR(b[3 + d], T[d], 1e-12 * std::fabs(F[0]) * 10 * DX);
    }
  }
}

// fix rigid/small goes the same way
TEST_F(Clumps, RigidAndRigidSmallAgree)
{
  std::array<double, 12> end[2];
  for (const std::string style : {"rigid molecule", "rigid/small molecule"}) {
    start();
    std::string scene = box({18, 16, 16});
    scene += "\nfix mol all property/atom mol ghost yes";
    script(scene + grain(1, {6.3, 6.1, 5.9}, 3.2) + grain(2, {9.9, 8.3, 6.4}, 2.6) +
           "\nset group all mol 1" + fluid("accel 2e-3 1e-3 -1e-3") + COLD + "\nfix b all " +
           style + run(150));
    auto &all = end[style != "rigid molecule"];
    for (int d = 0; d < 3; d++) {
      all[d] = x(1)[d] - Triple{6.3e-4, 6.1e-4, 5.9e-4}[d];
      all[3 + d] = v(1)[d];
      all[6 + d] = v(2)[d];
      all[9 + d] = omega(1)[d];
    }
  }
  EXPECT_NE(end[0][0], 0.0);
  for (int k = 0; k < 12; k++) EXPECT_NEAR(end[1][k], end[0][k], 1e-9 * std::fabs(end[0][k])) << k;
}

// a heavy doublet at rest in fluid at rest stays there
TEST_F(Clumps, OverlappingBodyInFluidAtRestFeelsNothing)
{
  script(box({18, 16, 16}) + grain(1, {6.3, 6.1, 5.9}, 3.2) + grain(2, {9.9, 8.3, 6.4}, 2.6) +
         fluid() + COLD + "\nfix b all rigid single" + run(20));
  for (int i = 1; i <= 2; i++)
    for (int k = 0; k < 6; k++) EXPECT_EQ(load(i)[k], 0.0);
  EXPECT_EQ(out(3), 0.0);
}

TEST_F(Clumps, FixRigidBeforeTheFluidIsWarnedOf)
{
  const std::string scene = box({18, 16, 16}) + grain(1, {6.3, 6.1, 5.9}, 3.2) +
      grain(2, {9.9, 8.3, 6.4}, 2.6),
                    rigid = COLD + "\nfix b all rigid single";
  const std::string warning = "Fix b (rigid) is defined before fix lb/ibb and does not see its "
                              "forces at the start of a run";
  EXPECT_NOT_IN(log_of(scene + fluid() + rigid + run(1)), warning);
  start();
  EXPECT_IN(log_of(scene + rigid + fluid() + run(1)), warning);
}
