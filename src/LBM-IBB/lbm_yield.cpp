// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_yield.h"

#include "lbm_bounce_back.h"

namespace lbm {
namespace {

  // calls f(group, first link, last link + 1) for what belongs to spheres that yield
  template <class F> void for_each_group(const Cover &cover, const Links &links, F &&f)
  {
    for (const LinkGroup &group : links.groups)
      if (cover.spheres()[group.sphere].yields) f(group);
  }

  constexpr int W = SIMD_WIDTH;
  using V = Pack<W>;

  // a, and arm x e, of a pack of links
  struct Reach {
    V a, turn[3];
    template <class Rule>
    LBM_INLINE Reach(Rule, const Decoder &decode, const Vec3 &centre, const int (&e)[3], double w,
                     const int32_t *node, const double *fraction)
    {
      const V q = load<V>(fraction);
      V arm[3];
      decode(load<PackInt<W>>(node), arm);
      for (int d = 0; d < 3; d++) arm[d] = arm[d] - centre[d] + double(e[d]) * q;
      a = 3.0 * w * Rule::template at<V>(q).c4;
      for (int d = 0; d < 3; d++) {
        const int p = (d + 1) % 3, s = (d + 2) % 3;
        turn[d] = double(e[s]) * arm[p] - double(e[p]) * arm[s];
      }
    }
  };

  // Calls f(nodes, fractions, n) for packs of links, of which n count: whatever the packs, the
  // arithmetic of a link is the same.
  template <class F> void in_packs(const Links &links, const LinkGroup &group, F &&f)
  {
    std::size_t k = group.begin;
    for (; k + W <= group.end; k += W) f(&links.node[k], &links.q[k], W);
    if (k == group.end) return;
    const Tail<W> tail(links.node, links.q, k, group.end);
    f(tail.node, tail.q, int(group.end - k));
  }

  double sum(const V &v, int n)
  {
    double s = 0.0;
    for (int k = 0; k < n; k++) s += v[k];
    return s;
  }

}    // namespace

// With e fixed in a group, zeta needs the sums of a, of a turn and of a turn turn^T alone.
template <class L, class Rule>
void add_responses(const Layout &at, const Cover &cover, const Links &links,
                   std::vector<Response> &responses)
{
  const Decoder decode(at);
  for_each_group(cover, links, [&](const LinkGroup &group) {
    const int(&e)[3] = L::e[group.direction];
    const Vec3 centre = cover.centre(group.sphere);
    double a = 0.0, b = 0.0, turn[3] = {0, 0, 0}, b_turn[3] = {0, 0, 0}, square[6] = {0};
    in_packs(links, group, [&](const int32_t *node, const double *q, int count) {
      const Reach reach(Rule{}, decode, centre, e, L::w[group.direction], node, q);
      const V stays = reach.a - 6.0 * L::w[group.direction];
      a += sum(reach.a, count);
      b += sum(stays, count);
      for (int d = 0, n = 0; d < 3; d++) {
        turn[d] += sum(reach.a * reach.turn[d], count);
        b_turn[d] += sum(stays * reach.turn[d], count);
        for (int c = 0; c <= d; c++)
          square[n++] += sum(reach.a * reach.turn[d] * reach.turn[c], count);
      }
    });
    Response &r = responses[group.sphere];
    int n = 0;
    for (int d = 0; d < 3; d++)
      for (int c = 0; c <= d; c++) r.zeta[n++] += a * e[d] * e[c];
    for (int d = 0, m = 0; d < 3; d++) {
      for (int c = 0; c < 3; c++) r.zeta[n++] += turn[d] * e[c];
      for (int c = 0; c <= d; c++) r.zeta[n++] += square[m++];
    }
    for (int d = 0; d < 3; d++) {
      r.swallowed[d] += b * e[d];
      r.swallowed[3 + d] += b_turn[d];
    }
  });
}

template <class L, class Rule>
Taken correct(const Layout &at, const Slots<L> &f, const Cover &cover, const Links &links,
              const std::vector<Gain> &gains)
{
  const Decoder decode(at);
  Taken taken;
  for_each_group(cover, links, [&](const LinkGroup &group) {
    const int i = group.direction;
    const Gain &gain = gains[group.sphere];
    const Vec3 centre = cover.centre(group.sphere);
    typename L::Real *back = f[opposite<L>(i)];
    in_packs(links, group, [&](const int32_t *node, const double *q, int count) {
      const Reach reach(Rule{}, decode, centre, L::e[i], L::w[i], node, q);
      V du = V{};
      for (int d = 0; d < 3; d++)
        du = du + L::e[i][d] * gain.velocity[d] + reach.turn[d] * gain.spin[d];
      const V less = reach.a * du;
      for (int l = 0; l < count; l++) back[node[l]] -= less[l];
      const double pushed = 6.0 * L::w[i] * sum(du, count);
      taken.displaced -= pushed;
      taken.swallowed += sum(less, count) - pushed;
    });
  });
  return taken;
}

#define LBM_INSTANTIATE_RULE(L, Rule)                                                             \
  template void add_responses<L, Rule>(const Layout &, const Cover &, const Links &,              \
                                       std::vector<Response> &);                                  \
  template Taken correct<L, Rule>(const Layout &, const Slots<L> &, const Cover &, const Links &, \
                                  const std::vector<Gain> &);
#define LBM_INSTANTIATE(L)         \
  LBM_INSTANTIATE_RULE(L, Halfway) \
  LBM_INSTANTIATE_RULE(L, Bouzidi) \
  LBM_INSTANTIATE_RULE(L, Cli)     \
  LBM_INSTANTIATE_RULE(L, Zhao)
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE
#undef LBM_INSTANTIATE_RULE

}    // namespace lbm
