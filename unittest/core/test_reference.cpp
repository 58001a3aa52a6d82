// SPDX-License-Identifier: GPL-2.0-only
// The solver against the plain one of reference.h, node by node and grain by grain.

#include "reference.h"
#include "scene.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

struct Case {
  std::string name;
  Settings settings;
  Int3 n;
  Vec3 force{};
  std::vector<Sphere> spheres;
  int steps = 13;
};

std::ostream &operator<<(std::ostream &out, const Case &c)
{
  return out << c.name;
}

// A population is a sum of some twenty numbers below 1/2 in one solver, of deviations in the other:
// some 1e-16 a step. Collisions damp it or, of odd moments at large tau-, keep it: steps * 1e-15
// is a generous bound for moments, and 1e-13 for sums over some hundred links.
constexpr double CLOSE = 3e-14, CLOSE_SUM = 1e-12;

void compare(const Case &c)
{
  scene::Box box(c.settings, c.n, c.force);
  reference::Solver plain(c.settings, c.n);
  plain.force = c.force;
  for (std::size_t x = 0; x < plain.nodes(); x++) {
    const Int3 p = plain.node(x);
    const Moments m = scene::some_flow(p, c.n, c.settings.dimension);
    box.fluid->set_equilibrium(p[0], p[1], p[2], m);
    plain.set_equilibrium(x, 1.0 + m.drho, m.u);
  }
  double links = 0.0, gaps = 0.0;
  for (int t = 0; t < c.steps; t++) {
    const auto spheres = scene::drifted(c.spheres, t);
    box.follow(spheres);
    plain.follow(spheres);
    box.advance();
    plain.step();
    ASSERT_EQ(box.fluid->links(), double(plain.links)) << "step " << t;
    ASSERT_EQ(2.0 * box.fluid->gaps(), double(plain.gaps)) << "step " << t;
    links += box.fluid->links();
    gaps += box.fluid->gaps();
    for (std::size_t x = 0; x < plain.nodes(); x++) {
      const Int3 p = plain.node(x);
      ASSERT_EQ(box.fluid->solid(p[0], p[1], p[2]), plain.solid(x));
      if (plain.solid(x)) continue;
      const Moments m = box.at(p[0], p[1], p[2]);
      const auto u = plain.velocity(x);
      ASSERT_NEAR(m.drho, plain.density(x) - 1.0, CLOSE)
          << "step " << t << " node " << p[0] << " " << p[1] << " " << p[2];
      for (int d = 0; d < 3; d++)
        ASSERT_NEAR(m.u[d], u[d], CLOSE)
            << "step " << t << " node " << p[0] << " " << p[1] << " " << p[2];
    }
    for (std::size_t s = 0; s < spheres.size(); s++)
      for (int d = 0; d < 3; d++) {
        ASSERT_NEAR(box.loads[s].force[d], plain.loads[s].force[d], CLOSE_SUM) << t << " " << s;
        ASSERT_NEAR(box.loads[s].torque[d], plain.loads[s].torque[d], 5 * CLOSE_SUM)
            << t << " " << s;
      }
  }
  const RefillCount &count = box.fluid->refilled();
  EXPECT_EQ(count.grad, plain.refilled_grad);
  EXPECT_EQ(count.equilibrium, plain.refilled_equilibrium);
  EXPECT_EQ(count.rest, plain.refilled_rest);
  EXPECT_EQ(links > 0.0, !c.spheres.empty());
  for (const char *what : {"links", "gaps"})
    ::testing::Test::RecordProperty(what, int(what[0] == 'l' ? links : gaps));
}

const char *const RULE[] = {"Halfway", "Bouzidi", "Cli"};

// spheres that overlap, leave gaps of one node, cross faces, edges and corners
std::vector<Sphere> crowd(const Int3 &n, int dimension, int count, bool moving, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(0.0, 1.0);
  std::vector<Sphere> list;
  for (int s = 0; s < count; s++) {
    Vec3 c, v{}, w{};
    for (int d = 0; d < 3; d++) {
      c[d] = u(random) * n[d];
      if (moving) v[d] = 0.06 * (2.0 * u(random) - 1.0);
      if (moving) w[d] = 0.02 * (2.0 * u(random) - 1.0);
    }
    double r = 0.8 + 1.6 * u(random);
    if (dimension == 2) {
      c[2] = 0.5;
      v[2] = w[0] = w[1] = 0.0;
    }
    if (moving && s % 3 == 2) v = w = Vec3{};
    list.push_back(scene::sphere(100 - s, c, r, v, w));
  }
  return list;
}

std::vector<Case> crowds()
{
  std::vector<Case> cases;
  for (int dimension : {2, 3})
    for (LinkRule rule : {LinkRule::HALFWAY, LinkRule::BOUZIDI, LinkRule::CLI})
      for (bool moving : {false, true})
        for (int variant = 0; variant < 3; variant++) {
          Case c;
          c.settings.dimension = dimension;
          c.settings.link = rule;
          c.settings.tau = std::array{0.8, 0.55, 1.4}[variant];
          c.settings.bgk = variant == 2;
          c.settings.refill = variant == 1 ? RefillRule::EQUILIBRIUM : RefillRule::GRAD;
          c.n = dimension == 2 ? Int3{23, 17, 1} : Int3{11, 9, 10};
          if (variant == 1) c.n = dimension == 2 ? Int3{16, 19, 1} : Int3{8, 13, 7};
          if (variant != 0) c.force = {1e-4, -2e-4, dimension == 3 ? 3e-4 : 0.0};
          c.spheres = crowd(c.n, dimension, dimension == 2 ? 9 : 12, moving, 7 * variant + 3);
          c.name = "D" + std::to_string(dimension) + RULE[int(rule)] +
              (moving ? "Moving" : "Fixed") + std::to_string(variant);
          c.steps = 13 + variant;
          cases.push_back(c);
        }
  return cases;
}

// walls along one direction, open faces along another, spheres that touch and cross them
std::vector<Case> channels()
{
  std::vector<Case> cases;
  for (int dimension : {2, 3})
    for (int open = 0; open < dimension; open++)
      for (int kind = 0; kind < 3; kind++)    // pressure - pressure, velocity - pressure, walls
        for (bool spheres : {false, true}) {
          Case c;
          c.settings.dimension = dimension;
          c.n = dimension == 2 ? Int3{14, 13, 1} : Int3{10, 9, 11};
          c.settings.tau = 0.7;
          c.settings.link = spheres ? LinkRule::BOUZIDI : LinkRule::CLI;
          const int wall = (open + 1) % dimension, other = (open + 2) % dimension;
          auto &f = c.settings.faces;
          f[wall][0] = f[wall][1] = {FaceKind::WALL, {}, 0.0};
          f[wall][0].u[open] = 0.02;
          if (dimension == 3) f[wall][1].u[other] = -0.03;
          f[open][0] = {FaceKind::PRESSURE, {}, 0.011};
          f[open][1] = {FaceKind::PRESSURE, {}, -0.007};
          if (kind == 1) {
            f[open][0].kind = FaceKind::VELOCITY;
            f[open][0].u = {0.01, -0.02, dimension == 3 ? 0.015 : 0.0};
          }
          if (kind == 2) {    // a cavity, or a duct
            f[open][0] = f[open][1] = {FaceKind::WALL, {}, 0.0};
            f[open][1].u[wall] = 0.04;
          }
          c.force = {2e-4, 1e-4, dimension == 3 ? -3e-4 : 0.0};
          if (spheres) c.spheres = crowd(c.n, dimension, dimension == 2 ? 7 : 9, true, 11 + kind);
          c.name = "D" + std::to_string(dimension) +
              std::array{"Pressure", "Velocity", "Walls"}[kind] + "xyz"[open] +
              (spheres ? "Spheres" : "");
          cases.push_back(c);
        }
  return cases;
}

class Equal : public ::testing::TestWithParam<Case> {};

TEST_P(Equal, ToPlainSolver)
{
  compare(GetParam());
}

std::string name_of(const ::testing::TestParamInfo<Case> &info)
{
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Crowd, Equal, ::testing::ValuesIn(crowds()), name_of);
INSTANTIATE_TEST_SUITE_P(Channel, Equal, ::testing::ValuesIn(channels()), name_of);

}    // namespace
