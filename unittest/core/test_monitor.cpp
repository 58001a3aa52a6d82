// SPDX-License-Identifier: GPL-2.0-only
// The survey of the whole fluid against its nodes one by one: sums, extremes, what is wrong.

#include "scene.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lbm;

namespace {

constexpr double NAN_VALUE = std::numeric_limits<double>::quiet_NaN();

// moments drawn at random, on rows that are no whole number of packs, some of their nodes solid
struct Drawn {
  scene::Box box;
  std::mt19937 random{7};

  Drawn(int dimension, bool single, const Vec3 &force, bool solids) :
      box(settings(dimension, single), dimension == 3 ? Int3{21, 6, 5} : Int3{37, 9, 1}, force)
  {
    if (solids) {
      const double middle = dimension == 3 ? 2.0 : 0.0;
      box.follow(
          {scene::sphere(1, {4.2, 2.5, middle}, 2.2), scene::sphere(2, {15.1, 3.5, middle}, 2.9)});
    }
    std::uniform_real_distribution<double> draw(-0.05, 0.05);
    box.for_each_node([&](int x, int y, int z) {
      Moments m{draw(random), {draw(random), draw(random), draw(random)}};
      if (dimension == 2) m.u[2] = 0.0;
      box.fluid->set_equilibrium(x, y, z, m);
    });
  }
  static Settings settings(int dimension, bool single)
  {
    Settings s;
    s.dimension = dimension;
    s.single = single;
    return s;
  }
};

void expect_sums_of_nodes(const scene::Box &box)
{
  Survey sum;
  sum.speed.value = 0.0;
  sum.drho_min.value = 1.0;
  sum.drho_max.value = -1.0;
  box.for_each_node([&](int x, int y, int z) {
    if (box.fluid->solid(x, y, z)) return;
    const Moments m = box.fluid->moments(x, y, z);
    sum.fluid_nodes += 1.0;
    sum.mass += 1.0 + m.drho;
    for (int d = 0; d < 3; d++) {
      sum.momentum[d] += (1.0 + m.drho) * m.u[d];
      sum.velocity[d] += m.u[d];
    }
    const double speed = std::sqrt(dot(m.u, m.u));
    if (speed > sum.speed.value) sum.speed = {speed, {x, y, z}};
    if (m.drho < sum.drho_min.value) sum.drho_min = {m.drho, {x, y, z}};
    if (m.drho > sum.drho_max.value) sum.drho_max = {m.drho, {x, y, z}};
  });
  const Survey s = box.fluid->survey();
  EXPECT_FALSE(s.bad);
  EXPECT_EQ(s.fluid_nodes, sum.fluid_nodes);
  EXPECT_NEAR(s.mass, sum.mass, 1e-13 * sum.mass);
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(s.momentum[d], sum.momentum[d], 1e-13 * sum.fluid_nodes);
    EXPECT_NEAR(s.velocity[d], sum.velocity[d], 1e-13 * sum.fluid_nodes);
  }
  for (auto extreme : {&Survey::speed, &Survey::drho_min, &Survey::drho_max}) {
    EXPECT_NEAR((s.*extreme).value, (sum.*extreme).value, 1e-15);
    EXPECT_EQ((s.*extreme).p, (sum.*extreme).p);
  }
}

TEST(Monitor, SumsAndExtremesAreThoseOfTheNodes)
{
  for (int dimension : {2, 3})
    for (bool single : {false, true})
      for (bool solids : {false, true})
        for (const Vec3 &force : {Vec3{}, Vec3{1e-3, -2e-3, 0.0}}) {
          Drawn drawn(dimension, single, force, solids);
          expect_sums_of_nodes(drawn.box);
          drawn.box.advance();    // populations lie differently in memory then
          expect_sums_of_nodes(drawn.box);
        }
}

// in a whole pack of a row and in what is left of it
TEST(Monitor, WhatIsWrongIsLeftOutOfSumsAndExtremes)
{
  for (int x : {1, 20})
    for (double drho : {NAN_VALUE, std::numeric_limits<double>::infinity(), -1.0, -1.5}) {
      Drawn drawn(3, false, {}, true);
      drawn.box.fluid->set_equilibrium(x, 0, 0, {0.0, {}});
      const Survey before = drawn.box.fluid->survey();
      drawn.box.fluid->set_equilibrium(x, 0, 0, {drho, {}});
      const Survey s = drawn.box.fluid->survey();
      EXPECT_TRUE(s.bad);
      EXPECT_EQ(s.bad_node, (Int3{x, 0, 0}));
      EXPECT_EQ(s.fluid_nodes, before.fluid_nodes);
      EXPECT_NEAR(s.mass, before.mass, 1e-12 * before.mass);
      EXPECT_EQ(s.speed.p, before.speed.p);
      EXPECT_EQ(s.drho_min.p, before.drho_min.p);
      EXPECT_EQ(s.drho_max.p, before.drho_max.p);
    }
}

TEST(Monitor, SolidsOnly)
{
  Settings s;
  s.faces[0][0].kind = s.faces[0][1].kind = FaceKind::WALL;
  s.faces[1] = s.faces[2] = s.faces[0];
  scene::Box box(s, {6, 6, 6});
  box.follow({scene::sphere(1, {2.5, 2.5, 2.5}, 9.0)});
  const Survey survey = box.fluid->survey();
  EXPECT_FALSE(survey.bad);
  EXPECT_EQ(survey.fluid_nodes, 0.0);
  EXPECT_EQ(survey.mass, 0.0);
  EXPECT_EQ(survey.speed.value, 0.0);
}

}    // namespace
