// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_yield.h"

#include "lbm_bounce_back.h"
#include "lbm_read_ahead.h"

#include <algorithm>

namespace lbm {

// how far ahead of its use a slot is fetched: from the memory
constexpr int PACKS_AHEAD = 16;

// all of arm x e
Vec3 Turn::complete(double s, double t) const
{
  Vec3 v;
  v[first] = s;
  v[second] = t;
  v[third] = with[0] * s + with[1] * t;
  return v;
}

template <class L> Response response(const Reach *reaches, const Load &in_gaps)
{
  Response response;
  for (int d = 0; d < 3; d++) {
    response.in_gaps[d] = in_gaps.force[d];
    response.in_gaps[3 + d] = in_gaps.torque[d];
  }
  for (int i = 1; i < L::Q; i++) {
    const auto &[links, sums] = reaches[i];
    if (links == 0.0) continue;
    const int(&e)[3] = L::e[i];
    const Turn two(e);
    const Vec3 plain = two.complete(sums[S], sums[T]), turn = two.complete(sums[CS], sums[CT]);
    Vec3 square[3];    // of (arm x e) (arm x e)^T
    square[two.first] = two.complete(sums[CSS], sums[CST]);
    square[two.second] = two.complete(sums[CST], sums[CTT]);
    for (int d = 0; d < 3; d++)
      square[two.third][d] =
          two.with[0] * square[two.first][d] + two.with[1] * square[two.second][d];

    const double three_w = 3.0 * L::w[i];
    int n = 0;
    for (int d = 0; d < 3; d++)
      for (int c = 0; c <= d; c++) response.zeta[n++] += three_w * sums[C] * e[d] * e[c];
    for (int d = 0; d < 3; d++) {
      for (int c = 0; c < 3; c++) response.zeta[n++] += three_w * turn[d] * e[c];
      for (int c = 0; c <= d; c++) response.zeta[n++] += three_w * square[d][c];
      response.swallowed[d] += three_w * (sums[C] - 2.0 * links) * e[d];
      response.swallowed[3 + d] += three_w * (turn[d] - 2.0 * plain[d]);
    }
  }
  return response;
}

// the mass less per link is a e.du, of which 6 w e.du is what fluid at rest with the surface leaves
template <class L> Taken taken(const Reach *reaches, const Gain &gain)
{
  Taken taken;
  for (int i = 1; i < L::Q; i++) {
    const auto &[links, sums] = reaches[i];
    const Turn two(L::e[i]);
    const double along = dot(L::e[i], gain.velocity), three_w = 3.0 * L::w[i];
    const double pushed = 2.0 * (links * along + dot(two.complete(sums[S], sums[T]), gain.spin));
    const double less = sums[C] * along + dot(two.complete(sums[CS], sums[CT]), gain.spin);
    taken.displaced -= three_w * pushed;
    taken.swallowed += three_w * (less - pushed);
  }
  return taken;
}

// in packs as bounce_back() makes them, so that a run that goes on does so to the bit
template <class L, class Rule>
void add_reaches(const Layout &at, const Cover &cover, const Links &links,
                 std::vector<Reach> &reaches)
{
  constexpr int W = SIMD_WIDTH;
  using V = Pack<W>;
  const Decoder decode(at);
  for (const LinkGroup &group : links.groups) {
    const int(&e)[3] = L::e[group.direction];
    const Vec3 centre = cover.centre(group.sphere);
    const Turn turn(e);
    ReachSums<V, true> sums;
    const auto add_pack = [&](const int32_t *node, const double *fractions, auto &to) LBM_INLINE {
      const V q = load<V>(fractions);
      V arm[3];
      decode(load<PackInt<W>>(node), arm);
      for (int d = 0; d < 3; d++) arm[d] = arm[d] - centre[d] + double(e[d]) * q;
      to.add(Rule::template at<V>(q).c4, turn.component(0, arm), turn.component(1, arm));
    };
    std::size_t k = group.begin;
    for (; k + W <= group.end; k += W) add_pack(&links.node[k], &links.q[k], sums);
    if (k < group.end) {
      const int n = int(group.end - k);
      const Tail<int32_t> node(&links.node[k], n);
      const Tail<double> q(&links.q[k], n);
      ReachSums<V, true> with_copies;
      add_pack(node.p, q.p, with_copies);
      sums.add_first(with_copies, n);
    }
    sums.add_to(reaches[std::size_t(group.sphere) * L::Q + group.direction],
                double(group.end - group.begin));
  }
}

template <class L, class Rule>
void correct(const Layout &at, const Slots<L> &f, const Cover &cover, const Links &links,
             const std::vector<Gain> &gains)
{
  constexpr int W = SIMD_WIDTH;
  using V = Pack<W>;
  const Decoder decode(at);
  ReadAhead ahead(
      links, 0, PACKS_AHEAD,
      [&](int i) {
        return f[opposite<L>(i)];
      },
      [](const typename L::Real *back, int32_t n) LBM_INLINE {
        __builtin_prefetch(back + n, 1);
      });
  for (const LinkGroup &group : links.groups) {
    const Gain &gain = gains[group.sphere];
    const int i = group.direction;
    typename L::Real *back = f[opposite<L>(i)];
    // e.(du + dspin x arm) = e.du + (e x dspin).arm, to which the part of the arm along e adds none
    const Vec3 turn =
        cross({double(L::e[i][0]), double(L::e[i][1]), double(L::e[i][2])}, gain.spin);
    const double along = dot(L::e[i], gain.velocity) - dot(turn, cover.centre(group.sphere));
    for (std::size_t k = group.begin; k < group.end; k += W) {
      ahead.next();
      if (!cover.spheres()[group.sphere].yields) continue;
      const int32_t *node = &links.node[k];
      V x[3];
      decode(load<PackInt<W>>(node), x);    // the last pack may end with links of the next group
      const V c4 = Rule::template at<V>(load<V>(&links.q[k])).c4;
      double less[W] = {};
      store(less, 3.0 * L::w[i] * c4 * (along + turn[0] * x[0] + turn[1] * x[1] + turn[2] * x[2]));
      const auto take = [&](int l) LBM_INLINE {
        back[node[l]] = typename L::Real(back[node[l]] - less[l]);
      };
      if (k + W <= group.end)
        for (int l = 0; l < W; l++) take(l);
      else
        for (int l = 0; l < int(group.end - k); l++) take(l);
    }
  }
}

#define LBM_INSTANTIATE_RULE(L, Rule)                                                            \
  template void add_reaches<L, Rule>(const Layout &, const Cover &, const Links &,               \
                                     std::vector<Reach> &);                                      \
  template void correct<L, Rule>(const Layout &, const Slots<L> &, const Cover &, const Links &, \
                                 const std::vector<Gain> &);
#define LBM_INSTANTIATE(L)                                    \
  template Response response<L>(const Reach *, const Load &); \
  template Taken taken<L>(const Reach *, const Gain &);       \
  LBM_INSTANTIATE_RULE(L, Halfway)                            \
  LBM_INSTANTIATE_RULE(L, Bouzidi)                            \
  LBM_INSTANTIATE_RULE(L, Cli)                                \
  LBM_INSTANTIATE_RULE(L, Zhao)
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE
#undef LBM_INSTANTIATE_RULE

}    // namespace lbm
