// SPDX-License-Identifier: GPL-2.0-only
// The machine's limit for in-place streaming: reads and writes all populations of a cube, nothing else,
// reading ahead as the sweep does.
//
//     mpirun -np RANKS limits D3Q19|D3Q19single|D2Q9|D2Q9single NODES SECONDS
//     mpirun -np RANKS limits peak
//
// NODES along an edge; the ranks share the cube and work at once. Prints M nodes/s of all ranks; peak:
// 10^9 multiplications and additions a second of all ranks in double precision, and how many of them a
// node takes in the sweep, D3Q19 and D2Q9.

#include "lbm_sweep.h"

#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1
#endif
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
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

// counts what is done with it
struct Counted {
  double value = 0.0;
  static inline int operations = 0;
  Counted(double v = 0.0) : value(v) {}
  friend Counted operator+(Counted, Counted) { return count(); }
  friend Counted operator-(Counted, Counted) { return count(); }
  friend Counted operator*(Counted, Counted) { return count(); }
  friend Counted operator/(Counted, Counted) { return count(); }
  friend Counted operator-(Counted) { return {}; }
  static Counted count()
  {
    operations++;
    return {};
  }
};

template <class L> int operations_a_node()
{
  Counted f[L::Q];
  Counted::operations = 0;
  Trt<L>::trt(0.6, 0.1875)(f, NoForce{});
  return Counted::operations;
}

void peak()
{
  constexpr int W = SIMD_WIDTH, CHAINS = 12;    // enough to hide the time of each
  constexpr long TIMES = 50'000'000;
  Pack<W> sum[CHAINS] = {}, by = Pack<W>{} + 0.999, more = Pack<W>{} + 1e-3;
  MPI_Barrier(MPI_COMM_WORLD);
  const double begin = MPI_Wtime();
  for (long t = 0; t < TIMES; t++) unroll<CHAINS>([&](auto k) LBM_INLINE {
      sum[k] = sum[k] * by + more;
    });
  const double elapsed = MPI_Wtime() - begin;
  double all = 0.0, mine = 2.0 * W * CHAINS * TIMES / elapsed;
  for (const auto &s : sum) all += s[0];
  MPI_Reduce(all > 0.0 ? &mine : &all, &all, 1, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
    printf("%.2f %d %d\n", all * 1e-9, operations_a_node<D3Q19>(), operations_a_node<D2Q9>());
}

}    // namespace

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  const std::string lattice = argc > 3 || (argc > 1 && !strcmp(argv[1], "peak")) ? argv[1] : "";
  const int nodes = argc > 3 ? atoi(argv[2]) : 0;
  const double seconds = argc > 3 ? atof(argv[3]) : 0.0;
  int status = 0;
  if (lattice == "peak")
    peak();
  else if (lattice == "D3Q19")
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
