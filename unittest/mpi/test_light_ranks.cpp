/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   Contributing authors: LBM-IBB developers
------------------------------------------------------------------------- */

// ctest: RANKS 1 2 3 4
// Light grains, whose velocity the fluid answers to within its step, across the faces of ranks.

#include "fluid_ranks.h"

#include <functional>

class LightRanks : public FluidRanks {
 protected:
  void TearDown() override
  {
    lmp.reset();
    MPI_Barrier(MPI_COMM_WORLD);
  }

  // over all grains
  double sum_of(const std::function<double(int)> &what) const
  {
    double mine = 0.0, all;
    for (int i = 0; i < lmp->atom->nlocal; i++) mine += what(i);
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, lmp->world);
    return all;
  }
};

// one across an edge of the box, one larger than a sub-domain next to a wall that moves, and one that
// is not light beside them; between two fluid steps too
TEST_F(LightRanks, SameResultOnAllRanks)
{
  for (int every : {1, 4})
    compare([&](const std::string &brick) {
      return box({18, 16, 18}, "p p f", brick) + grain(1, {0.3, 15.7, 8.2}, 3.3, {4e-3, -4e-3, 0}) +
          grain(2, {9.1, 8.2, 12.4}, 4.6) + grain(3, {10.1, 14.2, 4.4}, 2.6, {-2e-3, 0, 0}) +
          "\nset atom 1 density 10\nset atom 2 density 50\ntimestep " + num(DT / every) +
          "\nfix m all nve/sphere" +
          fluid("accel 1e-3 0 0 face zlo wall face zhi wall 1e-3 0 0 every " +
                std::to_string(every)) +
          run(42 * every + every / 2);
    });
}

TEST_F(LightRanks, SameResultOfDiscs)
{
  compare([&](const std::string &brick) {
    return box({36, 24, 1}, "p f p", brick) + disc(1, {0.4, 8.1, 0}, 3.3, {4e-3, 1e-3, 0}) +
        disc(2, {17.9, 12.3, 0}, 5.6, {-2e-3, 0, 0}) + "\nset group all density/disc 20" +
        "\nfix m all nve/sphere disc" + fluid("face ylo wall face yhi wall 2e-3 0 0") +
        "\nfix flat all enforce2d" + run(60);
  });
}

// as on one rank, see test_fix_light: of the fluid, the grains, and what is on its way between them
TEST_F(LightRanks, MomentumIsKeptToRoundOff)
{
  for (const std::string &brick : bricks()) {
    SCOPED_TRACE(brick);
    const int every = 3;
    start(MPI_COMM_WORLD);
    script(box({18, 16, 16}, "p p p", "processors " + brick) +
           grain(1, {0.3, 8.1, 15.9}, 3.3, {2e-12, 1e-12, 0}) +
           grain(2, {9.2, 8.1, 8.1}, 3.6, {0, -1e-12, 2e-12}) +
           "\nset group all density 10\nset atom 1 omega 0 0 1e-8\ntimestep " + num(DT / every) +
           "\nfix m all nve/sphere" + fluid("every " + std::to_string(every)));
    const auto total = [&](int d) {
      const double grains = sum_of([&](int i) {
        return lmp->atom->rmass[i] * lmp->atom->v[i][d] + 0.5 * DT / every * lmp->atom->f[i][d] +
            DT * fix()->array_atom[i][d];
      });
      return grains + RHO * cell_volume() * n[0] * n[1] * n[2] * out(9 + d);
    };
    Triple at_start;
    for (int d = 0; d < 3; d++)
      at_start[d] = sum_of([&](int i) {
        return lmp->atom->rmass[i] * lmp->atom->v[i][d];
      });
    script(run(every));
    for (int k = 0; k < 4; k++) {
      script(run(5 * every));
      for (int d = 0; d < 3; d++) EXPECT_NEAR(total(d), at_start[d], 4e-9 * at_start[0]) << d;
    }
    const double kept = sum_of([&](int i) {
      return lmp->atom->rmass[i] * std::fabs(lmp->atom->v[i][0]);
    });
    EXPECT_LT(kept, 0.2 * at_start[0]);    // the rest is in the fluid
  }
}
