// SPDX-License-Identifier: GPL-2.0-only
// Blocks arranged as a brick of MPI ranks.

#ifndef LBM_NEIGHBOURS_MPI_H
#define LBM_NEIGHBOURS_MPI_H

#include "lbm_neighbours.h"

#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1    // the deprecated C++ bindings only bring warnings
#endif
#include <mpi.h>

namespace lbm {

class MpiNeighbours : public Neighbours {
 public:
  // rank[d][side] is the neighbouring rank, MPI_PROC_NULL where the domain ends
  MpiNeighbours(MPI_Comm comm, const std::array<std::array<int, 2>, 3> &rank);
  bool exists(int d, int side) const override { return rank_[d][side] != MPI_PROC_NULL; }
  bool itself(int d) const override { return rank_[d][0] == me_ && rank_[d][1] == me_; }
  void sum(double *values, int n) override;
  void max(double *values, int n) override;
  std::vector<double> gather(const std::vector<double> &mine) override;

 protected:
  void shift_words(int d, int side, const void *send, std::size_t nsend, void *receive,
                   std::size_t nreceive) override;

 private:
  MPI_Comm comm_;
  int me_ = 0;
  std::array<std::array<int, 2>, 3> rank_;
};

}    // namespace lbm
#endif
