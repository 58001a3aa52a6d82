// SPDX-License-Identifier: GPL-2.0-only
// Solids given by a question alone: a ball of them is a grain, planes are exact, grains may touch
// them, and what cannot be right is seen.

#include "scene.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

const LinkRule RULES[] = {LinkRule::HALFWAY, LinkRule::BOUZIDI, LinkRule::CLI};

double norm_of(const Vec3 &a, const Vec3 &b)
{
  return scene::norm({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

Shape ball(const Vec3 &c, double r, int dimension = 3)
{
  const auto inside = [=](const Vec3 &x) {
    double rsq = 0.0;
    for (int d = 0; d < dimension; d++) rsq += (x[d] - c[d]) * (x[d] - c[d]);
    return rsq < r * r;
  };
  return {inside, {}, {}, c};
}

// n.x < at
Shape half_space(const Vec3 &n, double at)
{
  return {[=](const Vec3 &x) {
    return dot(n, x) < at;
  }};
}

void start_with_flow(scene::Box &box)
{
  box.for_each_node([&](int x, int y, int z) {
    box.fluid->set_equilibrium(x, y, z, scene::some_flow({x, y, z}, box.n, box.settings.dimension));
  });
}

// A grain and a ball of the same place are one thing for the fluid, link by link: force, torque and
// every node, spinning or not, whatever the rule, and however the block is cut
TEST(Obstacles, BallIsAGrain)
{
  for (int dimension : {2, 3})
    for (LinkRule rule : RULES)
      for (const Vec3 &spin : {Vec3{}, Vec3{0.0, 0.0, 0.004}}) {
        Settings s;
        s.dimension = dimension;
        s.link = rule;
        s.tau = 0.7;
        const Int3 n{17, 15, dimension == 3 ? 16 : 1};
        const Vec3 c = scene::snapped({7.83, 6.91, dimension == 3 ? 8.27 : 0.5});
        const double r = 4.3;
        const Vec3 force{1e-5, 2e-5, dimension == 3 ? -1e-5 : 0.0};
        scene::Box grain(s, n, force);
        grain.conserve = true;
        s.tile = {5, 6, dimension == 3 ? 7 : 1};
        scene::Box solid(s, n, force);
        Shape shape = ball(c, r, dimension);
        shape.spin = spin;
        solid.fluid->set_obstacles({shape});
        start_with_flow(grain);
        start_with_flow(solid);
        for (int t = 0; t < 40; t++) {
          grain.step({scene::sphere(1, c, r, {}, spin)});
          solid.step({});
          const Load &a = grain.loads[0], &b = solid.fluid->obstacles()[0].last;
          const double size = scene::norm(a.force) + scene::norm(a.torque);
          ASSERT_GT(size, 1e-6);
          ASSERT_LT(norm_of(a.force, b.force), 1e-11 * size);
          ASSERT_LT(norm_of(a.torque, b.torque), 1e-11 * size);
          ASSERT_NEAR(a.swallowed, b.swallowed, 1e-12);
        }
        EXPECT_EQ(grain.fluid->links(), solid.fluid->links());
        grain.for_each_node([&](int x, int y, int z) {
          ASSERT_EQ(grain.fluid->solid(x, y, z), solid.fluid->solid(x, y, z));
          if (grain.fluid->solid(x, y, z)) return;
          ASSERT_NEAR(grain.at(x, y, z).drho, solid.at(x, y, z).drho, 1e-13);
          ASSERT_LT(norm_of(grain.at(x, y, z).u, solid.at(x, y, z).u), 1e-13);
        });
      }
}

// Couette flow between two obstacles, of which one slides along itself: linear to round-off,
// wherever between nodes the planes lie; force and torque are those of the shear
TEST(Obstacles, PlanesAreExact)
{
  for (int dimension : {2, 3})
    for (double below : {2.1, 2.75}) {
      Settings s;
      s.dimension = dimension;
      s.tau = 1.1;
      const Int3 n{4, 17, dimension == 3 ? 5 : 1};
      const double above = 13.4, speed = 1e-4;
      scene::Box box(s, n);
      Shape top = half_space({0, -1, 0}, -above);
      top.velocity = {speed, 0.0, 0.0};
      top.about = {2.0, above, 0.5};
      box.fluid->set_obstacles({half_space({0, 1, 0}, below), top});
      for (int t = 0; t < 6000; t++) box.step({});
      box.for_each_fluid_node([&](int x, int y, int z) {
        const double expected = speed * (y + 0.5 - below) / (above - below);
        ASSERT_NEAR(box.at(x, y, z).u[0] / speed, expected / speed, 1e-7);
      });
      const double area = n[0] * n[2], nu = (s.tau - 0.5) / 3.0;
      const double shear = nu * speed / (above - below) * area;
      const auto &got = box.fluid->obstacles();
      EXPECT_NEAR(got[0].last.force[0] / shear, 1.0, 1e-6);
      EXPECT_NEAR(got[1].last.force[0] / shear, -1.0, 1e-6);
    }
}

// Poiseuille flow along slanted planes: largest error over largest speed
double slanted_channel(LinkRule rule)
{
  Settings s;
  s.dimension = 2;
  s.tau = 0.8;
  s.link = rule;
  // along (2, 1) through a periodic box of 40 x 20, where the channel meets itself
  const double slope = std::sqrt(5.0), half = 5.1, period = 40 / slope, accel = 1e-6;
  const Vec3 normal{-1 / slope, 2 / slope, 0.0};
  scene::Box box(s, {40, 20, 1}, {accel * 2 / slope, accel / slope, 0.0});
  const auto height = [=](const Vec3 &x) {    // above the middle of the channel
    const double h = dot(normal, x);
    return h - period * std::nearbyint(h / period);
  };
  box.fluid->set_obstacles({Shape{[=](const Vec3 &x) {
    return std::abs(height(x)) > half;
  }}});
  for (int t = 0; t < 3000; t++) box.step({});
  const double nu = (s.tau - 0.5) / 3.0, largest = accel * half * half / (2 * nu);
  double worst = 0.0;
  box.for_each_fluid_node([&](int x, int y, int) {
    const double h = height({x + 0.5, y + 0.5, 0.5});
    const double expected = accel * (half * half - h * h) / (2 * nu);
    const Vec3 u = box.at(x, y, 0).u;
    worst = std::max(worst, std::abs((2 * u[0] + u[1]) / slope - expected));
    worst = std::max(worst, std::abs((2 * u[1] - u[0]) / slope));
  });
  return worst / largest;
}

// the fractions are those of the planes: with walls half-way along each link it is a staircase
TEST(Obstacles, SlantedChannel)
{
  const double fractions = slanted_channel(LinkRule::CLI),
               staircase = slanted_channel(LinkRule::HALFWAY);
  EXPECT_LT(fractions, 0.02);
  EXPECT_GT(staircase, 3.0 * fractions);
}

// What the fluid loses the obstacle and the grains on it get, to round-off: gaps of one node, links
// hidden between the two included
TEST(Obstacles, MomentumIsConserved)
{
  for (LinkRule rule : RULES) {
    Settings s;
    s.link = rule;
    s.tau = 0.7;
    s.ledger = false;
    scene::Box box(s, {20, 18, 19});
    box.fluid->set_obstacles({half_space({0, 0, 1}, 4.3)});
    start_with_flow(box);
    const std::vector<Sphere> grains{scene::sphere(1, {6.2, 5.1, 7.8}, 3.5),
                                     scene::sphere(2, {14.3, 12.2, 9.1}, 3.6)};
    box.step(grains);
    EXPECT_GT(box.fluid->gaps(), 4.0);
    for (int t = 0; t < 20; t++) {
      const Vec3 before = box.fluid->survey().momentum;
      box.step(grains);
      const Vec3 after = box.fluid->survey().momentum;
      for (int d = 0; d < 3; d++) {
        const double got =
            box.loads[0].force[d] + box.loads[1].force[d] + box.fluid->obstacles()[0].last.force[d];
        ASSERT_NEAR(before[d] - after[d], got, 1e-12);
      }
    }
  }
}

// Grains that touch, overlap or nearly touch an obstacle feel nothing in fluid at rest and pressed,
// once the density around them is known; nor does an obstacle that the fluid surrounds
TEST(Obstacles, GiveNothingInFluidAtRestUnderPressure)
{
  for (double drho : {0.02, -0.01}) {
    Settings s;
    s.tau = 0.6;
    scene::Box box(s, {31, 20, 21});
    box.fluid->set_obstacles({half_space({0, 0, 1}, 4.3), ball({21.1, 9.7, 12.2}, 4.4)});
    box.fluid->fill(drho);
    const std::vector<Sphere> grains{scene::sphere(1, {6.2, 5.1, 7.5}, 3.2),     // touches
                                     scene::sphere(2, {6.8, 14.2, 7.3}, 3.3),    // overlaps
                                     scene::sphere(3, {21.3, 9.6, 19.0 + 0.1}, 2.5)};
    for (int t = 0; t < 4; t++) {
      box.step(grains);
      double worst = 0.0;
      for (const Load &load : box.loads)
        worst = std::max({worst, scene::norm(load.force), scene::norm(load.torque)});
      if (t == 0) {
        EXPECT_GT(worst, 0.05 * std::abs(drho) / 3.0 * M_PI * 3.2 * 3.2);
      } else {
        EXPECT_LT(worst, 1e-13);
        EXPECT_LT(scene::norm(box.fluid->obstacles()[1].last.force), 1e-13);
      }
    }
  }
}

// A grain that leaves an obstacle leaves its nodes solid; one that comes takes none of them
TEST(Obstacles, NodesStayTheirs)
{
  Settings s;
  s.tau = 0.7;
  scene::Box box(s, {20, 18, 24});
  const double floor = 4.3;
  box.fluid->set_obstacles({half_space({0, 0, 1}, floor), ball({9.7, 9.2, 5.1}, 2.6)});
  const auto solids = [&] {
    int count = 0;
    box.for_each_node([&](int x, int y, int z) {
      count += box.fluid->solid(x, y, z);
    });
    return count;
  };
  const int alone = solids();
  EXPECT_GT(alone, 20 * 18 * 4 + 20);
  std::vector<Sphere> grains{scene::sphere(1, {9.9, 9.4, 6.0}, 3.1, {0.0, 0.0, 0.09})};
  box.step(grains);
  const int together = solids();
  for (int t = 1; t < 100; t++) {
    auto list = scene::drifted(grains, t);
    if (t % 3 == 0)
      list.push_back(scene::sphere(2, {3.1, 3.2, 15.0}, 2.4));    // others come and go
    box.step(list);
    box.for_each_node([&](int x, int y, int z) {
      if (z + 0.5 < floor) ASSERT_TRUE(box.fluid->solid(x, y, z)) << x << " " << y << " " << z;
    });
  }
  EXPECT_GT(solids(), together);    // the grain no longer shares nodes
  box.step({});
  EXPECT_EQ(solids(), alone);
  EXPECT_LT(box.fluid->survey().speed.value, 0.2);
}

// Links of obstacles are kept where no grain is near. With grains that pass, rest, come, go and cross
// the box the fluid is that of a block that is not cut, where all links are found in every step.
TEST(Obstacles, KeptLinksAreThoseFoundAnew)
{
  for (int dimension : {2, 3})
    for (bool yields : {false, true}) {
      Settings s;
      s.dimension = dimension;
      s.tau = 0.7;
      const bool flat = dimension == 2;
      const Int3 n{40, 19, flat ? 1 : 16};
      const auto in_box = [&](double x, double y, double z) {
        return Vec3{x, y, flat ? 0.5 : z};
      };
      // two that nearly touch, one of them with a node of fluid in it, and one at the ends of the box
      Shape hollow = ball(in_box(27.6, 9.4, 8.4), 2.9, dimension);
      hollow.inside = [outer = hollow.inside,
                       hole = ball(in_box(27.5, 9.5, 8.5), 0.4, dimension)](const Vec3 &x) {
        return outer(x) && !hole.inside(x);
      };
      const std::vector<Shape> shapes{ball(in_box(20.3, 9.1, 8.2), 4.1, dimension), hollow,
                                      half_space({1, 0, 0}, 1.7)};
      s.tile = n;
      scene::Box whole(s, n, {1e-5, 0.0, 0.0});
      s.tile = {6, 5, 4};
      scene::Box cut(s, n, {1e-5, 0.0, 0.0});
      for (scene::Box *box : {&whole, &cut}) {
        box->fluid->set_obstacles(shapes);
        start_with_flow(*box);
      }
      std::vector<Sphere> grains{
          scene::sphere(1, in_box(7.3, 8.2, 7.7), 2.7, {0.06, 0.01, flat ? 0.0 : 0.02}),
          scene::sphere(2, in_box(33.1, 3.4, 3.2), 2.2, {0.02, -0.05, 0.0})};
      grains[0].yields = yields;
      for (int t = 0; t < 260; t++) {
        auto list = scene::drifted(grains, t < 60 ? t : std::max(60, t - 10));
        if (t % 50 < 20) list.insert(list.begin(), scene::sphere(3, in_box(12.2, 14.1, 3.3), 2.3));
        whole.step(list);
        cut.step(list);
        ASSERT_EQ(whole.fluid->links(), cut.fluid->links()) << t;
        ASSERT_EQ(whole.fluid->gaps(), cut.fluid->gaps()) << t;
        if (t % 10) continue;
        for (int k = 0; k < 3; k++) {
          const Load &a = whole.fluid->obstacles()[k].last, &b = cut.fluid->obstacles()[k].last;
          ASSERT_LT(norm_of(a.force, b.force), 1e-13) << k << " " << t;
          ASSERT_LT(norm_of(a.torque, b.torque), 1e-12) << k << " " << t;
        }
        whole.for_each_fluid_node([&](int x, int y, int z) {
          const Moments a = whole.at(x, y, z), b = cut.at(x, y, z);
          ASSERT_NEAR(a.drho, b.drho, 1e-13) << x << " " << y << " " << z << ", " << t;
          ASSERT_LT(norm_of(a.u, b.u), 1e-13) << x << " " << y << " " << z << ", " << t;
        });
      }
      EXPECT_GT(cut.fluid->gaps(), 0.0);
    }
}

// Where the fluid goes on from a state of another, it goes on as the other would have
TEST(Obstacles, GoOnFromAState)
{
  Settings s;
  s.tau = 0.7;
  const Int3 n{16, 14, 15};
  const auto shapes = std::vector<Shape>{ball({7.1, 6.6, 6.9}, 3.7)};
  scene::Box through(s, n, {1e-5, 0.0, 0.0}), later(s, n, {1e-5, 0.0, 0.0});
  through.fluid->set_obstacles(shapes);
  start_with_flow(through);
  for (int t = 0; t < 11; t++) through.step({});
  const Part all{{0, 0, 0}, n};
  std::vector<double> state(std::size_t(all.nodes()) * through.fluid->directions());
  through.fluid->give(all, state.data());
  later.fluid->set_obstacles(shapes);
  later.fluid->take(all, state.data());
  later.fluid->resume({}, {});
  later.fluid->resume_obstacles(through.fluid->obstacles());
  for (int t = 0; t < 9; t++) {
    through.step({});
    later.step({});
  }
  EXPECT_EQ(through.fluid->checksum(), later.fluid->checksum());
  EXPECT_EQ(through.fluid->obstacles()[0].last.force, later.fluid->obstacles()[0].last.force);
}

ShapeReview review(const Shape &shape, const Int3 &n = {24, 24, 24}, int dimension = 3)
{
  Settings s;
  s.dimension = dimension;
  return scene::Box(s, n).fluid->review({shape})[0];
}

TEST(Obstacles, ThinPartsAreSeen)
{
  const auto plate = [](double from, double to) {
    return Shape{[=](const Vec3 &x) {
      return x[0] > from && x[0] < to;
    }};
  };
  ShapeReview r = review(plate(5.2, 6.3));    // a layer of nodes
  EXPECT_EQ(r.covered, 24 * 24);
  EXPECT_EQ(r.surface, 24 * 24);
  EXPECT_EQ(r.thin, r.surface);
  r = review(plate(5.2, 7.0));
  EXPECT_EQ(r.thin, r.surface);
  r = review(plate(5.2, 7.9));
  EXPECT_EQ(r.thin, 0.0);
  r = review(plate(5.7, 6.2));    // between nodes
  EXPECT_EQ(r.covered, 0.0);
  EXPECT_EQ(r.missed, 24 * 24);
  for (double radius : {2.2, 3.9, 7.7}) {
    r = review(ball({11.4, 12.1, 10.8}, radius));
    EXPECT_GT(r.covered, 0.0);
    EXPECT_EQ(r.thin, 0.0) << radius;
    EXPECT_EQ(r.missed, 0.0) << radius;
  }
  EXPECT_GT(review(ball({11.4, 12.1, 10.8}, 0.9)).thin, 0.0);
}

TEST(Obstacles, MotionThatTakesASurfaceOffItselfIsSeen)
{
  const Vec3 c{11.4, 12.1, 10.8};
  Shape shape = ball(c, 5.3);
  EXPECT_EQ(review(shape).leaving, 0.0);
  shape.spin = {0.001, -0.002, 0.003};
  EXPECT_EQ(review(shape).leaving, 0.0);
  EXPECT_NEAR(review(shape).speed, 5.3 * scene::norm(shape.spin),
              0.02 * 5.3 * scene::norm(shape.spin));
  shape.about[0] += 0.5;
  EXPECT_GT(review(shape).leaving, 0.0);
  shape = ball(c, 5.3);
  shape.velocity = {0.01, 0.0, 0.0};
  EXPECT_GT(review(shape).leaving, 0.3 * review(shape).links);
  // a cylinder along z slides along z and turns about its axis, not along x
  shape = ball(c, 5.3, 2);
  shape.velocity = {0.0, 0.0, 0.01};
  shape.spin = {0.0, 0.0, -0.002};
  EXPECT_EQ(review(shape).leaving, 0.0);
  shape.spin = {0.0, 0.001, 0.0};
  EXPECT_GT(review(shape).leaving, 0.0);
}

TEST(Obstacles, ChecksumKnowsTheShape)
{
  const auto of = [](double r) {
    return review(ball({11.4, 12.1, 10.8}, r)).checksum;
  };
  EXPECT_EQ(of(5.3), of(5.3));
  EXPECT_NE(of(5.3), of(5.3001));
  EXPECT_NE(of(5.3), of(6.3));
}

}    // namespace
