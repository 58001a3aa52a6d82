// SPDX-License-Identifier: GPL-2.0-only
// Spheres that yield: light ones, whose velocity answers to the fluid within a step.
//
// A surface that moves by du faster than what was handed in would have got back, along a link,
//     f_o - a e.du,    a = 3 w c4    (lbm_bounce_back.h)
// so that with g = (e, arm x e) the sphere's load, force and torque, would have been
//     F - zeta (du, dspin),    zeta = sum of a g g^T    (links of gaps left out)
// Whoever moves the sphere uses this load, implicitly, and says afterwards by how much the velocity
// was larger in the mean: correct() then takes zeta du from the fluid, to round-off, along the same
// links. Rest density is good enough for zeta, and terms of second order in velocity are left out
// of it; F has both. Lattice units.

#ifndef LBM_YIELD_H
#define LBM_YIELD_H

#include "lbm_block.h"
#include "lbm_link.h"

namespace lbm {

struct Response {
  static constexpr int SIZE = 21;
  std::array<double, SIZE> zeta{};      // lower triangle by rows: force before torque
  std::array<double, 6> swallowed{};    // what Load::swallowed gains with (du, dspin)
  std::array<double, 6> in_gaps{};    // force and torque of links in gaps of one node, in the Load
};

// velocity and spin beyond what was handed in, mean over a step
struct Gain {
  Vec3 velocity{}, spin{};
};

// mass that the fluid lost to faster surfaces, as Load has it
struct Taken {
  double displaced = 0.0, swallowed = 0.0;
};

// Two of the three components of arm x e, as products of the arm: the third, along an axis of e,
// follows from them as (arm x e).e = 0.
struct Turn {
  int first, second, third;
  double of[2][3] = {}, with[2] = {};    // the third one is with[0] s + with[1] t
  explicit Turn(const int (&e)[3])
  {
    third = e[0] ? 0 : e[1] ? 1 : 2;
    first = (third + 1) % 3;
    second = (third + 2) % 3;
    const int d[2] = {first, second};
    for (int k = 0; k < 2; k++) {
      of[k][d[k]] = 0.0;
      of[k][(d[k] + 1) % 3] = e[(d[k] + 2) % 3];
      of[k][(d[k] + 2) % 3] = -e[(d[k] + 1) % 3];
      with[k] = -e[d[k]] * e[third];
    }
  }
  template <class V> LBM_INLINE V component(int k, const V (&arm)[3]) const
  {
    return of[k][0] * arm[0] + of[k][1] * arm[1] + of[k][2] * arm[2];
  }
  Vec3 complete(double s, double t) const;
};

// Of the links of one direction of one sphere the response needs these sums alone, with c = c4 and
// s, t the two components of Turn
enum { C, S, T, CS, CT, CSS, CST, CTT, REACH };
struct Reach {
  double links = 0.0, sums[REACH] = {};
};
// what is summed of spheres if any yields: reaches, Q of each sphere, and the part of its Load that
// comes from gaps of one node, where it does not yield
struct Yields {
  std::vector<Reach> reaches;
  std::vector<Load> in_gaps;
};
// in packs, or nothing for spheres that do not yield
template <class V, bool yields> struct ReachSums {
  V sums[REACH] = {};
  LBM_INLINE void add(const V &c, const V &s, const V &t)
  {
    const V cs = c * s, ct = c * t;
    const V more[REACH] = {c, s, t, cs, ct, cs * s, cs * t, ct * t};
    for (int n = 0; n < REACH; n++) sums[n] += more[n];
  }
  // of the first n numbers of each pack
  void add_first(const ReachSums &other, int n)
  {
    const V keep = first_of(V{} + 1.0, n, V{});
    for (int m = 0; m < REACH; m++) sums[m] += keep * other.sums[m];
  }
  void add_to(Reach &reach, double links) const
  {
    reach.links += links;
    add_totals(sums, reach.sums);
  }
};
template <class V> struct ReachSums<V, false> {
  void add_first(const ReachSums &, int) {}
};

// of a sphere, from the reaches of its directions
template <class L> Response response(const Reach *reaches, const Load &in_gaps);
template <class L> Taken taken(const Reach *reaches, const Gain &gain);

// the reaches of links that bounced back elsewhere, by sphere and direction
template <class L, class Rule>
void add_reaches(const Layout &at, const Cover &cover, const Links &links,
                 std::vector<Reach> &reaches);
// in the slots that the links wrote; gains by sphere. Those of a list that belong to spheres that
// yield: it may have others as well.
template <class L, class Rule>
void correct(const Layout &at, const Slots<L> &f, const Cover &cover, const Links &links,
             const std::vector<Gain> &gains);

}    // namespace lbm
#endif
