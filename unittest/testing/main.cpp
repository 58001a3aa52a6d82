// Main program of all tests.  Those that link LAMMPS define LBMIBB_TEST_MPI and may run on many
// ranks.  ctest starts one case at a time and is told by the exit status how it went.

#include <gtest/gtest.h>

static constexpr int SKIPPED = 77;

// 0: passed, 77: skipped, 1: failed
static int run_tests()
{
  if (RUN_ALL_TESTS() != 0) return 1;
  const auto *unit = ::testing::UnitTest::GetInstance();
  return (unit->skipped_test_count() > 0 && unit->successful_test_count() == 0) ? SKIPPED : 0;
}

#ifndef LBMIBB_TEST_MPI

int main(int argc, char **argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  return run_tests();
}

#else

#include <cstdio>
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
  if (::testing::GTEST_FLAG(list_tests)) return run_tests();

  MPI_Init(&argc, &argv);
  int me;
  MPI_Comm_rank(MPI_COMM_WORLD, &me);
  auto &listeners = ::testing::UnitTest::GetInstance()->listeners();
  if (me != 0) {
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter(me));
  }

  // failed on any rank: failed; skipped on any: skipped
  const int mine = run_tests();
  int failed = (mine == 1), skipped = (mine == SKIPPED);
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &skipped, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return failed ? 1 : skipped ? SKIPPED : 0;
}

#endif
