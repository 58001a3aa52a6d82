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

// The contact law of the grains against what is known in closed form: eqs (2)
// to (6) of the article, impacts, sliding and rolling, rest; and against the
// stock styles where they have the same law.

#include "contact_scenes.h"

#include "force.h"
#include "pair.h"

#include <cstdlib>

/* ---------------------------------------------------------------------- */
/* the law by itself                                                       */
/* ---------------------------------------------------------------------- */

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

/* ---------------------------------------------------------------------- */
/* the styles, driven by LAMMPS                                            */
/* ---------------------------------------------------------------------- */

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
