// SPDX-License-Identifier: GPL-2.0-only
// Enclosed fluid: sets of fluid nodes from which no population gets to the rest of the fluid.
//
// The rest is what touches an open face, and the largest set. Water would find a way out between
// grains that touch, but the lattice has none, and the smallest motion pumps such a set up or
// empties it, as it does single nodes (fill_pockets() in lbm_refill.h). So the mean density of a
// set of two nodes or more is kept at that around the spheres next to it, in every step, by the
// same shift at all its nodes: flow and gradients in it are left alone. Sets larger than the
// largest sphere, or with none around, are counted but not touched: a chamber keeps its water.
//
// Sets are found now and then, and kept until then though nodes come and go. Lattice units.

#ifndef LBM_ENCLOSED_H
#define LBM_ENCLOSED_H

#include "lbm_cover.h"
#include "lbm_neighbours.h"

namespace lbm {

template <class L> class Enclosed {
 public:
  explicit Enclosed(const Layout &layout) : at_(layout) {}

  // collective; lattice: nodes of the whole
  void find(const Cover &cover, const Int3 &lattice, Neighbours &neighbours);
  void forget();
  // After the link pass; f are the slots of the new step. Returns the mass that nodes of this block
  // gain. Collective, but sends nothing unless a set crosses blocks.
  double hold(const Slots<L> &f, const Cover &cover, Neighbours &neighbours) const;
  bool holds_any() const { return !held_.empty(); }    // of all blocks

  // of all blocks, when last found, single nodes among them
  double sets() const { return sets_; }
  double nodes() const { return nodes_; }
  double bytes() const;

 private:
  Layout at_;
  double sets_ = 0.0, nodes_ = 0.0;
  // those whose density is kept, in the same order on all blocks, with the nodes of this one
  struct Set {
    bool shared = false;    // between blocks
    std::vector<uint32_t> nodes;
  };
  std::vector<Set> held_;
};

}    // namespace lbm
#endif
