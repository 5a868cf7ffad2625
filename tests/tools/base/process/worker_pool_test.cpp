#include "tools/base/process/worker_pool.hpp"

#include <unistd.h>

#include <csignal>
#include <map>
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

Worked work_on(int count, int workers, const Work& work, double timeout_s = 0.0) {
  Worked worked;
  work_through(jobs_up_to(count), workers, work,
               {[&](int job, const std::string& text) { worked.results[job] = text; },
                [&](int job, const std::string& why) { worked.failures[job] = why; }},
               timeout_s);
  return worked;
}

TEST(WorkerPool, DoEveryJobOnceWhateverTheirNumber) {
  for (const int workers : {1, 2, 7, 50}) {
    const Worked worked = work_on(20, workers, [](int job) { return std::to_string(job * job); });
    ASSERT_EQ(worked.results.size(), 20U);
    for (const auto& [job, text] : worked.results) EXPECT_EQ(text, std::to_string(job * job));
    EXPECT_TRUE(worked.failures.empty());
  }
  EXPECT_TRUE(work_on(0, 2, [](int) { return ""; }).results.empty());
}

TEST(WorkerPool, WorkOnManyJobsInOneProcess) {
  const Worked worked = work_on(30, 2, [](int) { return std::to_string(getpid()); });
  std::set<std::string> processes;
  for (const auto& [job, process] : worked.results) processes.insert(process);
  EXPECT_LE(processes.size(), 2U);
  EXPECT_FALSE(processes.contains(std::to_string(getpid())));
}

TEST(WorkerPool, PassLongResults) {
  const Worked worked =
      work_on(3, 2, [](int job) { return std::string(3000000, static_cast<char>('a' + job)); });
  EXPECT_EQ(worked.results.at(2), std::string(3000000, 'c'));
}

/// Like libsdformat's assertions, which are no std::exception.
TEST(WorkerPool, AJobThatThrowsAnyTypeFailsAlone) {
  struct Assertion {};
  const Worked worked = work_on(2, 1, [](int job) {
    if (job == 0) throw Assertion();
    return std::string("done");
  });
  ASSERT_EQ(worked.failures.size(), 1U);
  EXPECT_NE(worked.failures.at(0).find("Assertion"), std::string::npos);
  EXPECT_EQ(worked.results, (std::map<int, std::string>{{1, "done"}}));
}

TEST(WorkerPool, AJobThatThrowsFailsAlone) {
  const Worked worked = work_on(4, 1, [](int job) {
    if (job == 1) throw std::runtime_error("no luck");
    return std::to_string(getpid());
  });
  EXPECT_EQ(worked.failures, (std::map<int, std::string>{{1, "no luck"}}));
  EXPECT_EQ(worked.results.at(0), worked.results.at(3));  // The process goes on.
}

TEST(WorkerPool, AProcessThatDiesIsReplaced) {
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

TEST(WorkerPool, AJobThatIsTooSlowIsEnded) {
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

TEST(WorkerPool, JobsDoNotChangeThisProcess) {
  int value = 1;
  work_on(1, 1, [&](int) { return value = 2, ""; });
  EXPECT_EQ(value, 1);
}

TEST(WorkerPool, HandsNoMoreOutOnceItIsStopped) {
  std::map<int, std::string> results;
  int failures = 0;
  JobOutcomes outcomes;
  outcomes.on_result = [&](int job, const std::string& text) { results[job] = text; };
  outcomes.on_failure = [&](int, const std::string&) { ++failures; };
  outcomes.stopped = [&] { return results.size() == 2 && failures == 1; };
  work_through(
      jobs_up_to(9), 1,
      [](int job) {
        if (job == 1) _exit(1);
        return std::to_string(job);
      },
      outcomes);
  EXPECT_EQ(results, (std::map<int, std::string>{{0, "0"}, {2, "2"}}));
}

TEST(WorkerPool, NeedsAWorker) {
  EXPECT_THROW(work_on(1, 0, [](int) { return ""; }), std::invalid_argument);
}

TEST(WorkerPool, PassesOnWhatTheCallerThrows) {
  JobOutcomes outcomes;
  outcomes.on_result = [](int, const std::string&) { throw std::runtime_error("enough"); };
  EXPECT_THROW(work_through(
                   jobs_up_to(9), 2, [](int) { return ""; }, outcomes),
               std::runtime_error);
}

/// The later one was forked with a copy of the end of the first one's socket.
TEST(WorkerProcess, EndsThoughALaterOneHoldsItsSocket) {
  const Work echo = [](int job) { return std::to_string(job); };
  WorkerProcess first(echo);
  WorkerProcess second(echo);
  EXPECT_EQ(first.end(), "its process ended with 0");
  EXPECT_EQ(second.end(), "its process ended with 0");
}

}  // namespace
}  // namespace castaway::testbed
