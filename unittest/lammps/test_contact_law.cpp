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
// to (6) of the article, impacts, sliding and rolling; and what the commands
// refuse.  Lengths, speeds and masses are those of sand grains, in SI units.

#include "lammps_fixture.h"

#include "force.h"
#include "gran_lsd_law.h"
#include "pair.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

using namespace GranLSD;

static constexpr double DENSITY = 2600.0;
static constexpr double KN = 1000.0;

// so stiff that the overlap is nothing against the radius, for results that
// hold for a point of contact at the radius

static constexpr double STIFF = 1.0e7;
static constexpr double STIFF_DISC = 1.0e10;
static constexpr double GRAVITY = 9.81;

static double sphere_mass(double r)
{
  return DENSITY * 4.0 / 3.0 * PI * r * r * r;
}

static double disc_mass(double r)
{
  return DENSITY * PI * r * r;
}

// restitution if the net force may not attract: Schwager and Poeschel, Granular
// Matter 9, 465 (2007), eq. (19)

static double cut_restitution(double e)
{
  const double zeta = damping_ratio(e);
  const double root = std::sqrt(1.0 - zeta * zeta);
  const double phase = std::atan2(2.0 * zeta * root, 1.0 - 2.0 * zeta * zeta);
  return std::exp(-zeta / root * (PI - phase));
}

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

// what an impact is made of; the defaults are two equal grains in 3d, without
// friction

struct Impact {
  double kn = KN, e = 0.8, mu = 0.0;
  double r1 = 3.0e-4, r2 = 3.0e-4;
  double vn = 0.05, vt = 0.0;    // approach of 1 to what it hits, and slip
  double parts = 50.0;           // time steps a contact
  double phase = 0.5;            // of a step, at the first touch
  double offset = 0.0;
  double skin = 1.0e-4;
  bool disc = false, newton = true;
  std::string limit = "no", extra;
};

class ContactTest : public LammpsTest {
 protected:
  static std::string num(double value)
  {
    char text[32];
    snprintf(text, sizeof(text), "%.17g", value);
    return text;
  }

  static std::string box(bool disc = false, bool newton = true, double skin = 1.0e-4,
                         const std::string &boundary = "")
  {
    std::string bound = boundary;
    if (bound.empty()) bound = disc ? "f f p" : "f f f";
    return "units si\natom_style sphere\natom_modify map array sort 0 0\n"
           "dimension " +
        std::string(disc ? "2" : "3") + "\nnewton " + (newton ? "on" : "off") + "\nboundary " +
        bound +
        "\ncomm_modify vel yes\n"
        "region box block -0.005 0.005 -0.005 0.005 " +
        (disc ? "-0.001 0.001" : "-0.005 0.005") + "\ncreate_box 2 box\nneighbor " + num(skin) +
        " bin\nneigh_modify delay 0 every 1 check yes\nthermo_style custom step";
  }

  static std::string grain(int id, double px, double py, double pz, double r, bool disc = false)
  {
    const std::string name = std::to_string(id);
    return "\ncreate_atoms 1 single " + num(px) + " " + num(py) + " " + num(pz) + "\nset atom " +
        name + " diameter " + num(2.0 * r) + "\nset atom " + name + " density" +
        (disc ? "/disc " : " ") + num(DENSITY);
  }

  static std::string velocity(int id, double vx, double vy, double vz)
  {
    const std::string name = std::to_string(id);
    return "\nset atom " + name + " vx " + num(vx) + " vy " + num(vy) + " vz " + num(vz);
  }

  static std::string pair(double e, double mu, double offset = 0.0, const std::string &limit = "no",
                          double kn = KN)
  {
    return "\npair_style gran/lsd/coulomb offset " + num(offset) + " limit_damping " + limit +
        "\npair_coeff * * " + num(kn) + " " + num(e) + " " + num(mu);
  }

  static std::string integrate(bool disc = false)
  {
    return disc ? "\nfix move all nve/sphere disc\nfix flat all enforce2d"
                : "\nfix move all nve/sphere";
  }

  static double mass_of(const Impact &c, double r)
  {
    return c.disc ? disc_mass(r) : sphere_mass(r);
  }

  static double pair_duration(const Impact &c)
  {
    const double m1 = mass_of(c, c.r1), m2 = mass_of(c, c.r2);
    return contact_time({c.kn, c.e, c.mu}, m1 * m2 / (m1 + m2));
  }

  static double wall_duration(const Impact &c)
  {
    return contact_time({c.kn, c.e, c.mu}, mass_of(c, c.r1));
  }

  // steps from before an impact to after it

  void run_through(const Impact &c)
  {
    script("run " + std::to_string((int) std::ceil(2.0 * c.parts) + 10) + " post no");
  }

  // grain 1 comes from the left along x, grain 2 rests

  void hit_grain(const Impact &c)
  {
    start();
    const double dt = pair_duration(c) / c.parts;
    const double gap = (2.0 + c.phase) * dt * c.vn;
    script(box(c.disc, c.newton, c.skin) + grain(1, -c.r1 - c.offset - gap, 0, 0, c.r1, c.disc) +
           grain(2, c.r2 + c.offset, 0, 0, c.r2, c.disc) + velocity(1, c.vn, c.vt, 0.0) +
           pair(c.e, c.mu, c.offset, c.limit, c.kn) + integrate(c.disc) + c.extra + "\ntimestep " +
           num(dt));
    run_through(c);
  }

  // grain 1 falls on a floor at y = 0 along -y, without gravity

  void hit_wall(const Impact &c)
  {
    start();
    const double dt = wall_duration(c) / c.parts;
    const double gap = (2.0 + c.phase) * dt * c.vn;
    script(box(c.disc, c.newton, c.skin) + grain(1, 0, c.r1 + c.offset + gap, 0, c.r1, c.disc) +
           velocity(1, c.vt, -c.vn, 0.0) + "\nfix floor all wall/gran/lsd/coulomb " + num(c.kn) +
           " " + num(c.e) + " " + num(c.mu) + " yplane 0 NULL offset " + num(c.offset) +
           " limit_damping " + c.limit + integrate(c.disc) + c.extra + "\ntimestep " + num(dt));
    run_through(c);
  }

  // Restitution, mean over where in a step the grains touch first: the dashpot
  // sets in with a jump, which a time step places to half a step.

  double mean_restitution(Impact c, bool wall)
  {
    static constexpr int PHASES = 16;
    double sum = 0.0;
    for (int p = 0; p < PHASES; p++) {
      c.phase = (p + 0.5) / PHASES;
      if (wall) {
        hit_wall(c);
        sum += v(1)[1] / c.vn;
      } else {
        hit_grain(c);
        sum += (v(2)[0] - v(1)[0]) / c.vn;
      }
    }
    return sum / PHASES;
  }
};

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

/* ---- the contact radius ---- */

TEST_F(ContactTest, OffsetShiftsTheTouch)
{
  const double r1 = 3.0e-4, r2 = 2.0e-4, offset = 5.0e-5;
  for (double gap : {1.0e-9, -1.0e-9}) {
    start();
    script(box() + grain(1, 0, 0, 0, r1) + grain(2, r1 + r2 + 2.0 * offset + gap, 0, 0, r2) +
           pair(0.9, 0.45, offset) + integrate() + "\ntimestep 1e-7\nrun 0 post no");
    if (gap > 0.0)
      EXPECT_EQ(f(2)[0], 0.0);
    else
      EXPECT_NEAR(f(2)[0], KN * 1.0e-9, 1.0e-5 * KN * 1.0e-9);

    start();
    script(box() + grain(1, 0, r1 + offset + gap, 0, r1) +
           "\nfix floor all wall/gran/lsd/coulomb 1000 0.9 0.45 yplane 0 NULL offset " +
           num(offset) + integrate() + "\ntimestep 1e-7\nrun 0 post no");
    if (gap > 0.0)
      EXPECT_EQ(f(1)[1], 0.0);
    else
      EXPECT_NEAR(f(1)[1], KN * 1.0e-9, 1.0e-5 * KN * 1.0e-9);
  }
}

TEST_F(ContactTest, OffsetLargerThanTheSkinMissesNothing)
{
  // a granular neighbor list of stock would end at r1 + r2 + skin, far inside
  Impact c;
  c.offset = 1.0e-4;
  c.skin = 1.0e-6;
  c.r2 = 2.0e-4;
  c.parts = 500.3;
  for (bool newton : {true, false}) {
    c.newton = newton;
    hit_grain(c);
    EXPECT_NEAR((v(2)[0] - v(1)[0]) / c.vn, c.e, 1.0e-3);
  }
}

TEST_F(ContactTest, OffsetAcrossAPeriodicFace)
{
  // the ghosts must reach as far as the contact
  const double r = 3.0e-4, offset = 1.0e-4;
  for (const char *newton : {"on", "off"}) {
    start();
    script(box(false, newton == std::string("on"), 1.0e-6, "p p p") +
           grain(1, -0.005 + r + 0.9 * offset, 0, 0, r) +
           grain(2, 0.005 - r - 0.9 * offset, 0, 0, r) + pair(0.9, 0.45, offset) + integrate() +
           "\ntimestep 1e-7\nrun 0 post no");
    EXPECT_NEAR(f(1)[0], KN * 0.2 * offset, 1.0e-9 * KN * offset);
    EXPECT_NEAR(f(2)[0], -KN * 0.2 * offset, 1.0e-9 * KN * offset);
  }
}

TEST_F(ContactTest, OffsetRollsOnItsContactRadius)
{
  // the contact point is at the contact radius: rolling means v = omega (r + offset)
  Impact c;
  c.offset = 6.0e-5;
  c.kn = STIFF;
  c.mu = 0.5;
  c.vt = 0.5 * 3.0 * c.mu * 1.8 * c.vn;
  hit_wall(c);
  EXPECT_NEAR(v(1)[0] + omega(1)[2] * (c.r1 + c.offset), 0.0, 1.0e-4 * c.vt);
}

TEST_F(ContactTest, OffsetWithNeighborMulti)
{
  const double r1 = 3.0e-4, r2 = 1.0e-4, offset = 1.0e-4;
  script(
      box(false, true, 1.0e-6) + grain(1, 0, 0, 0, r1) +
      grain(2, r1 + r2 + 1.9 * offset, 0, 0, r2) +
      "\nneighbor 1e-6 multi\nneigh_modify collection/interval 2 2.5e-4 6.5e-4\ncomm_modify mode "
      "multi vel yes" +
      pair(0.9, 0.45, offset) + integrate() + "\ntimestep 1e-7");
  EXPECT_ERROR("run 0", "interval");
  script("neigh_modify collection/type 1 *\nrun 0 post no");
  EXPECT_NEAR(f(2)[0], KN * 0.1 * offset, 1.0e-9 * KN * offset);
}

/* ---- walls ---- */

TEST_F(ContactTest, ReactionOfWallsIsReported)
{
  // between two walls that squeeze: the lower pushes up, the upper down
  const double r = 3.0e-4;
  script(box() + grain(1, 0, 0, r - 1.0e-6, r) +
         "\nfix slit all wall/gran/lsd/coulomb 1000 0.9 0.45 zplane 0 " + num(2.0 * r - 4.0e-6) +
         integrate() + "\ntimestep 1e-7\nrun 0 post no");
  EXPECT_EQ(thermo("f_slit"), 2.0);
  EXPECT_NEAR(thermo("f_slit[3]"), KN * 1.0e-6, 1.0e-9);
  EXPECT_NEAR(thermo("f_slit[6]"), -KN * 3.0e-6, 1.0e-9);
  EXPECT_NEAR(f(1)[2], -KN * 2.0e-6, 1.0e-9);

  // anew, at the same step
  script("displace_atoms all move 0 0 1e-6\nrun 0 post no");
  EXPECT_EQ(thermo("f_slit"), 1.0);
  EXPECT_NEAR(thermo("f_slit[3]"), 0.0, 1.0e-9);
  EXPECT_NEAR(thermo("f_slit[6]"), -KN * 4.0e-6, 1.0e-9);
}

TEST_F(ContactTest, WallKnowsGrainsThatAreSorted)
{
  // grains of many sizes bounce on a floor while they drift past each other, so
  // that LAMMPS changes their order; without contacts among them that is no matter
  std::vector<double> unsorted;
  for (const char *sort : {"0 0", "10 4e-4"}) {
    start();
    std::string text = box();
    for (int n = 0; n < 8; n++) {
      const double r = 2.0e-4 + 2.0e-5 * n;
      text += grain(n + 1, 1.0e-3 * (n - 4), r, 0, r) + velocity(n + 1, 0.2 * (4 - n), -0.5, 0.0);
    }
    script(text + "\natom_modify sort " + sort + "\npair_style zero 1e-4\npair_coeff * *" +
           "\nfix floor all wall/gran/lsd/coulomb 1000 0.9 0.02 yplane 0 0.001" + integrate() +
           "\ntimestep 5e-7\nrun 20000 post no");
    for (int id = 1; id <= 8; id++) {
      if (*sort == '0')
        unsorted.insert(unsorted.end(), {x(id)[1], v(id)[0]});
      else {
        EXPECT_EQ(x(id)[1], unsorted[2 * id - 2]) << "grain " << id;
        EXPECT_EQ(v(id)[0], unsorted[2 * id - 1]) << "grain " << id;
      }
    }
  }
}

TEST_F(ContactTest, ShearingWallDragsAGrainAlong)
{
  // until it rolls on the wall: its centre then has 2/7 of the wall's speed
  const double r = 3.0e-4, speed = 0.02;
  script(box() + grain(1, -0.004, r - sphere_mass(r) * GRAVITY / KN, 0, r) +
         "\nfix belt all wall/gran/lsd/coulomb 1000 0.9 0.45 yplane 0 NULL shear x " + num(speed) +
         "\nfix down all gravity 9.81 vector 0 -1 0" + integrate() +
         "\ntimestep 1e-6\nrun 10000 post no");
  EXPECT_NEAR(v(1)[0] / speed, 2.0 / 7.0, 1.0e-4);
}

TEST_F(ContactTest, WigglingWallMovesAsItSays)
{
  // a quarter of a period on, the wall has moved by the amplitude
  const double r = 3.0e-4, amplitude = 1.0e-5;
  script(box() + grain(1, 0, r, 0, r) +
         "\nfix plate all wall/gran/lsd/coulomb 1000 1 0 yplane 0 NULL wiggle y " + num(amplitude) +
         " 4e-5\ntimestep 1e-7\nrun 100 post no");
  EXPECT_NEAR(f(1)[1], KN * amplitude, 1.0e-9);
}

TEST_F(ContactTest, GrainBehindAWallIsPushedBack)
{
  const double r = 3.0e-4;
  script(box() + grain(1, 0, -0.5 * r, 0, r) +
         "\nfix floor all wall/gran/lsd/coulomb 1000 0.9 0.45 yplane 0 NULL" + integrate() +
         "\ntimestep 1e-7\nrun 0 post no");
  EXPECT_NEAR(f(1)[1], KN * 1.5 * r, 1.0e-9);
}

/* ---- frozen and rigid grains ---- */

TEST_F(ContactTest, FrozenGrainIsInfinitelyHeavy)
{
  // as the first and as the second of the pair
  const double r = 3.0e-4, vn = 0.05, e = 0.8;
  const double dt = contact_time({KN, e, 0.0}, sphere_mass(r)) / 1000.3;
  for (const char *frozen : {"1", "2"}) {
    for (bool newton : {true, false}) {
      start();
      const int mover = (*frozen == '1') ? 2 : 1;
      const double sign = (mover == 1) ? 1.0 : -1.0, gap = 2.5 * dt * vn;
      script(box(false, newton) + grain(1, -r - gap, 0, 0, r) + grain(2, r, 0, 0, r) +
             velocity(mover, sign * vn, 0, 0) + pair(e, 0.0) + "\ngroup ice id " + frozen +
             "\nfix ice ice freeze" + integrate() + "\ntimestep " + num(dt) + "\nrun 1500 post no");
      EXPECT_NEAR(-sign * v(mover)[0] / vn, e, 1.0e-3);
      EXPECT_EQ(v(3 - mover)[0], 0.0);
    }
  }
}

TEST_F(ContactTest, TwoFrozenGrainsAreLeftAlone)
{
  // neither has a mass to damp: no force, and nothing infinite in the pressure
  const double r = 3.0e-4;
  script(box() + grain(1, 0, 0, 0, r) + grain(2, r, 0, 0, r) + pair(0.9, 0.45) +
         "\nfix ice all freeze\ncompute p all pressure NULL pair\nthermo_style custom step c_p"
         "\ntimestep 1e-7\nrun 10 post no");
  EXPECT_EQ(f(1)[0], 0.0);
  EXPECT_EQ(thermo("c_p"), 0.0);
}

TEST_F(ContactTest, RigidBodyWeighsAsAWhole)
{
  // a dumbbell along its axis against a wall and against a grain: twice the mass
  const double r = 3.0e-4, vn = 0.05, e = 0.8, m = sphere_mass(r);
  const double dt = contact_time({KN, e, 0.0}, m * 2.0 * m / (3.0 * m)) / 1000.3;
  const std::string clump = "\ngroup clump id 1 2\nfix body clump rigid single"
                            "\nneigh_modify exclude group clump clump\ntimestep " +
      num(dt);
  script(box() + grain(1, 0, r + 2.5 * dt * vn, 0, r) + grain(2, 0, 3.0 * r + 2.5 * dt * vn, 0, r) +
         velocity(1, 0, -vn, 0) + velocity(2, 0, -vn, 0) + pair(e, 0.0) +
         "\nfix floor all wall/gran/lsd/coulomb 1000 " + num(e) + " 0 yplane 0 NULL" + clump +
         "\nrun 3000 post no");
  EXPECT_NEAR(v(1)[1] / vn, e, 1.0e-3);

  start();
  script(box() + grain(1, 0, r + 2.5 * dt * vn, 0, r) + grain(2, 0, 3.0 * r + 2.5 * dt * vn, 0, r) +
         grain(3, 0, -r, 0, r) + velocity(1, 0, -vn, 0) + velocity(2, 0, -vn, 0) + pair(e, 0.0) +
         clump + "\ngroup free id 3\nfix move free nve/sphere\nrun 3000 post no");
  EXPECT_NEAR((v(1)[1] - v(3)[1]) / vn, e, 1.0e-3);
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

/* ---- coefficients ---- */

TEST_F(ContactTest, EachPairOfTypesHasItsOwn)
{
  const double r = 3.0e-4;
  const std::string scene = box() + grain(1, 0, 0, 0, r) + grain(2, 2.0 * r - 1.0e-6, 0, 0, r) +
      "\nset atom 2 type 2\ntimestep 1e-7\npair_style gran/lsd/coulomb";
  script(scene + "\npair_coeff * * 1000 0.9 0.45\npair_coeff 1 2 2000 0.9 0.45\nrun 0 post no");
  EXPECT_NEAR(f(2)[0], 2000.0 * 1.0e-6, 1.0e-9);
}

TEST_F(ContactTest, CoefficientsFromAFile)
{
  // found through LAMMPS_POTENTIALS, which is set where the tests run
  const double r = 3.0e-4;
  script(box() + grain(1, 0, 0, 0, r) + grain(2, 2.0 * r - 1.0e-6, 0, 0, r) +
         "\ntimestep 1e-7\npair_style gran/lsd/coulomb\npair_coeff * * file quartz_sand.lsd quartz"
         "\nrun 0 post no");
  int dim;
  auto *pair = lmp->force->pair;
  EXPECT_EQ(((double **) pair->extract("kn", dim))[2][1], 1.0e3);
  EXPECT_EQ(dim, 2);
  EXPECT_EQ(((double **) pair->extract("e", dim))[1][1], 0.9);
  EXPECT_EQ(((double **) pair->extract("mu", dim))[1][2], 0.45);
  EXPECT_NEAR(f(2)[0], 1.0e-3, 1.0e-9);

  script("pair_coeff 1 2 file glass_beads.lsd glass\nrun 0 post no");
  EXPECT_EQ(((double **) pair->extract("e", dim))[1][2], 0.97);
  EXPECT_EQ(((double **) pair->extract("mu", dim))[2][1], 0.092);

  script("fix floor all wall/gran/lsd/coulomb file quartz_sand.lsd quartz xplane " +
         num(1.0e-6 - r) + " NULL\nrun 0 post no");
  EXPECT_NEAR(thermo("f_floor[1]"), 1.0e-3, 1.0e-9);
}

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

/* ---- what LAMMPS asks of a pair style ---- */

TEST_F(ContactTest, SingleIsTheForceOfTheRun)
{
  Impact c;
  c.mu = 0.3;
  c.vt = 0.1;
  c.r2 = 2.0e-4;
  c.offset = 2.0e-5;
  start();
  const double dt = pair_duration(c) / 50.0;
  script(box() + grain(1, -c.r1, 0, 0, c.r1) +
         grain(2, c.r2 + 2.0 * c.offset - 1.0e-6, 1.0e-5, 0, c.r2) + velocity(1, c.vn, c.vt, 0.01) +
         pair(c.e, c.mu, c.offset) + integrate() + "\ntimestep " + num(dt) + "\nrun 0 post no");
  const int i = index(1), j = index(2);
  double del[3], rsq = 0.0, fforce;
  for (int d = 0; d < 3; d++) {
    del[d] = x(1)[d] - x(2)[d];
    rsq += del[d] * del[d];
  }
  auto *pair = lmp->force->pair;
  pair->single(i, j, 1, 1, rsq, 0.0, 1.0, fforce);
  double fs2 = 0.0;
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(del[d] * fforce + pair->svector[d], f(1)[d], 1.0e-12);
    fs2 += pair->svector[d] * pair->svector[d];
  }
  EXPECT_NEAR(pair->svector[3], std::sqrt(fs2), 1.0e-15);
  EXPECT_GT(pair->svector[3], 0.0);

  // out of touch there is none
  pair->single(i, j, 1, 1, 1.0, 0.0, 1.0, fforce);
  EXPECT_EQ(fforce, 0.0);
  EXPECT_EQ(pair->svector[3], 0.0);
}

TEST_F(ContactTest, WorksInsideHybrid)
{
  const double r = 3.0e-4;
  script(box() + grain(1, 0, 0, 0, r) + grain(2, 2.0 * r - 1.0e-6, 0, 0, r) +
         "\npair_style hybrid gran/lsd/coulomb\npair_coeff * * gran/lsd/coulomb 1000 0.9 0.45"
         "\ntimestep 1e-7\nrun 0 post no");
  EXPECT_NEAR(f(2)[0], 1.0e-3, 1.0e-9);
  EXPECT_ERROR("timestep 1e-4\nrun 0", "Timestep 0.0001 is more than a tenth");
}

TEST_F(ContactTest, RestartContinuesTheRun)
{
  const std::string settle =
      "\nfix floor all wall/gran/lsd/coulomb 1000 0.9 0.45 zplane -0.005 NULL"
      "\nfix sidex all wall/gran/lsd/coulomb 1000 0.9 0.45 xplane -4e-4 4e-4"
      "\nfix sidey all wall/gran/lsd/coulomb 1000 0.9 0.45 yplane -4e-4 4e-4"
      "\nfix down all gravity 9.81 vector 0 0 -1" +
      integrate();
  std::string grains;
  for (int n = 0; n < 12; n++)
    grains += grain(n + 1, 1.0e-5 * (n * 7 % 5), 1.0e-5 * (n * 3 % 7), -0.0046 + 6.0e-4 * n,
                    2.5e-4 + 1.0e-6 * n);
  script(box() + grains +
         "\npair_style gran/lsd/coulomb offset 2e-5 limit_damping yes\npair_coeff * * 1000 0.9 0.45"
         "\npair_coeff 2 2 2000 0.8 0.3\npair_coeff 1 2 1500 0.7 0.2" +
         settle +
         "\ntimestep 1e-6\nrun 150000 post no\nwrite_restart contact_law.restart"
         "\nrun 5000 post no");
  std::vector<double> straight;
  for (int id = 1; id <= 12; id++)
    for (int d = 0; d < 3; d++) straight.insert(straight.end(), {x(id)[d], v(id)[d], omega(id)[d]});
  EXPECT_GT(thermo("f_floor"), 0.0);

  // read_restart brings the coefficients back, the fixes have no state
  start();
  script("atom_modify map array sort 0 0\ncomm_modify vel yes\nread_restart contact_law.restart"
         "\nneighbor 1e-4 bin\nneigh_modify delay 0 every 1 check yes" +
         settle + "\nrun 5000 post no");
  int n = 0;
  for (int id = 1; id <= 12; id++)
    for (int d = 0; d < 3; d++) {
      EXPECT_EQ(x(id)[d], straight[n++]);
      EXPECT_EQ(v(id)[d], straight[n++]);
      EXPECT_EQ(omega(id)[d], straight[n++]);
    }
  int dim;
  EXPECT_EQ(((double **) lmp->force->pair->extract("e", dim))[1][2], 0.7);
  EXPECT_EQ(((double **) lmp->force->pair->extract("mu", dim))[2][2], 0.3);
  EXPECT_EQ(((double **) lmp->force->pair->extract("kn", dim))[2][2], 2000.0);
  EXPECT_EQ(*(double *) lmp->force->pair->extract("offset", dim), 2.0e-5);
  std::remove("contact_law.restart");
}

TEST_F(ContactTest, RestartKeepsLimitDamping)
{
  // stop before the touch, go on from the restart file
  Impact c;
  c.e = 0.5;
  c.limit = "yes";
  c.parts = 1000.3;
  c.extra = "\nrestart 1 contact_law.*.restart\nrun 1 post no\nrestart 0";
  hit_grain(c);
  start();
  script("atom_modify map array sort 0 0\ncomm_modify vel yes\nread_restart contact_law.1.restart"
         "\nneighbor 1e-4 bin\nthermo_style custom step" +
         integrate() + "\ntimestep " + num(pair_duration(c) / c.parts));
  EXPECT_EQ(v(2)[0], 0.0);
  run_through(c);
  EXPECT_NEAR((v(2)[0] - v(1)[0]) / c.vn, cut_restitution(c.e), 1.0e-3);
  std::remove("contact_law.1.restart");
}

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

/* ---- refusals ---- */

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
