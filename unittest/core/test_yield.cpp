// SPDX-License-Identifier: GPL-2.0-only
// Spheres that yield: told of a gain of velocity afterwards, the fluid is where it would be had the
// sphere moved so in the first place, and the response says what its load would have been.

#include "scene.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

struct Case {
  int dimension;
  LinkRule rule;
  bool moving, single;
};

Settings settings(const Case &c)
{
  Settings s;
  s.dimension = c.dimension;
  s.tau = 0.7;
  s.link = c.rule;
  s.single = c.single;
  s.tile = {16, 6, 6};
  return s;
}

const Gain GAIN{{0.01, -0.02, 0.0}, {0.0, 0.0, 0.003}}, SLOW{{1e-6, -2e-6, 0.0}, {0.0, 0.0, 3e-7}};

// two spheres far enough from each other to share no gap; the first one yields
std::vector<Sphere> pair(const Case &c, double speed)
{
  const double z = c.dimension == 3 ? 8.2 : 0.5;
  std::vector<Sphere> list{scene::sphere(0, {6.3, 7.1, z}, 3.4),
                           scene::sphere(1, {15.6, 8.4, z}, 3.9)};
  list[0].yields = true;
  if (c.moving) list[0].velocity = {speed, 0.5 * speed, 0.0};
  return list;
}

void gain(Sphere &s, const Gain &by)
{
  for (int d = 0; d < 3; d++) {
    s.velocity[d] += by.velocity[d];
    s.spin[d] += by.spin[d];
  }
}

std::array<double, 6> numbers(const Gain &g)
{
  return {g.velocity[0], g.velocity[1], g.velocity[2], g.spin[0], g.spin[1], g.spin[2]};
}

std::array<double, 6> times(const Response &r, const Gain &by)
{
  const auto x = numbers(by);
  std::array<double, 6> y{};
  for (int i = 0, n = 0; i < 6; i++)
    for (int j = 0; j <= i; j++, n++) {
      y[i] += r.zeta[n] * x[j];
      if (j < i) y[j] += r.zeta[n] * x[i];
    }
  return y;
}

Response total(const scene::Box &box)
{
  Response sum;
  const auto &parts = box.fluid->responses();
  for (std::size_t k = 0; k < parts.size(); k++) {
    if (box.now.grain[k] != 0) continue;
    for (int n = 0; n < Response::SIZE; n++) sum.zeta[n] += parts[k].zeta[n];
    for (int d = 0; d < 6; d++) sum.swallowed[d] += parts[k].swallowed[d];
  }
  return sum;
}

class Yield : public ::testing::TestWithParam<Case> {
 protected:
  Int3 n = GetParam().dimension == 3 ? Int3{22, 17, 15} : Int3{22, 17, 1};
};

TEST_P(Yield, CorrectedFluidIsThatOfTheFasterSphere)
{
  const Case c = GetParam();
  scene::Box faster(settings(c), n, {1e-4, 0.0, 0.0}), told(settings(c), n, {1e-4, 0.0, 0.0});
  const auto grains = pair(c, 0.02);
  for (scene::Box *box : {&faster, &told}) {
    box->step(grains);    // it has moved in the next
    box->for_each_node(
        [&](int x, int y, int z) {    // a flow at rest density, which the response has
          Moments m = scene::some_flow({x, y, z}, n, c.dimension);
          m.drho = 0.0;
          box->fluid->set_equilibrium(x, y, z, m);
        });
  }
  auto list = scene::drifted(grains, 1);
  told.step(list);
  gain(list[0], GAIN);
  faster.step(list);
  std::vector<Gain> gains(told.now.spheres.size());
  for (std::size_t k = 0; k < gains.size(); k++)
    if (told.now.grain[k] == 0) gains[k] = GAIN;
  const Response r = total(told);
  double swallowed = told.loads[0].swallowed;
  const auto x = numbers(GAIN);
  for (int d = 0; d < 6; d++) swallowed += r.swallowed[d] * x[d];
  const double near = c.single ? 3e-7 : 1e-14;
  EXPECT_NEAR(swallowed, faster.loads[0].swallowed, 100 * near);

  told.fluid->correct(gains);
  double largest = 0.0;
  told.for_each_fluid_node([&](int x, int y, int z) {
    const Moments a = faster.at(x, y, z), b = told.at(x, y, z);
    EXPECT_NEAR(a.drho, b.drho, near);
    for (int d = 0; d < 3; d++) EXPECT_NEAR(a.u[d], b.u[d], near);
    largest = std::max(largest, std::abs(b.u[1]));
  });
  EXPECT_GT(largest, 1e-3);    // there is something to compare
}

TEST_P(Yield, WhatTheSphereWouldGetIsWhatTheFluidGives)
{
  const Case c = GetParam();
  scene::Box slow(settings(c), n), faster(settings(c), n);
  auto list = pair(c, 0.0);
  slow.step(list);
  gain(list[0], SLOW);
  faster.step(list);
  const Response r = total(slow);
  const auto less = times(r, SLOW);
  const double near = (c.single ? 1e-4 : 1e-5) * std::abs(less[1]);
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(faster.loads[0].force[d] - slow.loads[0].force[d], -less[d], near);
    EXPECT_NEAR(faster.loads[0].torque[d] - slow.loads[0].torque[d], -less[3 + d], 4 * near);
  }
  EXPECT_GT(less[0], 0.0);
  EXPECT_GT(less[5], 0.0);

  std::vector<Gain> gains(slow.now.spheres.size());
  for (std::size_t k = 0; k < gains.size(); k++)
    if (slow.now.grain[k] == 0) gains[k] = SLOW;
  const Survey before = slow.fluid->survey();
  slow.fluid->correct(gains);
  const Survey after = slow.fluid->survey();
  for (int d = 0; d < 3; d++)
    EXPECT_NEAR(after.momentum[d] - before.momentum[d], less[d], c.single ? 1e-7 : 1e-15);
}

TEST(Yield, NothingIsKeptOfSpheresThatDoNot)
{
  const Case c{3, LinkRule::CLI, true, false};
  const Int3 n{22, 17, 15};
  scene::Box box(settings(c), n);
  auto list = pair(c, 0.02);
  list[0].yields = false;
  box.step(list);
  const double without = box.fluid->bytes();
  EXPECT_TRUE(box.fluid->responses().empty());
  list[0].yields = true;
  box.step(list);
  EXPECT_EQ(box.fluid->responses().size(), box.now.spheres.size());
  EXPECT_GT(box.fluid->bytes(), without);
}

std::vector<Case> cases()
{
  std::vector<Case> list;
  for (int dimension : {2, 3})
    for (LinkRule rule : {LinkRule::HALFWAY, LinkRule::BOUZIDI, LinkRule::CLI, LinkRule::ZHAO})
      for (bool moving : {false, true}) list.push_back({dimension, rule, moving, false});
  list.push_back({3, LinkRule::CLI, true, true});
  return list;
}

INSTANTIATE_TEST_SUITE_P(Spheres, Yield, ::testing::ValuesIn(cases()));

}    // namespace
