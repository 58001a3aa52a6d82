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

// Impacts of two grains and of a grain on a wall, against what is known in closed
// form: restitution, duration, sliding and sticking; and against the stock styles
// where they have the same law.

#include "contact_scenes.h"

#include "force.h"
#include "pair.h"

/* ---- restitution, eq. (5) ---- */

class Restitution : public ContactTest, public ::testing::WithParamInterface<double> {};

TEST_P(Restitution, EqualGrains)
{
  Impact c;
  c.e = GetParam();
  EXPECT_NEAR(mean_restitution(c, false), c.e, 1.0e-3);
}

TEST_P(Restitution, UnequalGrains)
{
  Impact c;
  c.e = GetParam();
  c.r2 = 2.0e-4;
  EXPECT_NEAR(mean_restitution(c, false), c.e, 1.0e-3);
}

TEST_P(Restitution, GrainOnWall)
{
  Impact c;
  c.e = GetParam();
  EXPECT_NEAR(mean_restitution(c, true), c.e, 1.0e-3);
}

TEST_P(Restitution, DiscsAndDiscOnWall)
{
  Impact c;
  c.e = GetParam();
  c.r2 = 4.0e-4;
  c.disc = true;
  EXPECT_NEAR(mean_restitution(c, false), c.e, 1.0e-3);
  EXPECT_NEAR(mean_restitution(c, true), c.e, 1.0e-3);
}

TEST_P(Restitution, FrictionDoesNotTouchTheNormalMotion)
{
  Impact c;
  c.e = GetParam();
  c.mu = 0.5;
  c.vt = 0.1;
  EXPECT_NEAR(mean_restitution(c, true), c.e, 1.0e-3);
  EXPECT_LT(v(1)[0], 0.09);
}

TEST_P(Restitution, SingleImpactsConverge)
{
  // one impact, wherever it begins in a step, with the step far below t_c/50
  Impact c;
  c.e = GetParam();
  c.parts = 1000.3;
  for (double phase : {0.1, 0.6, 0.9}) {
    c.phase = phase;
    hit_grain(c);
    EXPECT_NEAR((v(2)[0] - v(1)[0]) / c.vn, c.e, 1.0e-3);
    hit_wall(c);
    EXPECT_NEAR(v(1)[1] / c.vn, c.e, 1.0e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(E, Restitution, ::testing::Values(0.5, 0.8, 0.9, 1.0),
                         [](const auto &param) {
                           return "e" + std::to_string((int) std::lround(100.0 * param.param));
                         });

TEST_F(ContactTest, LimitDampingGivesTheHigherRestitution)
{
  Impact c;
  c.parts = 1000.3;
  c.limit = "yes";
  for (double e : {0.5, 0.8}) {
    c.e = e;
    hit_grain(c);
    EXPECT_NEAR((v(2)[0] - v(1)[0]) / c.vn, cut_restitution(e), 1.0e-3);
    hit_wall(c);
    EXPECT_NEAR(v(1)[1] / c.vn, cut_restitution(e), 1.0e-3);
  }
}

/* ---- duration, eq. (6) with damping ---- */

TEST_F(ContactTest, ContactLastsAsLongAsComputed)
{
  Impact c;
  c.e = 0.5;
  c.r2 = 2.0e-4;
  c.parts = 200.0;
  hit_grain(c);
  const double expected = pair_duration(c);

  // again, step by step
  start();
  const double dt = expected / c.parts;
  script(box() + grain(1, -c.r1 - 1.5 * dt * c.vn, 0, 0, c.r1) + grain(2, c.r2, 0, 0, c.r2) +
         velocity(1, c.vn, 0, 0) + pair(c.e, c.mu) + integrate() + "\ntimestep " + num(dt) +
         "\nrun 0 post no");
  int steps = 0;
  for (int n = 0; n < 300; n++) {
    script("run 1 pre no post no");
    if (f(1)[0] != 0.0) steps++;
  }
  EXPECT_NEAR(steps * dt, expected, 1.5 * dt);
}

TEST_F(ContactTest, CriticalTimeIsExported)
{
  Impact c;
  c.r2 = 2.0e-4;
  hit_grain(c);

  // the smallest mass there is meets its like
  int dim = -1;
  auto *t_contact = (double *) lmp->force->pair->extract("t_contact", dim);
  ASSERT_NE(t_contact, nullptr);
  EXPECT_EQ(dim, 0);
  EXPECT_NEAR(*t_contact, contact_time({KN, c.e, 0.0}, 0.5 * sphere_mass(c.r2)),
              1e-12 * *t_contact);
  auto *offset = (double *) lmp->force->pair->extract("offset", dim);
  ASSERT_NE(offset, nullptr);
  EXPECT_EQ(*offset, 0.0);
}

/* ---- oblique impact, eq. (4) ---- */

class Oblique : public ContactTest, public ::testing::WithParamInterface<bool> {};

TEST_P(Oblique, GrossSlidingOnWall)
{
  // slip all along if v_t/v_n > (1 + 1/c) mu (1 + e): 3.5 for spheres, 3 for discs
  Impact c;
  c.disc = GetParam();
  c.kn = c.disc ? STIFF_DISC : STIFF;
  c.mu = 0.2;
  c.vt = 1.2 * 3.5 * c.mu * 2.0 * c.vn;
  c.parts = 1000.3;
  const double factor = c.disc ? INERTIA_DISC : INERTIA_SPHERE;
  for (double e : {1.0, 0.8}) {
    c.e = e;
    hit_wall(c);

    // the friction is mu times the impulse of the repulsion, m (1 + e) v_n if
    // nothing attracts: e = 1, or the value with attraction cut
    const double loss = c.mu * (1.0 + cut_restitution(e)) * c.vn;
    EXPECT_NEAR((c.vt - v(1)[0]) / loss, 1.0, 1.0e-3);
    EXPECT_NEAR(omega(1)[2] * c.r1 * factor / -loss, 1.0, 1.0e-3);
    EXPECT_NEAR(loss / (c.mu * (1.0 + e) * c.vn), 1.0, 5.0e-3);
  }
}

TEST_P(Oblique, StickingOnWall)
{
  // slip stops during the contact and the grain leaves rolling
  Impact c;
  c.disc = GetParam();
  c.kn = c.disc ? STIFF_DISC : STIFF;
  c.mu = 0.5;
  c.vt = 0.5 * 3.0 * c.mu * 1.8 * c.vn;
  hit_wall(c);
  const double kept = c.disc ? 2.0 / 3.0 : 5.0 / 7.0;
  EXPECT_NEAR(v(1)[0] / c.vt, kept, 1.0e-4);
  EXPECT_NEAR(-omega(1)[2] * c.r1 / c.vt, kept, 1.0e-4);
}

TEST_P(Oblique, GrossSlidingOfGrains)
{
  Impact c;
  c.disc = GetParam();
  c.kn = c.disc ? STIFF_DISC : STIFF;
  c.mu = 0.2;
  c.e = 1.0;
  c.r2 = 2.0e-4;
  c.vt = 1.2 * 3.5 * c.mu * 2.0 * c.vn;
  c.parts = 1000.3;
  hit_grain(c);
  const double m1 = mass_of(c, c.r1), m2 = mass_of(c, c.r2);
  const double meff = m1 * m2 / (m1 + m2);
  const double factor = c.disc ? INERTIA_DISC : INERTIA_SPHERE;
  const double impulse = c.mu * meff * 2.0 * c.vn;

  EXPECT_NEAR(m1 * (c.vt - v(1)[1]) / impulse, 1.0, 1.0e-3);
  EXPECT_NEAR(m2 * v(2)[1] / impulse, 1.0, 1.0e-3);
  EXPECT_NEAR(-omega(1)[2] * factor * m1 * c.r1 / impulse, 1.0, 1.0e-3);
  EXPECT_NEAR(-omega(2)[2] * factor * m2 * c.r2 / impulse, 1.0, 1.0e-3);
}

INSTANTIATE_TEST_SUITE_P(Shape, Oblique, ::testing::Values(false, true), [](const auto &param) {
  return param.param ? "Disc" : "Sphere";
});

TEST_P(Oblique, SmallSlipIsStoppedInOneStep)
{
  // 2/7 m_eff v/dt for spheres and 1/3 m_eff v/dt for discs, of grains and walls
  const bool disc = GetParam();
  const double r = 3.0e-4, slip = 1.0e-8, dt = 1.0e-7, kn = 1.0e6;
  const double m = disc ? disc_mass(r) : sphere_mass(r);
  const double factor = disc ? 1.0 / 3.0 : 2.0 / 7.0;
  const std::string scene = box(disc) + grain(1, 0, r - 1.0e-9, 0, r, disc) +
      velocity(1, slip, 0, 0) + integrate(disc) + "\ntimestep " + num(dt);

  script(scene + grain(2, 0, -r, 0, r, disc) + pair(0.9, 0.5, 0.0, "no", kn) + "\nrun 0 post no");
  EXPECT_NEAR(f(1)[0] / (-factor * 0.5 * m * slip / dt), 1.0, 1.0e-4);
  EXPECT_NEAR(f(2)[0] / (factor * 0.5 * m * slip / dt), 1.0, 1.0e-4);
  start();
  script(scene + "\nfix floor all wall/gran/lsd/coulomb " + num(kn) +
         " 0.9 0.5 yplane 0 NULL\nrun 0 post no");
  EXPECT_NEAR(f(1)[0] / (-factor * m * slip / dt), 1.0, 1.0e-4);
}

TEST_F(ContactTest, ElasticGrainsStillRub)
{
  // e = 1: the normal energy comes back, the friction works nevertheless
  Impact c;
  c.e = 1.0;
  c.mu = 0.3;
  c.vt = 0.2;
  c.parts = 1000.3;
  hit_wall(c);
  EXPECT_NEAR(v(1)[1] / c.vn, 1.0, 1.0e-4);
  EXPECT_NEAR((c.vt - v(1)[0]) / (c.mu * 2.0 * c.vn), 1.0, 1.0e-3);
}

/* ---- against the stock styles, where they have the same law ---- */

TEST_F(ContactTest, AgreesWithStockGranular)
{
  // hooke + coeff_restitution is eq. (5); linear_nohistory with a large xt
  // slides as Coulomb says
  Impact c;
  c.mu = 0.2;
  c.r2 = 2.0e-4;
  c.vt = 1.2 * 3.5 * c.mu * 2.0 * c.vn;
  c.parts = 2000.3;
  hit_grain(c);
  std::vector<double> ours;
  for (int id : {1, 2})
    for (int d : {0, 1}) ours.push_back(v(id)[d] / c.vn);
  ours.push_back(omega(1)[2] * c.r1 / c.vn);

  c.extra = "\npair_style granular\npair_coeff * * hooke 1000 0.8 damping coeff_restitution "
            "tangential linear_nohistory 1000 0.2";
  hit_grain(c);
  int n = 0;
  for (int id : {1, 2})
    for (int d : {0, 1}) EXPECT_NEAR(v(id)[d] / c.vn, ours[n++], 3.0e-3);
  EXPECT_NEAR(omega(1)[2] * c.r1 / c.vn, ours[n], 3.0e-3);
}
