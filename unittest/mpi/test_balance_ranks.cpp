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

// ctest: RANKS 2 3 4
// New sub-domains in mid-run: the fluid is the same to the bit, and goes on as it would have.

#include "fluid_ranks.h"

class BalanceRanks : public FluidRanks {
 protected:
  void TearDown() override
  {
    lmp.reset();
    MPI_Barrier(MPI_COMM_WORLD);
  }

  // cuts along x, y and z
  std::vector<double> cuts() const
  {
    const auto *comm = lmp->comm;
    std::vector<double> all;
    const double *split[3] = {comm->xsplit, comm->ysplit, comm->zsplit};
    for (int d = 0; d < 3; d++) all.insert(all.end(), split[d], split[d] + comm->procgrid[d] + 1);
    return all;
  }
  std::vector<double> uniform() const
  {
    std::vector<double> all;
    for (const int ranks : lmp->comm->procgrid)
      for (int k = 0; k <= ranks; k++) all.push_back(double(k) / ranks);
    return all;
  }
  std::string fluid_now()
  {
    script("write_restart now");
    std::ifstream file("now.lbibb", std::ios::binary);
    std::stringstream bytes;
    bytes << file.rdbuf();
    MPI_Barrier(lmp->world);
    return bytes.str();
  }
};

TEST_F(BalanceRanks, TheFluidIsKeptToTheBit)
{
  for (const std::string precision : {"double", "single"})
    for (const std::string &brick : bricks()) {
      SCOPED_TRACE(brick);
      start();
      script(box({24, 24, 24}, "p p f", "processors " + brick) +
             grain(1, {0.3, 3.1, 6.2}, 3.3, {4e-3, -4e-3, 1e-3}) + grain(2, {5.1, 10.2, 3.4}, 2.6) +
             grain(3, {5.1, 5.2, 19.4}, 4.6) + "\nfix m all nve/sphere" +
             fluid("accel 1e-3 0 0 face zlo wall face zhi wall precision " + precision) + run(21));
      const auto cut = cuts();
      const std::string before = fluid_now();
      const auto forces = result();
      script("balance 1.0 shift xyz 20 1.0");
      EXPECT_NE(cuts(), cut);
      EXPECT_TRUE(fluid_now() == before);
      EXPECT_GT(before.size(), 24u * 24u * 24u * 19u * 4u);
      // what the fix puts out does not change either
      script(run(0));
      for (int k : {2, 3, 4, 5, 12, 13}) EXPECT_EQ(out(k), forces.at(0)[k]) << k;
    }
}

TEST_F(BalanceRanks, LightGrains)
{
  compare([&](const std::string &brick) {
    return box({24, 24, 24}, "p p p", brick) + grain(1, {0.3, 3.1, 11.2}, 3.3, {4e-3, 0, 1e-3}) +
        grain(2, {5.1, 10.2, 3.4}, 3.6) + grain(3, {5.1, 17.2, 19.4}, 4.6) +
        "\nset atom 1 density 20\nset atom 2 density 50\ntimestep " + num(DT / 4) +
        "\nfix m all nve/sphere" + fluid("every 4 accel 1e-3 0 0") + run(42) +
        (brick.empty() ? "" : "\nbalance 1.0 shift xyz 20 1.0") + run(42) +
        (brick.empty() ? "" : "\nbalance 1.0 x uniform y uniform z uniform") + run(42);
  });
}

TEST_F(BalanceRanks, BetweenRuns)
{
  compare([&](const std::string &brick) {
    return box({24, 24, 24}, "p p p", brick) + grain(1, {0.3, 3.1, 11.2}, 3.3) +
        grain(2, {5.1, 10.2, 3.4}, 2.6) + grain(3, {5.1, 5.2, 19.4}, 4.6) +
        "\nfix m all move linear 4e-3 -3.9e-3 1e-3" + fluid("accel 1e-3 0 0") + run(21) +
        (brick.empty() ? "" : "\nbalance 1.0 shift xyz 20 1.0") + run(21) +
        (brick.empty() ? "" : "\nbalance 1.0 x uniform y uniform z uniform") + run(21);
  });
}

// between two fluid steps too; grains and their memory of the fluid go to other ranks with it
TEST_F(BalanceRanks, DuringARun)
{
  compare([&](const std::string &brick) {
    return box({24, 18, 24}, "p p f", brick) + heap({3, 3, 2}, 4e-3) + "\ntimestep " +
        num(DT / 20) +
        "\npair_style gran/lsd/coulomb\npair_coeff * * 0.05 0.8 0.4"
        "\nfix floor all wall/gran/lsd/coulomb 0.05 0.8 0.4 zplane 0 2.4e-3"
        "\nfix m all nve/sphere\nfix g all gravity 1 vector 0 0 -1"
        "\nneigh_modify delay 0 every 1 check yes" +
        fluid("every 20 buoyancy 0 0 -1 face zlo wall face zhi pressure 0") +
        "\nfix b all balance 130 1.0 shift xyz 5 1.0" + run(1300);
  });
  EXPECT_NE(cuts(), uniform());    // of the last brick
}

TEST_F(BalanceRanks, DiscsDuringARun)
{
  compare([&](const std::string &brick) {
    std::string text = box({36, 24, 1}, "p f p", brick);
    for (int i = 0; i < 4; i++)
      text += disc(i + 1, {4.0 + 6.3 * i, 6.1 + i, 0}, 2.6 + 0.1 * i, {4e-3, 1e-3 * i, 0});
    return text + "\nfix m all nve/sphere disc" + fluid("face ylo wall face yhi wall 2e-3 0 0") +
        "\nfix flat all enforce2d" + "\nfix b all balance 10 1.0 shift xy 5 1.0" + run(80);
  });
  EXPECT_NE(cuts(), uniform());
}

/* ---- weights ---- */

// A suspension that has settled, half of its grains in the lowest quarter: with even sub-domains the
// lowest rank does most of the work of grains, and with those that have as many grains each the
// highest does most of that of the fluid.
TEST_F(BalanceRanks, WeightsThatCountTheFluid)
{
  const double per_grain = 300.0;    // nodes that cost as much
  std::string grains;
  for (int id = 1; id <= 64; id++)
    grains +=
        grain(id, {3.0 + 4.0 * (id % 4), 3.0 + 4.0 * (id / 4 % 4), id * id * 60.0 / 4160.0}, 2.1);
  auto imbalance = [&](const std::string &weight) {
    start();
    script(box({18, 18, 60}, "p p f", "processors 1 1 *") + grains +
           fluid("accel 1e-3 0 0 face zlo wall face zhi wall") + "\nvariable cost atom " +
           num(per_grain) + "+f_w[7]" +
           (weight == "none" ? "" : "\nfix b all balance 10 1.01 shift z 10 1.01 " + weight) +
           run(100));
    double nodes = 0.0;
    for (int i = 0; i < lmp->atom->nlocal; i++) nodes += fix()->array_atom[i][6];
    const double *cut = lmp->comm->zsplit + lmp->comm->myloc[2];
    const double share = (cut[1] - cut[0]) * all_nodes();
    if (lmp->atom->nlocal > 0) {
      EXPECT_NEAR(nodes, share, 18.0 * 18.0 + 1e-6);    // a plane of nodes
    }
    const double mine = share + per_grain * lmp->atom->nlocal;
    double most, sum;
    MPI_Allreduce(&mine, &most, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return most / (sum / lmp->comm->nprocs);
  };
  const double uniform = imbalance("none"), by_grains = imbalance(""),
               weighted = imbalance("weight var cost");
  EXPECT_GT(uniform, 1.15);
  EXPECT_GT(by_grains, 1.15);
  EXPECT_LT(weighted, 1.1);
}
