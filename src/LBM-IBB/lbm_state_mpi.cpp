// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_state_mpi.h"

#include "lbm_mpi.h"

#include <algorithm>

namespace lbm {
namespace {

  std::vector<Part> gathered(const Part &mine, MPI_Comm comm, int ranks)
  {
    static_assert(sizeof(Part) == 6 * sizeof(int));
    std::vector<Part> all(ranks);
    MPI_Allgather(&mine, 6, MPI_INT, all.data(), 6, MPI_INT, comm);
    return all;
  }

}    // namespace

std::vector<Sphere> all_spheres(const Fluid &fluid, MPI_Comm comm)
{
  const std::vector<Sphere> mine = fluid.own_spheres();
  int ranks;
  MPI_Comm_size(comm, &ranks);
  std::vector<int> count(ranks), first(ranks, 0);
  const int n = int(mine.size());
  MPI_Allgather(&n, 1, MPI_INT, count.data(), 1, MPI_INT, comm);
  for (int r = 1; r < ranks; r++) first[r] = first[r - 1] + count[r - 1];
  std::vector<Sphere> all(first.back() + count.back());
  const Type sphere(sizeof(Sphere));
  MPI_Allgatherv(mine.data(), n, sphere.handle(), all.data(), count.data(), first.data(),
                 sphere.handle(), comm);
  std::sort(all.begin(), all.end(), [](const Sphere &a, const Sphere &b) {
    return a.id < b.id;
  });
  return all;
}

Carried::Carried(const Fluid &from, const Part &to, MPI_Comm comm) :
    comm_(comm), bytes_of_node_(from.directions() * from.bytes_of_population()),
    grains_(all_spheres(from, comm)), counts_{from.links(), from.gaps(), from.refilled(),
                                              from.ledger(), from.mean_density()}
{
  int ranks;
  MPI_Comm_size(comm, &ranks);
  const Part mine{from.layout().lo, from.layout().n};
  const auto before = gathered(mine, comm, ranks), after = gathered(to, comm, ranks);
  for (int r = 0; r < ranks; r++) {
    const Part leaves = common(mine, after[r]), comes = common(before[r], to);
    if (leaves.nodes() > 0) {
      out_.push_back({r, leaves, std::vector<char>(bytes_of_node_ * std::size_t(leaves.nodes()))});
      from.give(leaves, out_.back().data.data());
    }
    if (comes.nodes() > 0) in_.push_back({r, comes, {}});
  }
}

void Carried::into(Fluid &fluid)
{
  // counts of nodes fit into an int where those of bytes need not
  const Type node(bytes_of_node_);
  std::vector<MPI_Request> requests;
  for (const Parcel &p : out_) {
    requests.emplace_back();
    MPI_Isend(p.data.data(), int(p.part.nodes()), node.handle(), p.rank, 0, comm_,
              &requests.back());
  }
  for (Parcel &p : in_) {    // one at a time, so that little is held three times
    p.data.resize(bytes_of_node_ * std::size_t(p.part.nodes()));
    MPI_Recv(p.data.data(), int(p.part.nodes()), node.handle(), p.rank, 0, comm_,
             MPI_STATUS_IGNORE);
    fluid.take(p.part, p.data.data());
    p.data = {};
  }
  MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  fluid.resume(grains_, counts_);
}

}    // namespace lbm
