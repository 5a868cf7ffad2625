#include "tools/workers/worker_pool.hpp"

#include <csignal>
#include <map>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/files/file.hpp"

namespace castaway::testbed {
namespace {

std::map<int, int> exit_codes(int count, int workers, const Job& job) {
  std::map<int, int> codes;
  run_jobs(count, workers, job, [&](int index, int code) { codes[index] = code; });
  return codes;
}

TEST(WorkerPool, DoesEveryJobOnceWhateverTheNumberOfWorkers) {
  for (const int workers : {1, 2, 7}) {
    const TemporaryFolder folder;
    const auto job = [&](int index) {
      write_file(folder.path() / std::to_string(index), "done");
      return index;
    };
    const auto codes = exit_codes(5, workers, job);
    ASSERT_EQ(codes.size(), 5U);
    for (int i = 0; i < 5; ++i) {
      EXPECT_EQ(codes.at(i), i);
      EXPECT_EQ(read_file(folder.path() / std::to_string(i)), "done");
    }
  }
}

TEST(WorkerPool, JobsDoNotChangeThisProcess) {
  int value = 1;
  exit_codes(1, 1, [&](int) { return value = 2, 0; });
  EXPECT_EQ(value, 1);
}

TEST(WorkerPool, AJobThatThrowsOrDiesHasFailed) {
  const auto job = [](int index) -> int {
    if (index == 0) throw std::runtime_error("no luck");
    if (index == 1) raise(SIGKILL);
    return 0;
  };
  const std::map<int, int> expected{{0, 1}, {1, 1}, {2, 0}};
  EXPECT_EQ(exit_codes(3, 1, job), expected);
}

TEST(WorkerPool, StartsNoMoreOnceItIsStopped) {
  std::map<int, int> codes;
  run_jobs(
      9, 1, [](int index) { return index; }, [&](int index, int code) { codes[index] = code; },
      [&codes] { return codes.size() == 3; });
  EXPECT_EQ(codes, (std::map<int, int>{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(WorkerPool, NeedsAWorker) {
  EXPECT_THROW(exit_codes(1, 0, [](int) { return 0; }), std::invalid_argument);
  EXPECT_TRUE(exit_codes(0, 1, [](int) { return 0; }).empty());
}

}  // namespace
}  // namespace castaway::testbed
