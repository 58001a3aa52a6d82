// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_neighbours_mpi.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace lbm {

// memcpy must not be given null, not even for nothing
static void copy_words(void *to, const void *from, std::size_t n)
{
  if (n > 0) std::memcpy(to, from, 4 * n);
}

void Alone::shift_words(int d, int, const void *send, std::size_t nsend, void *receive,
                        std::size_t nreceive)
{
  if (periodic_[d]) copy_words(receive, send, std::min(nsend, nreceive));
}

MpiNeighbours::MpiNeighbours(MPI_Comm comm, const std::array<std::array<int, 2>, 3> &rank) :
    comm_(comm), rank_(rank)
{
  MPI_Comm_rank(comm, &me_);
}

void MpiNeighbours::shift_words(int d, int side, const void *send, std::size_t nsend, void *receive,
                                std::size_t nreceive)
{
  const int to = rank_[d][side], from = rank_[d][1 - side];
  if (to == me_ && from == me_) {
    copy_words(receive, send, std::min(nsend, nreceive));
    return;
  }
  constexpr std::size_t limit = std::numeric_limits<int>::max();
  if (nsend > limit || nreceive > limit)
    throw std::length_error("lattice too large for one rank: halo message exceeds 8 GiB");
  MPI_Sendrecv(send, int(nsend), MPI_UINT32_T, to, 2 * d + side, receive, int(nreceive),
               MPI_UINT32_T, from, 2 * d + side, comm_, MPI_STATUS_IGNORE);
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
