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

// Two dimensions through the whole fix: masses and inertia of discs, faces, links, refill, forces per
// unit of depth.

#include "fluid_scenes.h"

class Discs : public FluidTest {
 protected:
  static constexpr double R = 3.6;
  // a disc in a box of 12 cells, and these lines before the run
  std::string with(const std::string &lines, const std::string &options = "")
  {
    start();
    return box({12, 12, 1}) + disc(1, {6.2, 6.1, 0}, R) + fluid(options) + "\n" + lines + run(1);
  }
};

/* ---- inertia ---- */

TEST_F(Discs, InertiaOfSpheresIsRefused)
{
  EXPECT_ERROR(with("fix m all nve/sphere"),
               "fix m (nve/sphere) turns grain 1 with the inertia of a sphere, 0.4 m r^2, in 2d it "
               "must be that of a disc, 0.5 m r^2: add keyword disc to fix m");
  EXPECT_ERROR(with("fix m all nvt/sphere temp 1 1 1"), "add keyword disc to fix m");
  EXPECT_ERROR(with("group wet id 1\nfix m wet nve/sphere update dipole"), "dipole");
  EXPECT_EQ(error_of(with("fix m all nve/sphere disc")), "");
  EXPECT_EQ(error_of(with("fix m all nvt/sphere temp 1 1 1 disc")), "");
  // between two runs
  script("unfix m");
  EXPECT_ERROR("fix m all nve/sphere" + run(1), "add keyword disc to fix m");
  // as it should be in three dimensions
  start();
  EXPECT_EQ(error_of(box({12, 12, 12}) + grain(1, {6, 6, 6}, R) + fluid() +
                     "\nfix m all nve/sphere" + run(1)),
            "");
}

TEST_F(Discs, InertiaOfOtherGrainsIsTheirOwnMatter)
{
  // outside the group of the fluid
  start();
  EXPECT_EQ(error_of(box({24, 12, 1}) + disc(1, {6.2, 6.1, 0}, R) + disc(2, {18, 6, 0}, R) +
                     "\ngroup dry id 2\ngroup wet id 1\nfix w wet lb/ibb dx 1e-4 nu 1e-6 rho 1000"
                     "\nfix m dry nve/sphere" +
                     run(1)),
            "");
  EXPECT_ERROR("fix both all nve/sphere" + run(1), "fix both (nve/sphere) turns grain 1");
  // not integrated at all, frozen, moved
  EXPECT_EQ(error_of(with("")), "");
  EXPECT_EQ(error_of(with("fix m all nve/sphere\nfix ice all freeze")), "");
  EXPECT_EQ(error_of(with("fix m all move linear 1e-3 0 0")), "");
}

// no grain is there when the run starts
TEST_F(Discs, GrainsThatCome)
{
  const std::string scene = box({16, 24, 1}, "p f p") +
      "\nregion slab block 0 1.6e-3 0.8e-3 2.2e-3 -0.5e-4 0.5e-4"
      "\nfix g all gravity 0.1 vector 0 -1 0\nfix m all nve/sphere DISC"
      "\nfix rain all pour 2 1 4711 region slab diam one 7.2e-4 dens 2600 2600" +
      fluid("face ylo wall face yhi wall check 10");
  auto edited = [&](const std::string &word) {
    start();
    std::string text = scene;
    return text.replace(text.find("DISC"), 4, word);
  };
  EXPECT_ERROR(edited("") + run(100), "turns grain 1 with the inertia of a sphere");
  // fix pour gives discs the mass of spheres, 4/3 r times what it should be
  EXPECT_IN(log_of(edited("disc") + run(2)), "WARNING: Fix lb/ibb: grain 1 has the density 1.248");
  std::string text = edited("disc");
  text.replace(text.find("dens 2600 2600"), 14, "dens 5.41667e6 5.41667e6");
  EXPECT_NOT_IN(log_of(text + run(20)), "Fix lb/ibb: grain");
}

/* ---- mass ---- */

TEST_F(Discs, ImplausibleDensityIsWarnedOf)
{
  const std::string warning = "by m/(pi r^2) at step";
  const std::string free = "fix m all nve/sphere disc";
  EXPECT_NOT_IN(log_of(with(free)), "WARNING: Fix lb/ibb: grain");
  // a sphere of sand: 4/3 r of its density
  EXPECT_IN(log_of(with("set atom 1 density 2600\n" + free)),
            "WARNING: Fix lb/ibb: grain 1 has the density 1.248 by m/(pi r^2) at step 0, 0.001248 "
            "times that of the fluid, limits 0.2 and 100: masses in 2d are those of discs per unit "
            "of depth, pi r^2 times the density: use set group all density/disc");
  EXPECT_IN(log_of(with("set atom 1 density/disc 199\n" + free)), warning);
  EXPECT_NOT_IN(log_of(with("set atom 1 density/disc 201\n" + free)), warning);
  EXPECT_NOT_IN(log_of(with("set atom 1 density/disc 9.9e4\n" + free)), warning);
  EXPECT_IN(log_of(with("set atom 1 density/disc 1.01e5\n" + free)), warning);
  // for any fix that integrates, but not where the mass does not matter
  const std::string light = "set atom 1 density 2600\n";
  EXPECT_IN(log_of(with(light + "fix m all nve")), warning);
  EXPECT_NOT_IN(log_of(with(light)), warning);
  EXPECT_NOT_IN(log_of(with(light + "fix m all move linear 1e-3 0 0")), warning);
  EXPECT_NOT_IN(log_of(with(light + "fix m all nve/sphere disc\nfix ice all freeze")), warning);
}

// near a radius of 1 the density of a sphere looks like that of a disc, but not for two radii
TEST_F(Discs, MassesOfSpheresOfUnitRadius)
{
  auto scene = [&](const std::string &density, double second) {
    start();
    return "units lj\natom_style sphere\ndimension 2\nregion b block 0 20 0 10 -0.5 0.5"
           "\ncreate_box 1 b\ncreate_atoms 1 single 5 5 0\ncreate_atoms 1 single 15 5 0"
           "\nset atom 1 diameter 2\nset atom 2 diameter " +
        num(second) + "\nset group all " + density +
        " 2.5\ntimestep 0.01\nfix m all nve/sphere disc"
        "\nfix w all lb/ibb dx 0.2 nu 0.5 rho 1" +
        run(1);
  };
  EXPECT_IN(
      log_of(scene("density", 1.8)),
      "WARNING: Fix lb/ibb: the masses of the grains are those of spheres of density 2.5, for "
      "all radii from 0.9 to 1: masses in 2d");
  EXPECT_NOT_IN(log_of(scene("density/disc", 1.8)), "WARNING: Fix lb/ibb: the masses");
  EXPECT_NOT_IN(log_of(scene("density", 2.0)), "WARNING: Fix lb/ibb: the masses");
}

/* ---- forces per unit of depth ---- */

// what the fluid gains is what drives it less what the disc takes, at every step
TEST_F(Discs, MomentumBalance)
{
  const Triple a{2.0e-3, -1.0e-3, 0.0};
  for (const std::string options : {"", "link bouzidi", "collision bgk link halfway"}) {
    start();
    script(box({13, 12, 1}) + disc(1, {5.3, 6.1, 0}, R) +
           fluid("average no accel " + nums(a) + " " + options) + frozen() + run(20));
    for (int step = 0; step < 3; step++) {
      const Triple before = momentum();
      script(run(1));
      const Triple after = momentum();
      const double volume = out(12) * cell_volume();
      for (int d = 0; d < 2; d++)
        EXPECT_NEAR((after[d] - before[d]) / DT + force(1)[d], RHO * a[d] * volume,
                    1e-10 * RHO * 2.0e-3 * volume)
            << options;
      EXPECT_EQ(force(1)[2], 0.0);
      EXPECT_EQ(load(1)[3], 0.0);
      EXPECT_EQ(load(1)[4], 0.0);
    }
  }
}

// F / (mu U) = 4 pi / (-1/2 ln c - 0.738 + c - 0.887 c^2 + 2.038 c^3): Sangani & Acrivos, Int. J.
// Multiphase Flow 8, 193 (1982)
TEST_F(Discs, SquareArrayOfDiscs)
{
  const double L = 30, c = 0.1, r = L * std::sqrt(c / PI_), g = -0.01;
  const double exact =
      4.0 * PI_ / (-0.5 * std::log(c) - 0.738 + c - 0.887 * c * c + 2.038 * c * c * c);
  double mean = 0.0;
  const Triple places[] = {{15.0, 15.0, 0}, {15.5, 15.2, 0}, {15.3, 15.4, 0}};
  for (const Triple &place : places) {
    start();
    script(box({30, 30, 1}) + disc(1, place, r) + fluid("gradp 0 " + num(g) + " 0") + frozen() +
           run(4000));
    const double whole = -g * (out(12) * cell_volume() + grain_volume(r));
    EXPECT_NEAR(force(1)[1], whole, 1e-3 * whole);    // cli does not keep the mass exactly
    mean += -g * L * L * DX * DX / (RHO * NU * out(10)) / 3.0;
  }
  EXPECT_NEAR(mean, exact, 0.02 * exact);
}

// 4 pi mu r^2 w, times 1/(1 - (r/a)^2) within a ring of radius a; a square box is one of 1.08 half sides
TEST_F(Discs, TorqueOfASpinningDisc)
{
  const double r = 6.3, w = 1.0, a = 1.08 * 30;
  script(box({60, 60, 1}, "f f p") + disc(1, {30, 30, 0}, r) + "\nset atom 1 omega 0 0 " + num(w) +
         fluid("face xlo wall face xhi wall face ylo wall face yhi wall") +
         "\nfix m all move linear 0 0 0" + run(8000));
  const double T = 4.0 * PI_ * RHO * NU * r * DX * r * DX * w / (1.0 - r * r / a / a);
  EXPECT_NEAR(load(1)[5], -T, 0.02 * T);
  EXPECT_NEAR(force(1)[0], 0.0, 1e-8 * T / DX);
}

/* ---- moving discs ---- */

// the drag does not change if disc and fluid drift together; both refill rules, all links
TEST_F(Discs, DragIsThatOfTheRelativeVelocity)
{
  const double U = 2e-3;
  for (const std::string rules : {"", "refill equilibrium link bouzidi", "link halfway"}) {
    auto mean_drag = [&](double drift) {
      start();
      const int first = 300, steps = 200;
      script(box({30, 24, 1}) + disc(1, {5.3, 12.1, 0}, 4.2) + "\nvariable a equal " +
             num(drift / DT) + "*(step==1)\nfix m all move linear " + num(U + drift) + " 0 0" +
             fluid("accel v_a 0 0 " + rules) + run(first) + "\nfix mean all ave/time 1 " +
             std::to_string(steps) + " " + std::to_string(first + steps) + " f_w[6]" + run(steps));
      return lmp->modify->get_fix_by_id("mean")->compute_scalar();
    };
    const double still = mean_drag(0.0);
    EXPECT_LT(still, 0.0);
    EXPECT_NEAR(mean_drag(3e-3), still, 0.03 * std::fabs(still)) << rules;
    EXPECT_NEAR(mean_drag(-4e-3), still, 0.03 * std::fabs(still)) << rules;
  }
}

TEST_F(Discs, TranslationAcrossPeriodicFaces)
{
  Triple F{};
  double T = 0.0;
  for (const Cells shift : {Cells{0, 0, 0}, Cells{6, 0, 0}, Cells{5, 6, 0}}) {
    start();
    script(box({12, 11, 1}) + disc(1, {fmod(6.3 + shift[0], 12), fmod(5.1 + shift[1], 11), 0}, R) +
           fluid("accel 2e-3 -1e-3 0") + "\nfix m all nve/sphere disc" + run(60));
    if (shift == Cells{0, 0, 0}) {
      F = force(1);
      T = load(1)[5];
    }
    for (int d = 0; d < 2; d++) EXPECT_NEAR(force(1)[d], F[d], 1e-11 * std::fabs(F[0]));
    EXPECT_NEAR(load(1)[5], T, 1e-11 * std::fabs(F[0]) * DX);
  }
}

/* ---- faces, along x and along y alike ---- */

TEST_F(Discs, FacesAlongBothAxes)
{
  for (int d : {0, 1}) {
    const int w = 1 - d;
    auto cells = [&](int along, int across) {
      return d ? Cells{across, along, 1} : Cells{along, across, 1};
    };
    auto node = [&](int along, int across) {
      return d ? Cells{across, along, 0} : Cells{along, across, 0};
    };
    const std::string lo = d ? "ylo " : "xlo ", hi = d ? "yhi " : "xhi ";
    const std::string across = d ? "f p p" : "p f p", along = d ? "p f p" : "f p p";
    // pressures, in and out: a plug flow that speeds up by dp/(rho (L - dx)) per time
    start();
    script(box(cells(17, 4), along) +
           fluid("face " + lo + "pressure 2e-3 face " + hi + "pressure -2e-3") + run(0));
    EXPECT_EQ(out(12), 68);
    script(run(3000));
    EXPECT_NEAR(field("pressure", node(0, 2)), 2e-3, 1e-12);
    EXPECT_NEAR(field("pressure", node(16, 2)), -2e-3, 1e-12);
    EXPECT_NEAR(field("pressure", node(8, 2)), 0.0, 2e-4);
    // velocity in, pressure out
    start();
    script(box(cells(12, 4), along) +
           fluid("face " + lo + "velocity " + (d ? "0 v_u 0" : "v_u 0 0") + " face " + hi +
                 "pressure 0") +
           "\nvariable u equal 1e-3*(1-exp(-step/200))" + run(4000));
    for (int k = 0; k < 12; k++) EXPECT_NEAR(field("velocity", node(k, 1), d), 1e-3, 1e-6);
    // a moving wall: Couette flow along d
    start();
    const std::string U = d ? "0 2e-3 0" : "2e-3 0 0";
    script(box(cells(4, 8), across) +
           fluid("face " + std::string(d ? "xlo" : "ylo") + " wall face " + (d ? "xhi" : "yhi") +
                 " wall " + U) +
           run(2500));
    for (int j = 0; j < 8; j++) {
      EXPECT_NEAR(field("velocity", node(1, j), d), 2e-3 * (j + 0.5) / 8, 1e-12);
      EXPECT_NEAR(field("velocity", node(1, j), w), 0.0, 1e-12);
    }
    EXPECT_EQ(out(8), 0.0);
    EXPECT_EQ(out(11), 0.0);
  }
}
