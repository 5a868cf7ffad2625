#include "tools/workers/worker_notes.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tools/workers/worker_pool.hpp"

namespace castaway::testbed {
namespace {

TEST(WorkerNotes, ComeFromOtherProcessesInWholeLines) {
  WorkerNotes notes;
  std::vector<std::string> lines;
  run_jobs(
      5, 3,
      [&](int index) {
        notes.leave(std::string(100, static_cast<char>('a' + index)) + "\nend");
        return 0;
      },
      [&](int, int) {
        for (const std::string& line : notes.take()) lines.push_back(line);
      });
  std::sort(lines.begin(), lines.end());
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0], std::string(100, 'a') + " end");
  EXPECT_EQ(lines[4], std::string(100, 'e') + " end");
}

TEST(WorkerNotes, ThatAreTooLongAreCut) {
  WorkerNotes notes;
  notes.leave(std::string(10'000, 'x'));
  const auto lines = notes.take();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].size(), 4000U);
  EXPECT_TRUE(notes.take().empty());
}

}  // namespace
}  // namespace castaway::testbed
