// SPDX-License-Identifier: GPL-2.0-only
// The film between spheres that nearly touch: what it must not do, and published coefficients.

#include "lbm_lubrication.h"

#include <gtest/gtest.h>

#include <random>

using namespace lbm;

namespace {

constexpr double PI = 3.14159265358979323846;
const Film FILM{0.7, 0.1, 0.08, 1e-6};

struct Pair {
  double a1, a2, gap;
  Vec3 n, u1, u2, spin1, spin2;
};

std::vector<Pair> pairs()
{
  std::mt19937 random(3);
  std::normal_distribution<double> draw;
  auto vector = [&] {
    return Vec3{draw(random), draw(random), draw(random)};
  };
  std::vector<Pair> list;
  for (double ratio : {1.0, 0.2, 7.0})
    for (double gap : {1e-4, 0.03, 0.09}) {
      Vec3 n = vector();
      const double length = std::sqrt(dot(n, n));
      for (double &x : n) x /= length;
      list.push_back({1.3, 1.3 * ratio, gap, n, vector(), vector(), vector(), vector()});
    }
  return list;
}

// to which terms that are large one by one cancel
double round_off(const Pair &p)
{
  return 1e-14 * 6 * PI * FILM.viscosity * std::pow(p.a1 + p.a2, 3) / p.gap;
}

FilmLoad of(const Pair &p)
{
  const Vec3 w{p.u2[0] - p.u1[0], p.u2[1] - p.u1[1], p.u2[2] - p.u1[2]};
  return film_of_spheres(FILM, p.a1, p.a2, p.n, p.gap, w, p.spin1, p.spin2);
}

// two spheres that move as one body: the film is not deformed
TEST(Lubrication, RigidMotionMeetsNoResistance)
{
  for (Pair p : pairs()) {
    p.spin2 = p.spin1;
    const Vec3 turned = cross(p.spin1, p.n);
    for (int d = 0; d < 3; d++) p.u2[d] = p.u1[d] + (p.a1 + p.a2) * turned[d];
    const FilmLoad load = of(p);
    for (const Vec3 &v : {load.force, load.torque1, load.torque2})
      for (double x : v) EXPECT_NEAR(x, 0.0, round_off(p));
  }
}

TEST(Lubrication, AngularMomentumIsKept)
{
  for (const Pair &p : pairs()) {
    const FilmLoad load = of(p);
    const Vec3 orbital = cross(p.n, load.force);
    for (int d = 0; d < 3; d++)
      EXPECT_NEAR(load.torque1[d] + load.torque2[d] - (p.a1 + p.a2) * orbital[d], 0.0,
                  round_off(p));
  }
}

TEST(Lubrication, TheOrderOfTheSpheresDoesNotMatter)
{
  for (const Pair &p : pairs()) {
    Pair q{p.a2, p.a1, p.gap, {-p.n[0], -p.n[1], -p.n[2]}, p.u2, p.u1, p.spin2, p.spin1};
    const FilmLoad a = of(p), b = of(q);
    for (int d = 0; d < 3; d++) {
      EXPECT_NEAR(a.force[d], -b.force[d], round_off(p));
      EXPECT_NEAR(a.torque1[d], b.torque2[d], round_off(p));
    }
  }
}

TEST(Lubrication, AlwaysTakesEnergy)
{
  for (const Pair &p : pairs()) {
    const FilmLoad load = of(p);
    double power = 0.0;
    for (int d = 0; d < 3; d++)
      power += load.force[d] * (p.u1[d] - p.u2[d]) + load.torque1[d] * p.spin1[d] +
          load.torque2[d] * p.spin2[d];
    if (p.gap < FILM.reach())
      EXPECT_LT(power, 0.0);
    else
      EXPECT_EQ(power, 0.0);
  }
}

// limits of a wall: 1, 8/15, 1/10, 2/15, 2/5 (Goldman, Cox & Brenner 1967)
TEST(Lubrication, CoefficientsAtAWall)
{
  const double a = 1.3, gap = 0.01, mu = FILM.viscosity, L = std::log(FILM.shear / gap);
  const Vec3 n{0, 0, -1};
  const FilmLoad squeezed = film_at_wall(FILM, a, n, gap, {0, 0, 2}, {});    // towards each other
  EXPECT_NEAR(squeezed.force[2], 6 * PI * mu * a * a * (1 / gap - 1 / FILM.normal) * 2, 1e-10);
  const FilmLoad slid = film_at_wall(FILM, a, n, gap, {1, 0, 0}, {});
  EXPECT_NEAR(slid.force[0], 6 * PI * mu * a * 8 / 15 * L, 1e-12);
  EXPECT_NEAR(slid.torque1[1], -8 * PI * mu * a * a / 10 * L, 1e-12);    // n x w: as it would roll
  const FilmLoad turned = film_at_wall(FILM, a, n, gap, {}, {0, 1, 0});
  EXPECT_NEAR(turned.force[0], 6 * PI * mu * a * a * 2 / 15 * L, 1e-12);
  EXPECT_NEAR(turned.torque1[1], -8 * PI * mu * a * a * a * 2 / 5 * L, 1e-12);
  // and a wall is a large sphere
  const FilmLoad sphere = film_of_spheres(FILM, a, 1e7 * a, n, gap, {1, 0, 2}, {0, 1, 0}, {});
  const FilmLoad wall = film_at_wall(FILM, a, n, gap, {1, 0, 2}, {0, 1, 0});
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(sphere.force[d], wall.force[d], 1e-5 * std::abs(wall.force[d]) + 1e-12);
    EXPECT_NEAR(sphere.torque1[d], wall.torque1[d], 1e-5 * std::abs(wall.torque1[d]) + 1e-12);
  }
}

TEST(Lubrication, EndsAtItsCutOffsWithoutAJumpAndStopsGrowingAtTheThinnestFilm)
{
  const Vec3 n{1, 0, 0}, w{-1, 1, 0};
  auto force = [&](double gap) {
    return film_of_spheres(FILM, 1.0, 2.0, n, gap, w, {}, {}).force;
  };
  EXPECT_EQ(force(FILM.normal)[0], 0.0);
  EXPECT_NEAR(force(FILM.normal * (1 - 1e-9))[0], 0.0, 1e-6);
  EXPECT_NEAR(force(FILM.shear * (1 - 1e-9))[1], 0.0, 1e-6);
  EXPECT_EQ(force(1e-9), force(FILM.least));
  EXPECT_LT(force(1e-3)[0], force(1e-2)[0]);    // pushed away from what comes nearer
}

}    // namespace
