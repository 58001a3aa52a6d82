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

// compute lb/ibb/profile: numbers in the user's units, weights of grains, files, refusals. Sums over
// nodes are tested with the solver (core/test_profile.cpp).

#include "fluid_scenes.h"

#include "compute.h"

class Profile : public FluidTest {
 protected:
  enum { PLACE, POROSITY, PRESSURE, GRADIENT, RATIO, FLUX, PERMEABILITY, STRESS, COLUMNS };

  static std::string profile(const std::string &words)
  {
    return "\ncompute p all lb/ibb/profile w " + words;
  }
  std::vector<std::vector<double>> rows() const
  {
    auto *compute = lmp->modify->get_compute_by_id("p");
    compute->compute_array();
    std::vector<std::vector<double>> all;
    for (int k = 0; k < compute->size_array_rows; k++)
      all.emplace_back(compute->array[k], compute->array[k] + compute->size_array_cols);
    return all;
  }
  // grains of radius 3 in the middle of cells of 8, frozen; n cells high
  static std::string pile(int cells)
  {
    std::string text;
    for (int k = 0; k < cells; k++) text += grain(k + 1, {4, 4, 8.0 * k + 4}, 3.0);
    return text;
  }
  double weight(double r) const { return 10.0 * (SOLID - RHO) * grain_volume(r); }
};

// water at rest under its own weight, with a grain in it
TEST_F(Profile, HydrostaticColumn)
{
  script(box({8, 8, 24}, "p p f") + grain(1, {4.2, 3.9, 12}, 3.2) +
         fluid("accel 0 0 v_g face zlo wall face zhi pressure 0") +
         "\nvariable g equal -0.1*(1-cos(PI*step/2000))/2*(step<2000)-0.1*(step>=2000)" + frozen() +
         profile("z width 4e-4 gravity -0.1") + run(5000));
  const auto all = rows();
  ASSERT_EQ(all.size(), 6u);
  const double W = 0.01 * weight(3.2), S = 64 * DX * DX;
  for (int k = 0; k < 6; k++) {
    EXPECT_NEAR(all[k][PLACE], (4 * k + 2) * DX, 1e-15);
    EXPECT_NEAR(all[k][PRESSURE], RHO * 0.1 * (23.5 * DX - all[k][PLACE]), 1e-4 * RHO * 0.1 * DX);
    EXPECT_NEAR(all[k][GRADIENT], 0.0, 1e-4 * RHO * 0.1);
    // submerged weight of the grain above: half of it in the middle of the column
    const double part = k < 2 ? 1.0 : k > 3 ? 0.0 : all[k][STRESS] * S / W;
    EXPECT_NEAR(all[k][STRESS], part * W / S, 1e-4 * W / S);
  }
  EXPECT_NEAR(all[2][STRESS] + all[3][STRESS], W / S, 1e-4 * W / S);
}

// upward seepage through a pile of fixed grains: Darcy's law and the balance of weights
TEST_F(Profile, DarcyColumn)
{
  const double dp = 0.02;
  script(box({8, 8, 40}, "p p f") + pile(4) +
         fluid("buoyancy 0 0 -10 face zlo pressure 0.01 face zhi pressure -0.01") + frozen() +
         profile("z layers 5") + run(3000));
  const auto all = rows();
  ASSERT_EQ(all.size(), 5u);
  const double S = 64 * DX * DX, W = weight(3.0);
  double spent = 0.0;
  for (int k = 0; k < 5; k++) {
    const double length = (k == 0 || k == 4) ? 7.5 * DX : 8 * DX;
    EXPECT_NEAR(all[k][POROSITY], k < 4 ? 1.0 - covered({4, 4, 4}, 3.0) / 512.0 : 1.0, 1e-12);
    EXPECT_NEAR(all[k][FLUX], out(11), 0.04 * out(11));    // faces cut their planes of nodes
    EXPECT_NEAR(all[k][PERMEABILITY], all[k][FLUX] * NU * RHO / all[k][GRADIENT],
                1e-12 * std::fabs(all[k][PERMEABILITY]));
    EXPECT_NEAR(all[k][RATIO], k < 4 ? all[k][GRADIENT] * 8 * DX * S / W : 0.0, 1e-10);
    spent += all[k][GRADIENT] * length;
  }
  EXPECT_NEAR(spent, dp, 1e-12);
  // far from the ends one layer is as the other, but for the change of density
  EXPECT_NEAR(all[1][FLUX], all[2][FLUX], 0.003 * all[1][FLUX]);
  EXPECT_NEAR(all[1][GRADIENT], all[2][GRADIENT], 0.003 * all[1][GRADIENT]);
  EXPECT_LT(std::fabs(all[4][GRADIENT]), 0.05 * all[1][GRADIENT]);
  // total equilibrium of all that lies above the middle of the lowest layer
  const double load = 3.5 * W / S - (dp - 0.5 * all[0][GRADIENT] * 7.5 * DX);
  EXPECT_NEAR(all[0][STRESS], load, 1e-10);
  // the forces on the grains are the pressure difference
  EXPECT_NEAR(out(8), dp * S, 2e-3 * dp * S);
}

// the reference may be given; gravity that points up the axis turns the layers round
TEST_F(Profile, ReferenceAndDirection)
{
  const std::string scene = box({8, 8, 16}, "p p f") + pile(1) +
      fluid("buoyancy 0 0 v_g face zlo pressure v_p face zhi pressure 0") +
      "\nvariable p equal -0.2\nvariable g equal 10" + frozen();
  script(scene + profile("z layers 2") + run(200));
  const auto own = rows();
  EXPECT_LT(own[0][GRADIENT], 0.0);
  EXPECT_NEAR(own[0][RATIO], -own[0][GRADIENT] * 8 * DX * 64 * DX * DX / weight(3.0), 1e-10);
  EXPECT_EQ(own[1][RATIO], 0.0);
  EXPECT_NEAR(own[0][STRESS], 0.5 * (weight(3.0) / (64 * DX * DX) + own[0][GRADIENT] * 7.5 * DX),
              1e-10);
  script("uncompute p" + profile("z layers 2 critical 50"));
  const auto given = rows();
  for (int k = 0; k < 2; k++) {
    EXPECT_NEAR(given[k][RATIO], -given[k][GRADIENT] / 50.0, 1e-12);
    EXPECT_EQ(given[k][STRESS], own[k][STRESS]);
  }
  script("uncompute p" + profile("z layers 2 gravity 0"));
  EXPECT_EQ(rows()[0][STRESS], 0.0);
}

// discs; a uniform gradient counts as what drives; grains across a periodic face count on both sides
TEST_F(Profile, TwoDimensionsPeriodic)
{
  script(box({12, 16, 1}) + disc(1, {6, 0, 0}, 3.6) + fluid("gradp 0 -0.2 0 buoyancy 0 -10 0") +
         frozen() + profile("y layers 2") + run(2000));
  const auto all = rows();
  const double W = 10.0 * (SOLID - RHO) * grain_volume(3.6), S = 12 * DX;
  EXPECT_NEAR(all[0][GRADIENT], 0.2, 1e-4);
  EXPECT_NEAR(all[0][GRADIENT] + all[1][GRADIENT], 0.4, 1e-12);
  for (const auto &row : all) {
    EXPECT_NEAR(row[RATIO], row[GRADIENT] * 8 * DX * S / (0.5 * W), 1e-10);
    EXPECT_NEAR(row[FLUX], out(10), 0.01 * out(10));
  }
  EXPECT_NEAR(all[1][STRESS], 0.25 * W / S - 4 * DX * all[1][GRADIENT], 1e-10);
  EXPECT_NEAR(all[0][STRESS], 0.75 * W / S - 8 * DX * all[1][GRADIENT] - 4 * DX * all[0][GRADIENT],
              1e-10);
}

TEST_F(Profile, AveragesAndThermo)
{
  script(box({8, 8, 16}) + grain(1, {4, 4, 4}, 3) + fluid("gradp 0 0 -1") + frozen() +
         profile("z layers 4") +
         "\nfix a all ave/time 5 2 10 c_p[1] c_p[2] c_p[6] mode vector file profile.dat" +
         "\nthermo_style custom step c_p[1][6]" + run(10));
  const auto all = rows();
  std::ifstream file("profile.dat");
  std::string line, last;
  int lines = 0;
  while (std::getline(file, line))
    if (line[0] != '#') {
      last = line;
      lines++;
    }
  file.close();
  std::remove("profile.dat");
  EXPECT_EQ(lines, 1 + 4);    // step and rows; the first average is complete at step 10
  double row, place, porosity;
  std::istringstream(last) >> row >> place >> porosity;
  EXPECT_EQ(row, 4.0);
  EXPECT_NEAR(place, 14 * DX, 1e-8);
  EXPECT_EQ(porosity, all[3][POROSITY]);
  EXPECT_EQ(thermo("c_p[1][6]"), all[0][FLUX]);
}

TEST_F(Profile, Refusals)
{
  script(box({8, 8, 24}) + grain(1, {4, 4, 4}, 3) + fluid());
  EXPECT_ERROR("compute q all lb/ibb/profile w z", "Illegal compute lb/ibb/profile command");
  EXPECT_ERROR("compute q all lb/ibb/profile water z layers 4",
               "there is no fix lb/ibb with ID water: define it before the compute");
  EXPECT_ERROR("compute q all lb/ibb/profile w r layers 4", "'r' is no axis of this box");
  EXPECT_ERROR("compute q all lb/ibb/profile w z bins 4",
               "expected 'layers' or 'width', not 'bins'");
  EXPECT_ERROR("compute q all lb/ibb/profile w z layers 5",
               "layers 5 makes layers of 4.8 of the 24 nodes along z: layers are whole numbers of "
               "nodes, all equal; nearest are layers 6 or 4, width 0.0004 or 0.0006");
  EXPECT_ERROR("compute q all lb/ibb/profile w z layers 48", "makes layers of 0.5 of the 24 nodes");
  EXPECT_ERROR("compute q all lb/ibb/profile w z layers 0", "0 layers: at least 1 is needed");
  EXPECT_ERROR("compute q all lb/ibb/profile w z width 2.5e-4", "nearest are layers 12 or 8");
  EXPECT_ERROR("compute q all lb/ibb/profile w z width 5e-4", "nearest are layers 6 or 4");
  EXPECT_ERROR("compute q all lb/ibb/profile w z width 1.0", "nearest are layers 1 or 1");
  EXPECT_ERROR("compute q all lb/ibb/profile w z width 0", "width 0 must be larger than 0");
  EXPECT_ERROR("compute q all lb/ibb/profile w z layers 4 critical 0",
               "critical = 0 must be larger than 0");
  EXPECT_ERROR("compute q all lb/ibb/profile w z layers 4 critical 1e-300", "limit 1e-100");
  EXPECT_ERROR("compute q all lb/ibb/profile w z layers 4 gravity 1e308", "limit 1e100 either way");
  EXPECT_ERROR("compute q all lb/ibb/profile w z layers 4 gravity", "Illegal compute");
  EXPECT_ERROR("compute q all lb/ibb/profile w z layers 4 gravity 1 gravity 1",
               "gravity is given twice");
  EXPECT_ERROR("compute q all lb/ibb/profile w z layers 4 weight 1", "unknown keyword 'weight'");
  script(profile("z layers 4"));
  EXPECT_THROW(rows(), LAMMPS_NS::LAMMPSException);    // before the first run
  EXPECT_ERROR("run 0 post no\nunfix w\nprint $(c_p[1][2])", "there is no fix lb/ibb with ID w");
  EXPECT_ERROR("run 0", "there is no fix lb/ibb with ID w");

  start();
  script(box({8, 8, 1}) + fluid());
  EXPECT_ERROR(profile("z layers 1"), "'z' is no axis of this box: use x or y");
}
