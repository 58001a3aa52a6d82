// SPDX-License-Identifier: GPL-2.0-only
// Spheres that yield: light ones, whose velocity answers to the fluid within a step.
//
// A surface that moves by du faster than what was handed in would have got back, along a link,
//     f_o - a e.du,    a = 3 w c4    (lbm_bounce_back.h)
// Of the links those along the axes answer for all, ANSWER times as much, so that with
// g = (e, arm x e) the sphere's load, force and torque, becomes
//     F - zeta (du, dspin),    zeta = sum of ANSWER a g g^T    (in 3d links of gaps left out)
// Whoever moves the sphere uses this load, implicitly, and says afterwards by how much the velocity
// was larger in the mean: correct() then takes zeta du from the fluid, to round-off, along the same
// links. Rest density is good enough for zeta, and terms of second order in velocity are left out
// of it; F has both. Lattice units.
//
// Direction i has pi r^2 |e_i| links with a sphere in the mean, 2 r |e_i| with a disc, so that
// those along axes have 1/(1 + 2 sqrt 2) of the response to velocity and of that to spin, of a
// disc's 1/(1 + 1/sqrt 2). ANSWER makes it a third more than the whole, for neighbours may cover
// some: just the whole, and some light grains in crowds are thrown to and fro; two thirds: many.
//
// Links of gaps answer in 2d, as half-way links: water that is squeezed between discs has no way
// round them, and what it gives, held for a step, throws light ones to and fro (doc/stability.md).

#ifndef LBM_YIELD_H
#define LBM_YIELD_H

#include "lbm_block.h"
#include "lbm_link.h"

namespace lbm {

struct Response {
  static constexpr int SIZE = 21;
  std::array<double, SIZE> zeta{};      // lower triangle by rows: force before torque
  std::array<double, 6> swallowed{};    // what Load::swallowed gains with (du, dspin)
  std::array<double, 6> in_gaps{};      // force and torque of narrow gaps, in the Load
};

// velocity and spin beyond what was handed in, mean over a step
struct Gain {
  Vec3 velocity{}, spin{};
};

// mass that the fluid lost to faster surfaces, as Load has it
struct Taken {
  double displaced = 0.0, swallowed = 0.0;
};

template <class L> constexpr double ANSWER = L::D == 3 ? 5.0 : 2.25;
// does direction i? All but these have two components or none
template <class L> constexpr bool answers(int i)
{
  return L::e[i][0] * L::e[i][0] + L::e[i][1] * L::e[i][1] + L::e[i][2] * L::e[i][2] == 1;
}
template <class L> constexpr bool GAPS_ANSWER = L::D == 2;
// its axis, with the other two in cyclic order: arm x e = +-(0, arm_t, -arm_s) along (axis, s, t)
struct Axis {
  int axis, s, t;
  explicit Axis(int a) : axis(a), s((a + 1) % 3), t((a + 2) % 3) {}
  explicit Axis(const int (&e)[3]) : Axis(e[0] ? 0 : e[1] ? 1 : 2) {}
};

// Of the links of one sphere along one axis to one side the response needs these sums alone, with c
// = c4 and s, t of the arm
enum { C, S, T, CS, CT, CSS, CST, CTT, REACH };
struct Reach {
  double links = 0.0, sums[REACH] = {};
};
// by sphere: for each axis that against it and that along it
template <class L> constexpr int REACHES = 2 * L::D;
template <class L> constexpr std::size_t reach_of(std::size_t sphere, int i)
{
  const auto &e = L::e[i];
  return sphere * REACHES<L> + (e[0] ? 0 : e[1] ? 2 : 4) + (e[0] + e[1] + e[2] > 0);
}

// the next pack of links that answer: its nodes and its c4, which the sums have as rounded here
struct Answer {
  int32_t *node;
  float *c4;
  // links further that room is fetched for: it comes from the memory, and stores wait for each other
  static constexpr int AHEAD = 256;
  template <class V> LBM_INLINE V keep(const int32_t *nodes, const V &exact)
  {
    constexpr int W = SIMD_WIDTH;
    const Pack<W, float> rounded = convert<Pack<W, float>>(exact);
    __builtin_prefetch(node + AHEAD, 1);
    __builtin_prefetch(c4 + AHEAD, 1);
    store(node, load<PackInt<W>>(nodes));
    store(c4, rounded);
    node += W;
    c4 += W;
    return convert<V>(rounded);
  }
};

// links that answer, as they bounced back
struct Answers {
  std::vector<LinkGroup> groups;
  std::vector<int32_t> node;    // index of x_f
  std::vector<float> c4;
  std::size_t size = 0;    // entries in use of the arrays above, which reach a pack further

  void clear();
  // room for the links of one group, and its first pack
  Answer open(const LinkGroup &group);
  double bytes() const;
};
// what is kept of spheres if any yields: of those that do reaches and links; and of each what comes
// from gaps of one node or none (Gaps, Hidden), which is still to be added to its Load
struct Yields {
  std::vector<Reach> reaches;
  Answers answers;
  std::vector<Load> in_gaps;
};

// the gaps of one list of links, if they answer
template <class L>
void answer_gaps(const Layout &at, const Cover &cover, const Gaps &gaps, Yields &yields);

// in packs, or nothing of links that do not answer
template <class V, bool answer> struct ReachSums {
  V sums[REACH] = {}, counts = V{} + 1.0;
  Answer kept;
  explicit ReachSums(const Answer &first) : kept(first) {}
  // of packs to come the first n numbers count
  void only(int n) { counts = first_of(counts, n, V{}); }
  LBM_INLINE void add(const int32_t *nodes, const V &c4, const V &arm_s, const V &arm_t)
  {
    const V c = counts * kept.keep(nodes, c4), s = counts * arm_s, t = counts * arm_t;
    const V cs = c * s, ct = c * t;
    const V more[REACH] = {c, s, t, cs, ct, cs * s, cs * t, ct * t};
    for (int n = 0; n < REACH; n++) sums[n] += more[n];
  }
  void add_to(Reach &reach, double links) const
  {
    reach.links += links;
    add_totals(sums, reach.sums);
  }
};
template <class V> struct ReachSums<V, false> {
  void only(int) {}
};

// of a sphere, from its reaches
template <class L> Response response(const Reach *reaches, const Load &in_gaps);
template <class L> Taken taken(const Reach *reaches, const Gain &gain);

// reaches and answers of links that bounced back elsewhere, those of spheres that yield
template <class L, class Rule>
void recall(const Layout &at, const Cover &cover, const Links &links, Yields &yields);
// in the slots that the links wrote; gains by sphere
template <class L>
void correct(const Layout &at, const Slots<L> &f, const Cover &cover, const Answers &answers,
             const std::vector<Gain> &gains);

}    // namespace lbm
#endif
