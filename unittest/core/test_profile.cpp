// SPDX-License-Identifier: GPL-2.0-only
// The fluid by layers across an axis: exact where the answer is known, Darcy's law where it is not.

#include "scene.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

std::vector<Layer> profile(const scene::Box &box, int axis, int width, double force = 0.0)
{
  const Planes sums = box.fluid->planes(axis, box.n[axis]);
  const double across = double(box.n[0]) * box.n[1] * box.n[2] / box.n[axis];
  return layers(sums, across, width, scene::periodic(box.settings)[axis], force);
}

Settings settings(int dimension, int axis, FaceKind kind)
{
  Settings s;
  s.dimension = dimension;
  for (int side = 0; side < 2; side++) s.faces[axis][side].kind = kind;
  return s;
}

// a density that rises along the axis: pressure and gradient of every layer to round-off, whatever
// spheres hide of it, at the ends of the box as inside
void uniform_gradient(int dimension, int axis)
{
  const Int3 n{12, 12, dimension == 3 ? 12 : 1};
  scene::Box box(settings(dimension, axis, FaceKind::PRESSURE), n);
  const double slope = 3e-3, middle = dimension == 3 ? 5.2 : 0.0;
  box.follow(
      {scene::sphere(1, {4.1, 5.3, middle}, 3.6), scene::sphere(2, {9.0, 9.2, middle}, 2.1)});
  box.for_each_node([&](int x, int y, int z) {
    box.fluid->set_equilibrium(x, y, z, {slope * Int3{x, y, z}[axis], {}});
  });
  for (int width : {1, 2, 3, 4, 6, 12}) {
    const auto all = profile(box, axis, width);
    ASSERT_EQ(int(all.size()), 12 / width);
    double length = 0.0;
    for (std::size_t k = 0; k < all.size(); k++) {
      EXPECT_NEAR(all[k].pressure, slope / 3.0 * (k * width + 0.5 * (width - 1)), 1e-15);
      EXPECT_NEAR(all[k].gradient, -slope / 3.0, 1e-15);
      EXPECT_NEAR(all[k].flux, 0.0, 1e-15);
      length += all[k].length;
    }
    EXPECT_NEAR(length, 11.0, 1e-14);    // between the outermost planes
  }
}

TEST(Profile, UniformGradientIsExact)
{
  for (int dimension : {2, 3})
    for (int axis = 0; axis < dimension; axis++) uniform_gradient(dimension, axis);
}

// fluid at rest under its weight on a wall: its pressure balances the force, nothing drives it
TEST(Profile, HydrostaticColumnDrivesNothing)
{
  const double F = -2e-4;
  Settings s = settings(3, 2, FaceKind::WALL);
  s.faces[2][1].kind = FaceKind::PRESSURE;
  s.faces[2][1].drho = 0.0;
  scene::Box box(s, {8, 8, 12}, {0, 0, F});
  box.for_each_node([&](int x, int y, int z) {
    box.fluid->set_equilibrium(x, y, z, {3.0 * F * (z - 11), {}});
  });
  for (int t = 0; t < 50; t++) box.step({scene::sphere(1, {3.4, 4.1, 5.2}, 2.6)});
  for (int width : {1, 3, 12})
    for (const Layer &l : profile(box, 2, width, F)) {
      EXPECT_NEAR(l.gradient, 0.0, 1e-13);
      EXPECT_NEAR(l.flux, 0.0, 1e-13);
    }
  EXPECT_NEAR(profile(box, 2, 3, F)[0].pressure, -F * 10.0, 1e-13);
}

TEST(Profile, PorosityCountsNodes)
{
  const Int3 n{7, 8, 10};
  scene::Box box(settings(3, 0, FaceKind::PERIODIC), n);
  box.follow({scene::sphere(1, {6.3, 5.3, 9.2}, 3.1)});
  for (int axis = 0; axis < 3; axis++)
    for (int width : {1, n[axis]}) {
      std::vector<double> fluid(n[axis] / width, 0.0);
      box.for_each_fluid_node([&](int x, int y, int z) {
        fluid[Int3{x, y, z}[axis] / width] += 1.0;
      });
      const auto all = profile(box, axis, width);
      for (std::size_t k = 0; k < all.size(); k++)
        EXPECT_NEAR(all[k].porosity, fluid[k] * n[axis] / (560.0 * width), 1e-14);
    }
}

// planes and whole layers without fluid: no division by zero, the gradient across them is kept
TEST(Profile, LayersWithoutFluid)
{
  scene::Box box(settings(2, 1, FaceKind::WALL), {4, 24, 1});
  box.follow({scene::sphere(1, {2, 12, 0}, 6.0)});    // over its own images, no fluid in the middle
  box.for_each_node([&](int x, int y, int z) {
    box.fluid->set_equilibrium(x, y, z, {y < 12 ? 0.01 : -0.01, {}});
  });
  const auto all = profile(box, 1, 2);
  EXPECT_EQ(all[5].porosity, 0.0);
  double drop = 0.0;
  for (const Layer &l : all) {
    EXPECT_TRUE(std::isfinite(l.pressure + l.gradient + l.flux));
    drop += l.gradient * l.length;
  }
  EXPECT_NEAR(drop, 0.02 / 3.0, 1e-15);
  EXPECT_GT(all[5].gradient, 0.0);

  scene::Box full(settings(2, 1, FaceKind::PERIODIC), {4, 4, 1});
  full.follow({scene::sphere(1, {2, 2, 0}, 4.0)});
  for (const Layer &l : profile(full, 1, 1)) {
    EXPECT_EQ(l.porosity, 0.0);
    EXPECT_EQ(l.gradient, 0.0);
  }
}

// Three cells of a simple cubic array (solid fraction 1/8) between pressure faces: the same flux
// through every layer, the whole pressure difference spent, and the permeability of Zick & Homsy
// 1982, k = L^3/(6 pi a K), K = 4.292, which periodic cells driven by a force must have as well.
TEST(Profile, DarcyColumn)
{
  const int L = 16;
  const double a = L * std::cbrt(3.0 / (32.0 * M_PI)), drop = 1e-3;
  const double exact = L * L * L / (6.0 * M_PI * a * 4.292);
  std::vector<Sphere> spheres;
  for (int k = 0; k < 3; k++) spheres.push_back(scene::sphere(k + 1, {8.0, 8.0, L * (k + 0.5)}, a));
  Settings s = settings(3, 2, FaceKind::PRESSURE);
  s.tau = 1.0;
  s.faces[2][0].drho = 3.0 * drop;
  scene::Box box(s, {L, L, 3 * L});
  for (int t = 0; t < 1500; t++) box.step(spheres);
  const auto cells = profile(box, 2, L);
  double spent = 0.0;
  for (const Layer &l : cells) {
    EXPECT_NEAR(l.flux, cells[1].flux, 0.003 * cells[1].flux);    // the density changes by as much
    spent += l.gradient * l.length;
  }
  // mass is conserved by links, not by nodes: single planes scatter as spheres cut them
  for (const Layer &l : profile(box, 2, 1))
    EXPECT_NEAR(l.flux, cells[1].flux, 0.03 * cells[1].flux);
  EXPECT_NEAR(spent, drop, 1e-13);
  const double nu = (s.tau - 0.5) / 3.0, k = cells[1].flux * nu / cells[1].gradient;
  EXPECT_NEAR(k, exact, 0.03 * exact);

  Settings p = settings(3, 2, FaceKind::PERIODIC);
  p.tau = 1.0;
  scene::Box cell(p, {L, L, L}, {0, 0, drop / (3 * L)});
  for (int t = 0; t < 1500; t++) cell.step({spheres[0]});
  const auto all = profile(cell, 2, L, drop / (3 * L));
  EXPECT_NEAR(all[0].gradient, drop / (3 * L), 1e-16);
  EXPECT_NEAR(all[0].flux * nu / all[0].gradient, k, 0.005 * k);
}

TEST(Profile, PartsOfSpheres)
{
  for (int dimension : {2, 3}) {
    const double r = 1.7, all = dimension == 2 ? M_PI * r * r : 4.0 / 3.0 * M_PI * r * r * r;
    EXPECT_NEAR(volume_below(-2.0, r, dimension), 0.0, 1e-14);
    EXPECT_NEAR(volume_below(2.0, r, dimension), all, 1e-14);
    EXPECT_NEAR(volume_below(0.0, r, dimension), 0.5 * all, 1e-14);
    const double h = 1e-4;    // slices grow by the section
    for (double z : {-1.5, -0.3, 0.9}) {
      const double section = dimension == 2 ? 2.0 * std::sqrt(r * r - z * z)
                                            : M_PI * (r * r - z * z);
      EXPECT_NEAR((volume_below(z + h, r, dimension) - volume_below(z - h, r, dimension)) / (2 * h),
                  section, 1e-6);
    }
  }
}

}    // namespace
