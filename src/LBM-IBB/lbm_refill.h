// SPDX-License-Identifier: GPL-2.0-only
// Populations of nodes that a moving sphere has just uncovered (Mansouri et al. 2016, section 3.4).
//
// Such a node gets the velocity of the solid it belonged to, and
//   grad         local mean density and Grad's approximation (Chikatamarla, Ansumali & Karlin 2006)
//                with the velocity gradient by differences to the neighbours along the axes;
//                no such neighbour: equilibrium with the density of the populations that arrive;
//                none arrives from fluid: equilibrium with the mean density around the sphere
//   normal       local mean density, and what the neighbour nearest to the normal of the surface,
//                along an axis, has beyond equilibrium (Caiazzo 2008); else as grad
//   local        equilibrium with the local mean density; else as grad
//   equilibrium  the rule of the paper: equilibrium with the mean density of the whole system

#ifndef LBM_REFILL_H
#define LBM_REFILL_H

#include "lbm_covers.h"
#include "lbm_neighbours.h"

namespace lbm {

enum class RefillRule { GRAD, NORMAL, LOCAL, EQUILIBRIUM };

// how many nodes were filled, and by which rule they had to be
struct RefillCount {
  std::int64_t grad = 0,    // or normal, local
      equilibrium = 0, deep = 0;
};

// density excess of nodes, summed
template <class L> double excess_in(const Slots<L> &f, const std::vector<Index> &nodes);

// Fill them, between the link pass of step t - 1 and the sweep of step t; f are the slots of step
// t. Returns the sum of their density excess. Collective over all blocks.
template <class L>
double refill_local(RefillRule rule,    // all but EQUILIBRIUM
                    const Layout &at, const Slots<L> &f, const Cover &before, const Cover &now,
                    const std::vector<Uncovered> &nodes, double tau, const Vec3 &force,
                    Neighbours &neighbours, RefillCount &count);

template <class L>
double refill_equilibrium(const Slots<L> &f, const Cover &before,
                          const std::vector<Uncovered> &nodes, double drho_mean, const Vec3 &force,
                          RefillCount &count);

// Fluid nodes with no fluid neighbour or one, all others being covered or behind walls, after the
// link pass; f as above. Little or nothing can flow in or out on this lattice, though water could:
// left alone, such a node is pumped up or emptied by the smallest motion, and presses on its
// spheres accordingly. It gets the equilibrium of their mean velocity and,
//   without a fluid neighbour, of the mean density around them;
//   with one, of the mass it had and has exchanged with that neighbour.
// Returns the mass they have gained by it.
template <class L>
double fill_pockets(const Layout &at, const Slots<L> &f, const Cover &cover,
                    const std::vector<uint32_t> &pockets, const Vec3 &force);

}    // namespace lbm
#endif
