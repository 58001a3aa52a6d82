// SPDX-License-Identifier: GPL-2.0-only
// Enclosed fluid is found, counted as a plain flood would count it, and does not drift when the
// grains around it tremble.

#include "scene.h"

#include <gtest/gtest.h>

#include <set>

using namespace lbm;

namespace {

struct Count {
  double sets = 0.0, nodes = 0.0;
};

// by a flood from node to node along the velocities of the lattice
template <class L> Count flood(const scene::Box &box)
{
  const Int3 n = box.n;
  std::set<Int3> left;
  box.for_each_fluid_node([&](int x, int y, int z) {
    left.insert({x, y, z});
  });
  std::vector<double> closed, all;
  while (!left.empty()) {
    std::vector<Int3> list{*left.begin()};
    left.erase(left.begin());
    bool open = false;
    for (std::size_t k = 0; k < list.size(); k++)
      for (int i = 1; i < L::Q; i++) {
        Int3 p = list[k];
        bool there = true, outside = false, wall = false;
        for (int d = 0; d < 3; d++) {
          p[d] += L::e[i][d];
          const FaceKind kind = box.settings.faces[d][p[d] < 0 ? 0 : 1].kind;
          if (p[d] >= 0 && p[d] < n[d]) continue;
          there = there && kind == FaceKind::PERIODIC;
          wall = wall || kind == FaceKind::WALL;
          outside = outside || kind == FaceKind::PRESSURE;
          p[d] = (p[d] + n[d]) % n[d];
        }
        open = open || (outside && !wall);
        if (there && left.erase(p)) list.push_back(p);
      }
    all.push_back(double(list.size()));
    closed.push_back(open ? 0.0 : double(list.size()));
  }
  Count count;
  if (all.empty()) return count;
  closed[std::max_element(all.begin(), all.end()) - all.begin()] = 0.0;
  for (double size : closed) {
    count.nodes += size;
    count.sets += size > 0.0;
  }
  return count;
}

class EnclosedIn : public testing::TestWithParam<int> {
 protected:
  Settings settings;
  EnclosedIn() { settings.dimension = GetParam(); }
  bool flat() const { return GetParam() == 2; }
  Int3 box_of(int width) const { return {width, width + 3, flat() ? 1 : width - 2}; }
  Count found(scene::Box &box) const
  {
    box.fluid->inspect();
    return {box.fluid->enclosed_sets(), box.fluid->enclosed_nodes()};
  }
  Count expected(const scene::Box &box) const
  {
    return flat() ? flood<D2Q9>(box) : flood<D3Q19>(box);
  }

  // spheres that overlap and enclose a hollow with a radius of some two nodes, around the middle
  std::vector<Sphere> shell(const Int3 &n) const
  {
    std::vector<Vec3> places;
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;
    if (flat()) {
      for (int k = 0; k < 8; k++)
        places.push_back({std::cos(k * M_PI / 4), std::sin(k * M_PI / 4), 0});
    } else {    // a dodecahedron
      for (double a : {-1.0, 1.0})
        for (double b : {-1.0, 1.0}) {
          for (double c : {-1.0, 1.0}) places.push_back({a, b, c});
          for (int d = 0; d < 3; d++) {
            Vec3 p{};
            p[(d + 1) % 3] = a / g;
            p[(d + 2) % 3] = b * g;
            places.push_back(p);
          }
        }
    }
    std::vector<Sphere> list;
    for (const Vec3 &p : places) {
      Vec3 c;
      for (int d = 0; d < 3; d++) c[d] = 0.5 * n[d] + 0.1 + 6.2 * p[d] / scene::norm(p);
      list.push_back(scene::sphere(std::int64_t(list.size()), c, 4.0));
    }
    return list;
  }

  // each sphere about its place, on its own
  std::vector<Sphere> trembling(std::vector<Sphere> list, int t) const
  {
    constexpr double far = 0.08;
    for (Sphere &s : list)
      for (int d = 0; d < GetParam(); d++) {
        const double w = 0.02 + 0.003 * ((7 * s.id + 3 * d) % 11), phase = 1.7 * s.id + d;
        s.centre[d] += far * std::sin(w * t + phase);
        s.velocity[d] = far * w * std::cos(w * t + phase);
      }
    for (Sphere &s : list) s.centre = scene::snapped(s.centre);
    return list;
  }

  // mean density excess of the fluid within 3.5 nodes of the middle, and of all the rest
  std::array<double, 2> excess(const scene::Box &box) const
  {
    double sum[2] = {}, nodes[2] = {};
    box.for_each_fluid_node([&](int x, int y, int z) {
      const Vec3 r{x + 0.4 - 0.5 * box.n[0], y + 0.4 - 0.5 * box.n[1],
                   flat() ? 0.0 : z + 0.4 - 0.5 * box.n[2]};
      const int outside = scene::norm(r) > 4.0;
      sum[outside] += box.at(x, y, z).drho;
      nodes[outside] += 1.0;
    });
    EXPECT_GT(nodes[0], 10.0);
    return {sum[0] / nodes[0], sum[1] / nodes[1]};
  }
};

// crowds of grains that overlap, with all kinds of faces
TEST_P(EnclosedIn, IsCountedAsByAFlood)
{
  double sets = 0.0;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (FaceKind kind : {FaceKind::PERIODIC, FaceKind::WALL, FaceKind::PRESSURE})
    for (int width : {20, 66}) {
      if (!flat() && width > 30) width = 31;
      settings.faces = {};
      for (Face &face : settings.faces[1]) face.kind = kind;
      scene::Box box(settings, box_of(width));
      const Int3 n = box.n;
      std::vector<Sphere> grains;
      for (int k = 0; k < n[0] * n[1] * n[2] / (flat() ? 12 : 60); k++)
        grains.push_back(scene::sphere(
            k, {n[0] * unit(random), n[1] * unit(random), flat() ? 0.0 : n[2] * unit(random)},
            2.0 + 1.5 * unit(random)));
      box.step(grains);
      const Count count = found(box), right = expected(box);
      EXPECT_EQ(count.sets, right.sets) << width;
      EXPECT_EQ(count.nodes, right.nodes) << width;
      sets += right.sets;
    }
  EXPECT_GT(sets, 30.0);
}

TEST_P(EnclosedIn, NothingIsWithoutGrainsOrWithFew)
{
  scene::Box box(settings, box_of(16));
  EXPECT_EQ(found(box).sets, 0.0);
  box.step({scene::sphere(1, {8.2, 9.1, flat() ? 0.0 : 7.3}, 4.0)});
  EXPECT_EQ(found(box).sets, 0.0);
  box.step(shell(box.n));
  EXPECT_EQ(found(box).sets, 1.0);
  box.step({});
  EXPECT_EQ(found(box).sets, 0.0);
}

// the mean of many steps, as it rings; and it would drift if it were left alone
TEST_P(EnclosedIn, DoesNotDrift)
{
  const int steps = flat() ? 6000 : 1500;
  double away[2] = {};
  for (bool inspected : {false, true}) {
    scene::Box box(settings, box_of(24));
    box.conserve = true;
    const auto grains = shell(box.n);
    for (int t = 0; t < steps; t++) {
      box.follow(trembling(grains, t));
      if (inspected && t % 100 == 0) box.fluid->inspect();
      box.advance();
      if (t < steps / 2) continue;
      const auto drho = excess(box);
      away[inspected] += (drho[0] - drho[1]) / (steps / 2);
    }
    if (inspected) {
      EXPECT_EQ(box.fluid->enclosed_sets(), 1.0);
      const Ledger ledger = box.fluid->ledger();
      EXPECT_NEAR(box.fluid->survey().mass - double(box.n[0]) * box.n[1] * box.n[2], ledger.total(),
                  1e-9);
    }
  }
  EXPECT_LT(std::abs(away[1]), 2e-4);
  EXPECT_GT(std::abs(away[0]), 50.0 * std::abs(away[1]));
}

INSTANTIATE_TEST_SUITE_P(Dimension, EnclosedIn, testing::Values(2, 3));

}    // namespace
