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

// Runs with fix lb/ibb: none, several, interrupted; grains that come and go; two dimensions.

#include "fluid_scenes.h"

using Runs = FluidTest;

/* ---- several runs ---- */

TEST_F(Runs, RunZeroLeavesTheFluidAlone)
{
  const std::string scene = box({12, 11, 10}) + grain(1, {5.3, 6.1, 4.9}, 3.6, {2e-3, 0, 1e-3}) +
      "\nfix m all nve/sphere" + fluid("accel 2e-3 0 0 gradp 0 1 0");
  script(scene + run(25));
  const auto before = state();
  const Triple F = force(1);
  const double Ma = out(3), weight = mass();
  script(run(0) + run(0));
  EXPECT_EQ(state(), before);
  EXPECT_EQ(force(1), F);
  EXPECT_EQ(out(3), Ma);
  EXPECT_EQ(mass(), weight);
  script(run(10));
  const auto with = state();
  start();
  script(scene + run(35));
  EXPECT_EQ(state(), with);
}

TEST_F(Runs, SplitRunsAreIdentical)
{
  const std::string scene = box({12, 11, 16}) + grain(1, {5.3, 6.1, 11.9}, 3.6, {1e-3, 0, 0}) +
      "\ntimestep " + num(DT / 4) + "\nvariable a equal 1e-3*sin(step/10)" +
      "\nfix m all nve/sphere\nfix g all gravity 0.05 vector 0 0 -1" +
      fluid("every 4 accel v_a 0 0 buoyancy 0 0 -0.05");
  script(scene + run(240));
  const auto whole = state();
  const std::vector<double> at{x(1)[0], x(1)[2], v(1)[0], v(1)[2], omega(1)[1]};
  for (const std::string parts : {run(120) + run(120), run(3) + run(58) + run(179)}) {
    start();
    script(scene + parts);
    EXPECT_EQ(state(), whole);
    EXPECT_EQ((std::vector<double>{x(1)[0], x(1)[2], v(1)[0], v(1)[2], omega(1)[1]}), at);
  }
}

TEST_F(Runs, DefinedAnewWithAnotherTimestep)
{
  script(box({4, 6, 4}, "p f p") + fluid("face ylo wall face yhi wall accel 0.01 0 0") + run(50));
  EXPECT_GT(out(9), 0.0);
  script("unfix w\ntimestep " + num(DT / 2) +
         fluid("face ylo wall face yhi wall accel 0.01 0 0 every 5") + run(0));
  EXPECT_NEAR(out(9), 0.0, 1e-18);
  EXPECT_NEAR(out(2), 2.5 * DT, 1e-17);
  script("timestep " + num(DT / 5) + run(100));    // before the first fluid step it may change
  EXPECT_NEAR(out(1), TAU, 1e-12);
  EXPECT_GT(out(9), 0.0);
  // all of it once more
  script("clear\n" + box({4, 6, 4}, "p f p") + fluid("face ylo wall face yhi wall accel 0.01 0 0") +
         run(50));
  EXPECT_EQ(out(12), 96.0);
}

// a virial has to be announced a step ahead, whatever step the run begins at
TEST_F(Runs, VariableThatNeedsAComputeAnnounced)
{
  script(box({12, 12, 12}) + grain(1, {4, 6, 6}, 2.6) + grain(2, {9.1, 6, 6}, 2.6) +
         "\npair_style gran/lsd/coulomb\npair_coeff * * 1e-2 0.8 0.4\ncompute p all pressure NULL "
         "pair" +
         "\nvariable a equal 1e-9*c_p\nthermo 1000\nfix m all nve/sphere\ntimestep " +
         num(DT / 40) + fluid("every 40 accel v_a 0 0 check 1000"));
  EXPECT_EQ(error_of(run(3) + run(50) + run(120)), "");
  EXPECT_NE(out(9), 0.0);
}

/* ---- scenes that lack things ---- */

TEST_F(Runs, NoAtomsOfAnyStyle)
{
  for (const std::string style : {"sphere", "atomic", "ellipsoid"}) {
    start();
    std::string scene = box({4, 5, 6});
    scene.replace(scene.find("sphere"), 6, style);
    script(scene + fluid("accel 1e-3 0 0 gradp 0 0 1 buoyancy 0 0 -9.81") +
           (style == "atomic" ? "\nmass * 1" : "") + run(10));
    EXPECT_EQ(out(12), 120.0);
    EXPECT_NEAR(out(9), 1e-3 * 10 * DT, 1e-15);
    EXPECT_NEAR(out(11), -1e-3 * 10 * DT, 1e-15);
  }
}

TEST_F(Runs, AtomsThatAreNoGrainsMayBeThere)
{
  std::string scene = box({6, 6, 6});
  scene.replace(scene.find("sphere"), 6, "atomic");
  script(scene + "\ncreate_atoms 1 single 3e-4 3e-4 3e-4\nmass * 1\ngroup none empty" +
         "\nfix w none lb/ibb dx 1e-4 nu 1e-6 rho 1000" + run(3));
  EXPECT_EQ(out(12), 216.0);
}

/* ---- grains that come and go ---- */

TEST_F(Runs, GrainsCreatedAndDeletedBetweenRuns)
{
  const Triple a{6.2, 6.1, 5.3}, b{17.4, 6.3, 5.9}, c{6.4, 6.6, 5.2};
  script(box({24, 12, 12}) + fluid("accel 1e-3 0 0 check 1") + run(10));
  EXPECT_EQ(out(12), all_nodes());
  EXPECT_EQ(out(13), 0.0);
  script(grain(1, a, 3.6) + frozen() + run(10));
  EXPECT_EQ(out(12), all_nodes() - covered(a, 3.6));
  EXPECT_EQ(out(13), cut_links());
  script(grain(2, b, 4.13) + run(10));
  EXPECT_EQ(out(12), all_nodes() - covered(a, 3.6) - covered(b, 4.13));
  EXPECT_GT(force(1)[0], 0.0);
  EXPECT_GT(force(2)[0], 0.0);
  script("group gone id 1\ndelete_atoms group gone compress no" + run(10));
  EXPECT_EQ(out(12), all_nodes() - covered(b, 4.13));
  EXPECT_NEAR(out(6), force(2)[0], 1e-14 * force(2)[0]);
  script("delete_atoms group all" + run(10));
  EXPECT_EQ(out(12), all_nodes());
  EXPECT_EQ(out(6), 0.0);
  script(grain(1, c, 3.6) + run(10));
  EXPECT_EQ(out(12), all_nodes() - covered(c, 3.6));
  EXPECT_LT(out(3), 0.1);
}

TEST_F(Runs, GrainsDepositedDuringARun)
{
  std::ofstream("grain.mol") << "one grain\n\n1 atoms\n\nCoords\n\n1 0 0 0\n\nTypes\n\n1 1\n\n"
                                "Diameters\n\n1 6e-4\n\nMasses\n\n1 3e-7\n";
  script(
      box({16, 16, 16}) + "\nmolecule ball grain.mol\nregion all block " +
      "0 1.6e-3 0 1.6e-3 0 1.6e-3\nfix drop all deposit 4 1 5 4711 region all mol ball near 7e-4 "
      "attempt 1000" +
      fluid("accel 1e-3 0 0 check 1") + frozen() + run(40));
  std::remove("grain.mol");
  EXPECT_EQ(lmp->atom->natoms, 4);
  int solid = 0;
  for (int id = 1; id <= 4; id++) {
    solid += covered({x(id)[0] / DX, x(id)[1] / DX, x(id)[2] / DX}, 3.0);
    EXPECT_GT(force(id)[0], 0.0);
  }
  EXPECT_EQ(out(12), all_nodes() - solid);
}

TEST_F(Runs, GrainsPouredDuringARun)
{
  script(box({16, 16, 24}, "p p f") + "\nregion slab block 0 1.6e-3 0 1.6e-3 0.8e-3 2.2e-3" +
         "\nfix g all gravity 0.1 vector 0 0 -1\nfix m all nve/sphere"
         "\nfix rain all pour 3 1 4711 region slab diam range 5e-4 6e-4 dens 2600 2600" +
         fluid("buoyancy 0 0 -0.1 check 1 face zlo wall face zhi pressure 0") + "\ntimestep " +
         num(DT / 4) + run(200));
  EXPECT_EQ(lmp->atom->natoms, 3);
  EXPECT_GT(out(8), 0.0);
  EXPECT_LT(out(12), all_nodes() - 100);
}

// a grain leaves through an open face as it would into nothing
TEST_F(Runs, GrainLeavesTheBox)
{
  script(box({12, 12, 14}, "p p f") + grain(1, {6.2, 6.1, 11.0}, 3.3) +
         "\nthermo_modify lost ignore\nfix m all move linear 0 0 0.003" +
         fluid("face zlo wall face zhi pressure 0 check 1") + run(200));
  EXPECT_EQ(lmp->atom->natoms, 0);
  EXPECT_EQ(out(12), all_nodes());
  EXPECT_EQ(out(8), 0.0);
}

/* ---- two dimensions: a disc, and everything per unit of depth ---- */

TEST_F(Runs, DiscInTwoDimensions)
{
  const double r = 4.3;
  const Triple a{2e-3, -1e-3, 0}, c{9.3, 7.1, 0};
  script(box({18, 16, 1}) + disc(1, c, r) +
         fluid("link halfway accel " + nums(a) + " gradp 0 0.5 0") + frozen() + run(3000));
  EXPECT_EQ(out(12), all_nodes() - covered(c, r));
  EXPECT_EQ(out(13), cut_links());
  const double volume = out(12) * DX * DX, whole = RHO * a[0] * volume;
  EXPECT_NEAR(force(1)[0], whole, 1e-10 * whole);
  EXPECT_NEAR(force(1)[1], RHO * a[1] * volume - 0.5 * (volume + grain_volume(r)), 1e-10 * whole);
  EXPECT_EQ(force(1)[2], 0.0);
  EXPECT_NEAR(mass(), RHO * volume, 1e-6 * RHO * volume);
  EXPECT_EQ(values("velocity", 2)[0], 0.0);
  EXPECT_EQ(out(11), 0.0);
}

TEST_F(Runs, DiscSettlesUnderItsOwnWeight)
{
  // the fluid bears the submerged weight in the end
  const double r = 4.3, g = 0.02;
  script(
      box({24, 60, 1}, "f f p") + disc(1, {12.1, 45.3, 0}, r) + "\ntimestep " + num(DT / 4) +
      "\nfix m all nve/sphere disc\nfix g all gravity 0.02 vector 0 -1 0" +
      fluid("every 4 buoyancy 0 -0.02 0 face xlo wall face xhi wall face ylo wall face yhi wall") +
      "\nfix flat all enforce2d" + run(3000));
  const double weight = (SOLID - RHO) * grain_volume(r) * g;
  script("fix mean all ave/time 4 200 3800 f_w[7]" + run(800));
  EXPECT_NEAR(lmp->modify->get_fix_by_id("mean")->compute_scalar(), weight, 0.03 * weight);
  EXPECT_LT(v(1)[1], 0.0);
}
