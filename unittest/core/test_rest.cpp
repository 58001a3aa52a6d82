// SPDX-License-Identifier: GPL-2.0-only
// Grains feel nothing in fluid at rest, whatever its pressure: where they touch each other, where they
// touch walls and faces, and where all moves together.

#include "scene.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

const LinkRule RULES[] = {LinkRule::HALFWAY, LinkRule::BOUZIDI, LinkRule::CLI, LinkRule::ZHAO};
const RefillRule REFILLS[] = {RefillRule::GRAD, RefillRule::NORMAL, RefillRule::LOCAL,
                              RefillRule::EQUILIBRIUM};

// Pairs that hide links from each other: .1 apart, touching, overlapping, one node apart
std::vector<Sphere> pairs(const Vec3 &velocity)
{
  const double r = 3.2;
  std::vector<Sphere> list;
  const double gap[] = {0.1, 0.0, -0.4, 1.1};
  const Vec3 way[] = {{1, 0, 0}, {0.6, 0.8, 0}, {0.48, 0.6, 0.64}, {0.0, -0.6, 0.8}};
  for (int k = 0; k < 4; k++) {
    const Vec3 c{6.2 + 14.3 * (k % 2), 7.3 + 14.1 * (k / 2), 6.9};
    Vec3 b;
    for (int d = 0; d < 3; d++) b[d] = c[d] + (2 * r + gap[k]) * way[k][d];
    list.push_back(scene::sphere(2 * k, c, r, velocity));
    list.push_back(scene::sphere(2 * k + 1, b, r, velocity));
  }
  return list;
}

// Fluid at rest gives nothing to grains that hide links from each other; nor does fluid that moves
// with them: exact up to the rounding of some hundred links
TEST(Rest, GivesNothingWhereAllIsAtRestOrMovesTogether)
{
  for (LinkRule rule : RULES)
    for (RefillRule refill : REFILLS)
      for (const Vec3 &u : {Vec3{}, Vec3{0.1, 0.0, 0.0}, Vec3{0.06, -0.08, 0.05}}) {
        Settings s;
        s.tau = 0.6;
        s.link = rule;
        s.refill = refill;
        const Int3 n{29, 28, 21};
        scene::Box box(s, n);
        box.conserve = true;    // nor is there anything to give back
        box.for_each_node([&](int x, int y, int z) {
          box.fluid->set_equilibrium(x, y, z, {0.0, u});
        });
        const auto grains = pairs(u);
        for (int t = 0; t < 25; t++) box.step(scene::drifted(grains, t));
        for (const Load &load : box.loads) {
          EXPECT_LT(scene::norm(load.force), u == Vec3{} ? 1e-30 : 1e-14);
          EXPECT_LT(scene::norm(load.torque), u == Vec3{} ? 1e-30 : 5e-14);
        }
        EXPECT_EQ(box.fluid->refilled().grad + box.fluid->refilled().equilibrium > 0, u != Vec3{});
        box.for_each_fluid_node([&](int x, int y, int z) {
          const Moments m = box.at(x, y, z);
          ASSERT_NEAR(m.drho, 0.0, 1e-14);
          for (int d = 0; d < 3; d++) ASSERT_NEAR(m.u[d], u[d], 1e-14);
        });
      }
}

// Nor does fluid at rest at another density, be it in a bed under pressure: from the second step
// on, when the density around each grain is known. Without that, grains of this size that touch
// would attract each other by a tenth of p pi r^2.
TEST(Rest, GivesNothingInFluidUnderPressure)
{
  for (double drho : {0.02, -0.01}) {
    Settings s;
    s.tau = 0.6;
    scene::Box box(s, {29, 28, 21});
    box.fluid->fill(drho);
    auto grains = pairs({});
    grains[5] = scene::sphere(5, {5.9, 24.0, 13.2}, 2.5);    // a second neighbour of number 4
    for (int t = 0; t < 3; t++) {
      box.step(grains);
      double worst = 0.0;
      for (const Load &load : box.loads)
        worst = std::max({worst, scene::norm(load.force), scene::norm(load.torque)});
      if (t == 0) {
        EXPECT_GT(worst, 0.05 * std::abs(drho) / 3.0 * M_PI * 3.2 * 3.2);
      } else {
        EXPECT_LT(worst, 1e-14);
      }
      for (const Load &load : box.loads) EXPECT_NEAR(load.drho(), drho, 1e-14);
    }
  }
}

// Nor where a grain touches or cuts a wall of the box, an edge of two, or an open face: what lies
// behind presses as the water around the grain does
TEST(Rest, GivesNothingAtFacesUnderPressure)
{
  for (int dimension : {2, 3}) {
    Settings s;
    s.dimension = dimension;
    s.tau = 0.6;
    const int top = dimension - 1;
    const double drho = 0.02;
    for (Face &face : s.faces[0]) face.kind = FaceKind::WALL;
    s.faces[top][0].kind = FaceKind::WALL;
    s.faces[top][1].kind = FaceKind::PRESSURE;
    s.faces[top][1].drho = drho;
    const Int3 n{24, dimension == 3 ? 21 : 26, dimension == 3 ? 26 : 1};
    auto at = [&](double x, double up, double r, int id) {
      return scene::sphere(id, dimension == 3 ? Vec3{x, 10.3, up} : Vec3{x, up, 0.5}, r);
    };
    const std::vector<Sphere> grains = {at(12.2, 3.4, 3.4, 0), at(2.6, 2.4, 3.3, 1),
                                        at(20.8, 13.2, 3.2, 2), at(13.3, 23.1, 3.7, 3)};
    scene::Box box(s, n);
    box.fluid->fill(drho);
    for (int t = 0; t < 4; t++) {
      box.step(grains);
      for (std::size_t k = 0; k < grains.size(); k++) {
        const double force = scene::norm(box.loads[k].force);
        if (t == 0)    // the density around it is not known yet
          EXPECT_GT(force, 0.02 * drho / 3.0 * grains[k].radius * grains[k].radius) << k;
        else
          EXPECT_LT(force + scene::norm(box.loads[k].torque), 1e-14) << k;
      }
    }
  }
}

}    // namespace
