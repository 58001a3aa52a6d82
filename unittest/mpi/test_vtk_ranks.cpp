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

// compute lb/ibb/profile is the same on any brick of ranks.

// Files that fix lb/ibb/vtk writes do not know how many ranks wrote them.

#include "fluid_ranks.h"

#include "../lammps/vtk_file.h"

#include "lbm_sample.h"
#include "lbm_vtk.h"

class VtkRanks : public FluidRanks {
 protected:
  static std::string own(const std::string &name)    // of this rank
  {
    int me;
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    return name + std::to_string(me);
  }
};

// a value that tells node and column
static float value(const lbm::Int3 &node, int column)
{
  return float(node[0] + 100 * node[1] + 10000 * node[2]) + 0.25f * float(column);
}

// Nodes of several blocks, more than ranks, cut in every way. Every byte must be that which one rank
// alone writes, and every value in its place.
TEST_F(VtkRanks, NodesComeIntoOrder)
{
  const lbm::Int3 all{37, 31, 43};
  int me, ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &me);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  auto write = [&](const std::string &name, const lbm::Sample &sample, const lbm::Part &mine,
                   lbm::VtkEncoding encoding, MPI_Comm comm) {
    const lbm::Part part = sample.within(mine);
    auto file = lbm::vtk_image(sample.n, {0, 0, 0}, {1, 1, 1}, 0.5);
    int writers = 1;
    if (encoding != lbm::VtkEncoding::BASE64) MPI_Comm_size(comm, &writers);
    for (int columns : {3, 1}) {
      std::vector<float> values;
      for (int k = 0; k < part.n[2]; k++)
        for (int j = 0; j < part.n[1]; j++)
          for (int i = 0; i < part.n[0]; i++)
            for (int c = 0; c < columns; c++)
              values.push_back(
                  value(sample.node(part.lo[0] + i, part.lo[1] + j, part.lo[2] + k), c));
      const auto ordered =
          lbm::in_order(values, part, sample.n, columns, writers, lbm::VTK_BLOCK, comm);
      file.sections[0].arrays.push_back(
          lbm::vtk_array("f" + std::to_string(columns), columns, ordered));
    }
    EXPECT_EQ(lbm::write_vtk(name, file, encoding, comm), "");
  };

  const lbm::Sample samples[] = {
      {{0, 0, 0}, all, 1}, {{3, 0, 7}, {12, 11, 12}, 3}, {{5, 30, 1}, {9, 1, 40}, 1}};
  for (const lbm::Sample &sample : samples) {
    for (const auto encoding :
         {lbm::VtkEncoding::ZLIB, lbm::VtkEncoding::RAW, lbm::VtkEncoding::BASE64}) {
      if (encoding == lbm::VtkEncoding::ZLIB && !lbm::vtk_has_zlib()) continue;
      write(own("alone"), sample, {{0, 0, 0}, all}, encoding, MPI_COMM_SELF);
      const VtkReader alone(own("alone"));
      for (int columns : {3, 1}) {
        const auto found = alone.array("f" + std::to_string(columns));
        ASSERT_EQ(found.size(), std::size_t(sample.n[0]) * sample.n[1] * sample.n[2] * columns);
        std::size_t at = 0;
        for (int k = 0; k < sample.n[2]; k++)
          for (int j = 0; j < sample.n[1]; j++)
            for (int i = 0; i < sample.n[0]; i++)
              for (int c = 0; c < columns; c++)
                ASSERT_EQ(found[at++], value(sample.node(i, j, k), c));
      }
      for (int axis = 0; axis < 3; axis++) {
        // the first rank has most, and where there are four the last has none
        lbm::Part mine{{0, 0, 0}, all};
        const int cut = all[axis] - 2 * (ranks - 1);
        mine.lo[axis] = me == 0 ? 0 : cut + 2 * (me - 1);
        mine.n[axis] = me == 0 ? cut : 2;
        if (ranks == 4 && me >= 2) {
          mine.lo[axis] = cut + 2;
          mine.n[axis] = me == 2 ? 4 : 0;
        }
        write("together", sample, mine, encoding, MPI_COMM_WORLD);
        EXPECT_EQ(VtkReader::text_of("together"), VtkReader::text_of(own("alone"))) << axis;
        MPI_Barrier(MPI_COMM_WORLD);
      }
    }
  }
}

TEST_F(VtkRanks, FluidAndGrainsAreThoseOfOneRank)
{
  const Cells cells{24, 22, 20};    // two blocks
  auto scene = [&](const std::string &name, const std::string &brick) {
    return box(cells, "p p f", brick) + grain(1, {0.3, 6.1, 5.2}, 4.1, {2e-3, 0, 1e-3}) +
        grain(2, {12.2, 11.3, 10.8}, 3.7) + grain(3, {18.1, 21.8, 14.2}, 4.0) +
        "\nfix m all nve/sphere" + fluid("accel 1e-3 5e-4 0 face zlo wall face zhi wall") +
        "\nfix v all lb/ibb/vtk 10 w " + name + run(10);
  };
  start(MPI_COMM_SELF);
  script(scene(own("one"), ""));
  const VtkReader fluid(own("one") + "-fluid-000000010.vti");
  const VtkReader grains(own("one") + "-grains-000000010.vtp");
  EXPECT_EQ(grains.array("id"), (std::vector<double>{1, 2, 3}));
  for (const std::string &brick : bricks()) {
    SCOPED_TRACE(brick);
    start(MPI_COMM_WORLD);
    script(scene("all", "processors " + brick));
    MPI_Barrier(MPI_COMM_WORLD);
    auto same = [](const VtkReader &file, const VtkReader &alone, const char *name, double scale) {
      const auto found = file.array(name), wanted = alone.array(name);
      ASSERT_EQ(found.size(), wanted.size());
      double size = scale;
      for (double w : wanted) size = std::max(size, std::fabs(w));
      for (std::size_t k = 0; k < found.size(); k++) ASSERT_NEAR(found[k], wanted[k], 1e-6 * size);
    };
    const VtkReader fluid_of_all("all-fluid-000000010.vti");
    for (const char *name : {"velocity", "pressure", "solid"}) same(fluid_of_all, fluid, name, 0.0);
    const VtkReader grains_of_all("all-grains-000000010.vtp");
    for (const char *name : {"id", "points", "radius", "velocity", "omega", "force", "torque"})
      same(grains_of_all, grains, name, 0.0);
    MPI_Barrier(MPI_COMM_WORLD);
  }
}
