// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_exchange.h"

#include "lbm_bounce_back.h"
#include "lbm_momentum.h"

#include <algorithm>
#include <cmath>

namespace lbm {
namespace {

  // less than a pack of links, filled with copies of the last: they bounce back alike
  template <int W> struct Tail {
    int16_t place[3][W];
    double q[W];
    Tail(const Links &links, std::size_t k, std::size_t end)
    {
      for (int l = 0; l < W; l++, k += k + 1 < end) {
        for (int d = 0; d < 3; d++) place[d][l] = links.place[d][k];
        q[l] = links.q[k];
      }
    }
  };

  // indices of nodes; they fit, if not their parts, so that sums modulo 2^32 are right
  template <int W>
  LBM_INLINE inline PackUnsigned<W> index(const Layout &at, const PackInt<W> (&place)[3])
  {
    using U = PackUnsigned<W>;
    return U(place[0]) + U(place[1]) * uint32_t(at.stride_y) + U(place[2]) * uint32_t(at.stride_z) +
        uint32_t(at.origin);
  }

  // the slots that a link along i uses, see lbm_block.h: each is one address per node
  template <class L> struct LinkSlots {
    const typename L::Real *r1, *r2, *r3;
    typename L::Real *w;
    LinkSlots(const Layout &at, const Slots<L> &f, int i)
    {
      const int o = opposite<L>(i);
      r1 = f[i] + at.offset(L::e[i]);
      r2 = f[i];
      r3 = f[o] - at.offset(L::e[i]);
      w = f[o];
    }
  };

  template <class L, class Rule, bool moving, int W>
  LBM_INLINE inline void
  bounce_back_pack(const Layout &at, const LinkSlots<L> &slot, const Sphere &sphere,
                   const Vec3 &centre, const int (&e)[3], double weight, double refund,
                   const int16_t *const (&places)[3], const double *fractions, const float *drho,
                   Sums<Pack<W>> &sums)
  {
    using V = Pack<W>;
    PackInt<W> place[3];
    for (int d = 0; d < 3; d++) place[d] = convert<PackInt<W>>(load<PackShort<W>>(places[d]));
    const V q = load<V>(fractions);
    V arm[3];    // x_w - c
    for (int d = 0; d < 3; d++) arm[d] = convert<V>(place[d]) - centre[d] + double(e[d]) * q;
    uint32_t n[W];
    store(n, index<W>(at, place));
    const Coefficients<V> c = Rule::template at<V>(q);
    const V out = convert<V>(gather<W>(slot.r1, n));
    V back = c.c1 * out;
    if constexpr (Rule::interpolated)
      back = back + c.c2 * convert<V>(gather<W>(slot.r2, n)) +
          c.c3 * convert<V>(gather<W>(slot.r3, n));
    if constexpr (moving) {
      const Wall<V> wall(sphere, e, arm);
      const V rho = 1.0 + convert<V>(gather<W>(drho, n));
      back = back - c.c4 * (3.0 * weight) * rho * wall.eu;
      sums.swallowed = sums.swallowed + (out - back - (6.0 * weight) * rho * wall.eu);
      back = back + refund;
      exchange<moving>(sums, e, weight, out, back, arm, &wall);
    } else {
      sums.swallowed = sums.swallowed + (out - back);
      back = back + refund;
      exchange<moving>(sums, e, weight, out, back, arm, static_cast<Wall<V> *>(nullptr));
    }
    scatter<W>(slot.w, n, back);
  }

  // e.(u - u') of two walls in as much as they approach each other: along the mean of their normals,
  // which point along the arms
  inline double approach(const Vec3 (&u)[2], const double (&arm)[2][3], const int (&e)[3])
  {
    Vec3 n;
    const auto per_length = [](const double(&a)[3]) {
      return 1.0 / std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    };
    const double ahead = per_length(arm[0]), behind = per_length(arm[1]);
    for (int d = 0; d < 3; d++) n[d] = arm[0][d] * ahead - arm[1][d] * behind;
    const double nn = dot(n, n), along = dot(n, u[0]) - dot(n, u[1]);
    return nn > 0.0 ? dot(e, n) * along / nn : 0.0;
  }

  // Two links of one node that need each other's result: with f_o and f_i unknown,
  //     f_o = A + c2 f_i,  f_i = B + c2' f_o,  each rule's x_f' being the other's wall
  // Walls that approach each other are taken half-way: they displace what they should, while the rules
  // would say what happens in a channel of width q + q' without ends, by 1/(q + q') more.
  template <class L, class Rule, bool moving>
  void close_gap(const Layout &at, const Slots<L> &f, const Cover &cover, const Gap &gap,
                 const float *drho, std::vector<Load> &loads)
  {
    const int i = gap.direction, o = opposite<L>(i);
    const LinkSlots<L> slot(at, f, i);
    const Index n = at.index(gap.place[0], gap.place[1], gap.place[2]);
    const double out[2] = {slot.r1[n], slot.r3[n]};
    double q[2] = {gap.q_ahead, gap.q_behind};
    const double room = q[0] + q[1];
    if (room < GAP_MIN)
      for (double &k : q) k *= GAP_MIN / room;

    const int32_t owner[2] = {gap.ahead, gap.behind};
    double known[2], c2[2], c4[2], back[2], arm[2][3], pushed[2] = {0.0, 0.0};
    Vec3 velocity[2];
    for (int k = 0; k < 2; k++) {
      const int(&e)[3] = L::e[k == 0 ? i : o];
      const Sphere &sphere = cover.spheres()[owner[k]];
      const Vec3 &centre = cover.centre(owner[k]);
      for (int d = 0; d < 3; d++) arm[k][d] = gap.place[d] - centre[d] + q[k] * e[d];
      const Coefficients<double> c = Rule::at(q[k]);
      known[k] = c.c1 * out[k] + c.c3 * out[1 - k];
      c2[k] = c.c2;
      if constexpr (moving) {
        const Wall<double> wall(sphere, e, arm[k]);
        std::copy_n(wall.u, 3, velocity[k].begin());
        pushed[k] = 3.0 * L::w[i] * (1.0 + drho[n]) * wall.eu;
        c4[k] = c.c4;
      }
    }
    const double D = 1.0 / (1.0 - c2[0] * c2[1]),
                 squeezed = moving
        ? 1.5 * L::w[i] * (1.0 + drho[n]) * approach(velocity, arm, L::e[i])
        : 0.0;
    for (int k = 0; moving && k < 2; k++) known[k] -= c4[k] * (pushed[k] - squeezed);
    for (int k = 0; k < 2; k++) back[k] = (known[k] + c2[k] * known[1 - k]) * D - 2.0 * squeezed;
    double swallowed[2];
    for (int k = 0; k < 2; k++) {
      swallowed[k] = out[k] - back[k] - 2.0 * pushed[k];
      back[k] += L::w[i] * cover.spheres()[owner[k]].refund;
    }
    f[o][n] = back[0];
    f[i][n] = back[1];
    for (int k = 0; k < 2; k++) {
      const int(&e)[3] = L::e[k == 0 ? i : o];
      const Wall<double> wall(cover.spheres()[owner[k]], e, arm[k]);
      Sums<double> sums;
      exchange<moving>(sums, e, L::w[i], out[k], back[k], arm[k], &wall);
      sums.links = 1.0;
      sums.swallowed = swallowed[k];
      add<moving>(sums, e, L::w[i], loads[owner[k]]);
    }
  }

  void add_pressure(const Cover &cover, const Hidden &hidden, int32_t sphere, double p,
                    std::vector<Load> &loads)
  {
    const Vec3 turn = cross(cover.centre(sphere), hidden.we);
    for (int d = 0; d < 3; d++) {
      loads[sphere].force[d] += p * hidden.we[d];
      loads[sphere].torque[d] += p * (hidden.wxe[d] - turn[d]);
    }
  }

  // Fluid at rest would give 2 w drho e to s, and the opposite to t. The links from s to t, found
  // with sphere t on the rank that owns their first node, do it once more: half of it each. What is
  // behind a face does not.
  void press_apart(const Cover &cover, const Hidden &hidden, std::vector<Load> &loads)
  {
    if (hidden.t < 0) {
      add_pressure(cover, hidden, hidden.s, 2.0 * cover.spheres()[hidden.s].drho, loads);
      return;
    }
    const double drho = 0.5 * (cover.spheres()[hidden.s].drho + cover.spheres()[hidden.t].drho);
    add_pressure(cover, hidden, hidden.s, drho, loads);
    add_pressure(cover, hidden, hidden.t, -drho, loads);
  }

}    // namespace

template <class L, class Rule, bool moving>
void bounce_back(const Layout &at, const Slots<L> &f, const Cover &cover, const Links &links,
                 const float *drho, std::vector<Load> &loads)
{
  constexpr int W = SIMD_WIDTH;
  for (const LinkGroup &group : links.groups) {
    const int i = group.direction;
    const LinkSlots<L> slot(at, f, i);
    const Sphere &sphere = cover.spheres()[group.sphere];
    const Vec3 c = cover.centre(group.sphere);
    const double refund = L::w[i] * sphere.refund;
    Sums<Pack<W>> sums;
    const auto bounce_pack = [&](const int16_t *const(&places)[3], const double *q,
                                 auto &to) LBM_INLINE {
      bounce_back_pack<L, Rule, moving, W>(at, slot, sphere, c, L::e[i], L::w[i], refund, places, q,
                                           drho, to);
    };
    std::size_t k = group.begin;
    for (; k + W <= group.end; k += W)
      bounce_pack({&links.place[0][k], &links.place[1][k], &links.place[2][k]}, &links.q[k], sums);
    if (k < group.end) {
      const Tail<W> tail(links, k, group.end);
      Sums<Pack<W>> with_copies;
      bounce_pack({tail.place[0], tail.place[1], tail.place[2]}, tail.q, with_copies);
      sums.add_first(with_copies, int(group.end - k));
    }
    sums.links = double(group.end - group.begin);
    add<moving>(sums, L::e[i], L::w[i], loads[group.sphere]);
  }
  for (const Gap &gap : links.gaps) close_gap<L, Rule, moving>(at, f, cover, gap, drho, loads);
  for (const Hidden &hidden : links.hidden) press_apart(cover, hidden, loads);
}

#define LBM_INSTANTIATE_RULE(L, Rule)                                                           \
  template void bounce_back<L, Rule, false>(const Layout &, const Slots<L> &, const Cover &,    \
                                            const Links &, const float *, std::vector<Load> &); \
  template void bounce_back<L, Rule, true>(const Layout &, const Slots<L> &, const Cover &,     \
                                           const Links &, const float *, std::vector<Load> &);
#define LBM_INSTANTIATE(L)         \
  LBM_INSTANTIATE_RULE(L, Halfway) \
  LBM_INSTANTIATE_RULE(L, Bouzidi) \
  LBM_INSTANTIATE_RULE(L, Cli)
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE
#undef LBM_INSTANTIATE_RULE

}    // namespace lbm
