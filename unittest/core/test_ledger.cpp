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

// an obstacle is covered from the start, and grains that run into it cover no more than the rest
TEST(LedgerWith, Obstacles)
{
  Settings s;
  s.tau = 0.7;
  s.hold_mean = true;
  scene::Box box(s, {20, 18, 17}, {1e-5, 0, 2e-5});
  Shape wall;
  wall.inside = [](const Vec3 &x) {
    return x[0] > 12.3 && x[0] < 15.4;
  };
  wall.velocity = {0, 1e-2, 0};
  const double start = box.fluid->survey().mass;
  box.fluid->set_obstacles({wall});
  const std::vector<Sphere> grain{
      scene::sphere(1, {7.3, 8.1, 9.8}, 3.7, {0.05, 0.02, 0}, {0, 0, 1e-3})};
  for (int t = 0; t < 60; t++) {
    box.step(scene::drifted(grain, t));
    ASSERT_NEAR(box.fluid->survey().mass - start, box.fluid->ledger().total(), 1e-13 * start) << t;
  }
  EXPECT_GT(box.fluid->ledger().covered, 3 * 18 * 17);
}

// ---- the mean density of a closed box

class ClosedBox : public testing::TestWithParam<std::pair<int, bool>> {
 protected:
  const int dimension = GetParam().first;
  const bool single = GetParam().second;
  const Int3 n = dimension == 3 ? Int3{34, 17, 17} : Int3{54, 54, 1};
  Settings settings;

  ClosedBox()
  {
    settings.dimension = dimension;
    settings.single = single;
    settings.tau = 0.7;
  }

  // A dense bed, every grain on a path of its own: solid fraction .53, in two dimensions .57
  std::vector<Sphere> bed(int t) const
  {
    const double basis[4][3] = {{.1, .13, .25}, {.6, .63, .25}, {.6, .13, .75}, {.1, .63, .75}};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Sphere> list;
    for (int k = 0; k < (dimension == 3 ? 8 : 16); k++) {
      const double *b = basis[k % 4];
      Vec3 c{17 * (k / 4 + b[0]), 17 * b[1], 17 * b[2]}, v{};
      if (dimension == 2) c = {13.5 * (k % 4) + 6.7, 13.5 * (k / 4) + 6.7, 0.5};
      const double r = 5.3 + (dimension == 3 ? 0.3 : 0.5) * unit(random);
      for (int d = 0; d < dimension; d++) {
        const double far = 0.12 + 0.12 * unit(random), w = 8e-3 + 8e-3 * unit(random);
        const double phase = 2.0 * M_PI * unit(random);
        c[d] += far * std::sin(w * t + phase);
        v[d] = far * w * std::cos(w * t + phase);
      }
      list.push_back(scene::sphere(k, c, r, v, {0.0, 0.0, 1e-3}));
    }
    return list;
  }

  static double mean_excess(const Survey &s) { return (s.mass - s.fluid_nodes) / s.fluid_nodes; }

  // how far the mean density has gone in a thousand steps, the mean of some as it rings
  double drift(bool hold, double excess)
  {
    settings.hold_mean = hold;
    scene::Box box(settings, n);
    box.conserve = true;
    box.fluid->fill(excess);
    double mean[2] = {};
    for (int t = 0; t < 1200; t++) {
      box.follow(bed(t));
      if (t % 100 == 0) box.fluid->inspect();
      box.advance();
      if (t < 200 || t >= 1000) mean[t >= 1000] += mean_excess(box.fluid->survey()) / 200.0;
    }
    if (hold) EXPECT_NEAR(mean[0], excess, 1e-5);
    const Ledger ledger = box.fluid->ledger();
    EXPECT_EQ(ledger.gain(Ledger::RESTORED) != 0.0, hold);
    const double start = (1.0 + excess) * n[0] * n[1] * n[2], end = box.fluid->survey().mass;
    EXPECT_NEAR(end - start, ledger.total(), (single ? 1e-7 : 1e-13) * start);
    return std::abs(mean[1] - mean[0]);
  }
};

TEST_P(ClosedBox, KeepsItsMeanDensityIfWanted)
{
  const double with = drift(true, 0.0), without = drift(false, 0.0);
  EXPECT_LT(with, 1e-6);
  EXPECT_GT(without, 1e-5);
}

// that at which the grains began to move, whatever it was
TEST_P(ClosedBox, AtWhicheverDensityItBegan)
{
  EXPECT_LT(drift(true, 0.01), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Scene, ClosedBox,
                         testing::Values(std::make_pair(2, false), std::make_pair(2, true),
                                         std::make_pair(3, false)));

// what is given is at rest, and presses on no side more than on another
TEST(MeanDensity, IsKeptWithoutForceOrMomentum)
{
  Vec3 force[2], momentum[2];
  for (bool hold : {false, true}) {
    Settings s;
    s.tau = 0.7;
    s.hold_mean = hold;
    scene::Box box(s, {24, 20, 20});
    box.conserve = true;
    const std::vector<Sphere> grain{scene::sphere(1, {12.3, 10.1, 9.8}, 6.2, {2e-3, 1e-3, 0})};
    for (int t = 0; t < 300; t++) box.step(scene::drifted(grain, t));
    force[hold] = box.loads[0].force;
    momentum[hold] = box.fluid->survey().momentum;
    EXPECT_EQ(box.fluid->ledger().gain(Ledger::RESTORED) != 0.0, hold);
  }
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(force[1][d], force[0][d], 1e-4 * scene::norm(force[0]));
    EXPECT_NEAR(momentum[1][d], momentum[0][d], 1e-4 * scene::norm(momentum[0]));
  }
}

// nor where water can come and go, nor where nothing moves
TEST(MeanDensity, IsLeftAloneWhereItNeedNotBeKept)
{
  for (bool open : {false, true}) {
    Settings s;
    s.hold_mean = true;
    if (open) s.faces[2][0].kind = s.faces[2][1].kind = FaceKind::PRESSURE;
    scene::Box box(s, {20, 18, 22}, {1e-5, 0, 2e-5});
    const std::vector<Sphere> grain{
        scene::sphere(1, {9.3, 8.1, 9.8}, 5.2, {open ? 2e-3 : 0.0, 0, 0}, {0, 0, 1e-3})};
    for (int t = 0; t < 50; t++) box.step(scene::drifted(grain, t));
    EXPECT_EQ(box.fluid->ledger().gain(Ledger::RESTORED), 0.0);
    EXPECT_NE(box.fluid->ledger().gain(Ledger::SWALLOWED), 0.0);
  }
}

}    // namespace
