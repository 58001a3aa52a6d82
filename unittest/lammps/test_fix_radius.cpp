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

// SI in, SI out: what drives the fluid of fix lb/ibb comes back as force on the grains, flows between
// Keyword radius of fix lb/ibb: spheres of few cells drawn so that the fluid feels the radius meant.

#include "fluid_scenes.h"

#include <cstdlib>

using Radius = FluidTest;

// Simple cubic array of spheres at a solid fraction of .45, K = 28.1 (Zick & Homsy 1982), while the
// table is made from one of .125. Mean over places; accelerations so weak that inertia does not count.
TEST_F(Radius, TableOfADiluteArrayHelpsInADenseOne)
{
  const int cells = 7, places = 4;
  const double r = cells * std::cbrt(0.45 * 0.75 / PI_), accel = 1e-6;
  auto error = [&](const std::string &options) {
    double mean = 0.0;
    for (int k = 1; k <= places; k++) {
      auto part = [&](double x) {
        return x * k - std::floor(x * k) + 3.0;
      };
      start();
      script(box({cells, cells, cells}) +
             grain(1, {part(0.8191725), part(0.6710436), part(0.5497005)}, r) +
             fluid("accel " + num(accel) + " 0 0 " + options) + frozen() + run(400));
      const double L = cells * DX;
      mean += accel * L * L * L / (6.0 * PI_ * NU * r * DX * out(9)) / places;
    }
    return mean / 28.1 - 1.0;
  };
  const double given = error("radius given"), calibrated = error("radius calibrated");
  EXPECT_NEAR(error(""), given, 1e-12);
  EXPECT_GT(std::fabs(given), 0.03);
  EXPECT_LT(std::fabs(calibrated), 0.5 * std::fabs(given));
}

// what a grain displaces, and its mass, are not touched
TEST_F(Radius, VolumeStays)
{
  for (const std::string options : {"", "radius calibrated"}) {
    start();
    script(box({16, 16, 16}) + grain(1, {8.1, 8.2, 8.3}, 3.0) +
           fluid("buoyancy 0 0 -9.81 " + options) + run(1));
    const double weight = RHO * 9.81 * grain_volume(3.0);
    EXPECT_NEAR(f(1)[2], weight, 1e-9 * weight) << options;
  }
}

TEST_F(Radius, WithoutATableThatFitsIsRefused)
{
  auto refusal = [&](const std::string &options, const Cells &cells = {12, 12, 12}) {
    start();
    return error_of(box(cells) +
                    (cells[2] == 1 ? disc(1, {6, 6, 0}, 3.3) : grain(1, {6, 6, 6}, 3.3)) +
                    fluid(options) + frozen() + run(1));
  };
  EXPECT_EQ(refusal("radius calibrated"), "");
  EXPECT_NE(refusal("radius wrong").find("'wrong' is neither given nor calibrated"),
            std::string::npos);
  EXPECT_NE(refusal("radius calibrated", {12, 12, 1}).find("no table for discs"),
            std::string::npos);
  EXPECT_NE(refusal("radius calibrated collision bgk").find("the table is of collision trt 0.1875"),
            std::string::npos);
  EXPECT_NE(refusal("radius calibrated collision trt 0.25").find("the table is of collision trt"),
            std::string::npos);
  const std::string folders = std::getenv("LAMMPS_POTENTIALS");
  setenv("LAMMPS_POTENTIALS", "/nowhere", 1);
  EXPECT_NE(refusal("radius calibrated")
                .find("no file lbm-ibb.radius here or in a folder of the "
                      "environment variable LAMMPS_POTENTIALS (/nowhere)"),
            std::string::npos);
  {
    std::ofstream file("lbm-ibb.radius");
    file << "bouzidi 0.6 3.0 0.05\nbouzidi 1.0 3.0 0.1 # a remark\n";
  }
  EXPECT_EQ(refusal("radius calibrated link bouzidi"), "");    // tau = 0.8
  EXPECT_NE(refusal("radius calibrated link halfway").find("has no line of link halfway"),
            std::string::npos);
  EXPECT_NE(refusal("radius calibrated link bouzidi every 8")
                .find("tau = 2.9, but file lbm-ibb.radius has link bouzidi from 0.6 to 1 alone"),
            std::string::npos);
  {
    std::ofstream file("lbm-ibb.radius");
    file << "# spoilt\ncli any 3.0\n";
  }
  EXPECT_NE(refusal("radius calibrated").find("expected link tau r correction, not: cli any 3.0"),
            std::string::npos);
  std::remove("lbm-ibb.radius");
  setenv("LAMMPS_POTENTIALS", folders.c_str(), 1);
}
