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

// ctest: RANKS 3 6 8
// The same on numbers of ranks that are odd, or more than the machine may have, in every brick.

#include "fluid_ranks.h"

using ManyRanks = FluidRanks;

// nodes cannot be shared evenly, and sub-domains are smaller than grains
TEST_F(ManyRanks, FixedGrainsWithFaces)
{
  compare([&](const std::string &brick) {
    return box({19, 11, 17}, "f p f", brick) + grain(1, {6.2, 4.9, 7.7}, 4.6) +
        grain(2, {13.1, 6.3, 14.2}, 3.3) +
        fluid("face xlo wall 0 1e-3 0 face xhi wall face zlo pressure v_p face zhi velocity 0 0 "
              "5e-4 accel 0 1e-3 0") +
        "\nvariable p equal 1e-3*step" + frozen() + run(20);
  });
}

// through all sub-domains' faces and corners; most ranks own no grain
TEST_F(ManyRanks, PrescribedMotion)
{
  compare([&](const std::string &brick) {
    return box({16, 14, 15}, "p p p", brick) + grain(1, {12.3, 3.1, 11.2}, 3.3) +
        fluid("accel 1e-3 0 0") + "\nfix m all move linear -6e-3 5.9e-3 6.1e-3" + run(30);
  });
}

TEST_F(ManyRanks, FreeGrainLargerThanASubdomain)
{
  compare([&](const std::string &brick) {
    return box({12, 12, 12}, "p p p", brick) + grain(1, {2.3, 6.1, 9.2}, 5.1, {2e-3, 0, 1e-3}) +
        "\nset atom 1 omega 1 2 3\nfix m all nve/sphere" +
        fluid("accel 1e-3 0 0 refill equilibrium") + run(30);
  });
}

TEST_F(ManyRanks, Discs)
{
  compare([&](const std::string &brick) {
    return box({20, 16, 1}, "p f p", brick) + disc(1, {19.3, 6.1, 0}, 3.3, {3e-3, 1e-3, 0}) +
        disc(2, {8.2, 9.6, 0}, 4.1) + "\nfix m all nve/sphere disc" +
        fluid("face ylo wall face yhi wall 2e-3 0 0") + "\nfix flat all enforce2d" + run(80);
  });
}

TEST_F(ManyRanks, NoGrains)
{
  compare([&](const std::string &brick) {
    return box({9, 8, 10}, "p p f", brick) +
        fluid("face zlo velocity 1e-4 0 1e-3 face zhi pressure 0 accel 1e-3 0 0") + run(20);
  });
}
