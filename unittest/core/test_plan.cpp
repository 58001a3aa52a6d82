// SPDX-License-Identifier: GPL-2.0-only
// The arithmetic of lb/plan against numbers worked out by hand, and its optimum against a search.

#include "lbm_plan.h"
#include "lbm_solver.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lbm;

namespace {

// error .04 (3/r)^2, whatever the fraction; and one that depends on it
Accuracy table()
{
  Accuracy a;
  for (const char *line : {"# a comment", "", "drag 3 0.04", "drag 6 0.01  # second order",
                           "bed@0.2 5 0.01", "bed@0.6 5 0.04"})
    EXPECT_EQ(a.read(line), "") << line;
  return a;
}

// water, quartz of 1 mm, slow
Wish wish()
{
  Wish w;
  w.nu = 1e-6;
  w.rho = 1000.0;
  w.quantity = "drag";
  w.smallest = w.mean = 5e-4;
  w.speed = 1e-3;
  return w;
}

TEST(PlanAccuracy, PowerLawBetweenRowsSecondOrderBeyond)
{
  const Accuracy a = table();
  EXPECT_NEAR(a.error("drag", 3.0, 0.0), 0.04, 1e-15);
  EXPECT_NEAR(a.error("drag", 6.0, 0.0), 0.01, 1e-15);
  EXPECT_NEAR(a.error("drag", 4.0, 0.0), 0.04 * 9.0 / 16.0, 1e-12);
  EXPECT_NEAR(a.error("drag", 12.0, 0.0), 0.0025, 1e-12);
  EXPECT_NEAR(a.error("drag", 1.5, 0.0), 0.16, 1e-12);
  EXPECT_NEAR(a.radius("drag", 0.0025, 0.0), 12.0, 12.0 * 1e-3);
  EXPECT_NEAR(a.radius("drag", 0.04 * 9.0 / 16.0, 0.0), 4.0, 4.0 * 1e-3);
  EXPECT_NEAR(a.radius("drag", 0.16, 0.0), 1.5, 1.5 * 1e-3);
}

TEST(PlanAccuracy, GeometricMeanBetweenFractions)
{
  const Accuracy a = table();
  EXPECT_NEAR(a.error("bed", 5.0, 0.4), 0.02, 1e-12);
  EXPECT_NEAR(a.error("bed", 5.0, 0.0), 0.01, 1e-12);
  EXPECT_NEAR(a.error("bed", 5.0, 0.7), 0.04, 1e-12);
  EXPECT_NEAR(a.radius("bed", 0.02, 0.4), 5.0, 5e-3);
}

// a table that rises again: the radius is that from which on it stays good
TEST(PlanAccuracy, RadiusBeyondTheLastBadRow)
{
  Accuracy a;
  for (const char *line : {"drag 3 0.04", "drag 4 0.001", "drag 5 0.01", "drag 6 0.002"})
    a.read(line);
  const double r = a.radius("drag", 0.005, 0.0);
  EXPECT_GT(r, 5.0);
  EXPECT_LT(r, 6.0);
  EXPECT_NEAR(a.error("drag", r, 0.0), 0.005, 0.005 * 0.02);
}

TEST(PlanAccuracy, RefusesWhatItCannotRead)
{
  Accuracy a;
  for (const char *line :
       {"drag", "drag 3", "drag 3 x", "drag -3 0.1", "drag 3 0", "drag 3 0.1 4", "drag@ 3 0.1",
        "drag@2 3 0.1", "drag@x 3 0.1", "@0.1 3 0.1", "drag 3 nan"})
    EXPECT_NE(a.read(line), "") << line;
  EXPECT_TRUE(a.empty());
  EXPECT_EQ(a.read("drag 3 0.1"), "");
  EXPECT_NE(a.read("drag 3 0.2"), "");
}

// dx = .1 mm, tau 1.5: dt = dx^2/(3 nu) = 1/300 s; Ma = sqrt(3) u dt/dx = .0577;
// error .04 (3/5)^2 = .0144, of compressibility (u dt/dx)^2 = .00111 < a quarter of it
TEST(Plan, GivenSpacingTakesTheLargestGoodRelaxationTime)
{
  Wish w = wish();
  w.dx = 1e-4;
  const Advice a = advise(w, table());
  ASSERT_EQ(a.refusal, "");
  EXPECT_NEAR(a.tau, 1.5, 1e-12);
  EXPECT_NEAR(a.units.dt, 1.0 / 300.0, 1e-12);
  EXPECT_NEAR(a.mach, std::sqrt(3.0) / 30.0, 1e-9);
  EXPECT_NEAR(a.grid_error, 0.0144, 1e-9);
  EXPECT_NEAR(a.compressibility, 1.0 / 900.0, 1e-9);
  EXPECT_EQ(a.every, 1);
  EXPECT_NE(a.binds_dt.find("relaxation time"), std::string::npos);
}

// contacts of .7 ms: n_d = ceil(3.33/.7) = 5
TEST(Plan, GranularStepsFillTheFluidStep)
{
  Wish w = wish();
  w.dx = 1e-4;
  w.contact = 0.7e-3;
  const Advice a = advise(w, table());
  EXPECT_EQ(a.every, 5);
  EXPECT_NEAR(a.step * 5, a.units.dt, 1e-15);
  w.contact = a.units.dt / 4.0;    // whole: not one more
  EXPECT_EQ(advise(w, table()).every, 4);
}

// contacts of 1 us: 3333 steps would fill it, 1000 are enough, and 1111 times softer ones need 100
TEST(Plan, NoMoreGranularStepsThanTheFixTakes)
{
  Wish w = wish();
  w.dx = 1e-4;
  w.contact = 1e-6;
  const Advice a = advise(w, table());
  EXPECT_EQ(a.every, 1000);
  EXPECT_NEAR(a.units.dt, 1e-3, 1e-12);
  ASSERT_EQ(a.notes.size(), 1u);
  EXPECT_NE(a.notes[0].find("3333 granular steps"), std::string::npos) << a.notes[0];
  EXPECT_NE(a.notes[0].find("1.11e+03 times smaller"), std::string::npos) << a.notes[0];
}

// What is given may be out of reach of what is wished: .0144 of the lattice alone
TEST(Plan, SaysWhatIsOutOfReach)
{
  Wish w = wish();
  w.dx = 1e-4;
  w.tau = 1.0;
  w.error = 1e-3;
  Advice a = advise(w, table());
  ASSERT_EQ(a.notes.size(), 1u);
  EXPECT_NE(a.notes[0].find("the error wished, 0.001, needs less dx or a shorter step than given"),
            std::string::npos)
      << a.notes[0];
  w = wish();
  w.dx = 1e-4;
  w.tau = 1.0;    // dt = 1/600 s; contacts of 1 us would need 1667 steps, 278 times softer ones 100
  w.contact = 1e-6;
  a = advise(w, table());
  EXPECT_EQ(a.every, 1667);
  ASSERT_EQ(a.notes.size(), 1u);
  EXPECT_NE(a.notes[0].find("a contact stiffness 278 times smaller would need 100"),
            std::string::npos)
      << a.notes[0];
  w.contact = 1e-13;
  EXPECT_NE(advise(w, table()).refusal.find("contacts allow a granular step of 1e-13"),
            std::string::npos)
      << advise(w, table()).refusal;
  w = wish();
  w.dx = 1e-9;
  w.box = {1.0, 1.0, 1.0};
  EXPECT_NE(advise(w, table()).refusal.find("would be 1e+09 cells along x: too many"),
            std::string::npos)
      << advise(w, table()).refusal;
}

// ten times as fast: Ma <= .1 gives u dt/dx = .1/sqrt(3), its share of the error
// .0144/4 = (u dt/dx)^2 gives .06, more; so the Mach number binds. At 8 cells per radius the share
// is .00140625, and binds
TEST(Plan, MachNumberOrItsErrorBinds)
{
  Wish w = wish();
  w.dx = 1e-4;
  w.speed = 1e-2;
  const Advice a = advise(w, table());
  EXPECT_NEAR(a.mach, 0.1, 1e-9);
  EXPECT_NE(a.binds_dt.find("Mach"), std::string::npos);
  w.smallest = w.mean = 8e-4;
  const Advice b = advise(w, table());
  EXPECT_NEAR(b.compressibility, 0.00140625, 1e-9);
  EXPECT_NE(b.binds_dt.find("compressibility"), std::string::npos);
}

// 30 Pa at dx = 60 um: the density changes by 3 dp (dt/dx)^2/rho; half of that may be a quarter of
// the error .04 (3/3.5)^2 = .029388: .7347 %; Mach and error of a speed of .06 m/s beside
TEST(Plan, PressureLimitsTheChangeOfDensity)
{
  Wish w = wish();
  w.dx = 60e-6;
  w.smallest = 3.5 * 60e-6;
  w.mean = 300e-6;
  w.speed = 0.06;
  w.pressure = 30.0;
  const Advice a = advise(w, table());
  const double slope = std::sqrt(0.029388 / 4.0 / (0.06 * 0.06 + 1.5 * 0.03));
  EXPECT_NEAR(a.units.dt, slope * 60e-6, 1e-4 * a.units.dt);
  EXPECT_NEAR(a.excess, 3.0 * 0.03 * slope * slope, 1e-4 * a.excess);
  EXPECT_NEAR(a.tau, 0.5 + 3e-6 * slope / 60e-6, 1e-6);
}

// k = d^2 (1-phi)^3/(180 phi^2): d = 1 mm, phi = .6: 9.877e-10 m2; with H = 10 mm and 3 Pa
// the flux is .2963 mm/s, .7407 mm/s in the pores, eight times that 5.926 mm/s
TEST(Plan, SpeedAndDiffusionOfABed)
{
  EXPECT_NEAR(carman_kozeny(1e-3, 0.6), 9.8765e-10, 1e-13);
  Wish w = wish();
  w.dx = 60e-6;
  w.speed = 0.0;
  w.pressure = 3.0;
  w.fraction = 0.6;
  w.height = 0.01;
  const Advice a = advise(w, table());
  ASSERT_EQ(a.refusal, "");
  EXPECT_NEAR(a.speed, 0.005926, 1e-6);
  const double cs = a.units.sound_speed();
  EXPECT_NEAR(a.diffusion, 0.4 * 1e-6 * 1e-4 / (9.8765e-10 * cs * cs), 1e-3 * a.diffusion);
  // a run of ten such times would do; one of two must have a shorter step
  w.time = 2.0 * a.diffusion;
  const Advice b = advise(w, table());
  EXPECT_NEAR(b.diffusion, w.time / 10.0, 1e-6 * w.time);
  EXPECT_NE(b.binds_dt.find("pressure through the bed"), std::string::npos);
}

// dx must divide 2.4 x 2.4 x 7.2 mm: 4.9 mm ... wished .99e-4 gives 25 cells along x
TEST(Plan, SpacingDividesTheBox)
{
  Wish w = wish();
  w.box = {2.4e-3, 2.4e-3, 7.2e-3};
  w.error = 0.02;    // .8 of it by the lattice: r = 3 sqrt(.04/.016) = 4.743 cells, dx = .10541 mm
  const Advice a = advise(w, table());
  ASSERT_EQ(a.refusal, "");
  EXPECT_EQ(a.nodes, (Int3{23, 23, 69}));
  EXPECT_LE(a.error(), 0.02 * (1 + 1e-9));
  w.error = 0.0;
  w.dx = 0.99e-4;
  const std::string why = advise(w, table()).refusal;
  EXPECT_NE(
      why.find("does not divide all lengths of the box: nearest that do are 9.6e-05 and 0.0001;"),
      std::string::npos)
      << why;
  w.box = {2.4e-3, 2.4e-3 * std::sqrt(2.0), 7.2e-3};
  w.dx = 1e-4;
  EXPECT_NE(advise(w, table()).refusal.find("or make the box 0.0024 x 0.0034 x 0.0072"),
            std::string::npos)
      << advise(w, table()).refusal;
}

// what the error wants is not what the rules ask for
TEST(Plan, RulesBindBeforeTheError)
{
  Wish w = wish();
  w.error = 0.2;
  const Advice a = advise(w, table());
  EXPECT_NEAR(w.smallest / a.units.dx, RADIUS_WARN, 1e-6);
  // fast: tau >= .51 at sqrt(share) = u dt/dx needs a small dx
  w.error = 0.02;
  w.speed = 1.0;
  const Advice b = advise(w, table());
  EXPECT_NEAR(b.tau, TAU_LOW, 1e-6);
  EXPECT_NE(b.binds_dx.find("relaxation time"), std::string::npos);
  EXPECT_LE(b.error(), 0.02);
}

// The nearest possible is possible, and a little more is not
TEST(Plan, RefusesTheImpossibleWithTheNearest)
{
  Wish w = wish();
  w.dx = 1e-4;
  w.speed = 10.0;    // tau - 1/2 = sqrt(3) Ma nu/(u dx) = 1.7e-4
  std::string why = advise(w, table()).refusal;
  // u = .1 sqrt(3) nu/(.01 dx) = .173205 m/s, dx = .1 sqrt(3) nu/(.01 u) = 1.73205 um
  EXPECT_NE(why.find("dx <= 1.73205e-06, or speed <= 0.173205"), std::string::npos) << why;
  w.speed = 0.1732;
  EXPECT_EQ(advise(w, table()).refusal, "");
  w.speed = 0.1733;
  EXPECT_NE(advise(w, table()).refusal, "");
  w = wish();
  w.dx = 1e-4;
  w.pressure = 1000.0;    // .05 rho/3 (3 nu/(.01 dx))^2 = 150 Pa
  why = advise(w, table()).refusal;
  EXPECT_NE(why.find("or a pressure <= 150"), std::string::npos) << why;
  w.pressure = 149.0;
  EXPECT_EQ(advise(w, table()).refusal, "");
  w = wish();
  w.dx = 3e-4;
  why = advise(w, table()).refusal;
  EXPECT_NE(why.find("the nearest possible is dx = 0.00025, good is dx <= 0.000142857"),
            std::string::npos)
      << why;
  w.dx = 2.5e-4;
  EXPECT_EQ(advise(w, table()).refusal, "");
  w = wish();
  w.dx = 1e-4;
  w.speed = 0.1;
  w.tau = 1.0;    // Ma = .1 at tau = .5 + .1 sqrt(3) nu/(u dx) = .51732
  why = advise(w, table()).refusal;
  EXPECT_NE(why.find("the nearest is 0.517321 (Mach number 0.1)"), std::string::npos) << why;
  w.tau = 0.505;
  EXPECT_NE(advise(w, table()).refusal.find("the nearest is 0.51"), std::string::npos);
}

// No other spacing and step reach the wished error with fewer updates
TEST(Plan, NoOtherChoiceIsCheaper)
{
  Wish w = wish();
  w.error = 0.01;
  w.speed = 5e-3;    // neither tau nor the Mach number is a limit
  const Advice a = advise(w, table());
  const double dx = a.units.dx, dt = a.units.dt;
  EXPECT_LE(a.error(), w.error * (1 + 2e-3));
  auto error = [&](double x, double t) {
    return 0.04 * std::pow(3.0 * x / w.smallest, 2) + std::pow(w.speed * t / x, 2);
  };
  EXPECT_NEAR(error(dx, dt), a.error(), 1e-6);
  double best = 1e300;
  for (double x = 0.5 * dx; x < 1.2 * dx; x += 0.001 * dx) {
    const double left = w.error - error(x, 0.0);
    if (left <= 0.0) continue;
    const double t = std::sqrt(left) * x / w.speed;
    best = std::min(best, 1.0 / (x * x * x * t));
  }
  EXPECT_NEAR(1.0 / (dx * dx * dx * dt) / best, 1.0, 0.01);
}

TEST(Plan, SecondsAddUp)
{
  Advice a;
  a.fluid_steps = 1000;
  a.every = 20;
  const Pace pace{5e-9, 20e-9, 160.0};
  EXPECT_NEAR(seconds_of_run(a, {1e5, 2e4, 3e-6}, pace), 1000 * (5e-4 + 4e-4 + 6e-5), 1e-12);
}

// r = 5.3 cells on the lattice of the bench: 1992 links were counted, some hidden from each other
TEST(PlanPace, LinksOfASphereAndADisc)
{
  EXPECT_NEAR(links_of_sphere(5.275, 3), 1992, 0.01 * 1992);
  PaceSample sample;
  sample.n = {24, 24, 24};
  for (int dimension : {2, 3}) {
    sample.dimension = dimension;
    double sum = 0.0;
    for (int k = 0; k < 8; k++) {
      Settings settings;
      settings.dimension = dimension;
      const Int3 n{24, 24, dimension == 2 ? 1 : 24};
      Alone alone({true, true, dimension == 3});
      const auto fluid = Fluid::create(settings, {}, n, n, alone);
      fluid->fill(0.0);
      std::vector<Load> loads;
      fluid->follow(
          {{1, {12 + 0.31 * k, 12 + 0.13 * k, dimension == 2 ? 0.0 : 12 + 0.07 * k}, 6.3, {}, {}}});
      fluid->advance(loads);
      sum += fluid->links() / 8;
    }
    EXPECT_NEAR(links_of_sphere(6.3, dimension) / sum, 1.0, 0.02) << dimension;
  }
}

// A measurement gives times and bytes that can be true: a node has 19 or 9 numbers
TEST(PlanPace, MeasuresSomethingSensible)
{
  for (int dimension : {2, 3}) {
    PaceSample sample;
    sample.dimension = dimension;
    sample.n = {40, 40, dimension == 2 ? 1 : 40};
    sample.radius = 5.0;
    sample.fraction = 0.5;
    Alone alone({true, true, dimension == 3});
    const Pace pace = measure_pace(sample, 0, 1, alone);
    const double populations = dimension == 2 ? 9 * 8 : 19 * 8;
    EXPECT_GT(pace.bytes, populations);
    EXPECT_LT(pace.bytes, populations + 60);
    EXPECT_GT(pace.node, 1e-10);
    EXPECT_LT(pace.node, 1e-5);
    // 3 x 3 discs, or 3 x 3 x 3 body-centred cells; they save at most the sweep of what they cover
    const double nodes = dimension == 2 ? 1600 : 64000, spheres = dimension == 2 ? 9 : 54;
    EXPECT_GT(pace.link * spheres * links_of_sphere(5.0, dimension), -0.55 * nodes * pace.node);
    EXPECT_LT(pace.link, 1e-4);
  }
}

}    // namespace
