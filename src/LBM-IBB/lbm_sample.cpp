// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_sample.h"

#include "lbm_mpi.h"

#include <algorithm>

namespace lbm {
namespace {

  struct Stretch {
    Index first, last;    // the latter is not of it
  };

  Stretch stretch_of(int rank, Index all, int writers, int block)
  {
    const Index blocks = (all + block - 1) / block;
    auto start = [&](int r) {
      return std::min(all, blocks * std::min(r, writers) / writers * block);
    };
    return {start(rank), start(rank + 1)};
  }

  // f(place in the part, place in the whole, length) of each row's piece within the stretch, in order
  template <class F>
  void for_each_row(const Part &part, const Int3 &n, const Stretch &stretch, F &&f)
  {
    for (int k = 0; k < part.n[2]; k++)
      for (int j = 0; j < part.n[1]; j++) {
        const Index own = (Index(k) * part.n[1] + j) * part.n[0];
        const Index row = (Index(part.lo[2] + k) * n[1] + part.lo[1] + j) * n[0] + part.lo[0];
        const Index from = std::max(row, stretch.first),
                    to = std::min(row + part.n[0], stretch.last);
        if (from < to) f(own + from - row, from, to - from);
      }
  }

  std::vector<int> starts(const std::vector<int> &count)
  {
    std::vector<int> first(count.size(), 0);
    for (std::size_t r = 1; r < count.size(); r++) first[r] = first[r - 1] + count[r - 1];
    return first;
  }

}    // namespace

Part Sample::within(const Part &nodes) const
{
  Part part{};
  for (int d = 0; d < 3; d++) {
    const int from = std::max(0, (nodes.lo[d] - lo[d] + stride - 1) / stride);
    const int end = nodes.lo[d] + nodes.n[d] - lo[d];    // from the first node of the sample
    const int to = std::min(n[d], end > 0 ? (end - 1) / stride + 1 : 0);
    part.lo[d] = from;
    part.n[d] = std::max(0, to - from);
  }
  return part;
}

std::vector<float> in_order(const std::vector<float> &mine, const Part &part, const Int3 &n,
                            int values, int writers, int block, MPI_Comm comm)
{
  int me, ranks;
  MPI_Comm_rank(comm, &me);
  MPI_Comm_size(comm, &ranks);
  const Index all = Index(n[0]) * n[1] * n[2];
  std::vector<Part> parts(ranks);
  static_assert(sizeof(Part) == 6 * sizeof(int));
  MPI_Allgather(&part, 6, MPI_INT, parts.data(), 6, MPI_INT, comm);

  // both sides know who has what: nothing but values is sent, in the order of the sender's rows
  std::vector<int> out(ranks, 0), in(ranks, 0);
  std::vector<float> sent;
  sent.reserve(mine.size());
  for (int r = 0; r < ranks; r++)
    for_each_row(part, n, stretch_of(r, all, writers, block), [&](Index own, Index, Index length) {
      out[r] += int(length);
      const auto first = mine.begin() + own * values;
      sent.insert(sent.end(), first, first + length * values);
    });
  const Stretch stretch = stretch_of(me, all, writers, block);
  for (int r = 0; r < ranks; r++)
    for_each_row(parts[r], n, stretch, [&](Index, Index, Index length) {
      in[r] += int(length);
    });

  const std::size_t size = std::size_t(stretch.last - stretch.first) * values;
  std::vector<float> got(size), ordered(size);
  const auto first_out = starts(out), first_in = starts(in);
  const Type node{int(values * sizeof(float))};
  MPI_Alltoallv(sent.data(), out.data(), first_out.data(), node.handle(), got.data(), in.data(),
                first_in.data(), node.handle(), comm);
  auto next = got.begin();
  for (int r = 0; r < ranks; r++)
    for_each_row(parts[r], n, stretch, [&](Index, Index place, Index length) {
      std::copy_n(next, length * values, ordered.begin() + (place - stretch.first) * values);
      next += length * values;
    });
  return ordered;
}

}    // namespace lbm
