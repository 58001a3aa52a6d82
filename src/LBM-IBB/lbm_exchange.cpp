// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_exchange.h"

#include "lbm_bounce_back.h"
#include "lbm_momentum.h"
#include "lbm_read_ahead.h"

#include <algorithm>
#include <limits>

namespace lbm {
namespace {

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

  // how far ahead of their use the slots of links are fetched
  constexpr int PACKS_AHEAD = 8;

  template <class L, class Rule, Motion motion, bool ledger, bool answer, class V>
  LBM_INLINE inline void
  bounce_back_pack(const Decoder &decode, const LinkSlots<L> &slot, const Sphere &sphere,
                   const Vec3 &centre, const int (&e)[3], double weight, double refund,
                   const int32_t *n, const double *fractions, const float *drho,
                   Sums<V, ledger> &sums, ReachSums<V, answer> &reach)
  {
    constexpr int W = SIMD_WIDTH;
    const V q = load<V>(fractions);
    V arm[3];    // x_w - c
    decode(load<PackInt<W>>(n), arm);
    for (int d = 0; d < 3; d++) arm[d] = arm[d] - centre[d] + double(e[d]) * q;
    const Coefficients<V> c = Rule::template at<V>(q);
    const V out = convert<V>(gather<W>(slot.r1, n));
    V back = c.c1 * out;
    if constexpr (Rule::interpolated)
      back = back + c.c2 * convert<V>(gather<W>(slot.r2, n)) +
          c.c3 * convert<V>(gather<W>(slot.r3, n));
    [[maybe_unused]] V left = V{};    // by fluid at rest with the surface, see Load::swallowed
    const Wall<motion, V> wall(sphere, e, arm);
    if constexpr (motion != Motion::REST) {
      const V rho = 1.0 + convert<V>(gather<W>(drho, n));
      back = back - c.c4 * (3.0 * weight) * rho * wall.eu;
      left = (6.0 * weight) * rho * wall.eu;
    }
    if constexpr (ledger) {
      sums.swallowed = sums.swallowed + (out - back - left);
      if constexpr (motion != Motion::REST) sums.displaced = sums.displaced - left;
      back = back + refund;
    }
    exchange<motion>(sums, e, weight, out, back, arm, wall);
    if constexpr (answer) {
      const Axis axis(e);
      reach.add(n, c.c4, arm[axis.s], arm[axis.t]);
    }
    scatter<W>(slot.w, n, back);
  }

  // what lies at one end of gaps, a sphere for each number
  template <class V> struct End {
    V centre[3], velocity[3], spin[3], refund;
    V round;    // 0 of an obstacle, whose normals are not along its arms, else 1
    LBM_INLINE End(const Cover &cover, const int32_t *sphere)
    {
      constexpr int W = SIMD_WIDTH;
      const Sphere *spheres = cover.spheres().data();
      for (int d = 0; d < 3; d++) {
        centre[d] = pack_of<W>([&](int k) LBM_INLINE {
          return cover.centre(sphere[k])[d];
        });
        velocity[d] = pack_of<W>([&](int k) LBM_INLINE {
          return spheres[sphere[k]].velocity[d];
        });
        spin[d] = pack_of<W>([&](int k) LBM_INLINE {
          return spheres[sphere[k]].spin[d];
        });
      }
      refund = pack_of<W>([&](int k) LBM_INLINE {
        return spheres[sphere[k]].refund;
      });
      round = pack_of<W>([&](int k) LBM_INLINE {
        return double(!cover.is_obstacle(sphere[k]));
      });
    }
  };

  // e.(u - u') of two walls in as much as they approach each other: along the mean of their
  // normals, which point along the arms of spheres; that of a sphere if the other is an obstacle
  template <Motion motion, class V>
  LBM_INLINE inline V approach(const Wall<motion, V> (&wall)[2], const V (&arm)[2][3],
                               const End<V> *const (&ends)[2], const int (&e)[3])
  {
    V length[2], n[3], along = V{}, nn = V{}, en = V{};
    for (int k = 0; k < 2; k++)
      length[k] = root(arm[k][0] * arm[k][0] + arm[k][1] * arm[k][1] + arm[k][2] * arm[k][2]);
    for (int d = 0; d < 3; d++) {
      n[d] = ends[0]->round * arm[0][d] * length[1] - ends[1]->round * arm[1][d] * length[0];
      along = along + n[d] * (wall[0].u[d] - wall[1].u[d]);
      nn = nn + n[d] * n[d];
      en = en + double(e[d]) * n[d];
    }
    return en * along / (nn + std::numeric_limits<double>::min());
  }

  // Two links of one node that need each other's result: with f_o and f_i unknown,
  //     f_o = A + c2 f_i,  f_i = B + c2' f_o,  each rule's x_f' being the other's wall
  // Walls that approach each other are taken half-way: they displace what they should, while the
  // rules would say what happens in a channel of width q + q' without ends, by 1/(q + q') more.
  template <class L, class Rule, Motion motion, bool ledger>
  LBM_INLINE inline void close_gaps(const Decoder &decode, const Slots<L> &f,
                                    const LinkSlots<L> &slot,
                                    const End<Pack<SIMD_WIDTH>> *const (&ends)[2], int i,
                                    const int32_t *n, const double *const (&fractions)[2],
                                    const float *drho, Sums<Pack<SIMD_WIDTH>, ledger> (&sums)[2])
  {
    constexpr int W = SIMD_WIDTH;
    using V = Pack<W>;
    const int o = opposite<L>(i);
    V x[3];
    decode(load<PackInt<W>>(n), x);
    const V out[2] = {convert<V>(gather<W>(slot.r1, n)), convert<V>(gather<W>(slot.r3, n))};
    V q[2] = {load<V>(fractions[0]), load<V>(fractions[1])};
    const V room = q[0] + q[1], wider = room < GAP_MIN ? GAP_MIN / room : V{} + 1.0;

    V known[2], c2[2], c4[2], back[2], arm[2][3], pushed[2] = {V{}, V{}};
    for (int k = 0; k < 2; k++) {
      const int(&e)[3] = L::e[k == 0 ? i : o];
      q[k] = q[k] * wider;
      for (int d = 0; d < 3; d++) arm[k][d] = x[d] - ends[k]->centre[d] + double(e[d]) * q[k];
      const Coefficients<V> c = Rule::template at<V>(q[k]);
      known[k] = c.c1 * out[k] + c.c3 * out[1 - k];
      c2[k] = c.c2;
      c4[k] = c.c4;
    }
    const Wall<motion, V> wall[2] = {{*ends[0], L::e[i], arm[0]}, {*ends[1], L::e[o], arm[1]}};
    V squeezed = V{};
    if constexpr (motion != Motion::REST) {
      const V rho = 1.0 + convert<V>(gather<W>(drho, n));
      squeezed = (1.5 * L::w[i]) * rho * approach(wall, arm, ends, L::e[i]);
      for (int k = 0; k < 2; k++) {
        pushed[k] = (3.0 * L::w[i]) * rho * wall[k].eu;
        known[k] = known[k] - c4[k] * (pushed[k] - squeezed);
      }
    }
    const V D = 1.0 / (1.0 - c2[0] * c2[1]);
    for (int k = 0; k < 2; k++) {
      const int(&e)[3] = L::e[k == 0 ? i : o];
      back[k] = (known[k] + c2[k] * known[1 - k]) * D - 2.0 * squeezed;
      if constexpr (ledger) {
        sums[k].swallowed = sums[k].swallowed + (out[k] - back[k] - 2.0 * pushed[k]);
        if constexpr (motion != Motion::REST)
          sums[k].displaced = sums[k].displaced - 2.0 * pushed[k];
        back[k] = back[k] + L::w[i] * ends[k]->refund;
      }
      exchange<motion>(sums[k], e, L::w[i], out[k], back[k], arm[k], wall[k]);
    }
    scatter<W>(f[o], n, back[0]);
    scatter<W>(f[i], n, back[1]);
  }

  // the sphere ahead is one, those behind differ
  template <class L, class Rule, Motion motion, bool ledger>
  void close_group(const Layout &at, const Slots<L> &f, const Cover &cover, const Gaps &gaps,
                   const LinkGroup &group, const float *drho, std::vector<Load> &loads)
  {
    constexpr int W = SIMD_WIDTH;
    using V = Pack<W>;
    const Decoder decode(at);
    const int i = group.direction;
    const LinkSlots<L> slot(at, f, i);
    int32_t same[W];
    std::fill_n(same, W, group.sphere);
    const End<V> ahead(cover, same);
    Sums<V, ledger> sums;
    for (std::size_t k = group.begin; k < group.end; k += W) {
      const int n = int(std::min<std::size_t>(W, group.end - k));
      const Tail<int32_t> node(&gaps.node[k], n), sphere(&gaps.behind[k], n);
      const Tail<double> q_ahead(&gaps.q_ahead[k], n), q_behind(&gaps.q_behind[k], n);
      const End<V> behind(cover, sphere.p);
      Sums<V, ledger> of_pack[2];
      close_gaps<L, Rule, motion, ledger>(decode, f, slot, {&ahead, &behind}, i, node.p,
                                          {q_ahead.p, q_behind.p}, drho, of_pack);
      sums.add_first(of_pack[0], n);
      const auto &back = L::e[opposite<L>(i)];
      add_each<motion>(of_pack[1], sphere.p, n, back, L::w[i], loads);
    }
    sums.area = 2.0 * L::w[i] * double(group.end - group.begin);
    add_all<motion>(sums, L::e[i], loads[group.sphere]);
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
  // behind a face does not, nor does an obstacle, around which there may be any density.
  void press_apart(const Cover &cover, const Hidden &hidden, std::vector<Load> &loads)
  {
    if (hidden.t < 0 || cover.is_obstacle(hidden.t)) {
      const double p = 2.0 * cover.spheres()[hidden.s].drho;
      add_pressure(cover, hidden, hidden.s, p, loads);
      if (hidden.t >= 0) add_pressure(cover, hidden, hidden.t, -p, loads);
      return;
    }
    const double drho = 0.5 * (cover.spheres()[hidden.s].drho + cover.spheres()[hidden.t].drho);
    add_pressure(cover, hidden, hidden.s, drho, loads);
    add_pressure(cover, hidden, hidden.t, -drho, loads);
  }

}    // namespace

template <class L, class Rule, Motion motion, bool ledger, bool yields>
void bounce_back(const Layout &at, const Slots<L> &f, const Cover &cover, const Links &links,
                 const float *drho, std::vector<Load> &loads, [[maybe_unused]] Yields &yielding)
{
  constexpr int W = SIMD_WIDTH;
  const Decoder decode(at);
  Sums<Pack<W>, ledger> sums;
  const auto slots_along = [&](int i) LBM_INLINE {
    return LinkSlots<L>(at, f, i);
  };
  const auto fetch = [drho](const LinkSlots<L> &slot, int32_t n) LBM_INLINE {
    __builtin_prefetch(slot.r1 + n);
    if constexpr (Rule::interpolated) __builtin_prefetch(slot.r2 + n);
    if constexpr (Rule::interpolated) __builtin_prefetch(slot.r3 + n);
    if constexpr (motion != Motion::REST) __builtin_prefetch(drho + n);
    __builtin_prefetch(slot.w + n, 1);
  };
  ReadAhead ahead(links, PACKS_AHEAD, slots_along, fetch);
  // These follow the links: soon where a sphere moves, but behind those of a whole tile at rest
  ReadAhead gaps_ahead(links.gaps, 0, slots_along, fetch);
  for (std::size_t g = 0; g < links.groups.size(); g++) {
    const LinkGroup &group = links.groups[g];
    const int i = group.direction;
    const LinkSlots<L> slot(at, f, i);
    const Sphere &sphere = cover.spheres()[group.sphere];
    const Vec3 c = cover.centre(group.sphere);
    const double refund = L::w[i] * sphere.refund;
    const auto bounce_pack = [&](const int32_t *nodes, const double *q, auto &to,
                                 auto &reach) LBM_INLINE {
      ahead.next();
      if constexpr (motion != Motion::REST) gaps_ahead.next();
      bounce_back_pack<L, Rule, motion, ledger>(decode, slot, sphere, c, L::e[i], L::w[i], refund,
                                                nodes, q, drho, to, reach);
    };
    const auto bounce_group = [&](auto &reach) LBM_INLINE {
      std::size_t k = group.begin;
      for (; k + W <= group.end; k += W) bounce_pack(&links.node[k], &links.q[k], sums, reach);
      if (k == group.end) return;
      const int n = int(group.end - k);
      const Tail<int32_t> node(&links.node[k], n);
      const Tail<double> q(&links.q[k], n);
      Sums<Pack<W>, ledger> with_copies;
      reach.only(n);
      bounce_pack(node.p, q.p, with_copies, reach);
      sums.add_first(with_copies, n);
    };
    const double size = double(group.end - group.begin);
    bool done = false;
    if constexpr (yields)
      if (sphere.yields && answers<L>(i)) {
        Reach &sum = yielding.reaches[reach_of<L>(group.sphere, i)];
        __builtin_prefetch(&sum.links, 1);
        __builtin_prefetch(&sum.sums[REACH - 1], 1);
        ReachSums<Pack<W>, true> reach(yielding.answers.open(group));
        bounce_group(reach);
        reach.add_to(sum, size);
        done = true;
      }
    if (!done) {
      ReachSums<Pack<W>, false> none;
      bounce_group(none);
    }
    sums.area += 2.0 * L::w[i] * size;
    const bool last = g + 1 == links.groups.size() || links.groups[g + 1].sphere != group.sphere;
    if (last || motion == Motion::REST) {
      add_all<motion>(sums, L::e[i], loads[group.sphere]);
      sums = {};
    }
  }
  std::vector<Load> &in_gaps = yields ? yielding.in_gaps : loads;
  for (const LinkGroup &group : links.gaps.groups)
    close_group<L, Rule, motion, ledger>(at, f, cover, links.gaps, group, drho, in_gaps);
  if constexpr (yields) answer_gaps<L>(at, cover, links.gaps, yielding);
  for (const Hidden &hidden : links.hidden) press_apart(cover, hidden, in_gaps);
}

#define LBM_INSTANTIATE_ONE(L, Rule, motion, ledger, yields)                         \
  template void bounce_back<L, Rule, motion, ledger, yields>(                        \
      const Layout &, const Slots<L> &, const Cover &, const Links &, const float *, \
      std::vector<Load> &, Yields &);
#define LBM_INSTANTIATE_MOTION(L, Rule, motion, yields) \
  LBM_INSTANTIATE_ONE(L, Rule, motion, false, yields)   \
  LBM_INSTANTIATE_ONE(L, Rule, motion, true, yields)
#define LBM_INSTANTIATE_RULE(L, Rule)                   \
  LBM_INSTANTIATE_MOTION(L, Rule, Motion::REST, false)  \
  LBM_INSTANTIATE_MOTION(L, Rule, Motion::SHIFT, false) \
  LBM_INSTANTIATE_MOTION(L, Rule, Motion::TURN, false)  \
  LBM_INSTANTIATE_MOTION(L, Rule, Motion::TURN, true)
#define LBM_INSTANTIATE(L)         \
  LBM_INSTANTIATE_RULE(L, Halfway) \
  LBM_INSTANTIATE_RULE(L, Bouzidi) \
  LBM_INSTANTIATE_RULE(L, Cli)     \
  LBM_INSTANTIATE_RULE(L, Zhao)
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE
#undef LBM_INSTANTIATE_RULE
#undef LBM_INSTANTIATE_MOTION
#undef LBM_INSTANTIATE_ONE

}    // namespace lbm
