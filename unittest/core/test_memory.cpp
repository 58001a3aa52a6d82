// SPDX-License-Identifier: GPL-2.0-only
// Bytes a node, for what a scene holds.

#include "scene.h"

#include <gtest/gtest.h>

using namespace lbm;
using namespace scene;

namespace {

// face-centred cubic bed of solid fraction .6; grains of 10 cells
constexpr int N = 91, CELLS = 6;
constexpr double RADIUS = 5.0;

std::vector<Sphere> bed(double velocity)
{
  const double basis[4][3] = {{.1, .13, .17}, {.6, .63, .17}, {.6, .13, .67}, {.1, .63, .67}};
  const double cell = double(N) / CELLS;
  std::vector<Sphere> list;
  for (int i = 0; i < CELLS; i++)
    for (int j = 0; j < CELLS; j++)
      for (int k = 0; k < CELLS; k++)
        for (const auto &b : basis)
          list.push_back(sphere(std::int64_t(list.size()),
                                {(i + b[0]) * cell, (j + b[1]) * cell, (k + b[2]) * cell}, RADIUS,
                                {velocity, 0.0, 0.0}));
  return list;
}

double bytes_a_node(double velocity, int steps, bool single = false)
{
  Settings settings;
  settings.single = single;
  Box box(settings, {N, N, N});
  for (int t = 0; t < steps; t++) box.step(drifted(bed(velocity), t));
  return box.fluid->bytes() / std::pow(N, 3);
}

TEST(Memory, IsOneCopyOfThePopulationsWithoutGrains)
{
  EXPECT_LT(bytes_a_node(0.0, 0), 19 * 8 * 1.08);    // ghosts are 7 % of the nodes
}

TEST(Memory, OfADenseBedStaysBelow200BytesANode)
{
  EXPECT_LT(bytes_a_node(0.0, 2), 200.0);
  EXPECT_LT(bytes_a_node(0.01, 3), 200.0);
}

TEST(Memory, OfADenseBedInSinglePrecisionStaysBelow120BytesANode)
{
  EXPECT_LT(bytes_a_node(0.0, 2, true), 120.0);
  EXPECT_LT(bytes_a_node(0.01, 3, true), 120.0);
}

}    // namespace
