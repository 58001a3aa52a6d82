// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_overlap.h"

#include <algorithm>
#include <cmath>

namespace lbm {

namespace {
  constexpr int RAYS = 4096;

  // Ray k from the centre: evenly on a circle, or on a sphere by the golden angle (Gonzalez,
  // Mathematical Geosciences 42, 49 (2010))
  Vec3 ray(int k, int dimension)
  {
    const double pi = std::acos(-1.0);
    if (dimension == 2) {
      const double angle = 2.0 * pi * (k + 0.5) / RAYS;
      return {std::cos(angle), std::sin(angle), 0.0};
    }
    const double z = (2.0 * k + 1.0) / RAYS - 1.0, rho = std::sqrt(1.0 - z * z);
    const double angle = pi * (3.0 - std::sqrt(5.0)) * k;
    return {rho * std::cos(angle), rho * std::sin(angle), z};
  }

  // How far along n the other sphere lies less deep: R - |t n - d| = r - t is linear in t,
  // t = (d^2 - D^2) / 2 (n d + D), D = R - r; beyond it the other one is the deeper for ever
  double reach(const Vec3 &n, const Overlap &other, double radius)
  {
    const double D = other.radius - radius, along = dot(n, other.away) + D;
    const double excess = dot(other.away, other.away) - D * D;
    // one inside the other, both touching from within included: a single owner
    if (excess <= 0.0) return (D > 0.0 || (D == 0.0 && other.precedes)) ? 0.0 : radius;
    return along > 0.0 ? std::min(radius, 0.5 * excess / along) : radius;
  }
}    // namespace

double kept_share(double radius, const std::vector<Overlap> &others, int dimension)
{
  if (others.empty()) return 1.0;
  double sum = 0.0;
  for (int k = 0; k < RAYS; k++) {
    const Vec3 n = ray(k, dimension);
    double t = radius;
    for (const Overlap &other : others) t = std::min(t, reach(n, other, radius));
    const double part = t / radius;
    sum += dimension == 2 ? part * part : part * part * part;
  }
  return sum / RAYS;
}

}    // namespace lbm
