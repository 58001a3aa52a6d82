// SPDX-License-Identifier: GPL-2.0-only
// Spheres that yield: what the response says that a sphere gets less if it is faster, the fluid
// gets when told; it is a third more than what all links would have made of it.

#include "lbm_yield.h"
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

// of the fluid, with its moment about a point, from the images that are nearest to it
struct Momentum {
  double mass = 0.0;
  Vec3 linear{}, angular{};
};
Momentum momentum(const scene::Box &box, const Vec3 &about)
{
  Momentum sum;
  box.for_each_fluid_node([&](int x, int y, int z) {
    const Moments m = box.at(x, y, z);
    Vec3 arm{x + 0.5 - about[0], y + 0.5 - about[1], z + 0.5 - about[2]}, j;
    for (int d = 0; d < 3; d++) {
      arm[d] -= box.n[d] * std::nearbyint(arm[d] / box.n[d]);
      j[d] = (1.0 + m.drho) * m.u[d];
    }
    const Vec3 turn = cross(arm, j);
    sum.mass += m.drho;
    for (int d = 0; d < 3; d++) {
      sum.linear[d] += j[d];
      sum.angular[d] += turn[d];
    }
  });
  return sum;
}

// of sphere 0, which moves on from where it is; returns its response
Response check_what_the_fluid_gets(const Case &c, const Int3 &n, const std::vector<Sphere> &grains)
{
  scene::Box box(settings(c), n);
  box.step(grains);
  box.for_each_node([&](int x, int y, int z) {
    box.fluid->set_equilibrium(x, y, z, scene::some_flow({x, y, z}, n, c.dimension));
  });
  const auto list = scene::drifted(grains, 1);
  box.step(list);
  const Response r = total(box);
  const auto less = times(r, GAIN);
  std::vector<Gain> gains(box.now.spheres.size());
  for (std::size_t k = 0; k < gains.size(); k++)
    if (box.now.grain[k] == 0) gains[k] = GAIN;    // the other, if it yields, goes as it went

  const Momentum before = momentum(box, list[0].centre);
  const Ledger booked_before = box.fluid->ledger();
  box.fluid->correct(gains);
  const Momentum after = momentum(box, list[0].centre);
  const Ledger booked = box.fluid->ledger();
  const double near = c.single ? 2e-6 : 1e-13;
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(after.linear[d] - before.linear[d], less[d], near);
    EXPECT_NEAR(after.angular[d] - before.angular[d], less[3 + d], 10 * near);
  }
  EXPECT_GT(less[0], 0.1);    // there is something to compare
  EXPECT_GT(less[5], 0.1);
  EXPECT_NEAR(after.mass - before.mass, booked.total() - booked_before.total(), near);
  double swallowed = 0.0;
  const auto x = numbers(GAIN);
  for (int d = 0; d < 6; d++) swallowed += r.swallowed[d] * x[d];
  EXPECT_NEAR(booked.gain(Ledger::SWALLOWED) - booked_before.gain(Ledger::SWALLOWED), -swallowed,
              near);
  return r;
}

TEST_P(Yield, TheFluidGetsWhatTheSphereDoesNot)
{
  check_what_the_fluid_gets(GetParam(), n, pair(GetParam(), 0.02));
}

// with as many links as without the neighbour, if all count alike
TEST(Yield, InGapsOfDiscsToo)
{
  const Int3 n{22, 17, 1};
  for (LinkRule rule : {LinkRule::HALFWAY, LinkRule::BOUZIDI, LinkRule::CLI, LinkRule::ZHAO}) {
    const Case c{2, rule, true, false};
    auto list = pair(c, 0.001);
    for (bool yields : {false, true}) {
      list[1].centre = {list[0].centre[0] + 3.4 + 3.9 + 1.2, list[0].centre[1], 0.5};
      list[1].yields = yields;
      scene::Box box(settings(c), n);
      box.step(list);
      EXPECT_GT(box.fluid->gaps(), 0.0);
      const Response close = check_what_the_fluid_gets(c, n, list);
      list[1].centre[0] += 2.0;
      const Response apart = check_what_the_fluid_gets(c, n, list);
      if (rule == LinkRule::HALFWAY) EXPECT_NEAR(close.zeta[0] / apart.zeta[0], 1.0, 1e-12);
    }
  }
}

// Links along the axes for all: in the mean over places of the sphere, and at each of them not less
TEST_P(Yield, RespondsAThirdMoreThanAllLinks)
{
  const Case c = GetParam();
  double ours = 0.0, ours_of_spin = 0.0, all = 0.0, all_of_spin = 0.0;
  for (int place = 0; place < 6; place++) {
    scene::Box slow(settings(c), n), faster(settings(c), n);
    auto list = pair(c, 0.0);
    for (int d = 0; d < c.dimension; d++)
      list[0].centre[d] = snap(list[0].centre[d] + 0.17 * place * (d + 1));
    slow.step(list);
    gain(list[0], SLOW);
    faster.step(list);
    const auto less = times(total(slow), SLOW);
    Vec3 less_of_all, less_of_all_spin;
    for (int d = 0; d < 3; d++) {
      less_of_all[d] = slow.loads[0].force[d] - faster.loads[0].force[d];
      less_of_all_spin[d] = slow.loads[0].torque[d] - faster.loads[0].torque[d];
    }
    for (int d = 0; d < 2; d++) EXPECT_GT(less[d] / less_of_all[d], 1.0) << place << d;
    EXPECT_GT(less[5] / less_of_all_spin[2], 1.0) << place;
    ours += less[0] - 0.5 * less[1];    // along the gain
    all += less_of_all[0] - 0.5 * less_of_all[1];
    ours_of_spin += less[5];
    all_of_spin += less_of_all_spin[2];
  }
  const double mean = c.dimension == 3 ? ANSWER<D3Q19> / (1.0 + 2.0 * std::sqrt(2.0))
                                       : ANSWER<D2Q9> / (1.0 + 1.0 / std::sqrt(2.0));
  EXPECT_GT(mean, 1.3);
  EXPECT_NEAR(ours / all, mean, 0.08);
  EXPECT_NEAR(ours_of_spin / all_of_spin, mean, 0.12);
}

std::vector<double> populations(const scene::Box &box)
{
  const Part all{{0, 0, 0}, box.n};
  std::vector<double> values(std::size_t(box.fluid->directions()) * all.nodes());
  box.fluid->give(all, values.data());
  return values;
}

// A fluid that goes on from the state of another finds the answers of a step it has not made, in
// gaps and through the faces of the box too, in tiles and without.
TEST(Yield, IsFoundAnewToTheBit)
{
  for (int dimension : {2, 3})
    for (const Int3 &tile : {Int3{8, 5, 6}, Int3{22, 17, 15}}) {
      const Case c{dimension, LinkRule::CLI, true, false};
      Settings with = settings(c);
      with.tile = tile;
      const Int3 n{22, 17, dimension == 3 ? 15 : 1};
      auto list = pair(c, 0.02);
      const Vec3 at = list[0].centre;    // its neighbours on either side yield not
      list[1].centre = {at[0] + 3.4 + 3.9 + 1.2, at[1], at[2]};
      list.push_back(scene::sphere(2, {at[0] - 3.4 - 2.2 - 1.2, at[1], at[2]}, 2.2));
      scene::Box box(with, n), other(with, n);
      for (int t = 0; t < 3; t++) box.step(scene::drifted(list, t));
      EXPECT_GT(box.fluid->gaps(), 0.0);

      const Part all{{0, 0, 0}, n};
      const auto state = populations(box);
      other.fluid->take(all, state.data());
      Counts counts;
      counts.ledger = box.fluid->ledger();
      counts.mean = box.fluid->mean_density();
      other.fluid->resume(box.fluid->own_spheres(), counts);
      for (scene::Box *b : {&box, &other}) {
        std::vector<Gain> gains;
        for (const Sphere &s : b->fluid->spheres())
          gains.push_back({{1e-3 * double(s.id + 1), 2e-3, 0.0}, {0.0, 0.0, 1e-3}});
        b->fluid->correct(gains);
      }
      EXPECT_NE(populations(box), state);
      EXPECT_EQ(populations(other), populations(box));
      EXPECT_EQ(other.fluid->ledger().numbers(), box.fluid->ledger().numbers());
    }
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
