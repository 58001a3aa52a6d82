// Main program of the tests that link LAMMPS, on one rank or many.

#include <cstdio>
#include <gtest/gtest.h>
#include <mpi.h>

// ranks other than the first speak only of failures
class FailurePrinter : public ::testing::EmptyTestEventListener {
 public:
  explicit FailurePrinter(int me) : rank(me) {}
  void OnTestPartResult(const ::testing::TestPartResult &result) override
  {
    if (!result.failed()) return;
    const char *file = result.file_name() ? result.file_name() : "unknown file";
    fprintf(stderr, "rank %d: %s:%d: %s\n", rank, file, result.line_number(), result.message());
  }

 private:
  int rank;
};

int main(int argc, char **argv)
{
  ::testing::InitGoogleTest(&argc, argv);

  // listing the cases needs no MPI, and must work where MPI cannot start
  if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();

  MPI_Init(&argc, &argv);
  int me;
  MPI_Comm_rank(MPI_COMM_WORLD, &me);
  auto &listeners = ::testing::UnitTest::GetInstance()->listeners();
  if (me != 0) {
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter(me));
  }

  // a test that failed on any rank has failed
  int failed = RUN_ALL_TESTS();
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return failed;
}
