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

// lbm_ibb_field(), the door for programs and for Python: the numbers that dump grid would write.

#include "fluid_scenes.h"

#include "lb_ibb_library.h"

class Library : public FluidTest {
 protected:
  struct Block {
    const double *data;
    int lo[3], n[3], global[3], columns;
  };
  Block ask(const char *name, const char *id = "w")
  {
    Block b{};
    b.data = lbm_ibb_field(lmp.get(), id, name, b.lo, b.n, b.global, &b.columns);
    return b;
  }
  void expect_fields()
  {
    for (const char *name : {"density", "pressure", "velocity", "solid"}) {
      SCOPED_TRACE(name);
      const Block b = ask(name);
      ASSERT_NE(b.data, nullptr);
      const std::vector<double> copy(b.data, b.data + all_nodes() * std::max(b.columns, 1));
      for (int d = 0; d < 3; d++) {
        EXPECT_EQ(b.lo[d], 0);
        EXPECT_EQ(b.n[d], n[d]);
        EXPECT_EQ(b.global[d], n[d]);
      }
      for (int k = 0; k < std::max(b.columns, 1); k++) {
        const auto expected = values(name, k);
        double largest = 0.0;
        for (int i = 0; i < all_nodes(); i++) {
          EXPECT_EQ(copy[i * std::max(b.columns, 1) + k], expected[i]);
          largest = std::max(largest, std::fabs(expected[i]));
        }
        // nothing moves across the plane in two dimensions
        if (n[2] > 1 || k < 2) EXPECT_GT(largest, 0.0);
      }
    }
  }
};

TEST_F(Library, FieldsInThreeDimensions)
{
  script(box({8, 7, 6}) + grain(1, {4.3, 3.1, 2.9}, 2.4) + fluid("accel 2e-2 1e-2 5e-3") +
         frozen() + run(20));
  expect_fields();
}

TEST_F(Library, FieldsInTwoDimensions)
{
  script(box({9, 8, 1}) + disc(1, {4.3, 4.1, 0}, 2.4) + fluid("accel 2e-2 1e-2 0") + frozen() +
         run(20));
  expect_fields();
}

TEST_F(Library, RefusesWithAMessage)
{
  script(box({8, 7, 6}) + fluid());
  auto refuses = [this](const char *name, const char *id, const char *why) {
    EXPECT_EQ(ask(name, id).data, nullptr);
    char message[1024];
    EXPECT_NE(lammps_get_last_error_message(lmp.get(), message, sizeof message), 0);
    EXPECT_IN(message, why);
  };
  refuses("density", "w", "use run 0 before");
  script("run 0 post no");
  refuses("colour", "w", "density, pressure, velocity and solid");
  refuses("density", "milk", "no fix lb/ibb with ID milk");
  EXPECT_NE(ask("density").data, nullptr);
}
