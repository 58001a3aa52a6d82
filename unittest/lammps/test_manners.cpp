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

// fix lb/ibb among LAMMPS's other commands: it is listed, asked, printed, looped over and controlled
// like any fix.

#include "fluid_scenes.h"

#include "update.h"

#include <algorithm>
#include <cstdlib>

class Manners : public FluidTest {
 protected:
  std::string scene()
  {
    return box({8, 7, 6}) + grain(1, {4.3, 3.1, 2.9}, 2.4) + fluid("accel 1e-3 0 0") + frozen();
  }
};

TEST_F(Manners, InfoListsTheStyles)
{
  EXPECT_IN(log_of("info out log styles fix"), "lb/ibb");
  EXPECT_IN(log_of("info out log styles compute"), "lb/ibb/profile");
  EXPECT_IN(log_of("info out log styles pair"), "gran/lsd/coulomb");
  EXPECT_IN(log_of("info out log styles fix"), "wall/gran/lsd/coulomb");
  EXPECT_IN(log_of(scene() + run(0) + "\ninfo out log fixes"), "style = lb/ibb");
}

TEST_F(Manners, FixModifyRefusesWhatDoesNotApply)
{
  script(scene());
  // what LAMMPS's own fixes without these options say
  EXPECT_IN(error_of("fix_modify w energy yes"), "does not support fix_modify energy");
  EXPECT_IN(error_of("fix_modify w virial yes"), "does not support fix_modify virial");
  EXPECT_IN(error_of("fix_modify w hue red"), "hue");
}

TEST_F(Manners, JumpLoopUntilTheFlowIsFastEnough)
{
  std::ofstream("in.loop") << scene() << R"(
variable u equal f_w[9]
thermo 5
variable try loop 50
label more
run 5 post no
if "$(v_u) > 8e-6" then "jump SELF enough"
next try
jump SELF more
label enough
print "reached $(v_u) in ${try} rounds"
)";
  const std::string log = log_of("include in.loop");
  std::remove("in.loop");
  EXPECT_IN(log, "reached ");
  EXPECT_GT(out(9), 8e-6);
  EXPECT_GT(lmp->update->ntimestep, 5);
  EXPECT_LT(lmp->update->ntimestep, 250);    // it was not the end of the loop that ended it
}

TEST_F(Manners, HaltAndEvery)
{
  // fix halt ends the run when the fluid is fast enough; run every lets commands look in between
  script(scene() + "\nvariable u equal f_w[9]\nfix enough all halt 5 v_u > 8e-6 error continue" +
         "\nrun 1000 post no\nunfix enough");
  EXPECT_GT(out(9), 8e-6);
  EXPECT_LT(lmp->update->ntimestep, 1000);
  const std::string log =
      log_of("variable n equal 0\nrun 20 every 5 \"print 'looks: $(f_w[9]:%.3e)'\" post no");
  EXPECT_IN(log, "looks: ");
}

// What grains bear, added up by compute reduce and averaged by fix ave/time: in steady flow that is
// the acceleration of all the water between them.
TEST_F(Manners, ReducedLoadsBearTheWater)
{
  const double accel = 1e-3;
  script(box({12, 8, 8}) + grain(1, {3.1, 4.2, 3.9}, 2.4) + grain(2, {8.9, 3.6, 4.7}, 2.1) +
         fluid("accel 1e-3 0 0") + frozen() + "\ncompute sum all reduce sum f_w[1] f_w[2] f_w[3]" +
         "\ncompute most all reduce max f_w[1]" + run(600) +
         "\nfix mean all ave/time 1 10 10 c_sum[*] c_most" + run(10));
  auto *mean = lmp->modify->get_fix_by_id("mean");
  auto value = [&](int i) {
    return mean->compute_vector(i);
  };
  EXPECT_NEAR(value(0), mass() * accel, 1e-6 * mass() * accel);
  for (int d = 0; d < 3; d++) EXPECT_NEAR(value(d), out(6 + d), 1e-6 * mass() * accel);
  EXPECT_NEAR(value(3), std::max(load(1)[0], load(2)[0]), 1e-6 * mass() * accel);
  EXPECT_LT(value(3), 0.9 * value(0));    // two grains bear it
}

// The movie of quicksand is made only where ffmpeg is; its commands must be right everywhere.
TEST_F(Manners, TheMovieOfQuicksandIsSpeltRight)
{
  const char *source = std::getenv("LBMIBB_SOURCE_DIR");
  std::ifstream file(std::string(source ? source : "") + "/examples/quicksand/movie.lmp");
  if (!file) GTEST_SKIP() << "no examples beside these tests";
  std::string line, commands;
  while (std::getline(file, line)) {
    const auto from = line.find("\"dump"), to = line.rfind('"');
    if (from != std::string::npos) commands += line.substr(from + 1, to - from - 1) + "\n";
  }
  EXPECT_IN(commands, "dump movie ");
  EXPECT_IN(commands, "dump_modify movie ");
  script(scene() +
         "\nvariable out string movie\nvariable between equal 10\nvariable colour atom vx" +
         "\nvariable diameter atom 2.0*radius\n" + commands + "undump movie");
}

TEST_F(Manners, ErrorsNameTheKeywordAndThePage)
{
  script(box({8, 7, 6}));
  for (const auto &[options, keyword] :
       {std::pair<const char *, const char *>{"colour blue", "colour"},
        {"link strong", "link"},
        {"face zlo pressure 1", "face"},
        {"collision mrt", "collision"}}) {
    const std::string message = error_of(fluid(options));
    EXPECT_IN(message, keyword);
    EXPECT_IN(message, "fix_lb_ibb");
  }
  const std::string tau = error_of("fix w all lb/ibb dx 1e-4 nu 1e-30 rho 1000\nrun 0");
  EXPECT_IN(tau, "tau");
  EXPECT_IN(tau, "Howto_lbm_ibb");
}
