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

// What the contact styles refuse, and with which words: time steps, files,
// coefficients and commands.

#include "contact_scenes.h"

#include "update.h"

#include <fstream>

/* ---- the time step ---- */

class TimeStep : public ContactTest {
 protected:
  const double r = 2.0e-4;

  std::string scene(double dt, const std::string &law)
  {
    return box() + grain(1, -0.001, 0, 0, r) + grain(2, 0.001, 0, 0, 2.0 * r) + law + integrate() +
        "\ntimestep " + num(dt);
  }

  // with a pair so soft that only the floor matters
  const std::string floor = "\npair_style gran/lsd/coulomb\npair_coeff * * 1e-3 0.8 0.45\nfix "
                            "floor all wall/gran/lsd/coulomb 1000 0.8 0.45 yplane -0.004 NULL";
};

TEST_F(TimeStep, PairRefusesBeyondATenthAndWarnsBeyondAFiftieth)
{
  const double tc = contact_time({KN, 0.8, 0.45}, 0.5 * sphere_mass(r));
  char limit[80];
  snprintf(limit, sizeof(limit), "use a timestep of at most %.6g (%.6g is advised)", tc / 10.0,
           tc / 50.0);

  EXPECT_ERROR(scene(1.01 * tc / 10.0, pair(0.8, 0.45)) + "\nrun 0", limit);
  start();
  EXPECT_EQ(error_of(scene(0.99 * tc / 10.0, pair(0.8, 0.45)) + "\nrun 0 post no"), "");
  EXPECT_EQ(warnings(), 1);
  start();
  EXPECT_EQ(error_of(scene(1.01 * tc / 50.0, pair(0.8, 0.45)) + "\nrun 0 post no"), "");
  EXPECT_EQ(warnings(), 1);
  start();
  EXPECT_EQ(error_of(scene(tc / 50.0, pair(0.8, 0.45)) + "\nrun 0 post no"), "");
  EXPECT_EQ(warnings(), 0);
}

TEST_F(TimeStep, WallRefusesBeyondATenthAndWarnsBeyondAFiftieth)
{
  const double tc = contact_time({KN, 0.8, 0.45}, sphere_mass(r));
  char limit[80];
  snprintf(limit, sizeof(limit), "use a timestep of at most %.6g (%.6g is advised)", tc / 10.0,
           tc / 50.0);

  EXPECT_ERROR(scene(1.01 * tc / 10.0, floor) + "\nrun 0", limit);
  start();
  EXPECT_EQ(error_of(scene(0.99 * tc / 10.0, floor) + "\nrun 0 post no"), "");
  EXPECT_EQ(warnings(), 1);
  start();
  EXPECT_EQ(error_of(scene(tc / 50.0, floor) + "\nrun 0 post no"), "");
  EXPECT_EQ(warnings(), 0);
}

// fix dt/reset lets slow grains take long steps
TEST_F(TimeStep, LongerOneDuringARunIsNoticed)
{
  for (const bool of_floor : {false, true}) {
    start();
    const double tc = contact_time({KN, 0.8, 0.45}, (of_floor ? 1.0 : 0.5) * sphere_mass(r));
    const std::string text = scene(tc / 50.0, of_floor ? floor : pair(0.8, 0.45)) +
        "\nset group all vx 1e-6\nfix longer all dt/reset 5 NULL ";
    EXPECT_EQ(error_of(text + num(0.99 * tc / 10.0) + " 1e-4\nrun 10 post no"), "");
    EXPECT_DOUBLE_EQ(lmp->update->dt, 0.99 * tc / 10.0);
    start();
    EXPECT_ERROR(text + num(1.01 * tc / 10.0) + " 1e-4\nrun 10",
                 of_floor ? "is more than a tenth of the shortest contact of fix wall"
                          : "is more than a tenth of the shortest contact of pair_style");
  }
}

TEST_F(TimeStep, StiffestPairOfTypesThatCanMeetCounts)
{
  // type 2 has no grain, so its stiffness does not matter
  const double tc = contact_time({KN, 0.8, 0.45}, 0.5 * sphere_mass(r));
  const std::string law = pair(0.8, 0.45) + "\npair_coeff 2 2 1e6 0.8 0.45";
  EXPECT_EQ(error_of(scene(tc / 50.0, law) + "\nrun 0 post no"), "");
  EXPECT_EQ(warnings(), 0);
  EXPECT_ERROR("set atom 2 type 2\nrun 0", "is more than a tenth of the shortest contact");
}

TEST_F(TimeStep, FrozenPartnerMakesContactsLonger)
{
  // of two types, one all frozen: the moving grain's own mass counts
  const double tc = contact_time({KN, 0.8, 0.45}, sphere_mass(r));
  const std::string law = "\nset atom 2 type 2\ngroup ice type 2\nfix ice ice freeze"
                          "\npair_style gran/lsd/coulomb\npair_coeff * * 1 0.8 0.45"
                          "\npair_coeff 1 2 1000 0.8 0.45";
  EXPECT_EQ(error_of(scene(0.99 * tc / 10.0, law) + "\nrun 0 post no"), "");
  EXPECT_ERROR("timestep " + num(1.01 * tc / 10.0) + "\nrun 0", "is more than a tenth");
}

TEST_F(TimeStep, GrainsThatTurnLighterDuringARunAreNoticed)
{
  const double tc = contact_time({KN, 0.8, 0.45}, 0.5 * sphere_mass(r));
  std::string text = scene(tc / 50.0, pair(0.8, 0.45));
  text.replace(text.find("atom_style sphere"), 17, "atom_style sphere 1");
  EXPECT_EQ(error_of(text + "\nneigh_modify delay 0 every 1 check no\nrun 1 post no"), "");

  // fix adapt shrinks the grains when the check before the run has been passed
  const std::string shrink =
      "\nvariable small equal 2e-5\nfix shrink all adapt 1000 atom diameter v_small\nrun 10";
  EXPECT_ERROR(shrink, "is more than a tenth of the shortest contact of pair_style");

  start();
  text = scene(tc / 50.0, floor);
  text.replace(text.find("atom_style sphere"), 17, "atom_style sphere 1");
  EXPECT_EQ(error_of(text + "\nneigh_modify delay 0 every 1 check no\nrun 1 post no"), "");
  EXPECT_ERROR(shrink, "is more than a tenth of the shortest contact of fix wall");
}

/* ---- files ---- */

TEST_F(ContactTest, FilesThatAreRefused)
{
  script(box() + "\npair_style gran/lsd/coulomb");
  auto file = [](const char *text) {
    std::ofstream("contact_law.lsd") << text;
  };
  const std::string coeff = "pair_coeff * * file contact_law.lsd quartz";

  EXPECT_ERROR("pair_coeff * * file no_such.lsd quartz", "no_such.lsd: it is neither there nor in");
  EXPECT_ERROR("pair_coeff * * file quartz_sand.lsd chalk",
               "does not define chalk, it has: quartz quartz_2d");
  file("# DATE: 2026-01-01 CITATION: none\nquartz 1e3 0.9 0.45\n");
  EXPECT_ERROR(coeff, "does not name its units");
  file("# DATE: 2026-01-01 UNITS: cgs CITATION: none\nquartz 1e3 0.9 0.45\n");
  EXPECT_ERROR(coeff, "is in cgs units but the script uses si units");
  file("# DATE: 2026-01-01 UNITS: si CITATION: none\nquartz 1e3 0.9\n");
  EXPECT_ERROR(coeff, "has a line of 3 words");
  file("# DATE: 2026-01-01 UNITS: si CITATION: none\nquartz 1e3 0.9 0.4\nquartz 1e3 0.9 0.5\n");
  EXPECT_ERROR(coeff, "defines quartz twice");
  file("# DATE: 2026-01-01 UNITS: si CITATION: none\nquartz 1e3 0.9 rough\n");
  EXPECT_ERROR(coeff, "rough");
  file("# DATE: 2026-01-01 UNITS: si CITATION: none\nquartz 1e3 1.9 0.4\n");
  EXPECT_ERROR(coeff, "e = 1.9 must be above 0 and at most 1");
  std::remove("contact_law.lsd");
}

/* ---- commands ---- */

TEST_F(ContactTest, CoefficientsThatAreRefused)
{
  script(box() + "\npair_style gran/lsd/coulomb");
  EXPECT_ERROR("pair_coeff * * 0 0.9 0.45", "k_n = 0 must be positive");
  EXPECT_ERROR("pair_coeff * * -5 0.9 0.45", "k_n = -5 must be positive");
  EXPECT_ERROR("pair_coeff * * 1000 0 0.45", "e = 0 must be above 0 and at most 1");
  EXPECT_ERROR("pair_coeff * * 1000 1.1 0.45", "e = 1.1 must be above 0 and at most 1");
  EXPECT_ERROR("pair_coeff * * 1000 0.9 -0.1", "mu = -0.1 must be 0 or positive");
  EXPECT_ERROR("pair_coeff * * 1000 0.9", "missing");
  EXPECT_ERROR("pair_coeff * * 1000 0.9 0.45 7", "unexpected word 7");
  EXPECT_ERROR("pair_coeff 2* 1 1000 0.9 0.45", "no pair of types in 2* 1");
  EXPECT_ERROR("pair_coeff * * 1000 stiff 0.45", "stiff");

  // what is allowed at the edges
  EXPECT_EQ(error_of("pair_coeff * * 1000 1 0"), "");
}

TEST_F(ContactTest, PairStyleThatIsRefused)
{
  script(box());
  EXPECT_ERROR("pair_style gran/lsd/coulomb offset", "missing");
  EXPECT_ERROR("pair_style gran/lsd/coulomb offset -1e-5", "offset -1e-05 must be 0 or positive");
  EXPECT_ERROR("pair_style gran/lsd/coulomb damping 5", "unknown keyword damping");
  EXPECT_ERROR("pair_style gran/lsd/coulomb limit_damping perhaps", "perhaps");
}

TEST_F(ContactTest, CoefficientsAreNotMixed)
{
  script(box() + grain(1, 0, 0, 0, 3.0e-4) +
         "\ntimestep 1e-7\npair_style gran/lsd/coulomb"
         "\npair_coeff 1 1 1000 0.9 0.45\npair_coeff 2 2 1000 0.9 0.45");
  EXPECT_ERROR("run 0", "no coefficients for types 1 and 2: add pair_coeff 1 2");
}

TEST_F(ContactTest, GhostVelocitiesAreRequired)
{
  script(box() + grain(1, 0, 0, 0, 3.0e-4) + pair(0.9, 0.45) +
         "\ntimestep 1e-7\ncomm_modify vel no");
  EXPECT_ERROR("run 0", "add comm_modify vel yes");
}

TEST_F(ContactTest, SpheresAreRequired)
{
  const std::string atomic = "units si\natom_style atomic\nregion b block 0 1 0 1 0 1\n"
                             "create_box 1 b\nmass 1 1\ncomm_modify vel yes\nneighbor 1e-3 bin\n";
  script(atomic + "pair_style gran/lsd/coulomb\npair_coeff * * 1000 0.9 0.45\ntimestep 1e-7");
  EXPECT_ERROR("run 0", "use atom_style sphere");
  start();
  script("boundary f f f\n" + atomic);
  EXPECT_ERROR("fix w all wall/gran/lsd/coulomb 1000 0.9 0.45 zplane 0 NULL",
               "use atom_style sphere");
}

TEST_F(ContactTest, UnitsWithHiddenFactorsAreRefused)
{
  // where force is not mass times acceleration in the units of the script
  for (const std::string units : {"real", "metal"}) {
    const std::string text = "units " + units +
        "\natom_style sphere\nboundary f f f\nregion b block 0 10 0 10 0 10\ncreate_box 1 b\n"
        "create_atoms 1 single 5 5 5\ncomm_modify vel yes\ntimestep 1e-6\n";
    start();
    EXPECT_ERROR(text + "pair_style gran/lsd/coulomb\npair_coeff * * 1000 0.9 0.45\nrun 0",
                 "cannot be used with units " + units);
    start();
    EXPECT_ERROR(text + "fix w all wall/gran/lsd/coulomb 1000 0.9 0.45 zplane 0 NULL\nrun 0",
                 "cannot be used with units " + units);
  }
}

TEST_F(ContactTest, TwoFreezesOrTwoRigidsAreRefused)
{
  const double r = 3.0e-4;
  const std::string four = box() + grain(1, 0, 0, 0, r) + grain(2, 3 * r, 0, 0, r) +
      grain(3, 0, 3 * r, 0, r) + grain(4, 3 * r, 3 * r, 0, r) + pair(0.9, 0.45) +
      "\ntimestep 1e-7\ngroup one id 1 2\ngroup two id 3 4";
  script(four + "\nfix a one freeze\nfix b two freeze");
  EXPECT_ERROR("run 0", "one fix freeze, not with 2");
  start();
  script(four + "\nfix a one rigid single\nfix b two rigid single");
  EXPECT_ERROR("run 0", "one fix rigid, not with a and b");
}

TEST_F(ContactTest, WallsThatAreRefused)
{
  script(box(false, true, 1.0e-4, "p f f") + grain(1, 0, 0, 0, 3.0e-4) + "\ntimestep 1e-7");
  const std::string fix = "fix w all wall/gran/lsd/coulomb ";
  EXPECT_ERROR(fix + "1000 0.9 0.45", "missing");
  EXPECT_ERROR(fix + "0 0.9 0.45 zplane 0 NULL", "k_n = 0 must be positive");
  EXPECT_ERROR(fix + "1000 2 0.45 zplane 0 NULL", "e = 2 must be above 0 and at most 1");
  EXPECT_ERROR(fix + "1000 0.9 -1 zplane 0 NULL", "mu = -1 must be 0 or positive");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zcylinder 0 NULL", "expected xplane, yplane or zplane");
  EXPECT_ERROR(fix + "1000 0.9 0.45 xplane 0 NULL", "x is periodic");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane NULL NULL", "no wall at all");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane 2 1",
               "lower wall at 2 must be below the upper wall at 1");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane 0 NULL offset -1", "offset -1 must be 0 or positive");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane 0 NULL spin x 1", "unknown keyword spin");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane 0 NULL shear z 1", "shear must be along the wall");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane 0 NULL shear w 1", "must be x, y or z, not w");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane 0 NULL shear x", "missing");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane 0 NULL wiggle z 1e-5 0", "period of wiggle, 0, must be");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane 0 NULL shear x 1 shear y 1", "more than one motion");
  EXPECT_ERROR(fix + "1000 0.9 0.45 zplane 0 NULL\nrun_style respa 2 2 pair 1\nrun 0",
               "run_style verlet");

  start();
  script(box(true));
  EXPECT_ERROR("fix w all wall/gran/lsd/coulomb 1e6 0.9 0.45 zplane 0 NULL", "no meaning in 2d");
  EXPECT_ERROR("fix w all wall/gran/lsd/coulomb 1e6 0.9 0.45 yplane 0 NULL shear z 1",
               "cannot move along z in 2d");
}

/* ---- words and numbers ---- */

TEST_F(ContactTest, WordsOfThePairStyleThatAreRefused)
{
  const std::string scene = box() + grain(1, 0, 0, 0, 2e-4) + grain(2, 0.001, 0, 0, 3e-4);
  auto refusal = [&](const std::string &settings, const std::string &coeff = "* * 1000 0.8 0.45") {
    start();
    return error_of(scene + "\npair_style gran/lsd/coulomb " + settings + "\npair_coeff " + coeff +
                    "\ntimestep 1e-9\nrun 0");
  };
  auto expect = [](const std::string &message, const std::string &piece) {
    EXPECT_NE(message.find(piece), std::string::npos) << "no '" << piece << "' in: " << message;
  };
  EXPECT_EQ(refusal("offset 1e-5 limit_damping yes"), "");
  expect(refusal("offset 1e-5 offset 1e-5"), "offset is given twice: remove one of them");
  expect(refusal("limit_damping no limit_damping no"), "limit_damping is given twice");
  // a cutoff of metres would fill memory with ghost atoms
  EXPECT_EQ(refusal("offset 2.9e-4"), "");
  expect(refusal("offset 3.1e-4"), "offset 0.00031 is larger than the largest radius, 0.0003");
  expect(refusal("offset 900"), "offset 900 is larger than the largest radius");
  for (const std::string types : {"- *", "* -", "- -"})
    expect(refusal("", types + " 1000 0.8 0.45"), "are no atom types or ranges of them");
  start();
  expect(error_of(box() +
                  "\npair_style gran/lsd/coulomb offset 0.0051\npair_coeff * * 1000 0.8 0.45" +
                  "\nrun 0"),
         "offset 0.0051 is larger than half of the box, 0.005");
}

TEST_F(ContactTest, WordsOfTheWallThatAreRefused)
{
  auto refusal = [&](const std::string &words) {
    start();
    return error_of(box() + "\nfix floor all wall/gran/lsd/coulomb 1000 0.8 0.45 " + words);
  };
  auto expect = [](const std::string &message, const std::string &piece) {
    EXPECT_NE(message.find(piece), std::string::npos) << "no '" << piece << "' in: " << message;
  };
  EXPECT_EQ(refusal("yplane 0 NULL offset 1e-5 limit_damping yes shear x 1"), "");
  // LAMMPS itself refuses what is no number
  for (const std::string value : {"nan", "inf", "1e400"})
    for (const std::string words :
         {"yplane ", "yplane 0 NULL shear x ", "yplane 0 NULL wiggle x 1 "})
      expect(refusal(words + value + " NULL"), "loating point");
  expect(refusal("yplane 0 NULL offset 1e-5 offset 2e-5"), "offset is given twice");
}
