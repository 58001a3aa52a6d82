// SPDX-License-Identifier: GPL-2.0-only
// What crosses the faces of a block after a sweep: for every face only the populations that move
// through it (5 of 19, 3 of 9).
//
// With in-place streaming (lbm_block.h) a value that crosses a face with array k, e_k pointing out
// of the face, lies after an even sweep in the neighbour's boundary layer and is wanted in the
// ghost layer here; after an odd sweep it lies in the ghost layer here and is wanted in the
// neighbour's boundary layer: the same exchange read backwards. Directions one after the other
// carry values across edges: forwards x, y, z; backwards z, y, x.

#ifndef LBM_HALO_H
#define LBM_HALO_H

#include "lbm_block.h"
#include "lbm_neighbours.h"

#include <vector>

namespace lbm {

template <class L> class Halo {
 public:
  Halo(const Layout &layout, Neighbours &neighbours);

  // after the sweep of step t and before any reading of N_{t+1}; block.step() is still t
  void exchange(const Block<L> &block);

 private:
  struct Box {
    Int3 lo, hi;    // inclusive
    std::size_t nodes() const;
  };
  Layout at_;
  Neighbours &neighbours_;
  std::vector<typename L::Real> send_, receive_;

  // nodes of array k that cross the face: ghosts outside it, or the layer they are copies of
  Box region(int k, int d, int side, bool ghosts) const;
  template <class F> std::size_t for_each_crossing(int d, int side, bool ghosts, F &&f) const;
  void along(const Block<L> &block, int d, int side, bool forwards);
  void to_itself(const Block<L> &block, int d, int side, bool forwards) const;
};

}    // namespace lbm
#endif
