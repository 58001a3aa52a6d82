// SPDX-License-Identifier: GPL-2.0-only
// A fluid node that spheres enclose on all sides: its pressure must not depend on how the last
// steps pumped it, because water, unlike the lattice, finds a way out.

#include "lbm_solver.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

constexpr int N = 16;

// spheres (discs) of radius 1.75 at distance 1.8 on both sides of node 8 along every axis: they
// cover its neighbours, not the node
std::vector<Sphere> cage(int dimension, double squeeze, double drho)
{
  std::vector<Sphere> list;
  for (int d = 0; d < dimension; d++)
    for (int sense : {-1, 1}) {
      Sphere s{
          d * 2 + (sense + 1) / 2, {8.5, 8.5, dimension == 3 ? 8.5 : 0.5}, 1.75, {0.002, 0, 0}, {}};
      s.centre[d] = snap(s.centre[d] + sense * (1.8 + squeeze));
      s.drho = drho;
      list.push_back(s);
    }
  return list;
}

class Pocket : public testing::TestWithParam<int> {
 protected:
  std::unique_ptr<Fluid> fluid(Neighbours &neighbours)
  {
    Settings s;
    s.dimension = GetParam();
    const Int3 n{N, N, GetParam() == 3 ? N : 1};
    return Fluid::create(s, {0, 0, 0}, n, n, neighbours);
  }
  int z() const { return GetParam() == 3 ? 8 : 0; }
};

TEST_P(Pocket, HasTheDensityAndVelocityOfItsSurroundings)
{
  Alone periodic({true, true, true});
  const auto water = fluid(periodic);
  std::vector<Load> loads;
  for (int t = 0; t < 40; t++) {
    water->follow(cage(GetParam(), 1e-3 * (t % 3), 0.01));    // squeezed and released
    water->advance(loads);
    ASSERT_FALSE(water->solid(8, 8, z()));
    const Moments m = water->moments(8, 8, z());
    ASSERT_NEAR(m.drho, 0.01, 1e-15);
    ASSERT_NEAR(m.u[0], 0.002, 1e-15);
    ASSERT_NEAR(m.u[1], 0.0, 1e-15);
  }
}

TEST_P(Pocket, IsNoneWhileOneNeighbourIsFluid)
{
  Alone periodic({true, true, true});
  const auto water = fluid(periodic);
  std::vector<Load> loads;
  auto open = cage(GetParam(), 0.0, 0.01);
  open.pop_back();
  water->follow(open);
  water->advance(loads);
  EXPECT_GT(std::abs(water->moments(8, 8, z()).drho - 0.01), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Dimension, Pocket, testing::Values(2, 3));

}    // namespace
