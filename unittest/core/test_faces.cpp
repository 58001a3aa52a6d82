// SPDX-License-Identifier: GPL-2.0-only
// Pressure and velocity faces (Zou & He 1997; corrections of Mansouri et al. 2016, appendix A).

#include "scene.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

// density exactly as asked for, and no velocity along the face, in a flow that has both
void pressure_is_imposed(int dimension, int d)
{
  Settings s;
  s.dimension = dimension;
  s.tau = 0.7;
  s.faces[d][0] = {FaceKind::PRESSURE, {}, 0.012};
  s.faces[d][1] = {FaceKind::PRESSURE, {}, -0.005};
  Int3 n{9, 8, dimension == 3 ? 10 : 1};
  const Vec3 force{3e-4, -2e-4, dimension == 3 ? 1e-4 : 0.0};
  scene::Box box(s, n, force);
  box.for_each_node([&](int x, int y, int z) {
    box.fluid->set_equilibrium(x, y, z, scene::some_flow({x, y, z}, n, dimension));
  });
  for (int t = 0; t < 20; t++) {
    box.advance();
    box.for_each_node([&](int x, int y, int z) {
      const Int3 p{x, y, z};
      if (p[d] != 0 && p[d] != n[d] - 1) return;
      const Moments m = box.at(x, y, z);
      EXPECT_NEAR(m.drho, p[d] == 0 ? 0.012 : -0.005, 1e-15);
      for (int k = 0; k < dimension; k++) EXPECT_NEAR(k == d ? 0.0 : m.u[k], 0.0, 1e-15);
    });
  }
}

void velocity_is_imposed(int dimension, int d)
{
  Settings s;
  s.dimension = dimension;
  s.tau = 0.7;
  const Vec3 u[2] = {{0.02, -0.01, dimension == 3 ? 0.015 : 0.0}, {0.01, 0.01, 0.0}};
  for (int side = 0; side < 2; side++) s.faces[d][side] = {FaceKind::VELOCITY, u[side], 0.0};
  Int3 n{9, 8, dimension == 3 ? 10 : 1};
  const Vec3 force{3e-4, -2e-4, dimension == 3 ? 1e-4 : 0.0};
  scene::Box box(s, n, force);
  for (int t = 0; t < 20; t++) {
    box.advance();
    box.for_each_node([&](int x, int y, int z) {
      const Int3 p{x, y, z};
      if (p[d] != 0 && p[d] != n[d] - 1) return;
      const Moments m = box.at(x, y, z);
      for (int k = 0; k < dimension; k++) EXPECT_NEAR(m.u[k], u[p[d] != 0][k], 1e-15);
    });
  }
}

TEST(OpenFaces, ImposeWhatTheyAreAskedForExactly)
{
  for (int dimension : {2, 3})
    for (int d = 0; d < dimension; d++) {
      pressure_is_imposed(dimension, d);
      velocity_is_imposed(dimension, d);
    }
}

// u everywhere the same solves everything
TEST(OpenFaces, PlugFlowPassesUnchanged)
{
  for (int dimension : {2, 3})
    for (int d = 0; d < dimension; d++)
      for (int inlet = 0; inlet < 2; inlet++) {
        Settings s;
        s.dimension = dimension;
        Vec3 u{0.01, -0.02, dimension == 3 ? 0.03 : 0.0};
        for (int k = 0; k < 3; k++)
          if (k != d) u[k] = 0.0;
        if (inlet) u[d] = -u[d];
        s.faces[d][inlet] = {FaceKind::VELOCITY, u, 0.0};
        s.faces[d][1 - inlet] = {FaceKind::PRESSURE, {}, 0.004};
        scene::Box box(s, {6, 7, dimension == 3 ? 5 : 1});
        box.for_each_node([&](int x, int y, int z) {
          box.fluid->set_equilibrium(x, y, z, {0.004, u});
        });
        for (int t = 0; t < 50; t++) box.advance();
        box.for_each_node([&](int x, int y, int z) {
          const Moments m = box.at(x, y, z);
          EXPECT_NEAR(m.drho, 0.004, 1e-15 * 20);
          for (int k = 0; k < 3; k++) EXPECT_NEAR(m.u[k], u[k], 1e-15 * 20);
        });
      }
}

// Fluid at rest under a body force, between open faces or on a wall: drho = 3 F x, u = 0. Grains in
// it with CLI or half-way walls leave that exact, and feel Archimedes' force on the nodes they cover;
// linear Bouzidi interpolates between the pressures of two nodes and does not (u of order F).
TEST(OpenFaces, FluidUnderABodyForceStaysAtRest)
{
  const double F = 2e-4;
  for (int dimension : {2, 3})
    for (int d = 0; d < dimension; d++)
      for (int scene = 0; scene < 3; scene++)
        for (LinkRule rule : {LinkRule::CLI, LinkRule::HALFWAY}) {
          Settings s;
          s.dimension = dimension;
          s.link = rule;
          const Int3 n{9, 10, dimension == 3 ? 11 : 1};
          s.faces[d][0] = {scene == 1 ? FaceKind::WALL : FaceKind::PRESSURE, {}, 0.0};
          s.faces[d][1] = {
              scene == 2 ? FaceKind::WALL : FaceKind::PRESSURE, {}, 3 * F * (n[d] - 1)};
          const int w = (d + 1) % dimension;
          if (scene == 1) s.faces[w][0].kind = s.faces[w][1].kind = FaceKind::WALL;
          Vec3 force{};
          force[d] = F;
          scene::Box box(s, n, force);
          box.for_each_node([&](int x, int y, int z) {
            const Int3 p{x, y, z};
            box.fluid->set_equilibrium(x, y, z, {3 * F * p[d], {}});
          });
          const std::vector<Sphere> grains{
              scene::sphere(1, {4.3, 5.1, dimension == 3 ? 5.6 : 0.5}, 2.2)};
          for (int t = 0; t < 60; t++) box.step(grains);
          long covered = 0;
          box.for_each_node([&](int x, int y, int z) {
            if (box.fluid->solid(x, y, z)) {
              covered++;
              return;
            }
            const Int3 p{x, y, z};
            const Moments m = box.at(x, y, z);
            EXPECT_NEAR(m.drho, 3 * F * p[d], 1e-15);
            for (int k = 0; k < 3; k++) EXPECT_NEAR(m.u[k], 0.0, 1e-15);
          });
          EXPECT_GT(covered, 10);
          for (int k = 0; k < 3; k++)
            EXPECT_NEAR(box.loads[0].force[k], k == d ? -F * covered : 0.0, 1e-14);
        }
}

// the scene on one face, turned to another: faces, walls, grains, force and flow
struct Turn {
  Int3 axis;    // old axis k becomes axis[k]
  Int3 flip;    // and is mirrored
};

std::unique_ptr<scene::Box> turned(const Turn &turn, int dimension, bool velocity, int steps,
                                   Load &load)
{
  const Int3 n0{8, 9, dimension == 3 ? 10 : 1};
  auto turn_vector = [&](const Vec3 &v) {
    Vec3 u{};
    for (int k = 0; k < 3; k++) u[turn.axis[k]] = turn.flip[k] ? -v[k] : v[k];
    return u;
  };
  Int3 n{1, 1, 1};
  for (int k = 0; k < dimension; k++) n[turn.axis[k]] = n0[k];
  Settings s;
  s.dimension = dimension;
  s.tau = 0.65;
  auto face = [&](int d, int side) -> Face & {
    return s.faces[turn.axis[d]][turn.flip[d] ? 1 - side : side];
  };
  if (velocity)
    face(0, 0) = {FaceKind::VELOCITY, turn_vector({0.02, 0.0, 0.0}), 0.0};
  else
    face(0, 0) = {FaceKind::PRESSURE, {}, 0.01};
  face(0, 1) = {FaceKind::PRESSURE, {}, -0.01};
  face(1, 0) = face(1, 1) = {FaceKind::WALL, {}, 0.0};
  scene::Box *box = new scene::Box(s, n, turn_vector({1e-4, 2e-4, dimension == 3 ? -1e-4 : 0.0}));
  Vec3 c{3.3, 0.9, dimension == 3 ? 9.2 : 0.5}, centre{0.5, 0.5, 0.5};
  for (int k = 0; k < dimension; k++) centre[turn.axis[k]] = turn.flip[k] ? n0[k] - c[k] : c[k];
  std::vector<Sphere> grains{scene::sphere(1, centre, 1.9, turn_vector({0.02, 0.03, 0.0}))};
  for (int t = 0; t < steps; t++) box->step(scene::drifted(grains, t));
  load = box->loads[0];
  return std::unique_ptr<scene::Box>(box);
}

TEST(OpenFaces, TurnedScenesGiveTurnedFlows)
{
  for (int dimension : {2, 3})
    for (bool velocity : {false, true}) {
      Load load0;
      const auto first = turned({{0, 1, 2}, {0, 0, 0}}, dimension, velocity, 25, load0);
      EXPECT_GT(scene::norm(load0.force), 1e-3);
      Int3 axis{0, 1, 2};
      do {
        if (dimension == 2 && axis[2] != 2) continue;
        for (int f = 0; f < (dimension == 3 ? 8 : 4); f++) {
          const Turn turn{axis, {f & 1, (f >> 1) & 1, (f >> 2) & 1}};
          Load load;
          const auto box = turned(turn, dimension, velocity, 25, load);
          first->for_each_fluid_node([&](int x, int y, int z) {
            const Int3 p{x, y, z};
            Int3 q{0, 0, 0};
            for (int k = 0; k < dimension; k++)
              q[axis[k]] = turn.flip[k] ? first->n[k] - 1 - p[k] : p[k];
            const Moments a = first->at(x, y, z), b = box->at(q[0], q[1], q[2]);
            ASSERT_NEAR(b.drho, a.drho, 1e-14);
            for (int k = 0; k < dimension; k++)
              ASSERT_NEAR(b.u[axis[k]], turn.flip[k] ? -a.u[k] : a.u[k], 1e-14);
          });
          for (int k = 0; k < dimension; k++)
            EXPECT_NEAR(load.force[axis[k]], turn.flip[k] ? -load0.force[k] : load0.force[k],
                        1e-13);
        }
      } while (std::next_permutation(axis.begin(), axis.end()));
    }
}

// Channel of height n between walls along w, driven along d by two pressure faces; lengths counted
// between the nodes of the pressure planes. The gradient is small enough for the density change to
// be of no account. The number of nodes along d is even: between pressure faces an odd one keeps the
// staggered momentum, (-1)^(x + t), that the sudden start leaves.
// Returns the largest error of the velocity and the spread of the flux, in terms of the maximum.
std::array<double, 2> pressure_channel(int dimension, int d, int w, int n)
{
  Settings s;
  s.dimension = dimension;
  s.tau = 0.9;
  Int3 size{1, 1, 1};
  size[d] = 2 * n + 2;
  size[w] = n;
  const double drho = 1e-7, nu = (s.tau - 0.5) / 3.0;
  s.faces[d][0] = {FaceKind::PRESSURE, {}, drho / 2};
  s.faces[d][1] = {FaceKind::PRESSURE, {}, -drho / 2};
  s.faces[w][0].kind = s.faces[w][1].kind = FaceKind::WALL;
  scene::Box box(s, size);
  const double gradient = drho / 3.0 / (size[d] - 1), top = gradient * n * n / (8 * nu);
  for (int t = 0; t < 80 * n * n; t++) box.advance();
  double error = 0.0;
  std::vector<double> flux(size[d], 0.0);
  box.for_each_node([&](int x, int y, int z) {
    const Int3 q{x, y, z};
    const double h = q[w] + 0.5, u = box.at(x, y, z).u[d];
    error = std::max(error, std::abs(u - gradient / (2 * nu) * h * (n - h)) / top);
    flux[q[d]] += u / (top * n);
  });
  const auto [least, most] = std::minmax_element(flux.begin(), flux.end());
  return {error, *most - *least};
}

// Away from the edges two relaxation times make the flow exact; the edges, where a wall's
// bounce-back stands beside the face's rule, disturb it by a part of second order.
TEST(OpenFaces, PressureDrivesPoiseuilleFlow)
{
  for (auto [dimension, d, w] : {std::array{2, 0, 1}, std::array{2, 1, 0}, std::array{3, 0, 1},
                                 std::array{3, 2, 0}, std::array{3, 1, 2}}) {
    const auto [coarse, spread] = pressure_channel(dimension, d, w, 8);
    const auto [fine, spread2] = pressure_channel(dimension, d, w, 16);
    EXPECT_LT(coarse, 6e-3);
    EXPECT_GT(std::log2(coarse / fine), 1.8);
    EXPECT_LT(spread, 2e-6);    // the density differs by 1e-7 between the ends
    EXPECT_LT(spread2, 2e-6);
  }
}

// A parabola that comes in is there as it was asked for, at every node of the face, a product of two
// between four walls; and the channel carries it on as Poiseuille flow
TEST(OpenFaces, ParabolaComesIn)
{
  const double speed = 1e-6;
  for (int dimension : {2, 3}) {
    Settings s;
    s.dimension = dimension;
    s.tau = 0.9;
    const Int3 n{33, 16, dimension == 3 ? 12 : 1};
    for (int d = 1; d < dimension; d++) s.faces[d][0].kind = s.faces[d][1].kind = FaceKind::WALL;
    s.faces[0][0] = {FaceKind::VELOCITY, {speed, 0.0, 0.0}};
    s.faces[0][0].parabolic = true;
    s.faces[0][1].kind = FaceKind::PRESSURE;
    scene::Box box(s, n);
    for (int t = 0; t < 4000; t++) box.advance();
    const auto shape = [&](int d, int p) {
      const double h = (p + 0.5) / n[d];
      return 4.0 * h * (1.0 - h);
    };
    box.for_each_node([&](int x, int y, int z) {
      const double expected = shape(1, y) * (dimension == 3 ? shape(2, z) : 1.0);
      const bool edge = y == 0 || y == n[1] - 1 || (dimension == 3 && (z == 0 || z == n[2] - 1));
      if (x == 0 && !edge) ASSERT_NEAR(box.at(x, y, z).u[0] / speed, expected, 1e-10);
      // the edges, where a wall wins, disturb it by a part of second order
      if (x == n[0] / 2 && dimension == 2)
        ASSERT_NEAR(box.at(x, y, z).u[0] / speed, expected, 6e-3);
    });
  }
}

}    // namespace
