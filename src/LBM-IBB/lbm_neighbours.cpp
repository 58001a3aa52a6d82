// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_neighbours_mpi.h"

#include <algorithm>
#include <stdexcept>

namespace lbm {

void Alone::shift(int d, int, const double *send, std::size_t nsend, double *receive,
                  std::size_t nreceive)
{
  if (periodic_[d]) std::copy_n(send, std::min(nsend, nreceive), receive);
}

MpiNeighbours::MpiNeighbours(MPI_Comm comm, const std::array<std::array<int, 2>, 3> &rank) :
    comm_(comm), rank_(rank)
{
  MPI_Comm_rank(comm, &me_);
}

void MpiNeighbours::shift(int d, int side, const double *send, std::size_t nsend, double *receive,
                          std::size_t nreceive)
{
  const int to = rank_[d][side], from = rank_[d][1 - side];
  if (to == me_ && from == me_) {
    std::copy_n(send, std::min(nsend, nreceive), receive);
    return;
  }
  constexpr std::size_t limit = 1u << 30;
  if (nsend > limit || nreceive > limit)
    throw std::length_error("lattice too large for one rank: halo message exceeds 2^30 numbers");
  MPI_Sendrecv(send, int(nsend), MPI_DOUBLE, to, 2 * d + side, receive, int(nreceive), MPI_DOUBLE,
               from, 2 * d + side, comm_, MPI_STATUS_IGNORE);
}

void MpiNeighbours::sum(double *values, int n)
{
  MPI_Allreduce(MPI_IN_PLACE, values, n, MPI_DOUBLE, MPI_SUM, comm_);
}

void MpiNeighbours::max(double *values, int n)
{
  MPI_Allreduce(MPI_IN_PLACE, values, n, MPI_DOUBLE, MPI_MAX, comm_);
}

}    // namespace lbm
