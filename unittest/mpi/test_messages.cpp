// SPDX-License-Identifier: GPL-2.0-only
// What ranks send each other, counted: 5 of 19 populations for every node of a face and nothing else.
// ctest: LABELS quick RANKS 1 8

#include "../core/scene.h"

#include "lbm_neighbours_mpi.h"

#include <gtest/gtest.h>

using namespace lbm;

namespace {

class Counting : public MpiNeighbours {
 public:
  using MpiNeighbours::MpiNeighbours;
  double bytes = 0.0, messages = 0.0;

 protected:
  void shift_words(int d, int side, const void *send, std::size_t nsend, void *receive,
                   std::size_t nreceive) override
  {
    bytes += 4.0 * double(nsend);
    messages++;
    MpiNeighbours::shift_words(d, side, send, nsend, receive, nreceive);
  }
};

// a periodic cube on 1 or 2 x 2 x 2 ranks, spheres that move or none
struct Cube {
  static constexpr int N = 32;
  int me, ranks, edge;    // ranks along an edge
  Int3 place, n;
  Counting neighbours;
  std::unique_ptr<Fluid> fluid;

  static int rank()
  {
    int me;
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    return me;
  }
  static int edge_of_brick()
  {
    int ranks;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    return ranks == 8 ? 2 : 1;
  }
  static std::array<std::array<int, 2>, 3> ring()
  {
    const int e = edge_of_brick(), me = rank();
    std::array<std::array<int, 2>, 3> next;
    for (int d = 0, stride = 1; d < 3; d++, stride *= e) {
      const int other = e == 1 ? me : (me / stride % e == 0 ? me + stride : me - stride);
      next[d] = {other, other};
    }
    return next;
  }

  explicit Cube(bool single) :
      me(rank()),
      edge(edge_of_brick()), place{me % edge, me / edge % edge, me / edge / edge}, n{N / edge,
                                                                                     N / edge,
                                                                                     N / edge},
      neighbours(MPI_COMM_WORLD, ring())
  {
    Settings settings;
    settings.single = single;
    fluid = Fluid::create(settings, {place[0] * n[0], place[1] * n[1], place[2] * n[2]}, n,
                          {N, N, N}, neighbours);
  }

  double ideal(bool single) const
  {
    return 3 * 2 * 5.0 * n[0] * n[1] * (single ? sizeof(float) : sizeof(double));
  }
};

TEST(Messages, AreTheFacesAndNothingElse)
{
  for (bool single : {false, true}) {
    Cube cube(single);
    std::vector<Load> loads;
    for (int t = 0; t < 4; t++) {    // streaming in place sends other arrays in every second step
      cube.neighbours.bytes = cube.neighbours.messages = 0.0;
      cube.fluid->follow({});
      cube.fluid->advance(loads);
      const bool alone = cube.edge == 1;    // to itself a block sends nothing
      EXPECT_EQ(cube.neighbours.bytes, alone ? 0.0 : cube.ideal(single));
      EXPECT_EQ(cube.neighbours.messages, alone ? 0.0 : 6.0);
    }
    double nodes = double(cube.fluid->layout().nodes());
    EXPECT_EQ(nodes * std::pow(cube.edge, 3), std::pow(Cube::N, 3));
  }
}

// a grain that moves adds what uncovered nodes ask for: little
TEST(Messages, OfMovingGrainsAreFewMore)
{
  Cube cube(false);
  const Layout &at = cube.fluid->layout();
  std::vector<Load> loads;
  double most = 0.0;
  for (int t = 0; t < 20; t++) {
    cube.neighbours.bytes = 0.0;
    std::vector<Sphere> here;    // one grain for each rank, near its faces
    for (int k = 0; k < 3; k++) {
      Vec3 c;
      for (int d = 0; d < 3; d++) c[d] = at.lo[d] + (d == k ? 3.2 : 0.5 * at.n[d]) + 0.05 * t;
      here.push_back(scene::sphere(3 * cube.me + k, c, 2.6, {0.05, 0.05, 0.05}));
    }
    cube.fluid->follow(here);
    cube.fluid->advance(loads);
    most = std::max(most, cube.neighbours.bytes);
  }
  EXPECT_LE(most, 1.05 * cube.ideal(false));
}

}    // namespace
