// SPDX-License-Identifier: GPL-2.0-only
// The solver against the plain one of reference.h, node by node and grain by grain.

#include "reference.h"
#include "scene.h"

#include <gtest/gtest.h>

#include <functional>

using namespace lbm;

namespace {

struct Case {
  std::string name;
  Settings settings;
  Int3 n;
  Vec3 force{};
  std::vector<Sphere> spheres;
  int steps = 13;
  // spheres at step t; unless given, those above in steady motion
  std::function<std::vector<Sphere>(int)> at;
};

std::ostream &operator<<(std::ostream &out, const Case &c)
{
  return out << c.name;
}

// A moment is a sum of some twenty numbers that one solver holds whole and the other as deviations:
// 1e-15 a step from rounding, some tens of steps, and little damping where tau- is large. A load is a
// sum over some hundred links of it.
constexpr double CLOSE = 1e-13, CLOSE_SUM = 1e-12;
// the same in single precision: rounding is 5e8 times as coarse, but to populations of some 0.01
constexpr double COARSER = 5e6;

void compare(const Case &c)
{
  const double close = CLOSE * (c.settings.single ? COARSER : 1.0),
               close_sum = CLOSE_SUM * (c.settings.single ? COARSER : 1.0);
  scene::Box box(c.settings, c.n, c.force);
  reference::Solver plain(c.settings, c.n);
  plain.force = reference::whole(c.force);
  for (std::size_t x = 0; x < plain.nodes(); x++) {
    const Int3 p = plain.node(x);
    const Moments m = scene::some_flow(p, c.n, c.settings.dimension);
    box.fluid->set_equilibrium(p[0], p[1], p[2], m);
    plain.set_equilibrium(x, reference::Real(1.0) + m.drho, reference::whole(m.u));
  }
  double links = 0.0, gaps = 0.0;
  for (int t = 0; t < c.steps; t++) {
    const auto spheres = c.at ? c.at(t) : scene::drifted(c.spheres, t);
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
      ASSERT_NEAR(m.drho, plain.density(x) - 1.0, close)
          << "step " << t << " node " << p[0] << " " << p[1] << " " << p[2];
      for (int d = 0; d < 3; d++)
        ASSERT_NEAR(m.u[d], u[d], close)
            << "step " << t << " node " << p[0] << " " << p[1] << " " << p[2];
    }
    for (std::size_t s = 0; s < spheres.size(); s++)
      for (int d = 0; d < 3; d++) {
        ASSERT_NEAR(box.loads[s].force[d], plain.loads[s].force[d], close_sum) << t << " " << s;
        const double torque = double(plain.loads[s].torque[d]);
        ASSERT_NEAR(box.loads[s].torque[d], torque,
                    5 * close_sum * std::max(1.0, std::abs(torque)))    // it sums long arms
            << t << " " << s;
      }
  }
  const RefillCount &count = box.fluid->refilled();
  EXPECT_EQ(count.grad, plain.refilled_grad);
  EXPECT_EQ(count.equilibrium, plain.refilled_equilibrium);
  EXPECT_EQ(count.deep, plain.refilled_deep);
  for (const char *what : {"links", "gaps"})
    ::testing::Test::RecordProperty(what, int(what[0] == 'l' ? links : gaps));
}

const char *const RULE[] = {"Halfway", "Bouzidi", "Cli", "Zhao"};

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

// each rule with several links
RefillRule refill_of(LinkRule rule, int variant)
{
  if (variant == 0) return RefillRule::GRAD;
  const RefillRule others[] = {RefillRule::EQUILIBRIUM, RefillRule::NORMAL, RefillRule::LOCAL};
  return others[(variant - 1 + int(rule) / 2) % 3];
}

std::vector<Case> crowds()
{
  std::vector<Case> cases;
  for (int dimension : {2, 3})
    for (LinkRule rule : {LinkRule::HALFWAY, LinkRule::BOUZIDI, LinkRule::CLI, LinkRule::ZHAO})
      for (bool moving : {false, true})
        for (int variant = 0; variant < 3; variant++) {
          Case c;
          c.settings.dimension = dimension;
          c.settings.link = rule;
          c.settings.tau = std::array{0.8, 0.55, 1.4}[variant];
          c.settings.bgk = variant == 2;
          c.settings.refill = refill_of(rule, variant);
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

// scenes at the limits of what the solver should bear
std::vector<Case> limits()
{
  std::vector<Case> cases;
  auto add = [&](const std::string &name, const std::vector<Sphere> &spheres) {
    for (int dimension : {2, 3}) {
      Case c;
      c.name = name + std::to_string(dimension);
      c.settings.dimension = dimension;
      c.settings.tau = 0.7;
      c.n = dimension == 2 ? Int3{12, 11, 1} : Int3{9, 10, 8};
      c.force = {1e-4, -1e-4, 0.0};
      c.spheres = spheres;
      for (Sphere &s : c.spheres)
        if (dimension == 2) {
          s.centre[2] = 0.5;
          s.velocity[2] = s.spin[0] = s.spin[1] = 0.0;
        }
      cases.push_back(c);
    }
  };
  const Vec3 v{0.05, -0.03, 0.02}, w{0.01, 0.0, 0.02};
  using scene::sphere;
  add("None", {});
  add("NodesOnTheSurface", {sphere(1, {4.5, 5.5, 3.5}, 3.0)});
  add("CoversNoNode", {sphere(1, {4.0, 5.0, 3.0}, 0.6, {}, {})});
  add("CoversOneNode", {sphere(1, {4.4, 5.6, 3.5}, 0.3, v, w)});
  add("SmallerThanACell", {sphere(1, {4.1, 5.2, 3.3}, 0.9, v, w)});
  add("WiderThanTheBox", {sphere(1, {4.1, 5.2, 3.3}, 5.6, v, w)});
  add("CoversTheBox", {sphere(1, {4.1, 5.2, 3.3}, 20.0, v, w)});
  add("TwoInOnePlace", {sphere(2, {4.1, 5.2, 3.3}, 2.2, v, w), sphere(1, {4.1, 5.2, 3.3}, 2.2)});
  add("TouchingInANode", {sphere(2, {2.5, 5.5, 3.5}, 2.0), sphere(1, {6.5, 5.5, 3.5}, 2.0, v)});
  add("OneNodeApart", {sphere(2, {2.3, 5.2, 3.5}, 2.0, v), sphere(1, {7.1, 5.5, 3.3}, 2.0, {}, w)});

  // rows of more than 64 and of more than 128 nodes, and grains as wide
  auto add_wide = [&](const std::string &name, int dimension, const Int3 &n,
                      const std::vector<Sphere> &spheres) {
    add(name, spheres);
    cases.erase(cases.end() - (dimension == 2 ? 1 : 2));
    cases.back().n = n;
    cases.back().steps = 5;
  };
  add_wide("WideRows", 2, {150, 11, 1},
           {sphere(1, {63.2, 5.3, 0.5}, 3.4, v, w), sphere(2, {127.6, 2.1, 0.5}, 4.0),
            sphere(3, {149.0, 8.0, 0.5}, 2.7, v), sphere(4, {70.3, 6.0, 0.5}, 2.9)});
  add_wide("WideRows", 3, {133, 9, 8},
           {sphere(1, {62.2, 5.3, 2.5}, 3.4, v, w), sphere(2, {126.6, 2.1, 4.5}, 2.0),
            sphere(3, {132.0, 8.0, 7.5}, 2.7, v), sphere(4, {68.9, 6.0, 1.1}, 2.9)});
  add_wide("WideGrain", 2, {150, 131, 1},
           {sphere(1, {80.2, 60.3, 0.5}, 41.3, {0.02, 0.01, 0.0}, {0.0, 0.0, 1e-4}),
            sphere(2, {5.6, 2.1, 0.5}, 33.0)});
  add_wide("WideGrain", 3, {90, 7, 8}, {sphere(1, {40.2, 3.3, 4.5}, 32.3, v, w)});
  // spheres that come, go, stop and start again; fast ones; another order of the list
  auto add_script = [&](const std::string &name, std::function<std::vector<Sphere>(int)> at) {
    add(name, {});
    for (std::size_t k = cases.size() - 2; k < cases.size(); k++) {
      cases[k].steps = 24;
      const bool flat = cases[k].settings.dimension == 2;
      cases[k].at = [=](int t) {
        auto list = at(t);
        for (Sphere &s : list)
          if (flat) {
            s.centre[2] = 0.5;
            s.velocity[2] = s.spin[0] = s.spin[1] = 0.0;
          }
        return list;
      };
    }
  };
  const Sphere a = sphere(5, {3.2, 4.1, 3.3}, 2.1, v, w), b = sphere(9, {6.3, 7.4, 5.2}, 1.8);
  add_script("ComeAndGo", [=](int t) {
    std::vector<Sphere> list;
    if (t >= 2 && t < 9) list.push_back(a);
    if (t >= 5 && t < 14) list.push_back(b);
    if (t >= 17) list.push_back(scene::drifted({a}, t)[0]);
    return list;
  });
  add_script("StopAndStart", [=](int t) {
    Sphere s = a;
    const bool stopped = (t > 3 && t < 8) || t == 11 || t > 17;
    for (int k = 0; k < t; k++)    // moves with its velocity of the time
      if (!((k > 3 && k < 8) || k == 11 || k > 17)) s = scene::drifted({s}, 1)[0];
    if (stopped) s.velocity = s.spin = Vec3{};
    return std::vector<Sphere>{s, b};
  });
  add_script("TurnOnTheSpot", [=](int t) {
    Sphere s = a;
    s.velocity = {};
    s.spin = {0.0, 0.0, t % 5 < 2 ? 0.03 : 0.0};
    return std::vector<Sphere>{s, b};
  });
  add_script("Fast", [=](int t) {
    Sphere s = a;
    s.velocity = {0.9, 0.4, -0.3};
    s = scene::drifted({s}, t)[0];
    s.velocity = {0.09, 0.04, -0.03};    // what the fluid is told
    return std::vector<Sphere>{s};
  });
  add_script("NodesOnTheMovingSurface", [=](int t) {
    return std::vector<Sphere>{sphere(1, {4.5 + 0.5 * t, 5.5, 3.5}, 2.0, {0.05, 0.0, 0.0}, w)};
  });
  add_script("ListedInAnotherOrder", [=](int t) {
    const auto list = scene::drifted({a, b}, t);
    return t % 3 == 0 ? list : std::vector<Sphere>{list[1], list[0]};
  });
  const std::size_t n = cases.size();
  for (std::size_t k = 0; k < n; k++) {    // and with the rules of the paper
    cases.push_back(cases[k]);
    cases.back().name += "Paper";
    cases.back().settings.link = LinkRule::BOUZIDI;
    cases.back().settings.refill = RefillRule::EQUILIBRIUM;
    cases.back().settings.bgk = true;
  }
  return cases;
}

class Equal : public ::testing::TestWithParam<Case> {};

TEST_P(Equal, ToPlainSolver)
{
  compare(GetParam());
}

// links between the tiles of a sweep, as in blocks that are too large for the cache
TEST_P(Equal, ToPlainSolverInTiles)
{
  for (const Int3 &tile : {Int3{64, 64, 1}, Int3{64, 2, 3}, Int3{8, 5, 5}, Int3{1, 1, 1}}) {
    Case c = GetParam();
    c.settings.tile = tile;
    compare(c);
  }
}

TEST_P(Equal, ToPlainSolverInSingle)
{
  Case c = GetParam();
  c.settings.single = true;
  compare(c);
}

// the link pass has variants for surfaces that do not turn, and for links without a ledger
class EqualInVariants : public ::testing::TestWithParam<Case> {};

TEST_P(EqualInVariants, ToPlainSolver)
{
  for (bool turning : {false, true})
    for (bool ledger : {false, true}) {
      if (turning && ledger) continue;    // is what the others do
      Case c = GetParam();
      c.settings.ledger = ledger;
      if (!turning)
        for (Sphere &s : c.spheres) s.spin = {};
      compare(c);
    }
}

std::string name_of(const ::testing::TestParamInfo<Case> &info)
{
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Crowd, Equal, ::testing::ValuesIn(crowds()), name_of);
INSTANTIATE_TEST_SUITE_P(Crowd, EqualInVariants, ::testing::ValuesIn(crowds()), name_of);
INSTANTIATE_TEST_SUITE_P(Limit, Equal, ::testing::ValuesIn(limits()), name_of);
INSTANTIATE_TEST_SUITE_P(Channel, Equal, ::testing::ValuesIn(channels()), name_of);

}    // namespace
