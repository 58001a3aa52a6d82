// SPDX-License-Identifier: GPL-2.0-only
// The fused collide-and-stream loop over the owned nodes of a block: no branch, no virtual call.
//
// Every node is treated alike. Solid nodes are read as zero, so that whatever they hold can neither
// grow nor be seen; what fluid nodes get from them is overwritten by the link pass. Packs of solid
// nodes alone are left out.

#ifndef LBM_SWEEP_H
#define LBM_SWEEP_H

#include "lbm_block.h"
#include "lbm_collide.h"

namespace lbm {

// no solid anywhere: costs nothing
struct NoSolids {
  static constexpr bool present = false, keep_density = false;
  template <int W> static constexpr bool any_fluid(Index) { return true; }
};

// owner[n] >= 0 marks solid nodes
struct Solids {
  static constexpr bool present = true, keep_density = false;
  const int32_t *owner;
  template <int W> bool any_fluid(Index n) const { return any_negative<W>(owner + n); }
};

// the same; the density excess of each node is kept for the wall term of moving surfaces, and each
// gets the same small mass, at rest, see Ledger::RESTORED
struct MovingSolids {
  static constexpr bool present = true, keep_density = true;
  const int32_t *owner = nullptr;
  float *drho = nullptr;
  double gain = 0.0;
  template <int W> bool any_fluid(Index n) const { return any_negative<W>(owner + n); }
};

// Hardware reads ahead on some ten streams, not on 19: 512 bytes ahead is 1.6 times as fast (Zen 5,
// one core), while D2Q9 loses a seventh by being told.
template <class L> constexpr bool READS_AHEAD = L::Q > 9;
template <class L> constexpr int AHEAD = 512 / sizeof(typename L::Real);
template <class L> LBM_INLINE inline void read_ahead(const Slots<L> &p, Index n)
{
  unroll<L::Q>([&](auto i) LBM_INLINE {
    __builtin_prefetch(p[i] + n, 1);
  });
}

// ahead: the node to be read later
template <class L, int W, class Collision, class Force, class Solid>
LBM_INLINE inline void update_nodes(const Slots<L> &p, Index n, Index ahead,
                                    const Collision &collide, const Force &force,
                                    const Solid &solid)
{
  using V = Pack<W, typename L::Real>;
  if constexpr (READS_AHEAD<L> && W > 1)
    if (solid.template any_fluid<W>(ahead)) read_ahead<L>(p, ahead);
  if (!solid.template any_fluid<W>(n)) return;
  V f[L::Q];
  unroll<L::Q>([&](auto i) LBM_INLINE {
    f[i] = load<V>(p[i] + n);
  });
  if constexpr (Solid::present) {
    const auto owner = load<PackInt<W>>(solid.owner + n);
    unroll<L::Q>([&](auto i) LBM_INLINE {
      f[i] = where_fluid<W>(owner, f[i]);
    });
  }
  if constexpr (Solid::keep_density) f[0] = f[0] + typename L::Real(solid.gain);
  const V drho = collide(f, force);
  if constexpr (Solid::keep_density) store(solid.drho + n, convert<PackFloat<W>>(drho));
  unroll<L::Q>([&](auto i) LBM_INLINE {
    store(p[opposite<L>(i)] + n, f[i]);
  });
}

template <class L, class Collision, class Force, class Solid>
void sweep(const Block<L> &block, const Collision &collide, const Force &force, const Solid &solid,
           const Region &region)
{
  const Layout &at = block.layout();
  const Slots<L> p = block.slots();
  constexpr int W = width<typename L::Real>;
  const int length = region.hi[0] - region.lo[0] + 1;
  const Index to_next_row = at.stride_y - length;    // from the end of a row
  for (int z = region.lo[2]; z <= region.hi[2]; z++)
    for (int y = region.lo[1]; y <= region.hi[1]; y++) {
      const Index row = at.index(region.lo[0], y, z), row_end = row + length;
      Index n = row;
      for (; n + W <= row_end; n += W) {
        const Index ahead = n + AHEAD<L>;
        update_nodes<L, W>(p, n, ahead < row_end ? ahead : ahead + to_next_row, collide, force,
                           solid);
      }
      for (; n < row_end; n++) update_nodes<L, 1>(p, n, n, collide, force, solid);
    }
}

template <class L, class Collision, class Force, class Solid>
void sweep(const Block<L> &block, const Collision &collide, const Force &force, const Solid &solid)
{
  sweep(block, collide, force, solid, block.layout().all());
}

}    // namespace lbm
#endif
