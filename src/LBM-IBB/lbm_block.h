// SPDX-License-Identifier: GPL-2.0-only
// One rank's box of populations, and the in-place streaming that keeps a single copy of them.
//
// Shapes: the block owns nodes 0 <= x < n[0], ... and has one layer of ghost nodes around them (in
// two dimensions none along z). Node (x, y, z) of the block is node (x + lo[0], ...) of the whole
// lattice. index() is linear, x fastest; populations are stored one array per direction.
//
// Values are deviations from rest, f_i - w_i (lattice units): less round-off at small velocities,
// and fluid at rest is zero everywhere.
//
// In-place streaming, AA pattern (Bailey et al. 2009): N_t(i, n), the value that node n pulls along
// direction i at step t, lives in
//     array i      at n          when t is even,
//     array opp(i) at n - e_i    when t is odd.
// A node reads its Q values, collides, and writes f*_i where it read N_t(opp(i)): streaming is
// done. slots(t)[i][n] is N_t(i, n); nothing else in the solver knows the parity.

#ifndef LBM_BLOCK_H
#define LBM_BLOCK_H

#include "lbm_lattice.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace lbm {

using Index = std::int64_t;
using Int3 = std::array<int, 3>;
using Vec3 = std::array<double, 3>;

// nodes of the block, both corners among them
struct Region {
  Int3 lo{}, hi{};
  bool empty() const { return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]; }
  bool apart(const Region &r) const
  {
    for (int d = 0; d < 3; d++)
      if (lo[d] > r.hi[d] || r.lo[d] > hi[d]) return true;
    return false;
  }
};

// Where nodes lie in memory; shared by populations and by maps of the same box
struct Layout {
  Int3 lo{}, n{};    // first owned node of the whole lattice, owned nodes along x, y, z
  Int3 ghost{};      // layers of ghost nodes: 1, along z 0 in two dimensions
  Index stride_y = 0, stride_z = 0, origin = 0, size = 0;

  Layout() = default;
  Layout(const Int3 &lo, const Int3 &n, int dimension);

  Index index(int x, int y, int z) const { return origin + x + y * stride_y + z * stride_z; }
  Index offset(const int (&e)[3]) const { return e[0] + e[1] * stride_y + e[2] * stride_z; }
  Int3 node(Index i) const;    // inverse of index()
  bool owned(int x, int y, int z) const
  {
    return x >= 0 && x < n[0] && y >= 0 && y < n[1] && z >= 0 && z < n[2];
  }
  Index nodes() const { return Index(n[0]) * n[1] * n[2]; }
  Region all() const { return {{0, 0, 0}, {n[0] - 1, n[1] - 1, n[2] - 1}}; }
};

template <class L> using Slots = std::array<typename L::Real *, L::Q>;

struct Freed {
  void operator()(void *p) const;
};
// zeros, aligned to memory pages, to be given back by free(); throws std::bad_alloc
void *zeroed_pages(std::size_t bytes);

template <class L> class Block {
 public:
  using Real = typename L::Real;
  explicit Block(const Layout &layout);

  const Layout &layout() const { return at; }
  std::int64_t step() const { return t; }
  void advance() { t++; }

  // pointers p with p[i][index] = N_s(i, index) at step s
  Slots<L> slots(std::int64_t s) const
  {
    Slots<L> p;
    for (int i = 0; i < L::Q; i++)
      p[i] = (s & 1) ? array(opposite<L>(i)) - at.offset(L::e[i]) : array(i);
    return p;
  }
  Slots<L> slots() const { return slots(t); }

  Real *array(int i) const { return populations.get() + i * pitch; }
  double bytes() const { return sizeof(Real) * double(L::Q) * double(pitch); }

 private:
  Layout at;
  Index pitch;    // distance between the arrays of two directions
  std::int64_t t = 0;
  std::unique_ptr<Real[], Freed> populations;
};

}    // namespace lbm
#endif
