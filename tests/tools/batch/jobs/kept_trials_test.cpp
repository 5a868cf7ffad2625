#include "tools/batch/jobs/kept_trials.hpp"

#include <csignal>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/output/exit_code.hpp"

namespace castaway::testbed {
namespace {

using Texts = std::vector<std::string>;

const JobIdentity kEvaluation{"evaluation", "1.0", "program", "data", "spec"};

/// Runs batches of 2 and of 3 trials.
class KeptTrialsTest : public testing::Test {
 protected:
  /// Their texts together; the number of trials that were made is added to `made`.
  Texts run(KeptTrials& kept) {
    Texts all;
    for (const int count : {2, 3}) {
      const auto before = static_cast<int>(all.size());
      const Work work = [before, this](int trial) {
        const int job = before + trial;
        if (job == fails_) throw std::runtime_error("broke");
        if (job == dies_) std::raise(SIGKILL);
        return "job " + std::to_string(job);
      };
      for (std::string& text : kept.runner()(count, work, [this] { ++made_; })) {
        all.push_back(std::move(text));
      }
    }
    return all;
  }
  [[nodiscard]] BatchRequest request(int workers = 1) const {
    BatchRequest request;
    request.out = folder_.path() / "k";
    request.workers = workers;
    return request;
  }

  TemporaryFolder folder_;
  int fails_ = -1;
  int dies_ = -1;
  int made_ = 0;
  const Texts all_{"job 0", "job 1", "job 2", "job 3", "job 4"};
};

TEST_F(KeptTrialsTest, AreNotMadeAgain) {
  KeptTrials first(request(2), kEvaluation, 5);
  EXPECT_EQ(run(first), all_);
  EXPECT_EQ(made_, 5);
  EXPECT_TRUE(first.has_all());
  KeptTrials again(request(), kEvaluation, 5);
  fails_ = 0;
  EXPECT_EQ(run(again), all_);
  EXPECT_EQ(made_, 5);
  EXPECT_EQ(again.report(), kDone);
}

TEST_F(KeptTrialsTest, GoOnWhereOneFailsOrItsProcessDies) {
  fails_ = 1;
  dies_ = 3;
  KeptTrials kept(request(), kEvaluation, 5);
  EXPECT_EQ(run(kept), (Texts{"job 0", "", "job 2", "", "job 4"}));
  EXPECT_FALSE(kept.has_all());
  EXPECT_EQ(kept.report(), kRunFailed);
  fails_ = dies_ = -1;
  made_ = 0;
  KeptTrials same(request(), kEvaluation, 5);
  EXPECT_EQ(run(same)[1], "");
  EXPECT_EQ(made_, 0);
  BatchRequest retry = request();
  retry.retry_failed = true;
  KeptTrials again(retry, kEvaluation, 5);
  EXPECT_EQ(run(again), all_);
  EXPECT_EQ(made_, 2);
}

TEST_F(KeptTrialsTest, AreSharedAndCollected) {
  BatchRequest one = request();
  one.shard = {1, 2};
  KeptTrials first(one, kEvaluation, 5);
  EXPECT_EQ(run(first), (Texts{"job 0", "", "job 2", "", "job 4"}));
  EXPECT_EQ(first.report(), kDone);
  EXPECT_EQ(jobs_without_row(one.out, 5), (std::vector<int>{1, 3}));
  BatchRequest collect = request();
  collect.collect = true;
  KeptTrials early(collect, kEvaluation, 5);
  run(early);
  EXPECT_EQ(early.report(), kRunFailed);
  one.shard = {2, 2};
  fails_ = 0;  // Not its own.
  KeptTrials second(one, kEvaluation, 5);
  run(second);
  EXPECT_EQ(made_, 5);
  KeptTrials whole(collect, kEvaluation, 5);
  EXPECT_EQ(run(whole), all_);
  EXPECT_EQ(whole.report(), kDone);
}

TEST_F(KeptTrialsTest, OfNoFolderAreNotCollected) {
  BatchRequest collect = request();
  collect.collect = true;
  EXPECT_TRUE(contains(error_of([&] { KeptTrials(collect, kEvaluation, 5); }),
                       "it has no evaluation.json"));
  EXPECT_FALSE(std::filesystem::exists(collect.out));
}

}  // namespace
}  // namespace castaway::testbed
