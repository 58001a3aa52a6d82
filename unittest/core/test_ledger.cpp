// SPDX-License-Identifier: GPL-2.0-only
// The mass ledger: what is booked is what the fluid gains, to round-off, whatever the scene; and the
// mean density of a closed box that is kept by it.

#include "scene.h"

#include <gtest/gtest.h>

#include <string>

using namespace lbm;

namespace {

// what of a scene is there: dimension, precision, faces along the last direction, wall rule
struct What {
  int dimension;
  bool single;
  FaceKind face[2];
  LinkRule link;
};

std::vector<What> all()
{
  std::vector<What> list;
  const FaceKind P = FaceKind::PERIODIC, W = FaceKind::WALL, O = FaceKind::PRESSURE,
                 V = FaceKind::VELOCITY;
  for (int dimension : {2, 3})
    for (bool single : {false, true})
      for (const auto &face : {std::array<FaceKind, 2>{P, P}, {W, W}, {O, W}, {V, O}})
        for (LinkRule link : {LinkRule::CLI, LinkRule::BOUZIDI, LinkRule::HALFWAY})
          list.push_back({dimension, single, {face[0], face[1]}, link});
  return list;
}

class LedgerOf : public testing::TestWithParam<What> {
 protected:
  const What what = GetParam();
  const int last = what.dimension - 1;
  Int3 n{26, 24, what.dimension == 3 ? 25 : 1};
  Settings settings;

  LedgerOf()
  {
    settings.dimension = what.dimension;
    settings.single = what.single;
    settings.link = what.link;
    settings.tau = 0.7;
    for (int side = 0; side < 2; side++) {
      Face &face = settings.faces[last][side];
      face.kind = what.face[side];
      face.drho = 0.01;
      if (face.kind == FaceKind::VELOCITY) face.u[last] = 0.01;
      // walls that move along themselves, and meet the faces
      settings.faces[0][side].kind = FaceKind::WALL;
      settings.faces[0][side].u[last == 2 ? 1 : 0] = last == 2 ? 0.02 * side : 0.0;
    }
  }

  // a crowd that moves and turns, through faces and into each other
  std::vector<Sphere> crowd() const
  {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<Sphere> list;
    for (int z = 0; z < (what.dimension == 3 ? 3 : 1); z++)
      for (int y = 0; y < 3; y++)
        for (int x = 0; x < 3; x++) {
          const Vec3 c{8.5 * x + 4.3 + unit(random), 8.0 * y + 4.1 + unit(random),
                       what.dimension == 3 ? 8.3 * z + 4.0 + unit(random) : 0.0};
          const double flat = what.dimension == 3 ? 1.0 : 0.0;
          const Vec3 v{0.06 * unit(random), 0.06 * unit(random), 0.06 * flat * unit(random)};
          const Vec3 spin{0.01 * flat * unit(random), 0.01 * flat * unit(random),
                          0.01 * unit(random)};
          list.push_back(
              scene::sphere(std::int64_t(list.size()), c, 4.0 + 0.3 * unit(random), v, spin));
        }
    return list;
  }
};

TEST_P(LedgerOf, AllThatTheFluidGains)
{
  scene::Box box(settings, n, {1e-5, 2e-5, what.dimension == 3 ? -1e-5 : 0.0});
  box.conserve = true;
  box.for_each_node([&](int x, int y, int z) {
    box.fluid->set_equilibrium(x, y, z, scene::some_flow({x, y, z}, n, what.dimension));
  });
  const double start = box.fluid->survey().mass;
  // what single precision rounds: 2^-24 of populations of some hundredths, at every node and step
  const double close = what.single ? 2e-7 * start : 1e-13 * start;
  double gross = 0.0;
  for (int t = 0; t < 40; t++) {
    box.step(scene::drifted(crowd(), t));
    const Ledger ledger = box.fluid->ledger();
    ASSERT_NEAR(box.fluid->survey().mass - start, ledger.total(), close) << "step " << t;
    gross = 0.0;
    for (int k = 0; k < Ledger::ACCOUNTS; k++) gross += std::abs(ledger.gain(k));
  }
  // and not because nothing happened
  const Ledger ledger = box.fluid->ledger();
  EXPECT_GT(gross, 1e3 * close);
  for (int k : {Ledger::COVERED, Ledger::REFILLED, Ledger::DISPLACED})
    EXPECT_GT(std::abs(ledger.gain(k)), 1e2 * close) << k;
  for (int side = 0; side < 2; side++) {
    const double through = ledger.gain(Ledger::FACES + 2 * last + side);
    if (what.face[side] == FaceKind::PRESSURE || what.face[side] == FaceKind::VELOCITY)
      EXPECT_GT(std::abs(through), 1e2 * close) << side;
    else
      EXPECT_EQ(through, 0.0) << side;
  }
  EXPECT_EQ(ledger.gain(Ledger::RESTORED), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Scene, LedgerOf, testing::ValuesIn(all()));

}    // namespace
