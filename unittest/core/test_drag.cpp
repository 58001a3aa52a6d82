// SPDX-License-Identifier: GPL-2.0-only
// Force and torque on grains against known values, fixed and moving.

#include "scene.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

struct Drag {
  double K;          // F / (6 pi mu a U) of spheres, F / (mu U) of discs; U superficial
  double balance;    // force on the grain / driving force - 1
};

// Periodic cell of n nodes with one fixed sphere or disc of radius a, driven by a body force so weak
// that inertia is of no account. The flow sets in as exp(-t/T), T ~ .06 n^2/nu: "times" counts T.
Drag array_drag(int dimension, LinkRule rule, double tau, int n, double a, const Vec3 &offset,
                double times)
{
  Settings s;
  s.dimension = dimension;
  s.tau = tau;
  s.link = rule;
  const double accel = 1e-9, nu = (tau - 0.5) / 3.0, volume = std::pow(n, dimension);
  scene::Box box(s, {n, n, dimension == 3 ? n : 1}, {accel, 0.0, 0.0});
  Vec3 c{0.5, 0.5, 0.5};
  for (int d = 0; d < dimension; d++) c[d] = n / 2 + offset[d];
  const std::vector<Sphere> grain{scene::sphere(1, c, a)};
  for (int t = int(times * 0.06 * n * n / nu); t > 0; t--) box.step(grain);
  // the mean of two steps: a staggered part of the start stays with CLI and two rates
  double F = 0.5 * box.loads[0].force[0];
  box.step(grain);
  F += 0.5 * box.loads[0].force[0];
  const Survey survey = box.fluid->survey();
  const double U = survey.velocity[0] / volume;
  return {accel * volume / (nu * U * (dimension == 3 ? 6.0 * M_PI * a : 1.0)),
          F / (accel * survey.fluid_nodes) - 1.0};
}

// places of a grain in its cell of the lattice, spread evenly
Vec3 offset(int k)
{
  auto part = [&](double x) {
    return x * (k + 1) - std::floor(x * (k + 1));
  };
  return {part(0.8191725), part(0.6710436), part(0.5497005)};    // R3 sequence
}

// Zick & Homsy 1982: K = 4.292 at a solid fraction of 1/8. One place scatters by .15 %; the mean of
// eight is .3 % below with CLI (.06 % at 15 cells per diameter), 1.3 % with Bouzidi.
TEST(Drag, SimpleCubicArray)
{
  constexpr int n = 20, places = 8;    // 12.4 cells per diameter
  const double a = n * std::cbrt(0.125 * 3.0 / (4.0 * M_PI));
  double mean = 0.0;
  for (int k = 0; k < places; k++)
    mean += array_drag(3, LinkRule::CLI, 0.8, n, a, offset(k), 8.0).K / places;
  EXPECT_NEAR(mean / 4.292, 1.0, 0.006);
  double bouzidi = 0.0;
  for (int k = 0; k < 2; k++)
    bouzidi += array_drag(3, LinkRule::BOUZIDI, 0.8, n, a, offset(k), 8.0).K / 2;
  EXPECT_NEAR(bouzidi / 4.292, 1.0, 0.025);
}

// steady: all that drives the fluid arrives at the grain. And K does not know the viscosity with CLI
// and half-way walls; with Bouzidi's it does, by 8 % here.
TEST(Drag, SteadyForceAndViscosity)
{
  constexpr int n = 9;
  const double a = n * std::cbrt(0.125 * 3.0 / (4.0 * M_PI));
  for (LinkRule rule : {LinkRule::HALFWAY, LinkRule::BOUZIDI, LinkRule::CLI}) {
    std::vector<double> K;
    for (double tau : {0.6, 0.8, 1.5}) {
      const Drag drag = array_drag(3, rule, tau, n, a, {0.1, 0.2, 0.3}, 40.0);
      EXPECT_NEAR(drag.balance, 0.0, 1e-10);
      K.push_back(drag.K);
    }
    const double spread = std::max(std::abs(K[1] / K[0] - 1.0), std::abs(K[2] / K[0] - 1.0));
    if (rule == LinkRule::BOUZIDI) {
      EXPECT_GT(spread, 0.02);
    } else {
      EXPECT_LT(spread, 1e-6);    // products of velocities of 1e-8
    }
  }
}

// Three spheres in a periodic cell, less than a cell from one another: nodes with a wall on either
// side along a link. Where the second node of a rule is missing, what the wall opposite gives is put
// in: of the rates nothing but Lambda gets in, so that neither the flow nor the share that a sphere
// has of the drag knows the viscosity.
TEST(Drag, OfSpheresWithNarrowGapsAtAnyViscosity)
{
  constexpr int n = 15;
  const std::vector<Sphere> bed{scene::sphere(1, {4.3, 5.1, 7.6}, 3.7),
                                scene::sphere(2, {11.9, 5.4, 7.2}, 3.5),
                                scene::sphere(3, {8.2, 11.2, 9.4}, 3.4)};
  for (LinkRule rule : {LinkRule::HALFWAY, LinkRule::CLI}) {
    std::array<double, 4> first{};    // flow over force, and the three shares
    for (double tau : {0.55, 0.8, 1.5}) {
      Settings s;
      s.tau = tau;
      s.link = rule;
      const double nu = (tau - 0.5) / 3.0, accel = 1e-7 * nu * nu;    // Re = 1e-7
      scene::Box box(s, {n, n, n}, {accel, 0.0, 0.0});
      box.conserve = true;    // else density grows, and what hidden links get is a step late
      std::array<double, 3> drag{};
      const int steps = int(n * n / nu);
      for (int t = 0; t < steps; t++) {
        box.step(bed);
        if (t < steps - 2) continue;    // the mean of two steps
        for (int k = 0; k < 3; k++) drag[k] += 0.5 * box.loads[k].force[0];
      }
      ASSERT_GT(box.fluid->gaps(), 20.0);
      const Survey survey = box.fluid->survey();
      const double driven = accel * survey.fluid_nodes;
      const std::array<double, 4> found{nu * survey.velocity[0] / driven, drag[0] / driven,
                                        drag[1] / driven, drag[2] / driven};
      EXPECT_NEAR(found[1] + found[2] + found[3], 1.0, 1e-8);
      if (first[0] == 0.0) first = found;
      for (int k = 0; k < 4; k++)
        EXPECT_NEAR(found[k] / first[k], 1.0, 1e-7) << "number " << k << ", tau " << tau;
    }
  }
}

// Square array of discs at a solid fraction of .2: F/(mu U) = 51.53 (Sangani & Acrivos 1982)
TEST(Drag, SquareArrayOfDiscsConverges)
{
  auto error = [](LinkRule rule, int n, double &mean) {    // root mean square over places
    constexpr int places = 6;
    const double a = n * std::sqrt(0.2 / M_PI);
    double square = 0.0;
    mean = 0.0;
    for (int k = 0; k < places; k++) {
      const double e = array_drag(2, rule, 0.8, n, a, offset(k), 4.0).K / 51.53 - 1.0;
      square += e * e / places;
      mean += e / places;
    }
    return std::sqrt(square);
  };
  double mean;
  for (LinkRule rule : {LinkRule::HALFWAY, LinkRule::BOUZIDI, LinkRule::CLI, LinkRule::ZHAO}) {
    const double coarse = error(rule, 10, mean), fine = error(rule, 30, mean),
                 order = std::log(coarse / fine) / std::log(3.0);
    if (rule == LinkRule::HALFWAY) {
      EXPECT_LT(order, 1.5);
    } else {
      EXPECT_GT(order, 1.6);
      EXPECT_LT(fine, 0.012);
    }
  }
}

// T = 8 pi mu a^3 w of a sphere, 4 pi mu a^2 w of a disc (per depth) that turns on the spot. In a
// periodic box the mean vorticity is zero, which makes it turn against -phi w more: T/(1 - phi).
TEST(Drag, TorqueOnATurningGrain)
{
  auto torque = [](int dimension, LinkRule rule) {
    constexpr int n = 20, places = 4;
    const double a = 5.0, w = 1e-7;
    const double phi = dimension == 3 ? 4.0 * M_PI / 3.0 * std::pow(a / n, 3)
                                      : M_PI * a * a / (n * n);
    Settings s;
    s.dimension = dimension;
    s.link = rule;
    const double mu = (s.tau - 0.5) / 3.0,
                 exact = (dimension == 3 ? 8.0 * a : 4.0) * M_PI * mu * a * a * w / (1.0 - phi);
    double mean = 0.0;
    for (int k = 0; k < places; k++) {
      scene::Box box(s, {n, n, dimension == 3 ? n : 1});
      Vec3 c{n / 2 + offset(k)[0], n / 2 + offset(k)[1], 0.5}, spin{0.0, 0.0, w};
      if (dimension == 3) c[2] = n / 2 + offset(k)[2];
      int axis = 2;
      if (dimension == 3) {    // each axis in turn
        axis = k % 3;
        spin = {};
        spin[axis] = w;
      }
      for (int t = 0; t < 1200; t++) box.step({scene::sphere(1, c, a, {}, spin)});
      Load two = box.loads[0];
      box.step({scene::sphere(1, c, a, {}, spin)});
      for (int d = 0; d < 3; d++) {
        two.force[d] = 0.5 * (two.force[d] + box.loads[0].force[d]);
        two.torque[d] = 0.5 * (two.torque[d] + box.loads[0].torque[d]);
        EXPECT_NEAR(two.force[d], 0.0, 2e-3 * exact / a);
        EXPECT_NEAR(d == axis ? 0.0 : two.torque[d], 0.0, 5e-3 * exact);
      }
      mean -= two.torque[axis] / exact / places;
    }
    return mean;
  };
  EXPECT_NEAR(torque(2, LinkRule::CLI), 1.0, 0.005);
  EXPECT_NEAR(torque(3, LinkRule::CLI), 1.0, 0.01);
  EXPECT_NEAR(torque(2, LinkRule::BOUZIDI), 1.0, 0.015);
  EXPECT_NEAR(torque(3, LinkRule::BOUZIDI), 1.0, 0.03);
}

// Grain, walls and fluid drift together by V, and a force drives the fluid past the grain: its drag
// over the relative velocity is that of the fixed grain
TEST(Drag, DoesNotFeelACommonDrift)
{
  auto run = [](LinkRule rule, double V) {
    Settings s;
    s.link = rule;
    for (Face &face : s.faces[2]) {
      face.kind = FaceKind::WALL;
      face.u = {V, 0.0, 0.0};
    }
    scene::Box box(s, {20, 16, 18}, {1e-5, 0.0, 0.0});
    box.for_each_node([&](int x, int y, int z) {
      box.fluid->set_equilibrium(x, y, z, {0.0, {V, 0.0, 0.0}});
    });
    const std::vector<Sphere> grain{scene::sphere(1, {8.13, 8.29, 9.41}, 4.1, {V, 0.0, 0.0})};
    const int steps = 900, window = 100;    // at V = .05 over five cells
    double F = 0.0, U = 0.0;
    for (int t = 0; t < steps; t++) {
      box.step(scene::drifted(grain, t));
      if (t < steps - window) continue;
      const Survey survey = box.fluid->survey();
      F += box.loads[0].force[0];
      U += survey.velocity[0] / survey.fluid_nodes - V;
    }
    return F / U;
  };
  // what is left is the lattice's own error in Galilean invariance, of order V^2
  for (LinkRule rule : {LinkRule::CLI, LinkRule::BOUZIDI, LinkRule::ZHAO}) {
    const double rest = run(rule, 0.0);
    for (double V : {0.05, -0.1}) {
      const double drift = run(rule, V);
      EXPECT_NEAR(drift / rest, 1.0, 1.5 * V * V);
    }
  }
}

struct Noise {
  double bias, rms, rms_two;    // of the force, relative; of the mean of two steps
};

// A sphere that moves between plates, against the same at rest with plates and fluid moving past
Noise moving_against_fixed(const Settings &rules)
{
  constexpr double U = 0.04;
  constexpr int steps = 700, start = 300;
  const Int3 n{44, 22, 24};
  auto run = [&](bool moving) {
    Settings s = rules;
    s.tau = 0.63;
    for (Face &face : s.faces[2]) {
      face.kind = FaceKind::WALL;
      face.u = {moving ? 0.0 : -U, 0.0, 0.0};
    }
    scene::Box box(s, n);
    box.for_each_node([&](int x, int y, int z) {
      box.fluid->set_equilibrium(x, y, z, {0.0, {moving ? 0.0 : -U, 0.0, 0.0}});
    });
    const std::vector<Sphere> grain{
        scene::sphere(1, {12.3, 11.0, 12.0}, 4.0, {moving ? U : 0.0, 0.0, 0.0})};
    std::vector<double> force;
    for (int t = 0; t < steps; t++) {
      box.step(scene::drifted(grain, t));
      force.push_back(box.loads[0].force[0]);
    }
    return force;
  };
  const auto fixed = run(false), moving = run(true);
  Noise noise{};
  for (int t = start; t < steps; t++) {
    const double one = moving[t] / fixed[t] - 1.0,
                 two = (moving[t] + moving[t - 1]) / (fixed[t] + fixed[t - 1]) - 1.0;
    noise.bias += one / (steps - start);
    noise.rms += one * one / (steps - start);
    noise.rms_two += two * two / (steps - start);
  }
  noise.rms = std::sqrt(noise.rms);
  noise.rms_two = std::sqrt(noise.rms_two);
  return noise;
}

// Eight cells per diameter, where eleven gave a bias of -.2 % and 1.3 to 1.8 % of noise: errors of
// covering and uncovering nodes grow as their share of the surface
TEST(Drag, MovingSphereFeelsWhatAFixedOneFeels)
{
  Settings paper, grad, trt, normal;
  paper.bgk = grad.bgk = normal.bgk = true;
  paper.link = grad.link = normal.link = LinkRule::BOUZIDI;
  paper.refill = RefillRule::EQUILIBRIUM;
  normal.refill = RefillRule::NORMAL;
  const Noise a = moving_against_fixed(paper), b = moving_against_fixed(grad),
              c = moving_against_fixed(trt);
  EXPECT_LT(moving_against_fixed(normal).rms, 0.9 * a.rms);
  for (const Noise &noise : {a, b, c}) EXPECT_LT(std::abs(noise.bias), 0.008);
  EXPECT_LT(a.rms, 0.025);
  EXPECT_LT(b.rms, 0.8 * a.rms);    // what Grad's approximation is for
  EXPECT_LT(a.rms_two, 0.02);
  EXPECT_LT(b.rms_two, 0.015);
  EXPECT_LT(c.rms_two, 0.03);
}

// A sphere moves along the bottom of a heavy column of fluid, where the density is 3 % above the mean:
// nodes refilled with the mean of the system get a hole in the pressure, those with the local one none
TEST(Drag, LocalRefillLeavesThePressureInPlace)
{
  const auto noise = [](RefillRule rule) {
    Settings s;
    s.refill = rule;
    s.faces[2][0].kind = s.faces[2][1].kind = FaceKind::WALL;
    const double g = 1e-3, U = 0.01;
    const Int3 n{30, 18, 24};
    scene::Box box(s, n, {0.0, 0.0, -g});
    box.for_each_node([&](int x, int y, int z) {
      box.fluid->set_equilibrium(x, y, z, {std::exp(-3.0 * g * (z - 11.5)) - 1.0, {}});
    });
    const std::vector<Sphere> grain{scene::sphere(1, {9.1, 9.2, 6.3}, 4.1, {U, 0.0, 0.0})};
    std::vector<double> lift;    // mean of two steps
    Vec3 before{};
    for (int t = 0; t < 400; t++) {
      box.step(scene::drifted(grain, t));
      if (t > 200) lift.push_back(0.5 * (before[2] + box.loads[0].force[2]));
      before = box.loads[0].force;
    }
    double rms = 0.0;
    for (std::size_t t = 1; t + 1 < lift.size(); t++)
      rms += std::pow(lift[t + 1] - 2.0 * lift[t] + lift[t - 1], 2) / double(lift.size());
    return std::sqrt(rms);
  };
  const double system = noise(RefillRule::EQUILIBRIUM);
  for (RefillRule rule : {RefillRule::LOCAL, RefillRule::NORMAL, RefillRule::GRAD})
    EXPECT_LT(noise(rule), 0.5 * system);
}

}    // namespace
