// SPDX-License-Identifier: GPL-2.0-only
// Interpolated links swallow mass or add to it; with refunds what grains swallow comes back.

#include "scene.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

const LinkRule RULES[] = {LinkRule::BOUZIDI, LinkRule::CLI, LinkRule::ZHAO};

// face-centred cubic cells of 15 nodes, moved off the lattice: solid fraction .74, with gaps
std::vector<Sphere> bed(double x, double y, double z, int layers)
{
  const double basis[4][3] = {{.1, .13, .17}, {.6, .63, .17}, {.6, .13, .67}, {.1, .63, .67}};
  std::vector<Sphere> list;
  for (int k = 0; k < layers; k++)
    for (const auto &b : basis)
      list.push_back(scene::sphere(std::int64_t(list.size()),
                                   {x + 15 * b[0], y + 15 * b[1], z + 15 * (k + b[2])},
                                   5.3 - 0.1 * (list.size() % 3)));
  return list;
}

struct Change {
  double mass;    // of the fluid, from the first step to the last
  double step;    // largest within one step without refunds: what one step may lose
};

Change change_of_mass(LinkRule rule, bool conserve)
{
  Settings s;
  s.tau = 0.525;
  s.link = rule;
  scene::Box box(s, {15, 15, 30}, {0.0, 0.0, 5e-5});
  box.conserve = conserve;
  const auto grains = bed(0.0, 0.0, 0.0, 2);
  box.step(grains);
  const double before = box.fluid->survey().mass;
  double step = 0.0;
  for (int t = 0; t < 400; t++) {
    box.step(grains);
    double swallowed = 0.0;
    for (const Load &load : box.loads) swallowed += load.swallowed;
    step = std::max(step, std::abs(swallowed));
  }
  return {box.fluid->survey().mass - before, step};
}

TEST(Mass, IsKeptByRefundsAndOnlyByThem)
{
  for (LinkRule rule : RULES) {
    const Change with = change_of_mass(rule, true), without = change_of_mass(rule, false);
    EXPECT_LT(std::abs(with.mass), 2.0 * with.step);
    EXPECT_GT(std::abs(without.mass), 15.0 * without.step);
  }
}

// what is swallowed is all that the fluid loses
TEST(Mass, LossesAreAccountedFor)
{
  for (LinkRule rule : RULES) {
    Settings s;
    s.link = rule;
    scene::Box box(s, {15, 15, 15}, {1e-4, 0.0, 5e-5});
    box.step(bed(0.0, 0.0, 0.0, 1));
    for (int t = 0; t < 5; t++) {
      const double before = box.fluid->survey().mass;
      box.step(bed(0.0, 0.0, 0.0, 1));
      double swallowed = 0.0;
      for (const Load &load : box.loads) swallowed += load.swallowed;
      EXPECT_NEAR(box.fluid->survey().mass - before, -swallowed, 1e-11);
      EXPECT_NE(swallowed, 0.0);
    }
  }
}

// evenly spread, a refund presses on all sides alike: force of the driven fluid on the grains, as ever
TEST(Mass, RefundsGiveNoForceAndKeepMomentum)
{
  for (LinkRule rule : RULES) {
    Settings s;
    s.tau = 0.6;
    s.link = rule;
    const Vec3 force{2e-5, 0.0, 5e-5};
    scene::Box box(s, {15, 15, 15}, force);
    box.conserve = true;
    const auto grains = bed(0.0, 0.0, 0.0, 1);
    Survey before = box.fluid->survey();
    for (int t = 0; t < 50; t++) {
      box.step(grains);
      const Survey now = box.fluid->survey();
      for (int d = 0; d < 3; d++) {
        double on_grains = 0.0;
        for (const Load &load : box.loads) on_grains += load.force[d];
        if (t > 0)    // half a force comes with the first cover
          EXPECT_NEAR(now.momentum[d] - before.momentum[d], force[d] * now.fluid_nodes - on_grains,
                      1e-13);
      }
      before = now;
    }
  }
}

// a column between pressure faces: what goes in comes out
TEST(Mass, FluxThroughABedIsTheSameOnBothSides)
{
  Settings s;
  s.tau = 1.0;
  for (int side = 0; side < 2; side++) {
    s.faces[2][side].kind = FaceKind::PRESSURE;
    s.faces[2][side].drho = side == 0 ? 0.015 : -0.015;
  }
  double loss[2];
  for (bool conserve : {false, true}) {
    scene::Box box(s, {15, 15, 50});
    box.conserve = conserve;
    const auto grains = bed(0.0, 0.0, 10.0, 2);
    double flux[2] = {};    // below and above the bed, mean over planes and steps: sound rings
    for (int t = 0; t < 3000; t++) {
      box.step(grains);
      if (t < 2000) continue;
      const Planes sums = box.fluid->planes(2, 50);
      for (int k = 1; k < 8; k++)
        for (int z : {k, 49 - k})
          flux[z > 25] += sums.velocity[z] * (1.0 + sums.drho[z] / sums.fluid[z]);
    }
    loss[conserve] = 1.0 - flux[1] / flux[0];
  }
  EXPECT_GT(std::abs(loss[0]), 5e-3);
  EXPECT_LT(std::abs(loss[1]), 1e-3);
}

}    // namespace
