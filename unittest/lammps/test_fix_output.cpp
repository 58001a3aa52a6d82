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

// What other commands get from fix lb/ibb: thermo, averages, reductions, fields in dumps and files.

#include "fluid_scenes.h"

#include <cstdlib>

class Outputs : public FluidTest {
 protected:
  std::string scene(const std::string &options = "")
  {
    return box({8, 7, 6}) + grain(1, {4.3, 3.1, 2.9}, 2.6) + grain(2, {0.2, 6.8, 5.7}, 2.2) +
        fluid("accel 2e-3 1e-3 0 gradp 0 0 1 " + options) + frozen();
  }
  // all numbers of a file, line by line, those lines left out that begin otherwise
  static std::vector<std::vector<double>> table(const std::string &name)
  {
    std::vector<std::vector<double>> rows;
    std::ifstream file(name);
    std::string line;
    while (std::getline(file, line)) {
      std::vector<double> row;
      const char *at = line.c_str();
      char *end;
      for (double x = std::strtod(at, &end); end != at; x = std::strtod(at, &end)) {
        row.push_back(x);
        at = end;
      }
      if (*at == '\0' && !row.empty()) rows.push_back(row);
    }
    return rows;
  }
};

TEST_F(Outputs, ThermoAverageAndReduction)
{
  script(scene() +
         "\ncompute sum all reduce sum f_w[*]\nthermo_style custom step f_w f_w[*] c_sum[*]" +
         "\nthermo 5\nfix t all ave/time 1 10 10 f_w f_w[6] mode scalar\nvariable F equal f_w[6]" +
         "\nvariable fx atom f_w[1]\ncompute vsum all reduce sum v_fx" + run(20));
  EXPECT_NEAR(thermo("c_sum[1]"), out(6), 1e-14 * out(6));
  EXPECT_NEAR(thermo("c_sum[3]"), out(8), 1e-14 * out(6));
  EXPECT_NEAR(thermo("c_sum[1]"), force(1)[0] + force(2)[0], 1e-14 * out(6));
  EXPECT_NEAR(thermo("c_vsum"), out(6), 1e-14 * out(6));
  EXPECT_NEAR(thermo("c_sum[6]"), load(1)[5] + load(2)[5], 1e-14 * out(6) * DX);
  EXPECT_EQ(thermo("f_w"), mass());
  EXPECT_NEAR(thermo("v_F"), out(6), 1e-14 * out(6));
  EXPECT_NEAR(thermo("f_t[1]"), mass(), 1e-3 * mass());
  EXPECT_GT(thermo("f_t[2]"), 0.0);
  EXPECT_LT(thermo("f_t[2]"), 2.0 * out(6));
}

TEST_F(Outputs, PerAtomDump)
{
  script(scene() +
         "\ndump d all custom 10 atoms.dump id f_w[1] f_w[2] f_w[3] f_w[4] f_w[5] f_w[6]" +
         "\ndump_modify d format float %.17g sort id" + run(10) + "\nundump d");
  const auto rows = table("atoms.dump");
  std::remove("atoms.dump");
  ASSERT_GE(rows.size(), 2u);
  for (int id = 1; id <= 2; id++)
    for (int k = 0; k < 6; k++) EXPECT_EQ(rows[rows.size() - 3 + id][k + 1], load(id)[k]);
}

TEST_F(Outputs, FieldsInDumpsOfGrids)
{
  script(scene() + "\ndump g all grid 10 fluid.grid f_w:grid:density f_w:grid:pressure " +
         "f_w:grid:velocity[1] f_w:grid:velocity[2] f_w:grid:velocity[3] f_w:grid:solid" +
         "\ndump_modify g format float %.17g" +
         "\ndump v all grid/vtk 10 fluid*.vtr f_w:grid:velocity[1] f_w:grid:velocity[2] "
         "f_w:grid:velocity[3]\ndump p all grid/vtk 10 solid*.vtr f_w:grid:solid" +
         run(10) + "\nundump g\nundump v\nundump p");
  const auto rows = table("fluid.grid");
  for (const char *name : {"fluid.grid", "fluid0.vtr", "solid0.vtr"}) std::remove(name);
  const std::size_t all = all_nodes();
  ASSERT_GE(rows.size(), 2 * all);
  const std::vector<double> expected[] = {values("density"),     values("pressure"),
                                          values("velocity", 0), values("velocity", 1),
                                          values("velocity", 2), values("solid")};
  for (std::size_t k = 0; k < all; k++)
    for (int c = 0; c < 6; c++) ASSERT_EQ(rows[rows.size() - all + k][c], expected[c][k]);
  for (const std::string name : {"fluid10.vtr", "solid10.vtr"}) {
    std::ifstream file(name);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_IN(text.str(), "RectilinearGrid WholeExtent=\"0 8 0 7 0 6\"");
    std::remove(name.c_str());
  }
}

TEST_F(Outputs, FieldsAveragedAndInTwoDimensions)
{
  script(scene() + "\nfix a all ave/grid 5 2 10 8 7 6 f_w:grid:density f_w:grid:velocity[1]" +
         "\ndump a all grid 10 mean.grid f_a:grid:data[1] f_a:grid:data[2]" +
         "\ndump_modify a format float %.17g" + run(5));
  const auto rho5 = values("density"), u5 = values("velocity");
  script(run(5));
  const auto rho = values("density"), u = values("velocity");
  script("undump a");
  auto rows = table("mean.grid");
  const std::size_t all = all_nodes();
  ASSERT_GE(rows.size(), all);
  for (std::size_t k = 0; k < all; k++) {
    EXPECT_NEAR(rows[rows.size() - all + k][0], 0.5 * (rho[k] + rho5[k]), 1e-12 * RHO);
    EXPECT_NEAR(rows[rows.size() - all + k][1], 0.5 * (u[k] + u5[k]), 1e-17);
  }
  std::remove("mean.grid");

  start();
  script(box({9, 7, 1}) + disc(1, {4.3, 3.1, 0}, 2.6) + fluid("accel 2e-3 0 0") + frozen() +
         "\ndump g all grid 10 flat.grid f_w:grid:velocity[1] f_w:grid:solid" +
         "\ndump_modify g format float %.17g" + run(10) + "\nundump g");
  rows = table("flat.grid");
  std::remove("flat.grid");
  const auto flat = values("velocity"), solid = values("solid");
  ASSERT_GE(rows.size(), flat.size());
  for (std::size_t k = 0; k < flat.size(); k++) {
    EXPECT_EQ(rows[rows.size() - flat.size() + k][0], flat[k]);
    EXPECT_EQ(rows[rows.size() - flat.size() + k][1], solid[k]);
  }
}

TEST_F(Outputs, FieldsTakeNoMemoryUntilAskedFor)
{
  script(box({32, 32, 32}) + fluid() + run(1));
  const double before = fix()->memory_usage();
  EXPECT_LT(before, 200.0 * all_nodes());
  values("density");
  values("velocity", 0);
  EXPECT_NEAR(fix()->memory_usage() - before, 4 * 8.0 * all_nodes(), 1.0);
}

TEST_F(Outputs, BeforeTheFirstRun)
{
  script(scene());
  EXPECT_NEAR(out(1), TAU, 1e-14);
  for (int i = 3; i <= 14; i++) EXPECT_EQ(out(i), 0.0);
  EXPECT_THROW(fix()->get_griddata_by_index(0), LAMMPS_NS::LAMMPSException);
}

/* ---- what the log says ---- */

TEST_F(Outputs, SummaryOfTheScene)
{
  const std::string log =
      log_of(box({8, 8, 20}, "p p f") + grain(1, {4.3, 4.1, 9.9}, 3.6) +
             fluid("face zlo pressure 0.01 face zhi pressure -0.01 buoyancy 0 0 -9.81 average no") +
             frozen() + run(10));
  EXPECT_IN(log, "8 x 8 x 20 nodes of dx = 0.0001, D3Q19, collision trt, Lambda = 0.1875");
  EXPECT_IN(log, "fluid step = 1 x timestep = 0.001, tau = 0.80000");
  EXPECT_IN(log, "Ma = 0.1 at speed 0.005774, limit 0.3 at 0.01732");
  EXPECT_IN(log, "pressure planes along z are 0.0019 apart (box length - dx)");
  EXPECT_IN(log, "pressure difference now 0.02: density change 0.6 %");
  EXPECT_IN(log, "7.2 to 7.2 cells per diameter; links cli, refill grad, force of the last fluid");
  EXPECT_IN(log, "MiB on the fullest rank without grains; left out: walls, body force, messages between ranks, ");
  EXPECT_IN(log, "Fix lb/ibb: 10 fluid steps, ");
  EXPECT_IN(log, "raised the ghost cutoff from 0 to 0.00066 (largest radius + 2 dx + skin)");
}
