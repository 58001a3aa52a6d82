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

// Contacts that last, and many of them: from sliding to rolling, what a cloud of
// grains conserves, and grains that rest on each other.

#include "contact_scenes.h"

#include <cstdlib>

/* ---- from sliding to rolling ---- */

class Rolling : public ContactTest, public ::testing::WithParamInterface<bool> {};

TEST_P(Rolling, SlidesThenRolls)
{
  const bool disc = GetParam();
  const double r = 5.0e-4, mu = 0.45, v0 = 0.05;
  const double m = disc ? disc_mass(r) : sphere_mass(r);
  const double t_roll = v0 / (mu * GRAVITY) * (disc ? 1.0 / 3.0 : 2.0 / 7.0);
  const double kept = disc ? 2.0 / 3.0 : 5.0 / 7.0;
  const int steps = 4000;
  const double kn = disc ? 1.0e6 : KN;
  const double dt = t_roll / steps;
  ASSERT_LT(dt, contact_time({kn, 0.9, mu}, m) / 20.0);

  // laid down with the overlap that carries its weight
  script(box(disc) + grain(1, -0.004, r - m * GRAVITY / kn, 0, r, disc) + velocity(1, v0, 0, 0) +
         "\nfix floor all wall/gran/lsd/coulomb " + num(kn) + " 0.9 " + num(mu) +
         " yplane 0 NULL\nfix down all gravity " + num(GRAVITY) + " vector 0 -1 0" +
         integrate(disc) + "\ntimestep " + num(dt));

  // half way: slowing down at mu g
  script("run " + std::to_string(steps / 2) + " post no");
  EXPECT_NEAR(v(1)[0] / v0, 1.0 - 0.5 * (1.0 - kept), 2.0e-4);

  // just before rolling it still slips, just after it does not
  auto slip = [&]() {
    return v(1)[0] + omega(1)[2] * x(1)[1];
  };
  script("run " + std::to_string(steps * 49 / 100) + " post no");
  EXPECT_NEAR(slip() / v0, 0.01, 1.0e-3);
  script("run " + std::to_string(steps * 2 / 100) + " post no");
  EXPECT_NEAR(slip() / v0, 0.0, 1.0e-5);
  EXPECT_NEAR(v(1)[0] / v0, kept, 2.0e-4);

  // and goes on
  script("run " + std::to_string(4 * steps) + " post no");
  EXPECT_NEAR(v(1)[0] / v0, kept, 2.0e-4);
  EXPECT_NEAR(slip() / v0, 0.0, 1.0e-5);
}

INSTANTIATE_TEST_SUITE_P(Shape, Rolling, ::testing::Values(false, true), [](const auto &param) {
  return param.param ? "Disc" : "Sphere";
});

/* ---- conservation ---- */

class Conservation : public ContactTest {
 protected:
  static constexpr int NGRAINS = 27;

  void cloud(double offset, const std::string &newton)
  {
    // a lattice that flies together, sizes and velocities at random
    std::string text = box(false, newton == "on", 5.0e-5, "f f f");
    srand(4711);
    auto uniform = []() {
      return rand() / (RAND_MAX + 1.0);
    };
    for (int n = 0; n < NGRAINS; n++) {
      const double px = (n % 3 - 1) * 7.0e-4, py = (n / 3 % 3 - 1) * 7.0e-4,
                   pz = (n / 9 - 1) * 7.0e-4;
      text += grain(n + 1, px, py, pz, 2.0e-4 + 1.0e-4 * uniform());
      text += velocity(n + 1, -100.0 * px + 0.02 * uniform(), -100.0 * py + 0.02 * uniform(),
                       -100.0 * pz + 0.02 * uniform());
      text += "\nset atom " + std::to_string(n + 1) + " omega " + num(20.0 * uniform()) + " " +
          num(20.0 * uniform()) + " " + num(20.0 * uniform());
    }
    script(text + pair(0.8, 0.5, offset) + integrate() + "\ntimestep 3e-7");
  }

  double kinetic() const
  {
    double sum = 0.0;
    for (int id = 1; id <= NGRAINS; id++)
      for (int d = 0; d < 3; d++) sum += 0.5 * mass(id) * v(id)[d] * v(id)[d];
    return sum;
  }

  // momentum and angular momentum about the origin

  std::vector<double> totals() const
  {
    std::vector<double> sum(6, 0.0);
    for (int id = 1; id <= NGRAINS; id++) {
      const double m = mass(id), *p = x(id), *u = v(id), *w = omega(id);
      const double inertia = 0.4 * m * radius(id) * radius(id);
      for (int d = 0; d < 3; d++) {
        const int a = (d + 1) % 3, b = (d + 2) % 3;
        sum[d] += m * u[d];
        sum[3 + d] += m * (p[a] * u[b] - p[b] * u[a]) + inertia * w[d];
      }
    }
    return sum;
  }

  void check(double offset, const std::string &newton)
  {
    cloud(offset, newton);
    const auto before = totals();
    double momentum = 0.0, spin = 0.0;
    for (int id = 1; id <= NGRAINS; id++) {
      momentum += mass(id) * std::fabs(v(id)[0]);
      spin += mass(id) * std::fabs(v(id)[0]) * 7.0e-4;
    }
    const double energy = kinetic();
    script("run 20000 post no");
    EXPECT_LT(kinetic(), 0.7 * energy) << "the grains did not collide";
    const auto after = totals();
    for (int d = 0; d < 3; d++) {
      EXPECT_NEAR(after[d], before[d], 1.0e-12 * momentum);
      EXPECT_NEAR(after[3 + d], before[3 + d], 1.0e-12 * spin);
    }
  }
};

TEST_F(Conservation, MomentumAndAngularMomentum)
{
  check(0.0, "on");
}

TEST_F(Conservation, NewtonOff)
{
  check(0.0, "off");
}

TEST_F(Conservation, WithOffset)
{
  check(2.0e-5, "on");
}

/* ---- at rest ---- */

TEST_F(ContactTest, ColumnAtRestStaysAtRest)
{
  // five grains on top of each other, laid down with the overlaps that carry
  // the weight above, in sizes that differ
  const double radii[] = {3.0e-4, 2.5e-4, 3.0e-4, 2.0e-4, 2.5e-4};
  double above = 0.0, top = 0.0;
  for (double r : radii) above += sphere_mass(r) * GRAVITY;
  std::string text = box();
  std::vector<double> height;
  for (int n = 0; n < 5; n++) {
    height.push_back(top + radii[n] - above / KN);
    text += grain(n + 1, 0, 0, height.back(), radii[n]);
    top = height.back() + radii[n];
    above -= sphere_mass(radii[n]) * GRAVITY;
  }
  script(text + pair(0.9, 0.45) +
         "\nfix floor all wall/gran/lsd/coulomb 1000 0.9 0.45 zplane 0 NULL" +
         "\nfix down all gravity 9.81 vector 0 0 -1" + integrate() +
         "\ntimestep 4e-7\nrun 100000 post no");
  for (int n = 0; n < 5; n++) {
    EXPECT_EQ(x(n + 1)[0], 0.0);
    EXPECT_EQ(x(n + 1)[1], 0.0);
    EXPECT_NEAR(x(n + 1)[2], height[n], 1.0e-12);
    EXPECT_LT(std::fabs(v(n + 1)[2]), 1.0e-10);
  }

  // the floor carries the weight and nothing else
  double weight = 0.0;
  for (double r : radii) weight += sphere_mass(r) * GRAVITY;
  EXPECT_NEAR(thermo("f_floor[3]"), weight, 1.0e-9 * weight);
  EXPECT_EQ(thermo("f_floor"), 1.0);
}

class Pyramid : public ContactTest {
 protected:
  // Two discs side by side on a floor, a third on top.  The top one wants to
  // push them apart and sits at 60 degrees: the contacts bear it as long as mu
  // is above tan(15 degrees) = 0.268, whatever the floor.  Returns by how many
  // radii the top disc has come down after the time.

  static constexpr double R = 3.0e-4;

  double sunk(double mu, double time)
  {
    start();
    const double dt = 1.0e-6;
    script(box(true) + grain(1, -R, R, 0, R, true) + grain(2, R, R, 0, R, true) +
           grain(3, 0, R + std::sqrt(3.0) * R, 0, R, true) +
           "\npair_style gran/lsd/coulomb\npair_coeff * * 1e6 0.9 " + num(mu) +
           "\nfix floor all wall/gran/lsd/coulomb 1e6 0.9 " + num(mu) + " yplane 0 NULL" +
           "\nfix down all gravity 9.81 vector 0 -1 0" + integrate(true) + "\ntimestep " + num(dt));

    // the floor and the contacts take up the weight first
    script("run 5000 post no");
    const double y0 = x(3)[1];
    script("run " + std::to_string((int) std::lround(time / dt)) + " post no");
    return (y0 - x(3)[1]) / R;
  }
};

TEST_F(Pyramid, StandsWithEnoughFriction)
{
  // creeps, as a law without memory must: about one step's fall, g dt, per time
  EXPECT_LT(sunk(0.35, 0.1), 0.01);
  EXPECT_GT(sunk(0.35, 0.1), -1.0e-6);
}

TEST_F(Pyramid, FallsWithoutEnoughFriction)
{
  EXPECT_GT(sunk(0.2, 0.1), 0.1);
}
