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

  // a, and arm x e, of one link or a pack of them
  template <class L, class Rule, class V> struct Reach {
    V a, turn[3];
    LBM_INLINE Reach(const Decoder &decode, const Vec3 &centre, const int (&e)[3], double w,
                     const int32_t *node, const double *fraction)
    {
      constexpr int W = sizeof(V) / sizeof(double);
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

  // whole packs, then one by one
  template <class F> void in_packs(const LinkGroup &group, F &&f)
  {
    constexpr int W = SIMD_WIDTH;
    std::size_t k = group.begin;
    for (; k + W <= group.end; k += W) f(k, std::integral_constant<int, W>{});
    for (; k < group.end; k++) f(k, std::integral_constant<int, 1>{});
  }

  double sum(double v)
  {
    return v;
  }
  template <class V> double sum(const V &v)
  {
    double s = 0.0;
    for (unsigned k = 0; k < sizeof(V) / sizeof(double); k++) s += v[k];
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
    in_packs(group, [&](std::size_t k, auto width) {
      const Reach<L, Rule, Pack<width>> reach(decode, centre, e, L::w[group.direction],
                                              &links.node[k], &links.q[k]);
      const auto stays = reach.a - 6.0 * L::w[group.direction];
      a += sum(reach.a);
      b += sum(stays);
      for (int d = 0, n = 0; d < 3; d++) {
        turn[d] += sum(reach.a * reach.turn[d]);
        b_turn[d] += sum(stays * reach.turn[d]);
        for (int c = 0; c <= d; c++) square[n++] += sum(reach.a * reach.turn[d] * reach.turn[c]);
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
void correct(const Layout &at, const Slots<L> &f, const Cover &cover, const Links &links,
             const std::vector<Gain> &gains)
{
  const Decoder decode(at);
  for_each_group(cover, links, [&](const LinkGroup &group) {
    const int i = group.direction;
    const Gain &gain = gains[group.sphere];
    const Vec3 centre = cover.centre(group.sphere);
    typename L::Real *back = f[opposite<L>(i)];
    in_packs(group, [&](std::size_t k, auto width) {
      using V = Pack<width>;
      const Reach<L, Rule, V> reach(decode, centre, L::e[i], L::w[i], &links.node[k], &links.q[k]);
      V du = V{};
      for (int d = 0; d < 3; d++)
        du = du + L::e[i][d] * gain.velocity[d] + reach.turn[d] * gain.spin[d];
      const V less = reach.a * du;
      for (int l = 0; l < width; l++) {
        if constexpr (width == 1)
          back[links.node[k]] -= less;
        else
          back[links.node[k + l]] -= less[l];
      }
    });
  });
}

#define LBM_INSTANTIATE_RULE(L, Rule)                                                            \
  template void add_responses<L, Rule>(const Layout &, const Cover &, const Links &,             \
                                       std::vector<Response> &);                                 \
  template void correct<L, Rule>(const Layout &, const Slots<L> &, const Cover &, const Links &, \
                                 const std::vector<Gain> &);
#define LBM_INSTANTIATE(L)         \
  LBM_INSTANTIATE_RULE(L, Halfway) \
  LBM_INSTANTIATE_RULE(L, Bouzidi) \
  LBM_INSTANTIATE_RULE(L, Cli)
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE
#undef LBM_INSTANTIATE_RULE

}    // namespace lbm
