// SPDX-License-Identifier: GPL-2.0-only
// Cut links: an owned fluid node x_f whose neighbour x_s = x_f + e_i is covered by a sphere, or by an
// obstacle, which is one more in the list of spheres.
//
//     x_f' = x_f - e_i        x_f ---- q ----|---- x_s        q = |x_f - x_w| / |x_f - x_s| (eq. 16)
//
// Links are grouped by sphere and direction, so that what a group shares is known once per group.
// If x_f' is covered too (a gap of one node), the two links of x_f along i depend on each other:
// such pairs are Gaps. If x_f' lies behind an open face, q is set to 1/2, where every rule
// needs x_f alone.
//
// A fluid node with one fluid neighbour at most is a pocket, see fill_pockets() in lbm_refill.h.

#ifndef LBM_LINK_H
#define LBM_LINK_H

#include "lbm_cover.h"
#include "lbm_simd.h"

namespace lbm {

// no link is shorter: a node on a surface
constexpr double Q_MIN = 1e-6;

struct LinkGroup {
  int32_t sphere;
  int32_t direction;      // i, from fluid to solid
  uint32_t begin, end;    // in the arrays of Links
};

// Written in place: a group that is made aside and copied waits until all that was stored before is
// in the cache, as it is read wider than it was written.
inline void add_group(std::vector<LinkGroup> &groups, int32_t sphere, int direction,
                      std::size_t begin, std::size_t end)
{
  LinkGroup &group = groups.emplace_back();
  group.sphere = sphere;
  group.direction = int32_t(direction);
  group.begin = uint32_t(begin);
  group.end = uint32_t(end);
}

// pairs of links of one node along i = 1..P and its opposite: the group's sphere covers x_f + e_i
struct Gaps {
  std::vector<LinkGroup> groups;
  std::vector<int32_t> node, behind;    // index of x_f, and the sphere that covers x_f - e_i
  std::vector<double> q_ahead, q_behind;
  std::size_t size = 0;    // entries in use of the arrays above, which reach a pack further

  void clear();
  void add(int32_t node, int32_t behind);
  // those added since begin are a group; their fractions are to be filled in
  void close(int32_t ahead, int direction, std::size_t begin);
  void trim();
  double bytes() const;

 private:
  void resize(std::size_t room);
};

// Links between the nodes of two spheres that touch, or nearly, or of a sphere and what lies behind
// a face of the box: no fluid is there to press the two apart. Sums over such links from nodes of t
// to nodes of s; w weighs them as populations do. Those to nodes of an obstacle are left out: only
// the way back counts, so that an obstacle has no list of all it touches.
struct Hidden {
  int32_t s = 0, t = FLUID;    // t = FLUID: behind a face
  Vec3 we{},
      wxe{};    // of w e, and of w x times e with x the middle of the link, block coordinates
};

struct Links {
  std::vector<LinkGroup> groups;
  std::vector<int32_t> node;    // index of x_f
  std::vector<double> q;
  std::size_t size = 0;    // entries in use of the arrays above, which reach a pack further
  Gaps gaps;
  std::vector<uint32_t> pockets;    // fluid nodes, all neighbours but one covered or behind walls
  std::vector<Hidden> hidden;
  // scratch of find_links(): rows of nodes; the first and last in a layer with nodes of the sphere
  struct Span {
    int first, last;
  };
  std::vector<Bits> bits;
  std::vector<Span> spans;

  void clear();    // all but the pockets, which wait for the links of all spheres
  void trim();     // give back what is allocated and not in use, scratch too
  double bytes() const;
};

// the coordinates of owned nodes, from their indices: numbers below 2^31, which a product with the
// reciprocal cannot take across an integer if it is half a node away from it
class Decoder {
 public:
  explicit Decoder(const Layout &at) :
      origin(int32_t(at.origin)), stride_y(double(at.stride_y)), stride_z(double(at.stride_z))
  {
  }
  template <class V, class I> LBM_INLINE void operator()(const I &node, V (&x)[3]) const
  {
    const V n = convert<V>(node - origin);
    x[2] = convert<V>(convert<I>((n + 0.5) * (1.0 / stride_z)));
    const V m = n - x[2] * stride_z;
    x[1] = convert<V>(convert<I>((m + 0.5) * (1.0 / stride_y)));
    x[0] = m - x[1] * stride_y;
  }

 private:
  int32_t origin;
  double stride_y, stride_z;
};

// n numbers, less than a pack, filled with copies of the first: links that are treated alike. Reads
// a whole pack.
template <class T, int W = SIMD_WIDTH> struct Tail {
  T p[W] = {};
  Tail(const T *all, int n)
  {
    using V = Pack<W, T>;
    store(p, first_of(load<V>(all), n, V{} + all[0]));
  }
};

// fraction q of the link from node d = x_f - c, outside, along e, where it enters the sphere; V is a
// number or a pack
template <class V> LBM_INLINE inline V cut(const V (&d)[3], const int (&e)[3], const V &radius)
{
  const V zero{}, one = zero + 1.0, least = zero + Q_MIN;
  const double a = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
  const V b = double(e[0]) * d[0] + double(e[1]) * d[1] + double(e[2]) * d[2];
  const V c = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - radius * radius;
  const V disc = b * b - a * c;
  const V q = c / (root(disc > zero ? disc : zero) - b);
  return q > one ? one : (q > least ? q : least);
}

// the fluid nodes that can have a link to sphere s are among these
Region nodes_with_links(const Cover &cover, std::size_t s);

// append the links of sphere s from nodes of the region
template <class L>
void find_links(const Layout &at, const Cover &cover, std::size_t s, const Region &region,
                Links &links);

}    // namespace lbm
#endif
