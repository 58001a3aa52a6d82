// SPDX-License-Identifier: GPL-2.0-only
// Every so many-th node of a box of the lattice, and how their values come into order: ranks have
// them by bricks of nodes; a file wants them x fastest, in stretches that follow each other.

#ifndef LBM_SAMPLE_H
#define LBM_SAMPLE_H

#include "lbm_state.h"

#include <mpi.h>

#include <vector>

namespace lbm {

struct Sample {
  Int3 lo, n;    // first node; how many are taken along each direction
  int stride;
  // those of them among these nodes, counted within the sample
  Part within(const Part &nodes) const;
  Int3 node(int i, int j, int k) const
  {
    return {lo[0] + i * stride, lo[1] + j * stride, lo[2] + k * stride};
  }
};

// Collective. In: this rank's part of a whole of n, x fastest, so many values each. Out: the stretch of
// the whole that this rank has, of a multiple of block but for the last; ranks from writers on have
// none.
std::vector<float> in_order(const std::vector<float> &mine, const Part &part, const Int3 &n,
                            int values, int writers, int block, MPI_Comm comm);

}    // namespace lbm
#endif
