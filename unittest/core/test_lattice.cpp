// SPDX-License-Identifier: GPL-2.0-only
// The tables everything stands on, and the algebra of in-place streaming.

#include "lbm_bounce_back.h"
#include "lbm_equilibrium.h"
#include "lbm_halo.h"
#include "lbm_link.h"
#include "lbm_sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

using namespace lbm;

namespace {

template <class L> class Lattice : public ::testing::Test {
};
using Lattices = ::testing::Types<D3Q19, D2Q9>;
TYPED_TEST_SUITE(Lattice, Lattices);

TYPED_TEST(Lattice, OppositesAndDistinctDirections)
{
  using L = TypeParam;
  EXPECT_EQ(2 * L::P + 1, L::Q);
  std::set<Int3> seen;
  for (int i = 0; i < L::Q; i++) {
    const int o = opposite<L>(i);
    EXPECT_EQ(opposite<L>(o), i);
    for (int d = 0; d < 3; d++) EXPECT_EQ(L::e[o][d], -L::e[i][d]);
    EXPECT_EQ(L::w[o], L::w[i]);
    seen.insert({L::e[i][0], L::e[i][1], L::e[i][2]});
  }
  EXPECT_EQ(seen.size(), std::size_t(L::Q));
}

// sum w = 1, w e e = I/3, w e e e e = (II + II + II)/9: what the Navier-Stokes equations need
TYPED_TEST(Lattice, WeightsAreIsotropicToFourthOrder)
{
  using L = TypeParam;
  auto delta = [](int a, int b) {
    return a == b ? 1.0 : 0.0;
  };
  double zero = 0.0;
  for (int i = 0; i < L::Q; i++) zero += L::w[i];
  EXPECT_NEAR(zero, 1.0, 1e-15);
  for (int a = 0; a < L::D; a++)
    for (int b = 0; b < L::D; b++) {
      double second = 0.0;
      for (int i = 0; i < L::Q; i++) second += L::w[i] * L::e[i][a] * L::e[i][b];
      EXPECT_NEAR(second, delta(a, b) / 3.0, 1e-15);
      for (int c = 0; c < L::D; c++)
        for (int d = 0; d < L::D; d++) {
          double fourth = 0.0;
          for (int i = 0; i < L::Q; i++)
            fourth += L::w[i] * L::e[i][a] * L::e[i][b] * L::e[i][c] * L::e[i][d];
          EXPECT_NEAR(
              fourth,
              (delta(a, b) * delta(c, d) + delta(a, c) * delta(b, d) + delta(a, d) * delta(b, c)) /
                  9.0,
              1e-15);
        }
    }
}

TYPED_TEST(Lattice, EquilibriumHasItsMoments)
{
  using L = TypeParam;
  const Moments m{0.07, {0.05, -0.03, L::D == 3 ? 0.04 : 0.0}};
  double rho = 1.0, j[3] = {}, P[3][3] = {};
  for (int i = 0; i < L::Q; i++) {
    const double f = equilibrium<L>(i, m);
    rho += f;
    for (int a = 0; a < L::D; a++) {
      j[a] += L::e[i][a] * f;
      for (int b = 0; b < L::D; b++) P[a][b] += L::e[i][a] * L::e[i][b] * f;
    }
  }
  EXPECT_NEAR(rho, 1.07, 1e-15);
  for (int a = 0; a < L::D; a++) {
    EXPECT_NEAR(j[a], 1.07 * m.u[a], 1e-16);
    for (int b = 0; b < L::D; b++)    // pressure excess drho/3 and momentum flux rho u u
      EXPECT_NEAR(P[a][b], (a == b ? 0.07 / 3.0 : 0.0) + 1.07 * m.u[a] * m.u[b], 1e-16);
  }
}

// N_s(i, n) of all owned nodes: one address each, at every step
TYPED_TEST(Lattice, EverySlotHasOneOwner)
{
  using L = TypeParam;
  const Layout at({0, 0, 0}, {5, 4, L::D == 3 ? 3 : 1}, L::D);
  const Block<L> block(at);
  for (int s = 0; s < 2; s++) {
    const Slots<L> f = block.slots(s);
    std::set<const double *> seen;
    for (int z = 0; z < at.n[2]; z++)
      for (int y = 0; y < at.n[1]; y++)
        for (int x = 0; x < at.n[0]; x++)
          for (int i = 0; i < L::Q; i++) seen.insert(&f[i][at.index(x, y, z)]);
    EXPECT_EQ(seen.size(), std::size_t(L::Q * at.nodes()));
  }
}

template <class L> struct Nothing {
  template <class V, class Force> V operator()(V (&)[L::Q], const Force &) const { return V{}; }
};

// A collision that does nothing: every population must be found i * t cells on, at both parities
TYPED_TEST(Lattice, StreamingMovesEveryPopulationByItsVelocity)
{
  using L = TypeParam;
  for (const Int3 n : {Int3{11, 5, 4}, Int3{8, 3, 2}, Int3{1, 2, 1}, Int3{17, 1, 3}}) {
    const Layout at({0, 0, 0}, {n[0], n[1], L::D == 3 ? n[2] : 1}, L::D);
    Block<L> block(at);
    Alone alone({true, true, true});
    Halo<L> halo(at, alone);
    auto value = [&](int i, int x, int y, int z) {
      return i + 100.0 * (x + 100.0 * (y + 100.0 * z));
    };
    auto for_each = [&](auto &&g) {
      for (int z = 0; z < at.n[2]; z++)
        for (int y = 0; y < at.n[1]; y++)
          for (int x = 0; x < at.n[0]; x++)
            for (int i = 0; i < L::Q; i++) g(i, x, y, z);
    };
    for_each([&](int i, int x, int y, int z) {
      block.slots()[i][at.index(x, y, z)] = value(i, x, y, z);
    });
    for (int t = 1; t <= 5; t++) {
      sweep(block, Nothing<L>{}, NoForce{}, NoSolids{});
      halo.exchange(block);
      block.advance();
      for_each([&](int i, int x, int y, int z) {
        Int3 from{x, y, z};
        for (int d = 0; d < 3; d++)
          from[d] = ((from[d] - t * L::e[i][d]) % at.n[d] + 5 * at.n[d]) % at.n[d];
        ASSERT_EQ(block.slots()[i][at.index(x, y, z)], value(i, from[0], from[1], from[2]))
            << "step " << t << " direction " << i;
      });
    }
  }
}

TYPED_TEST(Lattice, CollisionConservesMassAndAddsTheForce)
{
  using L = TypeParam;
  const UniformForce force{{1e-3, -2e-3, L::D == 3 ? 3e-3 : 0.0}};
  for (const auto &collide : {Trt<L>::trt(0.6, 3.0 / 16), Trt<L>::bgk(1.3)}) {
    double f[L::Q], before[4] = {}, after[4] = {};
    for (int i = 0; i < L::Q; i++) f[i] = 0.01 * std::sin(1.0 + 7.0 * i);
    auto add = [&](double *sum) {
      for (int i = 0; i < L::Q; i++) {
        sum[3] += f[i];
        for (int d = 0; d < 3; d++) sum[d] += L::e[i][d] * f[i];
      }
    };
    add(before);
    EXPECT_NEAR(collide(f, force), before[3], 1e-16);
    add(after);
    EXPECT_NEAR(after[3], before[3], 1e-16);
    for (int d = 0; d < L::D; d++) EXPECT_NEAR(after[d] - before[d], force.F[d], 1e-16);
  }
}

// a fluid in equilibrium stays so, whatever the rates
TYPED_TEST(Lattice, CollisionLeavesEquilibrium)
{
  using L = TypeParam;
  const Moments m{0.03, {0.05, -0.03, L::D == 3 ? 0.04 : 0.0}};
  double f[L::Q];
  for (int i = 0; i < L::Q; i++) f[i] = equilibrium<L>(i, m);
  Trt<L>::trt(0.7, 0.25)(f, NoForce{});
  for (int i = 0; i < L::Q; i++) EXPECT_NEAR(f[i], equilibrium<L>(i, m), 1e-16);
}

TEST(Rules, CoefficientsSumToOneAndMeetAtHalf)
{
  auto check = [](auto rule, bool interpolated) {
    for (double q : {1e-6, 0.1, 0.49, 0.5, 0.51, 0.9, 1.0}) {
      const Coefficients<double> c = rule.at(q);
      EXPECT_NEAR(c.c1 + c.c2 + c.c3, 1.0, 1e-15);
      if (q == 0.5 || !interpolated) {
        EXPECT_DOUBLE_EQ(c.c1, 1.0);
        EXPECT_DOUBLE_EQ(c.c2, 0.0);
        EXPECT_DOUBLE_EQ(c.c4, 2.0);
      }
    }
  };
  check(Halfway{}, false);
  check(Bouzidi{}, true);
  check(Cli{}, true);
}

// packs take the same branch as single numbers, lane by lane
TEST(Rules, PacksEqualSingleNumbers)
{
  using V = Pack<SIMD_WIDTH>;
  V q;
  for (int k = 0; k < SIMD_WIDTH; k++) q[k] = 0.05 + 0.9 * k / (SIMD_WIDTH - 1.0);
  const Coefficients<V> pack = Bouzidi::at(q);
  for (int k = 0; k < SIMD_WIDTH; k++) {
    const Coefficients<double> one = Bouzidi::at(double(q[k]));
    EXPECT_DOUBLE_EQ(pack.c1[k], one.c1);
    EXPECT_DOUBLE_EQ(pack.c2[k], one.c2);
    EXPECT_DOUBLE_EQ(pack.c3[k], one.c3);
    EXPECT_DOUBLE_EQ(pack.c4[k], one.c4);
  }
}

TEST(Links, CutMeetsTheSphere)
{
  const int e[3] = {1, -1, 0};
  const double r = 3.2;
  for (double x : {-2.9, -2.6, -2.3}) {
    const double d[3] = {x, 1.9, 0.7};
    if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] <= r * r) continue;
    const double q = cut(d, e, r);
    if (q >= 1.0) continue;
    const Vec3 w{d[0] + q * e[0], d[1] + q * e[1], d[2]};
    EXPECT_NEAR(std::sqrt(dot(w, w)), r, 1e-15 * 10);
  }
  EXPECT_EQ(cut<double>({-3.2, 0.0, 0.0}, {1, 0, 0}, 3.2), Q_MIN);    // a node on the surface
}

TEST(Cover, CountsTheNodesOfABall)
{
  const Int3 n{13, 12, 11};
  const Layout at({0, 0, 0}, n, 3);
  Cover::Sides sides{};
  Cover cover(at, 3, sides);
  const Sphere s{1, {snap(6.21), snap(5.9), snap(5.43)}, 3.7, {}, {}};
  cover.place({s});
  long solid = 0, inside = 0;
  for (int z = 0; z < n[2]; z++)
    for (int y = 0; y < n[1]; y++)
      for (int x = 0; x < n[0]; x++) {
        const double d[3] = {x + .5 - s.centre[0], y + .5 - s.centre[1], z + .5 - s.centre[2]};
        const bool in = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < s.radius * s.radius;
        inside += in;
        solid += cover.owner()[at.index(x, y, z)] >= 0;
        EXPECT_EQ(cover.owner()[at.index(x, y, z)] >= 0, in);
      }
  EXPECT_EQ(solid, inside);
  EXPECT_GT(solid, 150);
  cover.place({});    // and gives them back
  for (Index i = 0; i < at.size; i++) ASSERT_EQ(cover.owner()[i], FLUID);
}

// two spheres that overlap: the deeper one owns a node, equal depths go to the smaller id, and the
// order of the list does not matter
TEST(Cover, OwnersDoNotDependOnTheOrderOfTheList)
{
  const Layout at({0, 0, 0}, {20, 12, 12}, 3);
  Cover::Sides sides{};
  Cover a(at, 3, sides), b(at, 3, sides);
  const std::vector<Sphere> list{{7, {7.5, 6.5, 6.5}, 4.0, {}, {}},
                                 {3, {11.5, 6.5, 6.5}, 4.0, {}, {}},
                                 {5, {9.5, 8.5, 6.5}, 3.0, {}, {}}};
  a.place(list);
  b.place({list[2], list[0], list[1]});
  const int to_a[] = {2, 0, 1};
  for (Index i = 0; i < at.size; i++) {
    const int32_t ob = b.owner()[i];
    ASSERT_EQ(a.owner()[i], ob < 0 ? ob : to_a[ob]);
  }
  EXPECT_EQ(a.owner()[at.index(9, 4, 6)], 1);    // in the middle of both: id 3
}

}    // namespace
