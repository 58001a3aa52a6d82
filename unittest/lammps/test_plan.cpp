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

// lb/plan in a script: what it refuses, the variables it leaves, the fix that takes its numbers.

#include "fluid_scenes.h"

#include "input.h"
#include "variable.h"

#include <cstdlib>

class Plan : public FluidTest {
 protected:
  // water, a box of 20 x 20 x 30 cells of 0.1 mm
  std::string scene(const std::string &boundary = "p p p") { return box({20, 20, 30}, boundary); }
  static std::string plan(const std::string &words)
  {
    return "\nlb/plan nu 1e-6 rho 1000 measure no " + words;
  }
  std::string refusal(const std::string &words)
  {
    start();
    return error_of(scene() + plan(words));
  }
  double value(const std::string &name) { return thermo("v_" + name); }
};

TEST_F(Plan, RefusesWordsItCannotUse)
{
  const std::string good = "dx 1e-4 diameter 8e-4 8e-4 speed 1e-3 ";
  EXPECT_EQ(refusal(good), "");
  start();
  EXPECT_IN(error_of(scene() + "\nlb/plan nu 1e-6"), "missing");
  start();
  EXPECT_IN(error_of(scene() + "\nlb/plan rho 1000 nu 1e-6"), "expected 'nu', not 'rho'");
  start();
  EXPECT_IN(error_of(scene() + "\nlb/plan nu 0 rho 1000"), "nu = 0 must be a number larger than 0");
  EXPECT_IN(refusal(good + "spede 1"), "unknown keyword 'spede'; known are dx, error");
  EXPECT_IN(refusal(good + "dx 1e-4"), "'dx' is given twice");
  EXPECT_IN(refusal(good + "time"), "missing");
  EXPECT_IN(refusal(good + "time nan"), "instead of 'nan'");
  EXPECT_IN(refusal(good + "time -1"), "time = -1 must be a number larger than 0");
  EXPECT_IN(refusal(good + "error 0.02"), "dx and error are given");
  EXPECT_IN(refusal("diameter 8e-4 8e-4 speed 1e-3"), "give dx, or the error");
  EXPECT_IN(refusal("error 2 diameter 8e-4 8e-4 speed 1e-3"), "0.02 are 2 %");
  EXPECT_IN(refusal("dx 1e-4 diameter 8e-4 8e-4"), "give the largest speed");
  EXPECT_IN(refusal("dx 1e-4 speed 1e-3"), "no grains are known");
  EXPECT_IN(refusal("dx 1e-4 speed 1e-3 diameter 9e-4 8e-4"), "larger than the mean");
  EXPECT_IN(refusal(good + "bed 1.5 1e-3"), "must be below 1");
  EXPECT_IN(refusal(good + "contact 100 0.9 0.4"), "depends on the density of the grains");
  EXPECT_IN(refusal(good + "contact -100 0.9 0.4"), "k_n = -100 must be positive");
  EXPECT_IN(refusal(good + "contact 100 0.9"), "expected k_n e mu");
  EXPECT_IN(refusal(good + "quantity lift"), "'lift' is none of drag, ");
  EXPECT_IN(refusal(good + "group all"), "diameter and group are given");
  EXPECT_IN(refusal("dx 1e-4 speed 1e-3 group all"), "no grains in group all");
  EXPECT_IN(refusal("dx 1e-4 speed 1e-3 group sand"), "group sand does not exist");
  EXPECT_IN(refusal(good + "box 1 1 1"), "there is a box");
  EXPECT_IN(refusal(good + "prefix a-b"), "letters, digits and _ only");
  EXPECT_IN(refusal(good + "grains frozen"), "'frozen' is neither moving nor still");
  EXPECT_IN(refusal(good + "precision single"), "no use with measure no");
  start();
  EXPECT_IN(error_of("units real\natom_style sphere" + plan(good)), "hidden conversion factors");
}

TEST_F(Plan, RefusesTheImpossibleWithTheNearest)
{
  EXPECT_IN(
      refusal("dx 1.1e-4 diameter 8e-4 8e-4 speed 1e-3"),
      "does not divide all lengths of the box: nearest that do are 0.0001 and 0.0001111111111");
  EXPECT_IN(refusal("dx 1e-4 diameter 8e-4 8e-4 speed 10"), "or speed <= 0.173205");
  EXPECT_IN(refusal("dx 1e-4 diameter 8e-4 8e-4 speed 1e-3 pressure 1000"), "or a pressure <= 150");
  EXPECT_IN(refusal("dx 2e-4 diameter 6e-4 8e-4 speed 1e-3"),
            "the nearest possible is dx = 0.00015");
  EXPECT_EQ(refusal("dx 1e-4 diameter 8e-4 8e-4 speed 0.173"), "");
}

TEST_F(Plan, RefusesBoxesTheFluidCannotHave)
{
  const std::string words = plan("dx 1e-4 diameter 8e-4 8e-4 speed 1e-3");
  EXPECT_IN(error_of(scene("p p s") + words), "does not support shrink-wrapped boxes");
  start();
  EXPECT_IN(
      error_of("units si\natom_style sphere\nregion b prism 0 1 0 1 0 1 0.1 0 0\ncreate_box 1 b" +
               words),
      "does not support triclinic boxes");
}

// tau = 1.5: dt = dx^2/(3 nu). Grains of .8 mm, 2600: m = 6.970e-7 kg; k_n = 100, e = .9:
// t_c = pi sqrt(m/200) sqrt(1 + (ln e/pi)^2) = .18556 ms, a fiftieth 3.7113 us: n_d = 899
TEST_F(Plan, LeavesItsNumbersInVariables)
{
  script(scene() +
         plan("dx 1e-4 diameter 8e-4 8e-4 speed 1e-3 density 2600 contact 100 0.9 0.4 time 1"));
  EXPECT_NEAR(value("lb_tau"), 1.5, 1e-12);
  EXPECT_NEAR(value("lb_dt_fluid"), 1.0 / 300.0, 1e-12);
  EXPECT_EQ(value("lb_every"), 899.0);
  EXPECT_NEAR(value("lb_dt") * 899.0, 1.0 / 300.0, 1e-12);
  EXPECT_EQ(value("lb_nodes"), 12000.0);
  EXPECT_EQ(value("lb_steps"), 300.0 * 899.0);
  EXPECT_NEAR(value("lb_mach"), std::sqrt(3.0) * 1e-3 / 300.0 / 1e-4, 1e-9);
  EXPECT_EQ(value("lb_seconds"), 0.0);    // not measured
  // again, and what was known is known no more
  script(plan("dx 5e-5 diameter 8e-4 8e-4 speed 1e-3"));
  EXPECT_EQ(value("lb_dx"), 5e-5);
  EXPECT_EQ(value("lb_every"), 1.0);
  EXPECT_EQ(value("lb_steps"), 0.0);
  script(plan("dx 1e-4 diameter 8e-4 8e-4 speed 1e-3 prefix other"));
  EXPECT_EQ(value("other_dx"), 1e-4);
  EXPECT_EQ(value("lb_dx"), 5e-5);
  script("variable taken_dx equal 1");
  EXPECT_IN(error_of(plan("dx 1e-4 diameter 8e-4 8e-4 speed 1e-3 prefix taken")),
            "variable taken_dx is there and of another style");
}

// a wish without a box: none of what depends on it
TEST_F(Plan, NeedsNoBox)
{
  const std::string text =
      log_of("units si\natom_style sphere" + plan("error 0.02 diameter 8e-4 8e-4 speed 1e-3"));
  EXPECT_IN(text, "no box");
  EXPECT_GT(value("lb_dx"), 0.0);
  EXPECT_LE(value("lb_error"), 0.02 * (1 + 1e-6));
  EXPECT_EQ(value("lb_nodes"), 0.0);
  script(plan("error 0.02 diameter 8e-4 8e-4 speed 1e-3 box 2e-3 2e-3 3e-3"));
  EXPECT_GT(value("lb_nodes"), 0.0);
}

// the grains of a group, in bed and alone, give what their diameters give
TEST_F(Plan, LooksAtTheGrainsThatAreThere)
{
  const std::string three =
      scene() + grain(1, {5, 5, 5}, 4.0) + grain(2, {14, 5, 5}, 5.0) + grain(3, {5, 14, 8}, 4.5);
  const std::string rest = " dx 1e-4 speed 0.02 pressure 0.5 contact 1e3 0.9 0.4";
  script(three + plan("group all" + rest));
  const double every = value("lb_every"), mach = value("lb_mach"), error = value("lb_error");
  // from z = 0 to 1.25 mm
  const double fraction = 4.0 / 3.0 * PI_ * (64.0 + 125.0 + 91.125) / (20 * 20 * 12.5);
  start();
  script(scene() +
         plan("diameter 8e-4 9e-4 density 2600 bed " + num(fraction) + " 1.25e-3" + rest));
  EXPECT_EQ(value("lb_every"), every);
  EXPECT_NEAR(value("lb_mach"), mach, 1e-9 * mach);
  EXPECT_NEAR(value("lb_error"), error, 1e-9 * error);
}

// over a range of wishes: the fix accepts the numbers, and nobody warns
TEST_F(Plan, TheFixTakesItsNumbersWithoutAWarning)
{
  for (const std::string wish :
       {"error 0.05 speed 1e-3", "error 0.02 speed 0.02", "error 0.02 pressure 2 speed 0.01",
        "dx 1e-4 speed 0.1", "dx 1e-4 pressure 20 speed 1e-3", "error 0.04 speed 0.4"}) {
    SCOPED_TRACE(wish);
    start();
    const std::string text =
        log_of(scene() + grain(1, {5, 5, 5}, 4.0) + grain(2, {14, 5, 5}, 5.0) +
               "\npair_style gran/lsd/coulomb\npair_coeff * * 1e3 0.9 0.4" +
               plan("group all contact 1e3 0.9 0.4 " + wish) +
               "\ntimestep ${lb_dt}\nfix m all nve/sphere\n"
               "fix w all lb/ibb dx ${lb_dx} nu 1e-6 rho 1000 every ${lb_every}" +
               run(0));
    EXPECT_NOT_IN(text, "WARNING");
    EXPECT_NOT_IN(text, "ERROR");
    EXPECT_IN(text, "Fix lb/ibb: ");
    EXPECT_NEAR(out(1), value("lb_tau"), 1e-9);
    EXPECT_NEAR(out(2), value("lb_dt_fluid"), 1e-12);
  }
}

TEST_F(Plan, DiscsHaveNoTableOfErrors)
{
  const std::string flat = box({30, 30, 1});
  EXPECT_IN(error_of(flat + plan("error 0.02 diameter 1e-3 1e-3 speed 1e-3")),
            "the errors known are those of spheres: give dx instead");
  start();
  script(flat + plan("dx 1e-4 diameter 1e-3 1e-3 speed 1e-3 density 2600 contact 1e5 0.9 0.4"));
  EXPECT_EQ(value("lb_error"), 0.0);
  EXPECT_EQ(value("lb_nodes"), 900.0);
  EXPECT_GT(value("lb_every"), 1.0);
}

// time and memory: more nodes take more; a LAMMPS inside leaves this one as it was
TEST_F(Plan, MeasuresAndLeavesTheSceneAlone)
{
  auto forces = [&](const std::string &between) {
    start();
    script(scene() + grain(1, {5, 5, 5}, 4.0) + grain(2, {14, 5, 5}, 5.0) +
           "\npair_style gran/lsd/coulomb\npair_coeff * * 1e3 0.9 0.4" + between +
           "\ntimestep 1e-6\nfix m all nve/sphere" + fluid("every 200 accel 0.1 0 0") + run(2000));
    return state();
  };
  const auto alone = forces("");
  const auto with =
      forces("\nlb/plan nu 1e-6 rho 1000 dx 1e-4 group all speed 1e-3 time 1 contact 1e3 "
             "0.9 0.4");
  EXPECT_EQ(with, alone);
  const double seconds = value("lb_seconds"), memory = value("lb_memory");
  EXPECT_GT(seconds, 0.0);
  EXPECT_GT(memory * 1048576.0, 12000.0 * 19 * 8);
  EXPECT_LT(memory * 1048576.0, 2.0 * 12000.0 * 19 * 8);
  script("lb/plan nu 1e-6 rho 1000 dx 2.5e-5 group all speed 1e-3 time 1");
  // 64 times the nodes and more steps, without granular ones: 18 times, if the machine is not busy
  EXPECT_GT(value("lb_seconds"), 4.0 * seconds);
  EXPECT_GT(value("lb_memory"), 40.0 * memory);
}

// the line in the summary of the fix, and what is said without a table
TEST_F(Plan, TheFixSaysWhatErrorToExpect)
{
  const std::string one = scene() + grain(1, {5, 5, 5}, 4.0);
  EXPECT_IN(log_of(one + fluid() + run(0)), "errors to expect at 4 cells per radius");
  start();
  EXPECT_NOT_IN(log_of(one + fluid("collision bgk") + run(0)), "errors to expect");
  start();
  EXPECT_NOT_IN(log_of(scene() + fluid() + run(0)), "errors to expect");
  const char *folders = std::getenv("LAMMPS_POTENTIALS");
  const std::string kept = folders ? folders : "";
  setenv("LAMMPS_POTENTIALS", "nowhere", 1);
  start();
  EXPECT_IN(log_of(one + fluid() + run(0)),
            "errors to expect are not known: no file lbm-ibb.accuracy");
  start();
  EXPECT_IN(error_of(scene() + plan("error 0.02 diameter 8e-4 8e-4 speed 1e-3")),
            "no error of drag is known, no file lbm-ibb.accuracy");
  start();
  EXPECT_EQ(error_of(scene() + plan("dx 1e-4 diameter 8e-4 8e-4 speed 1e-3")), "");
  {
    std::ofstream bad("lbm-ibb.accuracy");
    bad << "drag three 0.1\n";
  }
  start();
  EXPECT_IN(error_of(scene() + plan("dx 1e-4 diameter 8e-4 8e-4 speed 1e-3")), "drag three 0.1");
  std::remove("lbm-ibb.accuracy");
  setenv("LAMMPS_POTENTIALS", kept.c_str(), 1);
}
