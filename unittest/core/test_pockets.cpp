// SPDX-License-Identifier: GPL-2.0-only
// A fluid node that spheres enclose on all sides, or all but one: its pressure must not depend on how the last
// steps pumped it, because water, unlike the lattice, finds a way out.

#include "scene.h"

#include <gtest/gtest.h>

#include <set>

using namespace lbm;

namespace {

constexpr int N = 16;
constexpr double DRHO = 0.01;
constexpr double SPEED = 0.002;

class Pocket : public testing::TestWithParam<int> {
 protected:
  Settings settings;
  Int3 n{N, N, GetParam() == 3 ? N : 1};

  Pocket() { settings.dimension = GetParam(); }

  // Small spheres on all neighbours of a node but those numbered in open, drawn closer by squeeze;
  // those outside the box are left out.
  std::vector<Sphere> cage(const Int3 &node, const std::set<int> &open, double squeeze,
                           double speed) const
  {
    std::vector<Sphere> list;
    int number = 0;
    for (int z = -1; z <= 1; z++)
      for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
          const Int3 e{x, y, z};
          if ((GetParam() == 2 && z != 0) || std::abs(x) + std::abs(y) + std::abs(z) > 2 ||
              (x == 0 && y == 0 && z == 0))
            continue;
          bool inside = open.count(number++) == 0;
          Vec3 c;
          for (int d = 0; d < 3; d++) {
            const int p = node[d] + e[d];
            inside = inside && p >= 0 && p < n[d];
            c[d] = p + 0.5 - squeeze * e[d];
          }
          if (!inside) continue;
          list.push_back(scene::sphere(number, c, 0.45, {speed, 0.0, 0.0}));
          list.back().drho = DRHO;
        }
    return list;
  }
  int neighbours() const { return GetParam() == 3 ? 18 : 8; }

  // what is in the node after it was squeezed and released
  Moments pumped(const Int3 &node, const std::set<int> &open, double squeeze, double speed)
  {
    Alone alone(scene::periodic(settings));
    auto fluid = Fluid::create(settings, {0, 0, 0}, n, n, alone);
    std::vector<Load> loads;
    for (int t = 0; t < 7; t++) {
      const auto list = cage(node, open, squeeze * (t % 3), speed);
      fluid->follow(list);
      fluid->advance(loads);
      EXPECT_FALSE(fluid->solid(node[0], node[1], node[2]));
    }
    return fluid->moments(node[0], node[1], node[2]);
  }
  Int3 middle() const { return {8, 8, n[2] / 2}; }
};

void is_like_its_surroundings(const Moments &m, double speed)
{
  EXPECT_NEAR(m.drho, DRHO, 1e-15);
  EXPECT_NEAR(m.u[0], speed, 1e-15);
  EXPECT_NEAR(m.u[1], 0.0, 1e-15);
}

TEST_P(Pocket, HasTheDensityAndVelocityOfItsSurroundings)
{
  is_like_its_surroundings(pumped(middle(), {}, 1e-3, SPEED), SPEED);
}

// links that are kept keep their pockets
TEST_P(Pocket, IsOneAtRestToo)
{
  is_like_its_surroundings(pumped(middle(), {}, 0.0, 0.0), 0.0);
}

// with the velocity of its spheres, but the mass it had
TEST_P(Pocket, IsADeadEndWithOneFluidNeighbour)
{
  for (int open = 0; open < neighbours(); open++) {
    const Moments m = pumped(middle(), {open}, 1e-3, SPEED);
    EXPECT_NEAR(m.u[0], SPEED, 1e-15) << open;
    EXPECT_NEAR(m.u[1], 0.0, 1e-15) << open;
    EXPECT_LT(std::abs(m.drho), 0.5 * DRHO) << open;    // and not that around the spheres
  }
}

TEST_P(Pocket, ADeadEndKeepsMass)
{
  settings.link = LinkRule::HALFWAY;
  scene::Box box(settings, n);
  box.for_each_node([&](int x, int y, int z) {
    box.fluid->set_equilibrium(x, y, z, scene::some_flow({x, y, z}, n, GetParam()));
  });
  box.step(cage(middle(), {3}, 0.0, 0.0));
  const double mass = box.fluid->survey().mass;
  for (int t = 0; t < 50; t++) box.step(cage(middle(), {3}, 0.0, 0.0));
  EXPECT_NEAR(box.fluid->survey().mass, mass, 1e-14 * mass);
  const Int3 m = middle();
  EXPECT_LT(std::abs(box.at(m[0], m[1], m[2]).u[0]), 1e-15);
}

TEST_P(Pocket, IsNoneWithTwoFluidNeighbours)
{
  for (int open = 1; open < neighbours(); open++) {
    const Moments m = pumped(middle(), {open, open / 2}, 1e-3, SPEED);
    EXPECT_GT(std::abs(m.u[0] - SPEED), 1e-5) << open;
  }
}

// rows are read 62 nodes at a time
TEST_P(Pocket, IsFoundAtEveryPlaceOfARow)
{
  n[0] = 140;
  for (int x : {1, 60, 61, 62, 63, 64, 122, 123, 124, 125, 138})
    is_like_its_surroundings(pumped({x, 8, n[2] / 2}, {}, 1e-3, SPEED), SPEED);
}

// a wall of the box shuts it as well; a face where water comes in does not
TEST_P(Pocket, MayHaveAWallOnOneSide)
{
  for (int d = 0; d < GetParam(); d++)
    for (int side = 0; side < 2; side++) {
      Int3 node = middle();
      node[d] = side == 0 ? 0 : n[d] - 1;
      settings.faces = {};
      for (Face &face : settings.faces[d]) face.kind = FaceKind::WALL;
      is_like_its_surroundings(pumped(node, {}, 1e-3, 0.0), 0.0);
      settings.faces[d][side].kind = FaceKind::PRESSURE;
      EXPECT_NEAR(pumped(node, {}, 1e-3, 0.0).drho, 0.0, 1e-15) << d << " " << side;
    }
}

INSTANTIATE_TEST_SUITE_P(Dimension, Pocket, testing::Values(2, 3));

}    // namespace
