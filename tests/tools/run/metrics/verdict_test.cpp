#include "tools/run/metrics/verdict.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

JudgedRun run(std::uint64_t seed, std::optional<double> value) {
  return {seed, "runs/seed-" + std::to_string(seed), {{"error", value}}, 2.0};
}

Expectation expectation(const char* condition, SeedRule over = SeedRule::kAllSeeds) {
  return {"error", parse_condition(condition), over};
}

TEST(Verdict, OfAllSeedsJudgesEveryRun) {
  const auto checks = judge({expectation("< 5")}, {run(1, 4.0), run(2, 6.5)});
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_TRUE(checks[0].met);
  EXPECT_FALSE(checks[1].met);
  EXPECT_EQ(describe(checks[1]),
            "error is 6.5, expected < 5, missed by 1.5 (seed 2), see runs/seed-2");
}

TEST(Verdict, OfAnAggregatePointsAtTheRunFurthestOff) {
  const auto checks =
      judge({expectation("< 5", SeedRule::kMean)}, {run(1, 4.0), run(2, 9.0), run(3, 6.0)});
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_FALSE(checks[0].met);
  EXPECT_FALSE(checks[0].seed);
  EXPECT_EQ(checks[0].folder, "runs/seed-2");
  EXPECT_EQ(checks[0].wall_s, 6.0);
  EXPECT_EQ(describe(checks[0]),
            "error is 6.333, expected < 5, missed by 1.333 (mean of the seeds), see runs/seed-2");
}

TEST(Verdict, IsMetByAnAggregateThoughARunIsNot) {
  EXPECT_TRUE(
      judge({expectation("< 5", SeedRule::kMedian)}, {run(1, 4.0), run(2, 9.0), run(3, 1.0)})[0]
          .met);
}

TEST(Verdict, OfNothingMeasuredIsNotMet) {
  const auto each = judge({expectation("< 5")}, {run(1, std::nullopt)});
  EXPECT_FALSE(each[0].met);
  EXPECT_EQ(describe(each[0]),
            "error has nothing to measure, expected < 5 (seed 1), see runs/seed-1");
  EXPECT_FALSE(judge({expectation("< 5", SeedRule::kMax)}, {run(1, std::nullopt)})[0].met);
  const auto some =
      judge({expectation("< 5", SeedRule::kMax)}, {run(1, std::nullopt), run(2, 3.0)});
  EXPECT_TRUE(some[0].met);
}

TEST(Verdict, OfNoRunsIsNotMet) {
  EXPECT_FALSE(judge({expectation("< 5", SeedRule::kMean)}, {})[0].met);
}

}  // namespace
}  // namespace castaway::testbed
