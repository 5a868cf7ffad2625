#include "tools/workers/lasting_workers.hpp"

#include <unistd.h>

#include <csignal>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

/// Results and failures by job.
struct Worked {
  std::map<int, std::string> results;
  std::map<int, std::string> failures;
};

Worked work_on(int count, int workers, const CellWork& work, double timeout_s = 0.0) {
  std::vector<int> jobs(static_cast<std::size_t>(count));
  std::iota(jobs.begin(), jobs.end(), 0);
  Worked worked;
  work_through(jobs, workers, work,
               {[&](int job, const std::string& text) { worked.results[job] = text; },
                [&](int job, const std::string& why) { worked.failures[job] = why; }},
               timeout_s);
  return worked;
}

TEST(LastingWorkers, DoEveryJobOnceWhateverTheirNumber) {
  for (const int workers : {1, 2, 7, 50}) {
    const Worked worked = work_on(20, workers, [](int job) { return std::to_string(job * job); });
    ASSERT_EQ(worked.results.size(), 20U);
    for (const auto& [job, text] : worked.results) EXPECT_EQ(text, std::to_string(job * job));
    EXPECT_TRUE(worked.failures.empty());
  }
  EXPECT_TRUE(work_on(0, 2, [](int) { return ""; }).results.empty());
}

TEST(LastingWorkers, WorkOnManyJobsInOneProcess) {
  const Worked worked = work_on(30, 2, [](int) { return std::to_string(getpid()); });
  std::set<std::string> processes;
  for (const auto& [job, process] : worked.results) processes.insert(process);
  EXPECT_LE(processes.size(), 2U);
  EXPECT_FALSE(processes.contains(std::to_string(getpid())));
}

TEST(LastingWorkers, PassLongResults) {
  const Worked worked =
      work_on(3, 2, [](int job) { return std::string(3000000, static_cast<char>('a' + job)); });
  EXPECT_EQ(worked.results.at(2), std::string(3000000, 'c'));
}

TEST(LastingWorkers, AJobThatThrowsFailsAlone) {
  const Worked worked = work_on(4, 1, [](int job) {
    if (job == 1) throw std::runtime_error("no luck");
    return std::to_string(getpid());
  });
  EXPECT_EQ(worked.failures, (std::map<int, std::string>{{1, "no luck"}}));
  EXPECT_EQ(worked.results.at(0), worked.results.at(3));  // The process goes on.
}

TEST(LastingWorkers, AProcessThatDiesIsReplaced) {
  for (const int workers : {1, 3}) {
    const Worked worked = work_on(9, workers, [](int job) {
      if (job % 3 == 1) raise(SIGKILL);
      if (job % 3 == 2) _exit(7);
      return "done";
    });
    EXPECT_EQ(worked.results.size(), 3U);
    ASSERT_EQ(worked.failures.size(), 6U);
    EXPECT_EQ(worked.failures.at(4), "its process was killed by signal 9 (Killed)");
    EXPECT_EQ(worked.failures.at(5), "its process ended with 7");
  }
}

TEST(LastingWorkers, AJobThatIsTooSlowIsEnded) {
  const Worked worked = work_on(
      3, 2,
      [](int job) {
        if (job == 0) std::this_thread::sleep_for(std::chrono::hours(1));
        return "done";
      },
      0.3);
  EXPECT_EQ(worked.failures, (std::map<int, std::string>{{0, "took longer than 0.3 s"}}));
  EXPECT_EQ(worked.results.size(), 2U);
}

}  // namespace
}  // namespace castaway::testbed
