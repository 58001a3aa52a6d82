// The build's promise that the layout of classes holding Eigen members is the same in
// sources compiled for different processors (LAMMPS's and ours share headers).

#include <Eigen/Core>
#include <gtest/gtest.h>

TEST(BuildFlags, EigenAlignmentDoesNotDependOnTheProcessor)
{
  EXPECT_EQ(EIGEN_MAX_ALIGN_BYTES, 16);
  EXPECT_EQ(alignof(Eigen::Vector4d), 16u);
  EXPECT_EQ(sizeof(Eigen::Vector3d), 3 * sizeof(double));
}
