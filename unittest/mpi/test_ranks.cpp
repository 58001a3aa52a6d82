// SPDX-License-Identifier: GPL-2.0-only
// The solver core on every brick of ranks against the same scene on one process, which every rank
// runs for itself.

#include "../core/scene.h"

#include "lbm_neighbours_mpi.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

// this rank's part of a brick of ranks
struct Part {
  Int3 lo, n;
  std::array<std::array<int, 2>, 3> rank;
};

// Nodes are dealt out unevenly on purpose: the first ranks get one more
Part part_of(const Int3 &brick, const Int3 &n, const Settings &settings)
{
  int me;
  MPI_Comm_rank(MPI_COMM_WORLD, &me);
  const Int3 place{me % brick[0], me / brick[0] % brick[1], me / brick[0] / brick[1]};
  Part part{};
  for (int d = 0; d < 3; d++) {
    auto start = [&](int k) {
      return k * (n[d] / brick[d]) + std::min(k, n[d] % brick[d]);
    };
    part.lo[d] = start(place[d]);
    part.n[d] = start(place[d] + 1) - part.lo[d];
    for (int side = 0; side < 2; side++) {
      Int3 p = place;
      p[d] += side == 0 ? -1 : 1;
      const bool beyond = p[d] < 0 || p[d] >= brick[d];
      p[d] = (p[d] + brick[d]) % brick[d];
      part.rank[d][side] = beyond && !scene::periodic(settings)[d]
          ? MPI_PROC_NULL
          : p[0] + brick[0] * (p[1] + brick[1] * p[2]);
    }
  }
  return part;
}

std::vector<Int3> bricks(int dimension, const Int3 &n)
{
  int ranks;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<Int3> list;
  for (int x = 1; x <= ranks; x++)
    for (int y = 1; y <= ranks; y++)
      for (int z = 1; z <= ranks; z++)
        if (x * y * z == ranks && x <= n[0] && y <= n[1] && z <= n[2] && (dimension == 3 || z == 1))
          list.push_back({x, y, z});
  Int3 dims{0, 0, dimension == 3 ? 0 : 1};    // and the one that MPI would choose is among them
  MPI_Dims_create(ranks, 3, dims.data());
  EXPECT_TRUE(std::find(list.begin(), list.end(), dims) != list.end() || dims[0] > n[0]);
  return list;
}

struct Scene {
  Settings settings;
  Int3 n;
  Vec3 force;
  std::vector<Sphere> grains;
  int steps;
  int enclosed = 0;    // nodes, more than so many
};

// mass of the flow that scenes start with
double scene_start(const Scene &scene)
{
  double mass = 0.0;
  for (int z = 0; z < scene.n[2]; z++)
    for (int y = 0; y < scene.n[1]; y++)
      for (int x = 0; x < scene.n[0]; x++)
        mass += 1.0 + scene::some_flow({x, y, z}, scene.n, scene.settings.dimension).drho;
  return mass;
}

// Every node's arithmetic is the same on any number of ranks; only sums over links, and the float
// arithmetic of compilers for packs and for single numbers, may differ in the last digit
void same_on_every_brick(const Scene &scene)
{
  const double close = scene.settings.single ? 1e-7 : 1e-13;
  for (const Int3 &brick : bricks(scene.settings.dimension, scene.n)) {
    scene::Box one(scene.settings, scene.n, scene.force);
    const Part part = part_of(brick, scene.n, scene.settings);
    MpiNeighbours neighbours(MPI_COMM_WORLD, part.rank);
    auto fluid = Fluid::create(scene.settings, part.lo, part.n, scene.n, neighbours);
    fluid->set_force(scene.force);
    one.for_each_node([&](int x, int y, int z) {
      const Moments m = scene::some_flow({x, y, z}, scene.n, scene.settings.dimension);
      one.fluid->set_equilibrium(x, y, z, m);
      const Int3 p{x - part.lo[0], y - part.lo[1], z - part.lo[2]};
      if (fluid->layout().owned(p[0], p[1], p[2])) fluid->set_equilibrium(p[0], p[1], p[2], m);
    });
    const std::string where = "brick " + std::to_string(brick[0]) + " " + std::to_string(brick[1]) +
        " " + std::to_string(brick[2]);
    std::vector<double> drho(scene.grains.size(), 0.0);
    for (int t = 0; t < scene.steps; t++) {
      auto grains = scene::drifted(scene.grains, t);
      for (std::size_t s = 0; s < grains.size(); s++) grains[s].drho = drho[s];
      one.follow(grains);
      const scene::Images here = scene::images(grains, scene.settings, part.lo, part.n, scene.n);
      fluid->follow(here.spheres);
      if (t % 7 == 0) {
        one.fluid->inspect();
        fluid->inspect();
        ASSERT_EQ(fluid->enclosed_sets(), one.fluid->enclosed_sets()) << where << " step " << t;
        ASSERT_EQ(fluid->enclosed_nodes(), one.fluid->enclosed_nodes()) << where << " step " << t;
      }
      one.advance();
      std::vector<Load> parts;
      fluid->advance(parts);
      std::vector<double> loads(6 * grains.size() + 1, 0.0), around(2 * grains.size() + 1, 0.0);
      for (std::size_t k = 0; k < parts.size(); k++)
        for (int d = 0; d < 3; d++) {
          loads[6 * here.grain[k] + d] += parts[k].force[d];
          loads[6 * here.grain[k] + 3 + d] += parts[k].torque[d];
        }
      for (std::size_t k = 0; k < parts.size(); k++) {
        around[2 * here.grain[k]] += parts[k].pressing;
        around[2 * here.grain[k] + 1] += parts[k].area;
      }
      neighbours.sum(loads.data(), int(loads.size()));
      neighbours.sum(around.data(), int(around.size()));
      for (std::size_t s = 0; s < grains.size(); s++)
        drho[s] = around[2 * s + 1] > 0.0 ? around[2 * s] / around[2 * s + 1] : 0.0;
      for (std::size_t s = 0; s < grains.size(); s++)
        for (int d = 0; d < 3; d++) {
          ASSERT_NEAR(loads[6 * s + d], one.loads[s].force[d], close) << where << " step " << t;
          ASSERT_NEAR(loads[6 * s + 3 + d], one.loads[s].torque[d], 5 * close)
              << where << " step " << t;
        }
      double worst = 0.0;    // agreed upon, so that all ranks stop together
      for (int z = 0; z < part.n[2]; z++)
        for (int y = 0; y < part.n[1]; y++)
          for (int x = 0; x < part.n[0]; x++) {
            const Int3 p{x + part.lo[0], y + part.lo[1], z + part.lo[2]};
            if (fluid->solid(x, y, z) != one.fluid->solid(p[0], p[1], p[2])) worst = 1.0;
            if (fluid->solid(x, y, z)) continue;
            const Moments a = fluid->moments(x, y, z), b = one.at(p[0], p[1], p[2]);
            const double e[] = {a.drho - b.drho, a.u[0] - b.u[0], a.u[1] - b.u[1], a.u[2] - b.u[2]};
            for (double difference : e)
              if (!(std::abs(difference) <= worst)) worst = std::abs(difference);
          }
      neighbours.max(&worst, 1);
      ASSERT_LT(worst, close) << where << " step " << t;
      double counts[] = {fluid->links(), fluid->gaps(), double(fluid->refilled().grad),
                         double(fluid->refilled().equilibrium), double(fluid->refilled().deep)};
      neighbours.sum(counts, 5);
      const double expected[] = {
          one.fluid->links(), one.fluid->gaps(), double(one.fluid->refilled().grad),
          double(one.fluid->refilled().equilibrium), double(one.fluid->refilled().deep)};
      for (int k = 0; k < 5; k++) ASSERT_EQ(counts[k], expected[k]) << where << " step " << t;
    }
    Survey whole = fluid->survey();
    reduce(whole, neighbours);
    const Survey survey = one.fluid->survey();
    EXPECT_EQ(whole.fluid_nodes, survey.fluid_nodes);
    EXPECT_NEAR(whole.mass, survey.mass, close * survey.mass);
    for (int d = 0; d < 3; d++) EXPECT_NEAR(whole.momentum[d], survey.momentum[d], 100 * close);
    EXPECT_NEAR(whole.speed.value, survey.speed.value, close);
    EXPECT_NEAR(whole.drho_min.value, survey.drho_min.value, close);
    EXPECT_NEAR(whole.drho_max.value, survey.drho_max.value, close);
    EXPECT_FALSE(whole.bad);
    const Ledger ledger = fluid->ledger(), expected = one.fluid->ledger();
    const double start = double(scene.n[0]) * scene.n[1] * scene.n[2];
    for (int k = 0; k < Ledger::ACCOUNTS; k++)
      EXPECT_NEAR(ledger.gain(k), expected.gain(k), close * start) << where << " account " << k;
    EXPECT_EQ(ledger.covered, expected.covered);
    EXPECT_EQ(ledger.uncovered, expected.uncovered);
    EXPECT_NEAR(whole.mass - scene_start(scene), ledger.total(), close * start) << where;
    if (scene.enclosed) EXPECT_GT(one.fluid->enclosed_nodes(), scene.enclosed);
  }
}

std::vector<Sphere> crowd(const Int3 &n, int dimension, int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  std::vector<Sphere> list;
  for (int s = 0; s < count; s++) {
    Vec3 c, v, w;
    for (int d = 0; d < 3; d++) {
      c[d] = (0.5 + 0.5 * u(random)) * n[d];
      v[d] = 0.08 * u(random);
      w[d] = 0.03 * u(random);
    }
    if (dimension == 2) {
      c[2] = 0.5;
      v[2] = w[0] = w[1] = 0.0;
    }
    list.push_back(scene::sphere(s, c, 1.9 + 0.8 * u(random), v, w));
  }
  return list;
}

// every link rule with either refill; grains cross faces, edges and corners of the ranks
void moving_crowd(int dimension)
{
  for (LinkRule rule : {LinkRule::HALFWAY, LinkRule::BOUZIDI, LinkRule::CLI, LinkRule::ZHAO}) {
    Scene s;
    s.settings.dimension = dimension;
    s.settings.tau = 0.65;
    s.settings.bgk = rule == LinkRule::BOUZIDI;
    s.settings.link = rule;
    s.settings.tile = rule == LinkRule::HALFWAY ? Int3{} : Int3{8, 3, 3};
    s.settings.refill = rule == LinkRule::BOUZIDI ? RefillRule::EQUILIBRIUM
        : rule == LinkRule::ZHAO                  ? RefillRule::NORMAL
                                                  : RefillRule::GRAD;
    s.n = dimension == 3 ? Int3{19, 13, 14} : Int3{37, 26, 1};
    s.settings.hold_mean = true;
    s.force = {1e-4, -1e-4, dimension == 3 ? 2e-4 : 0.0};
    s.grains = crowd(s.n, dimension, dimension == 3 ? 14 : 12, 5 + int(rule));
    s.steps = 50;
    same_on_every_brick(s);
  }
}

TEST(Ranks, MovingCrowd3D)
{
  moving_crowd(3);
}

TEST(Ranks, MovingCrowd2D)
{
  moving_crowd(2);
}

// one small grain, and most ranks have never seen one
TEST(Ranks, LoneGrainCrossesAll)
{
  for (RefillRule refill : {RefillRule::GRAD, RefillRule::NORMAL, RefillRule::EQUILIBRIUM}) {
    Scene s;
    s.settings.refill = refill;
    s.n = {16, 12, 12};
    s.force = {};
    s.grains = {scene::sphere(1, {3.2, 3.1, 2.7}, 1.7, {0.15, 0.1, 0.09}, {0.0, 0.02, 0.01})};
    s.steps = 100;
    same_on_every_brick(s);
  }
}

// walls, of which one moves, and open faces; grains cross them too
TEST(Ranks, FacesOfEveryKind)
{
  for (int dimension : {2, 3})
    for (int open = 0; open < dimension; open++) {
      Scene s;
      s.settings.dimension = dimension;
      s.settings.tau = 0.7;
      s.n = dimension == 3 ? Int3{13, 12, 14} : Int3{23, 20, 1};
      const int wall = (open + 1) % dimension;
      auto &f = s.settings.faces;
      f[wall][0].kind = f[wall][1].kind = FaceKind::WALL;
      f[wall][1].u[open] = 0.03;
      f[open][0] = {FaceKind::VELOCITY, {}, 0.0};
      f[open][0].u[open] = 0.02;
      f[open][1] = {FaceKind::PRESSURE, {}, 0.01};
      s.force = {1e-4, 2e-4, dimension == 3 ? -1e-4 : 0.0};
      s.grains = crowd(s.n, dimension, 9, 3);
      s.steps = 50;
      same_on_every_brick(s);
    }
}

// so crowded that much of it is enclosed, on one rank and between several
TEST(Ranks, EnclosedFluid)
{
  for (int dimension : {2, 3}) {
    Scene s;
    s.settings.dimension = dimension;
    s.settings.hold_mean = true;
    s.n = dimension == 3 ? Int3{17, 13, 16} : Int3{37, 30, 1};
    s.force = {1e-4, 1e-4, 0.0};
    s.grains = crowd(s.n, dimension, dimension == 3 ? 280 : 150, 4);
    for (Sphere &g : s.grains)
      for (double &v : g.velocity) v *= 0.1;
    s.steps = 50;
    s.enclosed = 20;
    same_on_every_brick(s);
  }
}

// blocks one and two nodes thick, and a grain larger than a block
TEST(Ranks, ThinBlocks)
{
  Scene s;
  s.n = {4, 7, 5};
  s.force = {1e-4, 0.0, 2e-4};
  s.grains = {scene::sphere(1, {1.2, 3.3, 2.1}, 1.6, {0.05, 0.11, -0.04})};
  s.steps = 60;
  same_on_every_brick(s);
}

TEST(Ranks, SinglePrecision)
{
  Scene s;
  s.settings.single = true;
  s.n = {17, 12, 13};
  s.force = {1e-4, 0.0, 2e-4};
  s.grains = crowd(s.n, 3, 9, 5);
  s.steps = 50;
  same_on_every_brick(s);
}

TEST(Ranks, FluidWithoutGrains)
{
  Scene s;
  s.settings.tau = 0.55;
  s.n = {21, 11, 10};
  s.force = {1e-4, 0.0, 2e-4};
  s.steps = 50;
  same_on_every_brick(s);
}

}    // namespace
