// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_yield.h"

#include "lbm_bounce_back.h"
#include "lbm_read_ahead.h"

#include <algorithm>

namespace lbm {

// how far ahead of its use a slot is fetched: from the memory
constexpr int PACKS_AHEAD = 32;

void Answers::clear()
{
  groups.clear();
  size = 0;
}

Answer Answers::open(const LinkGroup &group)
{
  const std::size_t begin = size;
  size += group.end - group.begin;
  if (node.size() < size + SIMD_WIDTH) {
    node.resize(2 * size + SIMD_WIDTH);
    c4.resize(2 * size + SIMD_WIDTH);
  }
  add_group(groups, group.sphere, group.direction, begin, size);
  return {&node[begin], &c4[begin]};
}

double Answers::bytes() const
{
  return double(groups.capacity() * sizeof(LinkGroup) + node.capacity() * sizeof(int32_t) +
                c4.capacity() * sizeof(float));
}

// of a link that answers, but for c4
template <class L> constexpr double weight()
{
  int i = 1;
  while (!answers<L>(i)) i++;
  return ANSWER<L> * 3.0 * L::w[i];
}

template <class L> Response response(const Reach *reaches, const Load &in_gaps)
{
  Response response;
  for (int d = 0; d < 3; d++) {
    response.in_gaps[d] = in_gaps.force[d];
    response.in_gaps[3 + d] = in_gaps.torque[d];
  }
  const auto zeta = [&](int i, int j) -> double & {
    return response.zeta[std::max(i, j) * (std::max(i, j) + 1) / 2 + std::min(i, j)];
  };
  for (int k = 0; k < REACHES<L>; k++) {
    const auto &[links, sums] = reaches[k];
    const Axis a(k / 2);
    const double w = weight<L>(), we = k % 2 ? w : -w;
    const int s = 3 + a.s, t = 3 + a.t;
    zeta(a.axis, a.axis) += w * sums[C];
    zeta(s, a.axis) += w * sums[CT];
    zeta(t, a.axis) -= w * sums[CS];
    zeta(s, s) += w * sums[CTT];
    zeta(t, t) += w * sums[CSS];
    zeta(s, t) -= w * sums[CST];
    response.swallowed[a.axis] += we * (sums[C] - 2.0 * links);
    response.swallowed[s] += we * (sums[CT] - 2.0 * sums[T]);
    response.swallowed[t] -= we * (sums[CS] - 2.0 * sums[S]);
  }
  return response;
}

// the mass less per link is a e.du, of which 2 a / c4 e.du is what fluid at rest with the surface
// leaves
template <class L> Taken taken(const Reach *reaches, const Gain &gain)
{
  Taken taken;
  for (int k = 0; k < REACHES<L>; k++) {
    const auto &[links, sums] = reaches[k];
    const Axis a(k / 2);
    const double w = weight<L>(), we = k % 2 ? w : -w;
    const double along = gain.velocity[a.axis];
    const double pushed =
        2.0 * (links * along + sums[T] * gain.spin[a.s] - sums[S] * gain.spin[a.t]);
    const double less = sums[C] * along + sums[CT] * gain.spin[a.s] - sums[CS] * gain.spin[a.t];
    taken.displaced -= we * pushed;
    taken.swallowed += we * (less - pushed);
  }
  return taken;
}

namespace {

  // one link more, of a sphere that may yield
  template <class L>
  void answer_alone(const Decoder &decode, const Cover &cover, int32_t sphere, int i, int32_t node,
                    double q, Yields &yields)
  {
    if (!cover.spheres()[sphere].yields) return;
    const int(&e)[3] = L::e[i];
    const Axis axis(e);
    double arm[3];
    decode(node, arm);
    for (int d = 0; d < 3; d++) arm[d] = arm[d] - cover.centre(sphere)[d] + e[d] * q;
    const Answer link = yields.answers.open({sphere, int32_t(i), 0, 1});
    const double c = Halfway::at(0.5).c4, s = arm[axis.s], t = arm[axis.t];
    *link.node = node;
    *link.c4 = float(c);
    Reach &reach = yields.reaches[reach_of<L>(sphere, i)];
    const double more[REACH] = {c, s, t, c * s, c * t, c * s * s, c * s * t, c * t * t};
    for (int n = 0; n < REACH; n++) reach.sums[n] += more[n];
    reach.links += 1.0;
  }

}    // namespace

template <class L>
void answer_gaps(const Layout &at, const Cover &cover, const Gaps &gaps, Yields &yields)
{
  if constexpr (!GAPS_ANSWER<L>) return;
  const Decoder decode(at);
  for (const LinkGroup &group : gaps.groups) {
    const int i = group.direction;
    if (!answers<L>(i)) continue;
    for (std::size_t k = group.begin; k < group.end; k++) {
      answer_alone<L>(decode, cover, group.sphere, i, gaps.node[k], gaps.q_ahead[k], yields);
      answer_alone<L>(decode, cover, gaps.behind[k], opposite<L>(i), gaps.node[k], gaps.q_behind[k],
                      yields);
    }
  }
}

// in packs as bounce_back() makes them, so that a run that goes on does so to the bit
template <class L, class Rule>
void recall(const Layout &at, const Cover &cover, const Links &links, Yields &yields)
{
  constexpr int W = SIMD_WIDTH;
  using V = Pack<W>;
  const Decoder decode(at);
  for (const LinkGroup &group : links.groups) {
    const int(&e)[3] = L::e[group.direction];
    if (!answers<L>(group.direction) || !cover.spheres()[group.sphere].yields) continue;
    const Vec3 centre = cover.centre(group.sphere);
    const Axis axis(e);
    const auto add_pack = [&](const int32_t *node, const double *fractions, auto &to) LBM_INLINE {
      const V q = load<V>(fractions);
      V arm[3];
      decode(load<PackInt<W>>(node), arm);
      for (int d = 0; d < 3; d++) arm[d] = arm[d] - centre[d] + double(e[d]) * q;
      to.add(node, Rule::template at<V>(q).c4, arm[axis.s], arm[axis.t]);
    };
    ReachSums<V, true> sums(yields.answers.open(group));
    std::size_t k = group.begin;
    for (; k + W <= group.end; k += W) add_pack(&links.node[k], &links.q[k], sums);
    if (k < group.end) {
      const int n = int(group.end - k);
      const Tail<int32_t> node(&links.node[k], n);
      const Tail<double> q(&links.q[k], n);
      sums.only(n);
      add_pack(node.p, q.p, sums);
    }
    sums.add_to(yields.reaches[reach_of<L>(group.sphere, group.direction)],
                double(group.end - group.begin));
  }
  answer_gaps<L>(at, cover, links.gaps, yields);
}

template <class L>
void correct(const Layout &at, const Slots<L> &f, const Cover &cover, const Answers &answers,
             const std::vector<Gain> &gains)
{
  constexpr int W = SIMD_WIDTH;
  using V = Pack<W>;
  const Decoder decode(at);
  ReadAhead ahead(
      answers, PACKS_AHEAD,
      [&](int i) {
        return f[opposite<L>(i)];
      },
      [](const typename L::Real *back, int32_t n) LBM_INLINE {
        __builtin_prefetch(back + n, 1);
      });
  for (const LinkGroup &group : answers.groups) {
    const Gain &gain = gains[group.sphere];
    const int i = group.direction;
    typename L::Real *back = f[opposite<L>(i)];
    // e.(du + dspin x arm) = e.du + (e x dspin).arm, to which the part of the arm along e adds none
    const Vec3 turn =
        cross({double(L::e[i][0]), double(L::e[i][1]), double(L::e[i][2])}, gain.spin);
    const double along = dot(L::e[i], gain.velocity) - dot(turn, cover.centre(group.sphere));
    for (std::size_t k = group.begin; k < group.end; k += W) {
      ahead.next();
      const int32_t *node = &answers.node[k];
      V x[3];
      decode(load<PackInt<W>>(node), x);    // the last pack may end with links of the next group
      const V c4 = convert<V>(load<Pack<W, float>>(&answers.c4[k]));
      double less[W] = {};
      store(less, weight<L>() * c4 * (along + turn[0] * x[0] + turn[1] * x[1] + turn[2] * x[2]));
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

#define LBM_INSTANTIATE_RULE(L, Rule) \
  template void recall<L, Rule>(const Layout &, const Cover &, const Links &, Yields &);
#define LBM_INSTANTIATE(L)                                                                   \
  template Response response<L>(const Reach *, const Load &);                                \
  template Taken taken<L>(const Reach *, const Gain &);                                      \
  template void answer_gaps<L>(const Layout &, const Cover &, const Gaps &, Yields &);       \
  template void correct<L>(const Layout &, const Slots<L> &, const Cover &, const Answers &, \
                           const std::vector<Gain> &);                                       \
  LBM_INSTANTIATE_RULE(L, Halfway)                                                           \
  LBM_INSTANTIATE_RULE(L, Bouzidi)                                                           \
  LBM_INSTANTIATE_RULE(L, Cli)                                                               \
  LBM_INSTANTIATE_RULE(L, Zhao)
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE
#undef LBM_INSTANTIATE_RULE

}    // namespace lbm
