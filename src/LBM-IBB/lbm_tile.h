// SPDX-License-Identifier: GPL-2.0-only
// A block cut into tiles that fit into a core's own cache, swept one after the other, x fastest.
//
// What needs a node and its neighbours swept can follow the sweep by one node in each direction:
// behind(k) are nodes whose neighbours have all been swept once tile k has. The outermost layer of
// the block needs what comes from beyond its faces as well, and is left for the end: shell().
// A block that fits into the cache as a whole is not cut: then all of it is shell.

#ifndef LBM_TILE_H
#define LBM_TILE_H

#include "lbm_block.h"

#include <algorithm>
#include <vector>

namespace lbm {

class Tiles {
 public:
  // size: nodes of a tile; 0: chosen by what a node holds
  Tiles(const Layout &layout, int dimension, double bytes_a_node, const Int3 &size);

  std::size_t count() const { return std::size_t(parts_[0]) * parts_[1] * parts_[2]; }
  bool cut() const { return count() > 1; }
  Region swept(std::size_t k) const;
  Region behind(std::size_t k) const;
  const std::vector<Region> &shell() const { return shell_; }
  // tiles k whose behind(k) has nodes of this region
  template <class F> void for_each_behind(const Region &region, F &&f) const;

 private:
  Int3 n_, size_, parts_{};
  Region inner_;
  std::vector<Region> shell_;
};

template <class F> void Tiles::for_each_behind(const Region &region, F &&f) const
{
  Int3 first, last;
  for (int d = 0; d < 3; d++) {
    const int lo = std::max(region.lo[d], inner_.lo[d]), hi = std::min(region.hi[d], inner_.hi[d]);
    if (lo > hi) return;
    first[d] = std::min((lo + 1) / size_[d], parts_[d] - 1);    // behind by one node
    last[d] = std::min((hi + 1) / size_[d], parts_[d] - 1);
  }
  for (int k = first[2]; k <= last[2]; k++)
    for (int j = first[1]; j <= last[1]; j++)
      for (int i = first[0]; i <= last[0]; i++) f(i + parts_[0] * (j + std::size_t(parts_[1]) * k));
}

}    // namespace lbm
#endif
