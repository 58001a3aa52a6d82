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

std::vector<double> MpiNeighbours::gather(const std::vector<double> &mine)
{
  int ranks;
  MPI_Comm_size(comm_, &ranks);
  std::vector<int> count(ranks), first(ranks, 0);
  const int n = int(mine.size());
  MPI_Allgather(&n, 1, MPI_INT, count.data(), 1, MPI_INT, comm_);
  for (int r = 1; r < ranks; r++) first[r] = first[r - 1] + count[r - 1];
  std::vector<double> all(std::size_t(first.back()) + count.back());
  MPI_Allgatherv(mine.data(), n, MPI_DOUBLE, all.data(), count.data(), first.data(), MPI_DOUBLE,
                 comm_);
  return all;
}

}    // namespace lbm
