// SPDX-License-Identifier: GPL-2.0-only
// Momentum that a link gives to its sphere, and sums of it; formula and source: lbm_exchange.h.
// Lattice units; V is a number or a pack.

#ifndef LBM_MOMENTUM_H
#define LBM_MOMENTUM_H

#include "lbm_simd.h"
#include "lbm_sphere.h"

#include <vector>

namespace lbm {

// mass, if there is a ledger of it
template <class V, bool ledger> struct Swallowed {
  V swallowed = V{}, displaced = V{};
};
template <class V> struct Swallowed<V, false> {
};

// What one sphere adds up, in packs. Surfaces at rest are pressed along e alone: torque then holds
// the sum of arm times pressure, of one direction.
template <class V, bool ledger> struct Sums : Swallowed<V, ledger> {
  V force[3] = {V{}, V{}, V{}}, torque[3] = {V{}, V{}, V{}}, pressing = V{};
  double area = 0.0;

  // of the first n numbers of each pack
  void add_first(const Sums &other, int n)
  {
    const V keep = first_of(V{} + 1.0, n, V{});
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

// number(pack) is what counts of a pack
template <Motion motion, class V, bool ledger, class F>
LBM_INLINE inline void add(const F &number, double area, const Sums<V, ledger> &sums,
                           const int (&e)[3], Load &load)
{
  constexpr bool moving = motion != Motion::REST;
  const double pressing = number(sums.pressing);
  Vec3 force, torque;
  for (int d = 0; d < 3; d++) {
    force[d] = moving ? number(sums.force[d]) : e[d] * pressing;
    torque[d] = number(sums.torque[d]);
  }
  if (!moving) torque = cross(torque, {double(e[0]), double(e[1]), double(e[2])});
  load.pressing += pressing;
  if constexpr (ledger) {
    load.swallowed += number(sums.swallowed);
    if constexpr (moving) load.displaced += number(sums.displaced);
  }
  load.area += area;
  for (int d = 0; d < 3; d++) {
    load.force[d] += force[d];
    load.torque[d] += torque[d];
  }
}

// of the links of one sphere
template <Motion motion, class V, bool ledger>
LBM_INLINE inline void add_all(const Sums<V, ledger> &sums, const int (&e)[3], Load &load)
{
  add<motion>(
      [](const V &v) {
        return total(v);
      },
      sums.area, sums, e, load);
}

// of n links of weight w, each of another sphere
template <Motion motion, class V, bool ledger>
void add_each(const Sums<V, ledger> &sums, const int32_t *sphere, int n, const int (&e)[3],
              double w, std::vector<Load> &loads)
{
  for (int k = 0; k < n; k++)
    add<motion>(
        [k](const V &v) {
          return v[k];
        },
        2.0 * w, sums, e, loads[sphere[k]]);
}

// velocity of a surface, of one sphere or of one for each number, and what it does to a link
template <Motion motion, class V> struct Wall {
  V u[3], eu, usq;
  template <class S> LBM_INLINE Wall(const S &s, const int (&e)[3], const V (&arm)[3])
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
  template <class S> LBM_INLINE Wall(const S &, const int (&)[3], const V (&)[3]) {}
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
