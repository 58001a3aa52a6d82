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

// The contact law by itself, without LAMMPS: one force at a time, against eqs (2)
// to (6) of the article.

#include "contact_scenes.h"

TEST(ContactLaw, DampingIsEq5WithNaturalLogarithms)
{
  // -2 ln(.8) sqrt(k m)/sqrt(pi^2 + ln(.8)^2), worked out by hand
  EXPECT_NEAR(damping({1000.0, 0.8, 0.0}, 1.0e-7), 1.4170060e-3, 1.0e-9);
  EXPECT_EQ(damping({1000.0, 1.0, 0.5}, 1.0e-7), 0.0);
}

TEST(ContactLaw, CutRestitutionKnownValues)
{
  EXPECT_NEAR(cut_restitution(0.8), 0.8081, 5.0e-5);
  EXPECT_NEAR(cut_restitution(0.5), 0.5503, 5.0e-5);
  EXPECT_NEAR(cut_restitution(0.3), 0.3971, 5.0e-5);
}

class LawForce : public ::testing::Test {
 protected:
  const double n[3] = {0.0, 0.0, 1.0};
  const double zero[3] = {0.0, 0.0, 0.0};
  const double r = 1.0e-3, m = 1.0e-5, dt = 1.0e-6;

  Force wall(const double *v, const double *omega, double overlap, const Material &mat, bool cut,
             double factor = INERTIA_SPHERE) const
  {
    const Side still = {zero, zero, 0.0, 0.0, 0.0};
    return evaluate(make_law(mat, cut), overlap, n, make_side(v, omega, r, r, m, factor), still,
                    dt);
  }
};

TEST_F(LawForce, SpringRepelsAndAtRestThereIsNoFriction)
{
  const auto hit = wall(zero, zero, 1.0e-6, {1000.0, 0.8, 0.5}, false);
  EXPECT_DOUBLE_EQ(hit.fn, 1.0e-3);
  EXPECT_EQ(hit.fs[0], 0.0);
  EXPECT_EQ(hit.fs[1], 0.0);
  EXPECT_EQ(hit.fs[2], 0.0);
}

TEST_F(LawForce, FrictionOpposesSlip)
{
  const double v[3] = {0.3, -0.4, 0.0};
  const auto hit = wall(v, zero, 1.0e-6, {1000.0, 0.8, 0.5}, false);
  EXPECT_DOUBLE_EQ(hit.fs[0], -0.5 * 1.0e-3 * 0.6);
  EXPECT_DOUBLE_EQ(hit.fs[1], 0.5 * 1.0e-3 * 0.8);
  EXPECT_EQ(hit.fs[2], 0.0);
}

TEST_F(LawForce, RollingDoesNotSlip)
{
  // omega = v x-direction/r about +y: the contact point below stands still
  const double v[3] = {0.25, 0.0, 0.0}, omega[3] = {0.0, 250.0, 0.0};
  const auto hit = wall(v, omega, 1.0e-6, {1000.0, 0.8, 0.5}, false);
  EXPECT_NEAR(hit.slip[0], 0.0, 1.0e-15);
  EXPECT_NEAR(hit.fs[0], 0.0, 1.0e-12);
}

TEST_F(LawForce, SmallSlipIsStoppedInOneStep)
{
  // m_t = 2/7 m for a sphere, 1/3 m for a disc on a wall
  const double v[3] = {1.0e-6, 0.0, 0.0};
  const auto sphere = wall(v, zero, 1.0e-6, {1000.0, 0.8, 0.5}, false, INERTIA_SPHERE);
  EXPECT_DOUBLE_EQ(sphere.fs[0], -2.0 / 7.0 * m * v[0] / dt);
  const auto disc = wall(v, zero, 1.0e-6, {1000.0, 0.8, 0.5}, false, INERTIA_DISC);
  EXPECT_DOUBLE_EQ(disc.fs[0], -1.0 / 3.0 * m * v[0] / dt);
}

TEST_F(LawForce, AttractionIsKeptOrCutAndNeverRubs)
{
  const double v[3] = {0.1, 0.0, 0.5};
  const auto kept = wall(v, zero, 1.0e-9, {1000.0, 0.5, 0.5}, false);
  EXPECT_LT(kept.fn, 0.0);
  EXPECT_EQ(kept.fs[0], 0.0);
  const auto cut = wall(v, zero, 1.0e-9, {1000.0, 0.5, 0.5}, true);
  EXPECT_EQ(cut.fn, 0.0);
  EXPECT_EQ(cut.fs[0], 0.0);
}
