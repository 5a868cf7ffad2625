#include "tools/batch/jobs/trial_runner.hpp"

#include <csignal>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/run/localizer_failure.hpp"

namespace castaway::testbed {
namespace {

std::string text_of_trial(int trial) { return "trial\n" + std::to_string(trial); }

TEST(TrialRunner, GivesTheTextsInOrder) {
  for (const int workers : {1, 3}) {
    int heard = 0;
    const auto texts = run_at_once(workers)(5, text_of_trial, [&] { ++heard; });
    EXPECT_EQ(heard, 5);
    ASSERT_EQ(texts.size(), 5U);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(texts[static_cast<std::size_t>(i)], text_of_trial(i));
  }
}

TEST(TrialRunner, EndsWithTheFirstThatFails) {
  const Work broken = [](int trial) -> std::string {
    if (trial == 2) throw std::runtime_error("broken");
    return "";
  };
  const Work killed = [](int) -> std::string {
    std::raise(SIGKILL);
    return "";
  };
  for (const int workers : {1, 2}) {
    EXPECT_TRUE(contains(error_of([&] { run_at_once(workers)(4, broken, [] {}); }), "broken"));
  }
  EXPECT_TRUE(contains(error_of([&] { run_at_once(2)(1, killed, [] {}); }), "trial 0: "));
}

TEST(TrialRunner, KeepsTheKindOfALocalizersFailure) {
  const Work failed = [](int) -> std::string { throw LocalizerFailure("died"); };
  for (const int workers : {1, 2}) {
    EXPECT_THROW(run_at_once(workers)(1, failed, [] {}), LocalizerFailure);
  }
}

}  // namespace
}  // namespace castaway::testbed
