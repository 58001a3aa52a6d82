// SPDX-License-Identifier: GPL-2.0-only
// What the whole fluid looks like at one moment: sums, extremes, and the first node that went
// wrong. One pass over the block, made only when somebody asks. Lattice units.

#ifndef LBM_MONITOR_H
#define LBM_MONITOR_H

#include "lbm_block.h"
#include "lbm_equilibrium.h"
#include "lbm_neighbours.h"

namespace lbm {

struct Extreme {
  double value;
  Int3 p;    // node of the whole lattice; of this block's extreme, not of all blocks
};

struct Survey {
  double fluid_nodes = 0.0;
  double mass = 0.0;         // sum of rho
  Vec3 momentum{};           // sum of rho u
  Vec3 velocity{};           // sum of u; over all nodes of the box it is the superficial velocity
  Extreme speed{0.0, {}};    // largest |u|
  Extreme drho_min{0.0, {}}, drho_max{0.0, {}};
  // a node that is not a number, or whose density is not positive
  bool bad = false;
  Int3 bad_node{};
  double bad_drho = 0.0;
};

// of this block; owner may be null
template <class L>
Survey survey(const Layout &at, const Slots<L> &f, const int32_t *owner, const Vec3 &force);

// sums and extremes over all blocks; places stay this block's
void reduce(Survey &s, Neighbours &neighbours);

}    // namespace lbm
#endif
