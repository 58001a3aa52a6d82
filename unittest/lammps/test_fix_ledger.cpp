/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// The mass ledger in the vector of fix lb/ibb and in its report; a dense bed that moves as contacts,
// weight and water make it.

#include "fluid_scenes.h"

class LedgerOfFix : public FluidTest {
 protected:
  enum { COVERED = 15, UNCOVERED, DISPLACED, SWALLOWED, RETURNED, POCKETS, RESTORED, FACES };
  enum { LAST = 27, UNACCOUNTED, SETS, NODES };

  double gained() const
  {
    double sum = 0.0;
    for (int k = COVERED; k <= LAST; k++) sum += out(k);
    return sum;
  }
  double at_first() const { return RHO * n[0] * n[1] * n[2] * cell_volume(); }
  double mean_density() const { return mass() / (out(12) * cell_volume()) / RHO; }

  // Grains on a face-centred lattice, shaken: a solid fraction of .52, or of .55 of discs
  std::string bed(const std::string &options = "")
  {
    std::string text = box({36, 27, 27}, "p p f");
    int id = 0;
    for (int k = 0; k < 2 * 4 * 3 * 3 * 3; k++) {
      const int x = k % 8, y = k / 8 % 6, z = k / 48;
      if ((x + y + z) % 2 || z > 5 || id >= 108) continue;
      const double r = 2.9 + 0.1 * ((7 * id) % 5);
      const Triple v{2e-3 * std::sin(id), 2e-3 * std::cos(1.7 * id), 2e-3 * std::sin(2.3 * id + 1)};
      text += grain(++id, {4.5 * x + 1.3, 4.5 * y + 2.1, 4.4 * z + 2.9}, r, v);
    }
    return text + "\ntimestep " + num(DT / 25) +
        "\npair_style gran/lsd/coulomb\npair_coeff * * 0.05 0.8 0.4"
        "\nfix floor all wall/gran/lsd/coulomb 0.05 0.8 0.4 zplane 0 2.7e-3"
        "\nfix m all nve/sphere\nfix g all gravity 0.004 vector 1 0 -1"
        "\nneigh_modify delay 0 every 1 check yes" +
        fluid("every 25 buoyancy 0.0028284 0 -0.0028284 face zlo wall face zhi wall " + options);
  }
};

TEST_F(LedgerOfFix, AddsUpWhateverThereIs)
{
  for (const std::string faces :
       {"face zlo wall face zhi wall", "face zlo pressure 2e-4 face zhi wall",
        "face zlo velocity 0 0 1e-3 face zhi pressure 0"}) {
    start();
    script(box({12, 11, 15}, "p p f") + grain(1, {5.3, 6.1, 4.9}, 3.6, {2e-3, 0, 4e-3}) +
           grain(2, {5.3, 6.1, 12.2}, 2.9) + "\nfix m all nve/sphere" + fluid(faces) + run(0));
    EXPECT_EQ(gained(), 0.0);
    EXPECT_DOUBLE_EQ(mass(), at_first());
    for (int k = 0; k < 4; k++) {
      script(run(9));
      EXPECT_NEAR(mass() - at_first(), gained(), 1e-13 * at_first());
      EXPECT_NEAR(out(UNACCOUNTED), 0.0, 1e-13 * at_first());
    }
    EXPECT_LT(out(COVERED), 0.0);
    EXPECT_GT(out(UNCOVERED), 0.0);
    EXPECT_NEAR(out(SWALLOWED) + out(RETURNED), 0.0, 0.5 * std::fabs(out(SWALLOWED)));
    EXPECT_EQ(out(FACES + 4) != 0.0, faces.find("zlo wall") == std::string::npos) << faces;
    EXPECT_EQ(out(FACES + 5) != 0.0, faces.find("zhi wall") == std::string::npos) << faces;
    for (int k = 0; k < 4; k++) EXPECT_EQ(out(FACES + k), 0.0);
  }
}

// links are not asked for what they keep; the rest is as before
TEST_F(LedgerOfFix, WithoutConserveTheLinksAreWhatIsUnaccounted)
{
  start();
  script(box({12, 11, 15}) + grain(1, {5.3, 6.1, 4.9}, 3.6, {2e-3, 0, 4e-3}) +
         "\nfix m all nve/sphere" + fluid("conserve no") + run(30));
  for (int k : {DISPLACED, SWALLOWED, RETURNED, RESTORED}) EXPECT_EQ(out(k), 0.0);
  EXPECT_NEAR(mass() - at_first() - gained(), out(UNACCOUNTED), 1e-15 * at_first());
  EXPECT_GT(std::fabs(out(UNACCOUNTED)), 1e-9 * at_first());
}

TEST_F(LedgerOfFix, EnclosedFluidIsReported)
{
  start();
  std::string text = box({24, 24, 1}, "p p p");
  for (int k = 0; k < 8; k++)
    text += disc(k + 1, {12.1 + 6.2 * std::cos(k * PI_ / 4), 12.3 + 6.2 * std::sin(k * PI_ / 4), 0},
                 4.0);
  const std::string log = log_of(text + frozen() + fluid() + "\nrun 3");
  EXPECT_EQ(out(SETS), 1.0);
  EXPECT_GT(out(NODES), 8.0);
  EXPECT_LT(out(NODES), 20.0);
  EXPECT_IN(log, "mass gained so far: covered ");
  EXPECT_IN(log, "1 enclosed pockets with ");
}

// a thousand fluid steps of a bed that slides and rattles between two walls
TEST_F(LedgerOfFix, DenseBedKeepsItsMeanDensity)
{
  start();
  script(bed() + run(25 * 500));    // grains that overlap at the start push off first
  const auto mean_of_steps = [&]() {
    double mean = 0.0;
    for (int k = 0; k < 100; k++) {
      script(run(25));
      mean += mean_density() / 100.0;
    }
    return mean;
  };
  const double uncovered = out(UNCOVERED), restored = out(RESTORED), before = mean_of_steps();
  script(run(25 * 900));
  const double after = mean_of_steps();
  EXPECT_GT(1.0 - out(12) / (n[0] * n[1] * n[2]), 0.5);
  EXPECT_GT(out(UNCOVERED) - uncovered, 0.01 * mass());             // it did move
  EXPECT_GT(std::fabs(out(RESTORED) - restored), 1e-4 * mass());    // or else it would drift
  EXPECT_NEAR(after, before, 1e-6);
  EXPECT_NEAR(after, 1.0, 1e-5);
}
