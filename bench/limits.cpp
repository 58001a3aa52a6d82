// SPDX-License-Identifier: GPL-2.0-only
// The machine's limit for in-place streaming: reads and writes all populations of a cube, nothing else,
// reading ahead as the sweep does.
//
//     mpirun -np RANKS limits D3Q19|D3Q19single|D2Q9|D2Q9single NODES SECONDS
//
// NODES along an edge; the ranks share the cube and work at once. Prints M nodes/s of all ranks.

#include "lbm_sweep.h"

#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1
#endif
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <string>

using namespace lbm;

namespace {

template <class L> void update(Block<L> &block)
{
  using Real = typename L::Real;
  constexpr int W = width<Real>;
  const Layout &at = block.layout();
  const Slots<L> p = block.slots();
  for (int z = 0; z < at.n[2]; z++)
    for (int y = 0; y < at.n[1]; y++) {
      const Index row = at.index(0, y, z);
      for (Index n = row; n + W <= row + at.n[0]; n += W) {
        Pack<W, Real> f[L::Q];
        if constexpr (READS_AHEAD<L>) read_ahead<L>(p, n);
        unroll<L::Q>([&](auto i) LBM_INLINE {
          f[i] = load<Pack<W, Real>>(p[i] + n);
        });
        unroll<L::Q>([&](auto i) LBM_INLINE {
          store(p[i] + n, f[i] + Real(1e-30));
        });
      }
    }
  block.advance();    // both parities, as they lie differently in memory
}

template <class L> void measure(int nodes, double seconds)
{
  int ranks;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const Int3 n = L::D == 3 ? Int3{nodes, nodes, nodes / ranks} : Int3{nodes, nodes / ranks, 1};
  Block<L> block(Layout({0, 0, 0}, n, L::D));
  update(block);
  MPI_Barrier(MPI_COMM_WORLD);
  const double begin = MPI_Wtime();
  double elapsed = 0.0, steps = 0.0;
  for (; elapsed < seconds; steps++) {
    update(block);
    elapsed = MPI_Wtime() - begin;
    MPI_Bcast(&elapsed, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  }
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) printf("%.2f\n", steps * double(block.layout().nodes()) * ranks / elapsed * 1e-6);
}

}    // namespace

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  const std::string lattice = argc > 3 ? argv[1] : "";
  const int nodes = argc > 3 ? atoi(argv[2]) : 0;
  const double seconds = argc > 3 ? atof(argv[3]) : 0.0;
  int status = 0;
  if (lattice == "D3Q19")
    measure<D3Q19>(nodes, seconds);
  else if (lattice == "D3Q19single")
    measure<InSingle<D3Q19>>(nodes, seconds);
  else if (lattice == "D2Q9")
    measure<D2Q9>(nodes, seconds);
  else if (lattice == "D2Q9single")
    measure<InSingle<D2Q9>>(nodes, seconds);
  else {
    fprintf(stderr, "limits D3Q19|D3Q19single|D2Q9|D2Q9single NODES SECONDS\n");
    status = 2;
  }
  MPI_Finalize();
  return status;
}
