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

// Grains that come and go while the fluid runs: created, deposited, poured, deleted, evaporated, and
// the ways to hold or to drive one.

#include "fluid_scenes.h"

#include <algorithm>

class ComeAndGo : public FluidTest {
 protected:
  int grains() const { return lmp->atom->nlocal; }
  // nodes that the present grains cover, counted anew; grains must not overlap
  int covered_now() const
  {
    int sum = 0;
    for (int i = 0; i < grains(); i++) {
      const double *p = lmp->atom->x[i];
      sum += covered({p[0] / DX, p[1] / DX, p[2] / DX}, lmp->atom->radius[i] / DX);
    }
    return sum;
  }
  double fastest() const
  {
    double most = 0.0;
    for (int d = 0; d < 3; d++)
      for (const double u : values("velocity", d)) most = std::max(most, std::fabs(u));
    return most;
  }
  void expect_finite() const
  {
    for (const double value : state()) ASSERT_TRUE(std::isfinite(value));
  }
  // a template of one grain, radius in cells
  static std::string molecule(double r)
  {
    std::ofstream("one.mol") << "one grain\n\n1 atoms\n\nCoords\n\n1 0 0 0\n\nTypes\n\n1 1\n\n"
                             << "Diameters\n\n1 " << num(2.0 * r * DX) << "\n\nMasses\n\n1 "
                             << num(SOLID * 4.0 / 3.0 * PI_ * std::pow(r * DX, 3)) << "\n";
    return "\nmolecule one one.mol";
  }
  void TearDown() override { std::remove("one.mol"); }
};

// Raised slowly, between walls: what a sudden pressure sets in motion dies slowly, or not at all if it
// changes sign from node to node.
static const std::string PRESSED =
    "face xlo wall face xhi wall face zlo pressure v_p face zhi pressure v_p ";
static const std::string RAISED =
    "\nvariable p equal 0.075*(1-cos(PI*step/6000)*(step<6000)+(step>=6000))";

/* ---- in ---- */

TEST_F(ComeAndGo, CreatedInStillFluid)
{
  script(box({12, 11, 10}) + fluid("check 1") + frozen() + run(3));
  const double before = mass();
  EXPECT_NEAR(before, all_nodes() * cell_volume() * RHO, 1e-14 * before);
  const Triple c{6.3, 5.1, 4.9};
  script(grain(1, c, 3.57) + run(4));
  for (int k = 0; k < 6; k++) EXPECT_EQ(load(1)[k], 0.0);
  EXPECT_EQ(fastest(), 0.0);
  EXPECT_EQ(out(12), all_nodes() - covered(c, 3.57));
  EXPECT_EQ(out(13), cut_links());
  EXPECT_NEAR(before - mass(), covered(c, 3.57) * cell_volume() * RHO, 1e-12 * before);
}

// fluid at rest under pressure: 4.5 % denser than rho; the grain is at rest in it from its first
// step on, and the fluid that fills its place when it is gone is as dense as that around
TEST_F(ComeAndGo, CreatedAndDeletedUnderPressure)
{
  const double excess = 0.15 / (RHO * SOUND * SOUND);
  script(box({12, 11, 14}, "f p f") + RAISED + fluid(PRESSED) + frozen() + run(9000));
  ASSERT_NEAR(out(4), 1.0 + excess, 1e-10);
  ASSERT_LT(fastest(), 1e-9 * SOUND);
  const double mg = RHO * cell_volume(), scale = 0.15 * DX * DX;    // of a force
  const Triple c{6.3, 5.1, 6.9};
  script(grain(1, c, 3.57) + run(3));
  for (int k = 0; k < 3; k++) EXPECT_NEAR(load(1)[k], 0.0, 1e-7 * scale);
  EXPECT_NEAR(mass() / mg, (1.0 + excess) * (all_nodes() - covered(c, 3.57)), 1e-6);
  script("delete_atoms group all" + run(1));
  EXPECT_EQ(out(12), all_nodes());
  script(run(5));
  expect_finite();
  EXPECT_NEAR(out(4), 1.0 + excess, 1e-9);
  EXPECT_NEAR(out(5), 1.0 + excess, 1e-9);
  EXPECT_LT(fastest(), 1e-9 * SOUND);
}

// the cover follows grains that LAMMPS inserts in mid-run, and they feel nothing at rest
TEST_F(ComeAndGo, DepositedAtRest)
{
  script(box({24, 20, 20}) + molecule(2.63) +
         "\nregion all block 0 24e-4 0 20e-4 0 20e-4\ncomm_modify cutoff 1e-3" +
         "\nfix drop all deposit 5 1 3 4711 region all mol one near 6e-4" + fluid() + run(8));
  const int first = grains();
  script(run(12));
  EXPECT_GT(grains(), first);
  EXPECT_EQ(grains(), 5);
  EXPECT_EQ(out(12), all_nodes() - covered_now());
  EXPECT_NEAR(mass(), out(12) * cell_volume() * RHO, 1e-12 * mass());
  EXPECT_EQ(fastest(), 0.0);
  for (int i = 0; i < grains(); i++)
    for (int k = 0; k < 6; k++) EXPECT_EQ(fix()->array_atom[i][k], 0.0);
}

// poured grains slow down to the speed at which they sink
TEST_F(ComeAndGo, PouredGrainsSink)
{
  const double g = 0.01;
  script(box({20, 20, 30}, "p p f") + "\ntimestep " + num(DT / 4) +
         "\nregion top block 0 20e-4 0 20e-4 18e-4 28e-4" +
         "\nfix g all gravity 0.01 vector 0 0 -1\nfix free all nve/sphere" +
         "\nfix pour all pour 4 1 4711 region top diam one 6e-4 dens 2600 2600 vol 0.2 200" +
         "\npair_style gran/lsd/coulomb\npair_coeff * * 0.05 0.9 0.3" +
         fluid("every 4 buoyancy 0 0 -0.01 face zlo wall face zhi wall"));
  script(run(4));
  ASSERT_EQ(grains(), 4);
  EXPECT_EQ(out(12), all_nodes() - covered_now());
  double v0 = 0.0;
  for (int i = 0; i < grains(); i++) v0 += lmp->atom->v[i][2];
  script(run(4 * 500));
  expect_finite();
  EXPECT_EQ(out(12), all_nodes() - covered_now());
  double v1 = 0.0, drag = 0.0;
  for (int i = 0; i < grains(); i++) {
    v1 += lmp->atom->v[i][2];
    drag += fix()->array_atom[i][2];
  }
  EXPECT_GT(drag, 0.0);    // upwards
  // fix pour lets them in faster than they sink: more slowly than one alone would, Stokes
  const double stokes = 2.0 / 9.0 * (SOLID / RHO - 1.0) * g * 9.0 * DX * DX / NU;
  EXPECT_LT(v0, -4.0 * 2.0 * stokes);
  EXPECT_GT(v1, -4.0 * stokes);
  EXPECT_LT(v1, -4.0 * 0.2 * stokes);
  EXPECT_NEAR(mass(), out(12) * cell_volume() * RHO, 5e-3 * mass());
}

/* ---- out ---- */

// a grain that moved is deleted: the hole fills, what it gave the fluid dies away, no trace is left
TEST_F(ComeAndGo, DeletedInMotion)
{
  const std::string walls = "face ylo wall face yhi wall face zlo wall face zhi wall";
  script(box({20, 16, 16}, "p f f") + grain(1, {7.3, 8.1, 7.9}, 4.17) +
         "\nfix m all move linear 4e-3 0 0" + fluid(walls) + run(60));
  const Triple at_end{x(1)[0] / DX, x(1)[1] / DX, x(1)[2] / DX};
  const double before = mass(), hole = covered(at_end, 4.17) * cell_volume() * RHO;
  const double moving = momentum()[0] + hole * 4e-3;
  script("delete_atoms group all" + run(1));
  EXPECT_EQ(out(12), all_nodes());
  EXPECT_EQ(out(13), 0.0);
  EXPECT_EQ(out(6), 0.0);
  expect_finite();
  // the hole is filled at the density around it, and with the velocity of the grain
  EXPECT_NEAR(mass(), before + hole, 0.01 * hole);
  const double p0 = momentum()[0];
  EXPECT_NEAR(p0, moving, 0.05 * moving);
  const double m0 = mass();
  double fast = fastest();
  for (int k = 0; k < 4; k++) {
    script(run(200));
    expect_finite();
    EXPECT_NEAR(mass(), m0, 1e-11 * m0);    // walls keep it
    EXPECT_LT(fastest(), 0.5 * fast);
    fast = fastest();
  }
  EXPECT_LT(momentum()[0], 1e-2 * p0);
  EXPECT_GT(momentum()[0], 0.0);
}

// a grain created where another was has no past of that
TEST_F(ComeAndGo, NewGrainHasNoPast)
{
  const std::string options = "accel 2e-3 1e-3 0 average ";
  const std::string scene = box({14, 12, 12}) + grain(1, {4.3, 6.1, 5.9}, 2.74, {2e-3, 0, 0}) +
      "\nset atom 1 omega 0 0 3";
  Triple first[2];
  for (const bool average : {false, true}) {
    start();
    script(scene + fluid(options + (average ? "yes" : "no")) + "\nfix m all move linear 2e-3 0 0" +
           run(20));
    script("delete_atoms group all" + grain(1, {9.37, 6.11, 5.93}, 2.74) + run(1));
    first[average] = force(1);
    EXPECT_EQ(out(12), all_nodes() - covered_now());
  }
  // one step is all it has, with the mean of two as without
  for (int d = 0; d < 3; d++) EXPECT_EQ(first[0][d], first[1][d]);
  EXPECT_NE(first[0][0], 0.0);
}

TEST_F(ComeAndGo, Evaporated)
{
  std::string scene = box({24, 12, 12}, "f p p");
  const Triple centres[3] = {{5.1, 6.2, 6.3}, {12.4, 5.9, 6.1}, {18.7, 6.4, 5.8}};
  for (int i = 0; i < 3; i++) scene += grain(i + 1, centres[i], 2.73);
  script(scene + "\nregion right block 15e-4 24e-4 0 12e-4 0 12e-4" +
         fluid("accel 0 2e-3 0 face xlo wall face xhi wall") + frozen() +
         "\nfix dry all evaporate 20 1 right 4711" + run(15));
  ASSERT_EQ(grains(), 3);
  const double before = mass();
  script(run(15));
  ASSERT_EQ(grains(), 2);
  EXPECT_EQ(out(12), all_nodes() - covered_now());
  EXPECT_EQ(out(13), cut_links());
  EXPECT_NEAR(mass() - before, covered(centres[2], 2.73) * cell_volume() * RHO, 2e-5 * before);
  expect_finite();
  // in the end the fluid is held by the two that are left and the walls, as it is without a third
  script(run(1500));
  const Triple here = force(1);
  start();
  std::string twin = box({24, 12, 12}, "f p p") + grain(1, centres[0], 2.73) +
      grain(2, centres[1], 2.73) + fluid("accel 0 2e-3 0 face xlo wall face xhi wall") + frozen();
  script(twin + run(1530));
  for (int d = 0; d < 3; d++) EXPECT_NEAR(here[d], force(1)[d], 2e-3 * std::fabs(here[1]));
}

/* ---- held and driven ---- */

// held by fix freeze, by no integrator at all, by fix move, by fix setforce: one and the same
TEST_F(ComeAndGo, FourWaysToHoldAGrain)
{
  std::vector<Triple> F, T;
  for (const std::string hold :
       {"fix h all freeze", "", "fix h all move linear 0 0 0",
        "fix i all nve/sphere\nfix h all setforce 0 0 0\nfix r all freeze"}) {
    start();
    script(box({14, 12, 11}) + grain(1, {6.3, 5.6, 5.2}, 3.3) + grain(2, {11.1, 9.7, 8.2}, 2.4) +
           fluid("accel 2e-3 1e-3 0 buoyancy 0 0 -9.81 gradp 0 0 1 every 2") + "\n" + hold +
           "\ntimestep " + num(DT / 2) + run(200));
    F.push_back(force(1));
    T.push_back({load(1)[3], load(1)[4], load(1)[5]});
  }
  for (std::size_t k = 1; k < F.size(); k++)
    for (int d = 0; d < 3; d++) {
      EXPECT_NEAR(F[k][d], F[0][d], 1e-13 * std::fabs(F[0][0])) << k;
      EXPECT_NEAR(T[k][d], T[0][d], 1e-13 * std::fabs(F[0][0]) * DX) << k;
    }
}

// turned about its own centre by fix move rotate, or given the spin by hand
TEST_F(ComeAndGo, RotatedByFixMove)
{
  const double spin = 3.0, r = 4.3;
  double torque[2];
  for (const bool rotated : {false, true}) {
    start();
    script(box({14, 14, 14}) + grain(1, {7, 7, 7}, r) + fluid() + "\nset atom 1 omega 0 0 " +
           num(spin) +
           (rotated ? "\nfix m all move rotate 7e-4 7e-4 7e-4 0 0 1 " + num(2.0 * PI_ / spin)
                    : "\nfix m all move linear 0 0 0") +
           run(150));
    torque[rotated] = load(1)[5];
  }
  EXPECT_LT(torque[0], 0.0);
  EXPECT_NEAR(torque[1], torque[0], 1e-9 * std::fabs(torque[0]));
}

// a grain shaken by fix move wiggle about a place: as much momentum goes in as comes out
TEST_F(ComeAndGo, WiggledByFixMove)
{
  script(box({14, 12, 12}) + grain(1, {6.3, 6.1, 5.9}, 3.43) +
         "\nfix m all move wiggle 1e-4 0 0 0.1" + fluid("check 1"));
  // one period is 100 fluid steps; the second and third are alike
  std::vector<double> swing;
  for (int k = 0; k < 30; k++) {
    script(run(10));
    swing.push_back(force(1)[0]);
    EXPECT_EQ(out(12), all_nodes() - covered_now());
  }
  double most = 0.0;
  for (const double F : swing) most = std::max(most, std::fabs(F));
  for (int k = 10; k < 20; k++) EXPECT_NEAR(swing[k + 10], swing[k], 0.05 * most) << k;
  expect_finite();
}
