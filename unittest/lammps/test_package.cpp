// LAMMPS knows the package by name, and the packages that it stands on are there.

#include "library.h"

#include <gtest/gtest.h>

TEST(Package, IsListed)
{
  EXPECT_EQ(lammps_config_has_package("LBM-IBB"), 1);
  EXPECT_EQ(lammps_config_has_package("GRANULAR"), 1);
}
