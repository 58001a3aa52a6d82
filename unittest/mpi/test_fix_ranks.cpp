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

// The fluid and its grains are the same on any brick of ranks, see fluid_ranks.h.

#include "fluid_ranks.h"

TEST_F(FluidRanks, FixedGrains)
{
  compare([&](const std::string &brick) {
    return box({18, 12, 18}, "p p p", brick) + heap({3, 2, 3}, 0.0) +
        fluid("accel 2e-3 -1e-3 5e-4 gradp 0.1 0 0") + frozen() + run(40);
  });
}

TEST_F(FluidRanks, FixedGrainsWithFaces)
{
  compare([&](const std::string &brick) {
    return box({18, 12, 18}, "f p f", brick) + heap({3, 2, 3}, 0.0) +
        fluid("face xlo wall 0 1e-3 0 face xhi wall face zlo pressure v_p face zhi velocity 0 0 "
              "5e-4 "
              "refill equilibrium link bouzidi collision bgk") +
        "\nvariable p equal 1e-3*step" + frozen() + run(40);
  });
}

// through faces, edges and corners of sub-domains and of the periodic box
TEST_F(FluidRanks, PrescribedMotion)
{
  for (const Triple &u :
       {Triple{4e-3, 0, 0}, Triple{0, -4e-3, 4e-3}, Triple{-4e-3, 3.9e-3, 4.1e-3}})
    compare([&](const std::string &brick) {
      return box({16, 14, 15}, "p p p", brick) + grain(1, {12.3, 3.1, 11.2}, 3.3) +
          grain(2, {5.1, 10.2, 3.4}, 2.6) + fluid("check 10") + "\nfix m all move linear " +
          nums(u) + run(100);
    });
}

TEST_F(FluidRanks, FreeGrainsThatCollide)
{
  compare([&](const std::string &brick) {
    return box({18, 18, 12}, "p p f", brick) + heap({3, 3, 2}, 4e-3) + "\ntimestep " +
        num(DT / 20) +
        "\npair_style gran/lsd/coulomb\npair_coeff * * 0.05 0.8 0.4"
        "\nfix floor all wall/gran/lsd/coulomb 0.05 0.8 0.4 zplane 0 1.2e-3"
        "\nfix m all nve/sphere\nfix g all gravity 1 vector 0 0 -1"
        "\nneigh_modify delay 0 every 1 check yes" +
        fluid("every 20 buoyancy 0 0 -1 face zlo wall face zhi pressure 0") + run(1600);
  });
}

// films between grains, and between grains and the floor, which they creep towards
TEST_F(FluidRanks, FilmsBetweenGrains)
{
  compare([&](const std::string &brick) {
    return box({18, 12, 12}, "p p f", brick) + grain(1, {4.5, 6, 3.1}, 3, {1e-3, 0, -1e-3}) +
        grain(2, {10.7, 6.2, 3.2}, 3, {-2e-3, 0, 0}) +
        grain(3, {7.5, 6.3, 8.3}, 2.5, {1e-3, 2e-3, -3e-3}) +
        "\npair_style lubricate/lb/ibb 2e-6\npair_coeff * *\nset group all omega 1 2 3"
        "\nfix m all nve/sphere\ntimestep 2e-5" +
        fluid("every 50 face zlo wall 1e-3 0 0 face zhi wall") + run(400);
  });
}

// LAMMPS sizes its buffers for ghosts' forces by newton on: the bed lies on the lowest rank alone, so
// that one sends more than it gets
TEST_F(FluidRanks, NewtonOff)
{
  compare([&](const std::string &brick) {
    return box({90, 90, 12}, "f f f", brick + "\nnewton off") + heap({15, 15, 1}, 0.0) +
        fluid("accel 1e-3 0 0 face xlo wall face xhi wall face ylo wall face yhi wall face zlo "
              "wall "
              "face zhi wall") +
        frozen() + run(3);
  });
}

// one grain that reaches over all sub-domains, and ranks that own none
TEST_F(FluidRanks, GrainLargerThanASubdomain)
{
  compare([&](const std::string &brick) {
    return box({12, 12, 12}, "p p p", brick) + grain(1, {2.3, 6.1, 9.2}, 5.1, {2e-3, 0, 1e-3}) +
        "\nset atom 1 omega 1 2 3\nfix m all nve/sphere" + fluid("accel 1e-3 0 0") + run(60);
  });
}

TEST_F(FluidRanks, TwoDimensions)
{
  compare([&](const std::string &brick) {
    return box({20, 16, 1}, "p f p", brick) + disc(1, {19.3, 6.1, 0}, 3.3, {3e-3, 1e-3, 0}) +
        disc(2, {8.2, 9.6, 0}, 4.1) + "\nfix m all nve/sphere disc" +
        fluid("face ylo wall face yhi wall 2e-3 0 0") + "\nfix flat all enforce2d" + run(80);
  });
}

// discs through all faces of sub-domains, with contacts, open faces and the rules of the article
TEST_F(FluidRanks, DiscsThatCollide)
{
  compare([&](const std::string &brick) {
    std::string text = box({18, 24, 1}, "p f p", brick);
    int id = 0;
    for (int j = 0; j < 3; j++)
      for (int i = 0; i < 3; i++)
        text += disc(++id, {6.0 * i + 3.1 + 0.3 * j, 6.0 * j + 5.2, 0}, 2.6 + 0.1 * i,
                     {4e-3 * (1 - i), 3e-3 * (j - 1), 0});
    return text + "\ntimestep " + num(DT / 20) +
        "\npair_style gran/lsd/coulomb\npair_coeff * * 500 0.8 0.4"
        "\nfix floor all wall/gran/lsd/coulomb 500 0.8 0.4 yplane 2e-4 2.2e-3"
        "\nfix m all nve/sphere disc\nfix g all gravity 1 vector 0 -1 0"
        "\nneigh_modify delay 0 every 1 check yes" +
        fluid("every 20 buoyancy 0 -1 0 gradp 0.1 0 0 collision bgk link bouzidi refill "
              "equilibrium "
              "face ylo velocity 0 1e-4 0 face yhi pressure 0") +
        "\nfix flat all enforce2d" + run(1600);
  });
}

// per-grid data of all ranks together are those of one
TEST_F(FluidRanks, FieldsInTwoDimensions)
{
  std::map<std::string, std::vector<double>> rows;
  int me;
  MPI_Comm_rank(MPI_COMM_WORLD, &me);
  auto fields = [&](MPI_Comm comm, const std::string &brick, const std::string &name) {
    start(comm);
    script(box({20, 16, 1}, "p f p", brick) + disc(1, {19.3, 6.1, 0}, 3.3) +
           fluid("accel 2e-3 0 0 face ylo wall face yhi wall") + frozen() +
           "\ncompute cell all property/grid 20 16 1 id\ndump g all grid 10 " + name +
           " c_cell:grid:data f_w:grid:velocity[1] f_w:grid:velocity[2] f_w:grid:pressure "
           "f_w:grid:solid\ndump_modify g format float %.17g first no" +
           run(10) + "\nundump g");
    MPI_Barrier(comm);
    std::map<int, std::vector<double>> node;
    std::ifstream file(name);
    std::string line;
    while (std::getline(file, line) && line.find("GRID CELLS") == std::string::npos) {}
    for (double id, u, v, p, s; file >> id >> u >> v >> p >> s;) node[(int) id] = {u, v, p, s};
    return node;
  };
  const std::string own = "alone" + std::to_string(me) + ".grid";
  const auto alone = fields(MPI_COMM_SELF, "", own);
  std::remove(own.c_str());
  ASSERT_EQ(alone.size(), 320u);
  for (const std::string &brick : bricks()) {
    if (brick.substr(brick.size() - 2) != " 1") continue;
    SCOPED_TRACE(brick);
    const auto together = fields(MPI_COMM_WORLD, "processors " + brick, "together.grid");
    MPI_Barrier(MPI_COMM_WORLD);
    if (me == 0) std::remove("together.grid");
    ASSERT_EQ(together.size(), alone.size());
    const double scale[] = {1e-5, 1e-5, RHO * SOUND * SOUND * 1e-3, 1.0};
    for (const auto &[id, values] : alone)
      for (int k = 0; k < 4; k++)
        ASSERT_NEAR(together.at(id)[k], values[k], 1e-12 * scale[k]) << id << " " << k;
  }
}

TEST_F(FluidRanks, NoGrains)
{
  compare([&](const std::string &brick) {
    return box({9, 7, 8}, "p p f", brick) +
        fluid("face zlo velocity 1e-4 0 1e-3 face zhi pressure 0 accel 1e-3 0 0") + run(50);
  });
}

// grains that appear and vanish while the others' sub-domains look on
TEST_F(FluidRanks, GrainsComeAndGo)
{
  compare([&](const std::string &brick) {
    return box({16, 14, 15}, "p p p", brick) + fluid("accel 1e-3 0 0") + run(5) +
        grain(1, {12.3, 3.1, 11.2}, 3.3) + grain(2, {15.9, 10.2, 0.1}, 2.6) +
        "\nfix m all move linear 2e-3 1e-3 0" + run(20) +
        "\ngroup gone id 1\ndelete_atoms group gone" + " compress no" + run(20);
  });
}

TEST_F(FluidRanks, GrainsPouredDuringARun)
{
  compare([&](const std::string &brick) {
    return box({16, 16, 24}, "p p f", brick) +
        "\nregion slab block 0 1.6e-3 0 1.6e-3 0.8e-3 2.2e-3" +
        "\nfix g all gravity 0.1 vector 0 0 -1\nfix m all nve/sphere"
        "\nfix rain all pour 3 1 4711 region slab diam one 5.5e-4 dens 2600 2600" +
        fluid("every 4 buoyancy 0 0 -0.1 face zlo wall face zhi pressure 0") + "\ntimestep " +
        num(DT / 4) + run(200);
  });
}

/* ---- what all ranks refuse together ---- */

TEST_F(FluidRanks, StopsSayTheSameOnAllRanks)
{
  script(box({16, 14, 15}) + grain(1, {4.3, 3.1, 11.2}, 3.3) + fluid("accel 0.4 0 0 check 5") +
         frozen());
  const std::string message = error_of(run(200));
  EXPECT_IN(message, "stopped at step");
  EXPECT_NOT_IN(message, "on proc");
  char first[2000];
  snprintf(first, sizeof(first), "%s", message.c_str());
  MPI_Bcast(first, sizeof(first), MPI_CHAR, 0, MPI_COMM_WORLD);
  EXPECT_EQ(message, std::string(first));
}
