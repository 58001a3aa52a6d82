// SPDX-License-Identifier: GPL-2.0-only
// Momentum that a link gives to its sphere, and sums of it; formula and source: lbm_exchange.h.
// Lattice units; V is a number or a pack.

#ifndef LBM_MOMENTUM_H
#define LBM_MOMENTUM_H

#include "lbm_simd.h"
#include "lbm_sphere.h"

namespace lbm {

// mass, if there is a ledger of it
template <class V, bool ledger> struct Swallowed {
  V swallowed = V{}, displaced = V{};
};
template <class V> struct Swallowed<V, false> {
};

// what one direction of one sphere adds up, in packs; the links of surfaces at rest are pressed
// along e alone, and torque then holds the sum of arm times pressure
template <class V, bool ledger> struct Sums : Swallowed<V, ledger> {
  V force[3] = {V{}, V{}, V{}}, torque[3] = {V{}, V{}, V{}}, pressing = V{};
  double links = 0.0;

  // of the first n numbers of each pack
  void add_first(const Sums &other, int n)
  {
    V keep{};
    for (int k = 0; k < n; k++) keep[k] = 1.0;
    for (int d = 0; d < 3; d++) {
      force[d] += keep * other.force[d];
      torque[d] += keep * other.torque[d];
    }
    pressing += keep * other.pressing;
    if constexpr (ledger) {
      this->swallowed += keep * other.swallowed;
      this->displaced += keep * other.displaced;
    }
  }
};

template <Motion motion, class V, bool ledger>
void add(const Sums<V, ledger> &sums, const int (&e)[3], double w, Load &load)
{
  constexpr bool moving = motion != Motion::REST;
  const double pressing = total(sums.pressing);
  Vec3 force, torque;
  for (int d = 0; d < 3; d++) {
    force[d] = moving ? total(sums.force[d]) : e[d] * pressing;
    torque[d] = total(sums.torque[d]);
  }
  if (!moving) torque = cross(torque, {double(e[0]), double(e[1]), double(e[2])});
  load.pressing += pressing;
  if constexpr (ledger) {
    load.swallowed += total(sums.swallowed);
    if constexpr (moving) load.displaced += total(sums.displaced);
  }
  load.area += 2.0 * w * sums.links;
  for (int d = 0; d < 3; d++) {
    load.force[d] += force[d];
    load.torque[d] += torque[d];
  }
}

// velocity of a surface and what it does to a link
template <Motion motion, class V> struct Wall {
  V u[3], eu, usq;
  LBM_INLINE Wall(const Sphere &s, const int (&e)[3], const V (&arm)[3])
  {
    for (int d = 0; d < 3; d++) {
      const int a = (d + 1) % 3, b = (d + 2) % 3;
      u[d] = V{} + s.velocity[d];
      if constexpr (motion == Motion::TURN) u[d] = u[d] + (s.spin[a] * arm[b] - s.spin[b] * arm[a]);
    }
    eu = double(e[0]) * u[0] + double(e[1]) * u[1] + double(e[2]) * u[2];
    usq = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  }
};
template <class V> struct Wall<Motion::REST, V> {
  LBM_INLINE Wall(const Sphere &, const int (&)[3], const V (&)[3]) {}
};

// momentum of a link given to its sphere; arm = x_w - c
template <Motion motion, class V, bool ledger>
LBM_INLINE inline void exchange(Sums<V, ledger> &sums, const int (&e)[3], double w, const V &out,
                                const V &back, const V (&arm)[3], const Wall<motion, V> &wall)
{
  V g = out + back;
  if constexpr (motion != Motion::REST) {
    g = g - w * (9.0 * wall.eu * wall.eu - 3.0 * wall.usq);
    const V h = out - back - 6.0 * w * wall.eu;
    V F[3];
    for (int d = 0; d < 3; d++) F[d] = double(e[d]) * g - wall.u[d] * h;
    for (int d = 0; d < 3; d++) {
      const int a = (d + 1) % 3, b = (d + 2) % 3;
      sums.force[d] = sums.force[d] + F[d];
      sums.torque[d] = sums.torque[d] + (arm[a] * F[b] - arm[b] * F[a]);
    }
  } else {
    for (int d = 0; d < 3; d++) sums.torque[d] = sums.torque[d] + arm[d] * g;
  }
  sums.pressing = sums.pressing + g;
}

}    // namespace lbm
#endif
