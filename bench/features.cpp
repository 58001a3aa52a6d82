// SPDX-License-Identifier: GPL-2.0-only
// Scene of the solver core for ./run features: a cube of 48 nodes, and what is named:
//  features [grains] [moving] [rotation] [yields] [ledger] [faces] [walls] [force] [checks] [ranks]
// measured() is called for 1, 2 and 6 steps: the last less the one before are four steps without
// anything that is done once. Printed is what the same scene must give in every build.

#include "lbm_neighbours_mpi.h"
#include "lbm_solver.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

using namespace lbm;

namespace {

constexpr int N = 48, CELLS = 4;

struct Wanted {
  bool grains = false, moving = false, rotation = false, yields = false, ledger = false,
       faces = false, walls = false, force = false, checks = false, ranks = false;

  Wanted(int argc, char **argv)
  {
    const std::pair<const char *, bool *> names[] = {
        {"grains", &grains}, {"moving", &moving}, {"rotation", &rotation}, {"yields", &yields},
        {"ledger", &ledger}, {"faces", &faces},   {"walls", &walls},       {"force", &force},
        {"checks", &checks}, {"ranks", &ranks}};
    for (int k = 1; k < argc; k++) {
      bool known = false;
      for (const auto &[name, flag] : names)
        if (!std::strcmp(name, argv[k])) *flag = known = true;
      if (!known) {
        std::fprintf(stderr, "features: no feature '%s'\n", argv[k]);
        std::exit(1);
      }
    }
  }
};

// spheres on a face-centred cubic lattice, solid fraction 0.6, their periodic images among them;
// ids of the grains themselves count from 0
struct Bed {
  std::vector<Sphere> spheres;
  int grains = 4 * CELLS * CELLS * CELLS;

  Bed(const Wanted &wanted, const Int3 &lo, const Int3 &n)
  {
    const double a = double(N) / CELLS, radius = a * std::cbrt(0.6 * 3.0 / 16.0 / M_PI);
    const double basis[4][3] = {{.1, .13, .17}, {.6, .63, .17}, {.6, .13, .67}, {.1, .63, .67}};
    const Vec3 velocity{wanted.moving ? 0.01 : 0.0, 0.0, 0.0};
    const Vec3 spin{0.0, 0.0, wanted.rotation ? 0.001 : 0.0};
    const auto home = [](int i) {
      return (i + CELLS) % CELLS;
    };
    for (int i = -1; i <= CELLS; i++)
      for (int j = -1; j <= CELLS; j++)
        for (int k = -1; k <= CELLS; k++)
          for (int b = 0; b < 4; b++) {
            const Int3 cell{i, j, k};
            Vec3 c;
            bool reaches = true;
            for (int d = 0; d < 3; d++) {
              c[d] = snap((cell[d] + basis[b][d]) * a);
              reaches =
                  reaches && c[d] + radius > lo[d] - 2.0 && c[d] - radius < lo[d] + n[d] + 2.0;
            }
            const int id = b + 4 * (home(i) + CELLS * (home(j) + CELLS * home(k)));
            if (!reaches) continue;
            spheres.push_back({id, c, radius, velocity, spin});
            spheres.back().yields = wanted.yields;
          }
  }
};

class Scene {
 public:
  Scene(const Wanted &wanted, int rank, int ranks) : wanted(wanted)
  {
    Int3 lo{0, 0, 0}, n{N, N, N};
    n[2] /= ranks;
    lo[2] = rank * n[2];
    Settings s;
    s.ledger = wanted.ledger;
    if (wanted.faces || wanted.walls)
      for (Face &face : s.faces[2]) face.kind = wanted.faces ? FaceKind::PRESSURE : FaceKind::WALL;
    const bool closed = wanted.faces || wanted.walls;
    if (ranks == 1)
      neighbours = std::make_unique<Alone>(std::array<bool, 3>{true, true, !closed});
    else
      neighbours = std::make_unique<MpiNeighbours>(
          MPI_COMM_WORLD,
          std::array<std::array<int, 2>, 3>{{{rank, rank}, {rank, rank}, {1 - rank, 1 - rank}}});
    fluid = Fluid::create(s, lo, n, {N, N, N}, *neighbours);
    if (wanted.force) fluid->set_force({0.0, 0.0, 1e-6});
    for (int z = 0; z < n[2]; z++)
      for (int y = 0; y < n[1]; y++)
        for (int x = 0; x < n[0]; x++) {
          const double k = 2.0 * M_PI / N;
          fluid->set_equilibrium(
              x, y, z,
              {1e-3 * std::sin(k * x), {0.01 * std::sin(k * y), 0.01 * std::cos(k * x), 0.02}});
        }
    if (!wanted.grains) return;
    bed = std::make_unique<Bed>(wanted, lo, n);
    sums.resize(bed->grains);
    before.resize(bed->grains);
  }

  void step()
  {
    if (bed) hand_in();
    if (wanted.yields && !loads.empty())
      fluid->correct({bed->spheres.size(), Gain{{1e-4, 0.0, 0.0}, {0.0, 0.0, 1e-5}}});
    fluid->follow(bed ? bed->spheres : none);
    fluid->advance(loads);
    if (wanted.checks) seen = fluid->survey().speed.value;
    if (bed) take_back();
  }

  void print(bool here)
  {
    // mass, momentum, and of the spheres: force, torque, links
    double sums[] = {0.0, 0.0, 0.0, 0.0, fluid->links()};
    const Int3 &n = fluid->layout().n;
    for (int z = 0; z < n[2]; z++)
      for (int y = 0; y < n[1]; y++)
        for (int x = 0; x < n[0]; x++) {
          if (fluid->solid(x, y, z)) continue;
          const Moments m = fluid->moments(x, y, z);
          sums[0] += 1.0 + m.drho;
          sums[1] += (1.0 + m.drho) * m.u[2];
        }
    for (const Load &load : loads) {
      sums[2] += load.force[2];
      sums[3] += load.torque[2];
    }
    neighbours->sum(sums, 5);
    if (!here) return;
    std::printf("result:");
    for (double x : sums) std::printf(" %.12g", x);
    std::printf("\n");
  }

 private:
  const Wanted wanted;
  std::unique_ptr<Neighbours> neighbours;
  std::unique_ptr<Fluid> fluid;
  std::unique_ptr<Bed> bed;
  const std::vector<Sphere> none;
  std::vector<Load> loads, sums, before;    // of spheres; of grains, in the last step and before
  double seen = 0.0;

  void hand_in()
  {
    for (Sphere &s : bed->spheres) {
      s.centre[0] = snap(s.centre[0] + s.velocity[0]);
      s.drho = sums[s.id].drho();
      if (wanted.ledger)
        s.refund = refund(sums[s.id].swallowed, before[s.id].swallowed, sums[s.id].area);
    }
  }

  void take_back()
  {
    std::swap(before, sums);
    sums.assign(bed->grains, {});
    for (std::size_t k = 0; k < loads.size(); k++) {
      Load &sum = sums[bed->spheres[k].id];
      sum.pressing += loads[k].pressing;
      sum.area += loads[k].area;
      sum.swallowed += loads[k].swallowed;
    }
  }
};

}    // namespace

extern "C" __attribute__((noinline)) void measured(void *scene, int steps)
{
  for (int t = 0; t < steps; t++) static_cast<Scene *>(scene)->step();
}

int main(int argc, char **argv)
{
  const Wanted wanted(argc, argv);
  int rank = 0, ranks = 1;
  if (wanted.ranks) {
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (ranks != 2) {
      std::fprintf(stderr, "features: 'ranks' takes two of them: mpirun -np 2\n");
      std::exit(1);
    }
  }
  {
    Scene scene(wanted, rank, ranks);
    for (int steps : {1, 2, 6}) measured(&scene, steps);
    scene.print(rank == 0);
  }
  if (wanted.ranks) MPI_Finalize();
}
