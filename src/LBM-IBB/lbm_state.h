// SPDX-License-Identifier: GPL-2.0-only
// What the next step of the fluid depends on, but for what drives it: populations and the spheres
// of the last step, in a form that neither ranks nor the parity of the streaming shape.
//
// The canonical form of a node are its N_t(i, x), i = 0..Q-1 (lbm_block.h), in the precision they
// are stored in: bit for bit. Solid nodes have them too: they are read when a sphere uncovers them.
// Nodes follow each other with x fastest. Spheres are those of the last follow(), one of each
// grain.

#ifndef LBM_STATE_H
#define LBM_STATE_H

#include "lbm_cover.h"
#include "lbm_ledger.h"
#include "lbm_refill.h"

#include <algorithm>

namespace lbm {

// a box of nodes of the whole lattice
struct Part {
  Int3 lo, n;
  Index nodes() const { return Index(n[0]) * n[1] * n[2]; }
};

// nodes of both; none along a direction in which they do not meet
inline Part common(const Part &a, const Part &b)
{
  Part c{};
  for (int d = 0; d < 3; d++) {
    c.lo[d] = std::max(a.lo[d], b.lo[d]);
    c.n[d] = std::max(0, std::min(a.lo[d] + a.n[d], b.lo[d] + b.n[d]) - c.lo[d]);
  }
  return c;
}

// what was counted so far: of this rank; of all ranks
struct Counts {
  double links = 0.0, gaps = 0.0;
  RefillCount refilled;
  Ledger ledger;
  MeanDensity mean;
};

// what the next step needs of a grain in the last one, as it is on file
struct Trace {
  std::int64_t id = 0;
  Vec3 centre{};
  double radius = 0.0;
  Vec3 velocity{}, spin{};
  double drho = 0.0;
  std::int64_t yields = 0;
  Trace() = default;
  explicit Trace(const Sphere &s);
  Sphere sphere() const;
};

// canonical form of the owned nodes of a part; f are the slots of the present step
template <class L>
void give(const Layout &at, const Slots<L> &f, const Part &part, typename L::Real *to);
template <class L>
void take(const Layout &at, const Slots<L> &f, const Part &part, const typename L::Real *from);

// of the owned nodes; the sum over blocks modulo 2^64 does not depend on how the lattice is cut
template <class L> std::uint64_t checksum(const Layout &at, const Slots<L> &f, const Int3 &global);
std::uint64_t checksum(const Sphere &sphere);
// of words of 8 bytes, in their order
std::uint64_t checksum(const void *words, std::size_t n);

// the whole lattice
struct Lattice {
  Int3 n;
  std::array<bool, 3> periodic;    // false along z in two dimensions
};

// Of the spheres that reach a block, images among them, those whose centre lies in it: of all
// blocks together each grain is there once. Beyond the end of the box the nearest node counts.
std::vector<Sphere> centred_here(const std::vector<Sphere> &spheres, const Layout &at,
                                 const Lattice &lattice);
// all images of these grains that reach the block or its ghosts
std::vector<Sphere> reaching_here(const std::vector<Sphere> &grains, const Layout &at,
                                  const Lattice &lattice);

// the same spheres at the same places?
bool same_but_for_order(std::vector<Sphere> a, std::vector<Sphere> b);

}    // namespace lbm
#endif
