// SPDX-License-Identifier: GPL-2.0-only
// The link pass: every cut link bounces back, and gives its momentum to its sphere.
//
// Momentum exchange, Galilean invariant form (Wen et al. 2014), per link, i from fluid to solid:
//     F = e_i (f*_i + f_o) - u_w (f*_i - f_o)
// with the deviations from the equilibrium at rest density and wall velocity in place of f: the sum
// over a closed surface is the same, and links that two touching grains hide from each other
// contribute what fluid at rest density, at rest with the surface, would have given: nothing.
// A sphere's refund is added to what comes back along each of its links, times the weight w.
// Fluid at another density presses the two apart where they hide links: equal and opposite forces
// of the mean density excess around them, without which they would attract each other.

#ifndef LBM_EXCHANGE_H
#define LBM_EXCHANGE_H

#include "lbm_block.h"
#include "lbm_link.h"
#include "lbm_simd.h"
#include "lbm_yield.h"

namespace lbm {

// Bounce back all links, after the sweep of step t and its halo exchange; f are the slots of step
// t + 1. drho is the density excess by node where surfaces move, else null.
// loads[s] is increased by what sphere s receives. Without a ledger of mass nothing is refunded and
// what links swallow is not summed. With yields, which goes with Motion::TURN, what gaps give goes
// to those sums instead, and with it the reaches of spheres that yield, see lbm_yield.h.
template <class L, class Rule, Motion motion, bool ledger, bool yields>
void bounce_back(const Layout &at, const Slots<L> &f, const Cover &cover, const Links &links,
                 const float *drho, std::vector<Load> &loads, Yields &sums);

// Gaps below this sum of the two fractions are treated as if they had it: the closed form of a pair
// of links is ill-conditioned as both surfaces meet in one node.
constexpr double GAP_MIN = 0.2;

}    // namespace lbm
#endif
