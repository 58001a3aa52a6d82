/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Pair style lubricate/lb/ibb: with the lattice it gives the resistance of a sphere next to a wall
// that theory gives, which the lattice alone does not; pairs; what is refused.

#include "fluid_scenes.h"

#include "force.h"
#include "pair.h"

namespace {

// resistance of a sphere that approaches a plane, over that far from it: Brenner, Chem. Eng. Sci.
// 16, 242 (1961)
double brenner(double gap_over_radius)
{
  const double a = std::acosh(1.0 + gap_over_radius);
  double sum = 0.0;
  for (int n = 1; (2 * n + 1) * a < 60.0; n++) {
    const double m = 2 * n + 1;
    const double above = 2.0 * std::sinh(m * a) + m * std::sinh(2.0 * a);
    const double below = 4.0 * std::pow(std::sinh(0.5 * m * a), 2) - std::pow(m * std::sinh(a), 2);
    sum += n * (n + 1.0) / ((m - 2.0) * (m + 2.0)) * (above / below - 1.0);
  }
  return 4.0 / 3.0 * std::sinh(a) * sum;
}

// of one that moves along it, thin gaps: Goldman, Cox & Brenner, Chem. Eng. Sci. 22, 637 (1967)
double goldman(double gap_over_radius)
{
  return 0.9588 - 8.0 / 15.0 * std::log(gap_over_radius);
}

class Lubrication : public FluidTest {
 protected:
  static constexpr double R = 6.0, CREEP = 1e-3;    // cells; cells a fluid step

  std::string pair_style(const std::string &options)
  {
    return "\npair_style lubricate/lb/ibb " + options + "\npair_coeff * *";
  }
  // a sphere over a wall, moved as told: no film can stop it, so none is too stiff for the time step
  std::string sphere(double gap, const Triple &move, bool films)
  {
    const double cell = CREEP * DX / DT;
    return box({36, 36, 36}, "p p f") + grain(1, {18.2, 18.3, R + gap}, R) +
        (films ? pair_style("1e-7") : "\npair_style zero 1.3e-3\npair_coeff * *") +
        "\nfix m all move linear " + nums({move[0] * cell, move[1] * cell, move[2] * cell}) +
        fluid("face zlo wall face zhi wall");
  }
  double stokes() const { return 6.0 * PI_ * NU * RHO * R * DX * CREEP * DX / DT; }
  double gap() const { return lmp->atom->x[index(1)][2] / DX - R; }
};

TEST_F(Lubrication, ApproachToAWallIsBrenners)
{
  script(sphere(0.8, {0, 0, -1}, true) + run(500));
  for (int steps : {0, 100, 100, 50}) {    // gaps .3, .2, .1, .05
    if (steps) script(run(steps));
    const double exact = brenner(gap() / R);
    EXPECT_NEAR(f(1)[2] / stokes(), exact, 0.04 * exact) << gap();
  }
  start();
  script(sphere(0.8, {0, 0, -1}, false) + run(700));
  EXPECT_LT(f(1)[2] / stokes(), 0.2 * brenner(gap() / R)) << "the lattice alone";
}

TEST_F(Lubrication, SlidingAlongAWallIsGoldmans)
{
  for (double gap : {0.3, 0.1, 0.03}) {
    start();
    script(sphere(gap, {0.3, 0, 0}, true) + run(600));
    const double exact = goldman(gap / R);
    EXPECT_NEAR(-f(1)[0] / (0.3 * stokes()), exact, 0.04 * exact) << gap;
    if (gap < 0.05) {
      start();
      script(sphere(gap, {0.3, 0, 0}, false) + run(600));
      EXPECT_LT(-f(1)[0] / (0.3 * stokes()), 0.7 * exact) << "the lattice alone";
    }
  }
}

// two grains in a film: opposite forces of the published size, beside those of another pair style
TEST_F(Lubrication, PairsGetOppositeForces)
{
  const double gap = 0.1, speed = 1e-3;
  script(box({16, 12, 12}) + grain(1, {4.5, 6, 6}, 3, {speed, 0, 0}) +
         grain(2, {10.5 + gap, 6, 6}, 3) + "\nset group all density 1e9" +
         "\npair_style hybrid/overlay gran/lsd/coulomb lubricate/lb/ibb 1e-7"
         "\npair_coeff * * gran/lsd/coulomb 1e3 0.9 0.4\npair_coeff * * lubricate/lb/ibb" +
         "\nfix m all nve/sphere" + fluid("every 1") + run(0));
  const double a = 3.0 * DX, mu = NU * RHO;
  const double push =
      6.0 * PI_ * mu * a * a / 4.0 * (1.0 / (gap * DX) - 1.0 / (2.0 / 3.0 * DX)) * speed;
  EXPECT_NEAR(f(1)[0], -push, 1e-9 * push);
  EXPECT_NEAR(f(2)[0], push, 1e-9 * push);
  // grains outside the fluid's group have no film
  start();
  script(box({16, 12, 12}) + grain(1, {4.5, 6, 6}, 3, {speed, 0, 0}) +
         grain(2, {10.5 + gap, 6, 6}, 3) + "\nset group all density 1e9\ngroup wet id 1" +
         pair_style("1e-7") + "\nfix m all nve/sphere\nfix w wet lb/ibb dx 1e-4 nu 1e-6 rho 1000" +
         run(0));
  EXPECT_EQ(f(1)[0], 0.0);
  EXPECT_EQ(f(2)[0], 0.0);
}

// as computes ask for it: force over distance
TEST_F(Lubrication, ForceOfAPairAlone)
{
  script(box({16, 12, 12}) + grain(1, {4.5, 6, 6}, 3, {1e-3, 2e-3, 0}) +
         grain(2, {10.5, 6.9, 6.5}, 3) + "\nset group all density 1e9" +
         pair_style("1e-7 shear 0") + "\nfix m all nve/sphere" + fluid("every 1") + run(0));
  double del[3], rsq = 0.0, fforce = 0.0;
  for (int d = 0; d < 3; d++) {
    del[d] = x(1)[d] - x(2)[d];
    rsq += del[d] * del[d];
  }
  lmp->force->pair->single(index(1), index(2), 1, 1, rsq, 1.0, 1.0, fforce);
  EXPECT_GT(fforce, 0.0);    // they approach
  for (int d = 0; d < 3; d++)
    EXPECT_NEAR(f(1)[d], fforce * del[d], 1e-9 * std::fabs(fforce * del[0]));
  lmp->force->pair->single(index(1), index(2), 1, 1, 2.0 * rsq, 1.0, 1.0, fforce);
  EXPECT_EQ(fforce, 0.0);
}

TEST_F(Lubrication, WallsMayBeLeftOut)
{
  for (const bool walls : {true, false}) {
    start();
    script(box({12, 12, 12}, "p p f") + grain(1, {6, 6, 3.1}, 3, {0, 0, -1e-3}) +
           "\nset group all density 1e9" + pair_style(walls ? "1e-7" : "1e-7 walls no") +
           "\nfix m all nve/sphere" + fluid("face zlo wall face zhi wall") + run(0));
    EXPECT_EQ(f(1)[2] > 0.0, walls);
  }
}

TEST_F(Lubrication, Refusals)
{
  const std::string one = box({12, 12, 12}, "p p f") + grain(1, {6, 6, 6}, 3);
  const std::string water = fluid("face zlo wall face zhi wall");
  auto with = [&](const std::string &options, const std::string &why) {
    start();
    EXPECT_ERROR(one + pair_style(options) + water + "\nfix m all nve/sphere" + run(1), why);
  };
  with("", "Illegal pair_style lubricate/lb/ibb");
  with("0", "the smallest gap is 0: it must be larger than 0");
  with("nan", "nan");
  with("1e-6 normal", "missing argument");
  with("1e-6 normal -1", "cut-off normal -1 is not between 0 and 3 cells");
  with("1e-6 cells 1", "unknown keyword cells, known are normal, shear and walls");
  with("1e-4", "is not below the cut-offs");
  with("1e-6\npair_coeff * * 5", "pair_coeff takes two types and nothing else");
  with("1e-6\npair_coeff 2* 1", "no pair of types in 2* 1 with the first not above the second");
  with("1e-6\ncomm_modify vel no", "requires the velocities of ghost atoms");
  with("1e-9", "less than the timestep of 0.001, which would be unstable: use a timestep <=");
  start();
  EXPECT_ERROR(one + pair_style("1e-6") + "\nfix m all nve/sphere" + run(1),
               "there is no fix lb/ibb, from which it takes viscosity and spacing");
  start();
  EXPECT_ERROR(one + "\npair_style lubricate/lb/ibb 1e-6\npair_coeff 1 1\npair_coeff 2 2" + water +
                   run(1),
               "no pair_coeff for types 1 and 2: add pair_coeff 1 2");
  start();
  EXPECT_ERROR(box({12, 12, 1}) + disc(1, {6, 6}, 3) + pair_style("1e-6") + fluid() + run(1),
               "cannot be used in 2d");
}

}    // namespace
