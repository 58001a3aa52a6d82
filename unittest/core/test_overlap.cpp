// SPDX-License-Identifier: GPL-2.0-only

// Volume of overlapping spheres, shared out among them, against closed forms and counted points.

#include "lbm_overlap.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

using lbm::kept_share;
using lbm::Overlap;
using lbm::Vec3;

namespace {
const double PI = std::acos(-1.0);

struct Ball {
  Vec3 c;
  double r;
};

double volume(double r, int dimension)
{
  return dimension == 2 ? PI * r * r : 4.0 / 3.0 * PI * r * r * r;
}

// of the union, as the sum of what each ball keeps
double kept(const std::vector<Ball> &balls, int dimension)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < balls.size(); i++) {
    std::vector<Overlap> others;
    for (std::size_t j = 0; j < balls.size(); j++) {
      if (i == j) continue;
      Vec3 away;
      for (int d = 0; d < 3; d++) away[d] = balls[j].c[d] - balls[i].c[d];
      others.push_back({away, balls[j].r, j < i});
    }
    sum += volume(balls[i].r, dimension) * kept_share(balls[i].r, others, dimension);
  }
  return sum;
}

// two balls d apart: Weisstein, "Sphere-sphere intersection", eq. 16; "Circle-circle intersection",
// eq. 14 (MathWorld)
double lens(double R, double r, double d, int dimension)
{
  if (dimension == 3)
    return PI * std::pow(R + r - d, 2) * (d * d + 2 * d * (r + R) - 3 * (r - R) * (r - R)) /
        (12 * d);
  const double root = std::sqrt((-d + r + R) * (d + r - R) * (d - r + R) * (d + r + R));
  return r * r * std::acos((d * d + r * r - R * R) / (2 * d * r)) +
      R * R * std::acos((d * d + R * R - r * r) / (2 * d * R)) - 0.5 * root;
}
}    // namespace

TEST(Overlap, AloneOrApart)
{
  EXPECT_EQ(kept_share(3.0, {}, 3), 1.0);
  EXPECT_EQ(kept_share(3.0, {{{6.0, 0, 0}, 3.0, true}}, 3), 1.0);
}

TEST(Overlap, TwoBallsLoseTheirLens)
{
  for (const int dimension : {2, 3})
    for (const double r : {3.0, 2.0, 1.3})
      for (const double d : {1.9, 2.7, 4.1}) {
        const Vec3 other{d * 0.6, d * 0.8, 0.0};
        const double all = volume(3.0, dimension) + volume(r, dimension);
        EXPECT_NEAR(kept({{{}, 3.0}, {other, r}}, dimension), all - lens(3.0, r, d, dimension),
                    3e-4 * all)
            << dimension << " " << r << " " << d;
      }
}

TEST(Overlap, OneInsideTheOther)
{
  for (const int dimension : {2, 3}) {
    const double whole = volume(3.0, dimension);
    EXPECT_DOUBLE_EQ(kept({{{}, 3.0}, {{}, 3.0}, {{}, 3.0}}, dimension), whole);
    EXPECT_DOUBLE_EQ(kept({{{}, 3.0}, {{0.4, 0.2, 0.0}, 2.0}}, dimension), whole);
    EXPECT_DOUBLE_EQ(kept({{{1.0, 0, 0}, 2.0}, {{}, 3.0}}, dimension), whole);    // touch within
  }
}

// where three meet, inclusion and exclusion by pairs would be wrong
TEST(Overlap, ThreeBallsAgainstPoints)
{
  const std::vector<Ball> balls = {
      {{0, 0, 0}, 3.0}, {{2.0, 0.4, 0.3}, 2.5}, {{0.7, 2.1, -0.5}, 2.0}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-5.0, 5.0);
  const int points = 400000;
  int inside = 0;
  for (int k = 0; k < points; k++) {
    const Vec3 p{u(random), u(random), u(random)};
    bool in = false;
    for (const Ball &b : balls)
      in = in || std::hypot(p[0] - b.c[0], p[1] - b.c[1], p[2] - b.c[2]) < b.r;
    inside += in;
  }
  const double counted = 1000.0 * inside / points;
  // binomial: sqrt(n p (1-p)), p = .2: three of them are 0.006
  EXPECT_NEAR(kept(balls, 3) / counted, 1.0, 0.007);
}
