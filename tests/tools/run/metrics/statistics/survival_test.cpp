#include "tools/run/metrics/statistics/survival.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

Survival survival_of(const std::vector<std::pair<double, bool>>& observations) {
  Survival survival;
  for (const auto& [time, event] : observations) survival.add(time, event);
  return survival;
}

TEST(Survival, WithoutCensoringIsTheShareThatIsLeft) {
  const Survival survival = survival_of({{1.0, true}, {4.0, true}, {2.0, true}, {2.0, true}});
  const std::vector<SurvivalStep> steps = survival.steps();
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_DOUBLE_EQ(steps[0].survival, 0.75);
  EXPECT_DOUBLE_EQ(steps[1].survival, 0.25);
  EXPECT_EQ(steps[1].at_risk, 3);
  EXPECT_EQ(steps[1].events, 2);
  EXPECT_EQ(steps[2].survival, 0.0);
  EXPECT_EQ(*survival.median_s(), 2.0);
  EXPECT_EQ(survival.longest_s(), 4.0);
}

TEST(Survival, AnObservationThatEndsAtAnEventIsAtRisk) {
  const Survival survival = survival_of({{1.0, false}, {1.0, true}});
  EXPECT_EQ(survival.steps().front().at_risk, 2);
  EXPECT_DOUBLE_EQ(survival.steps().front().survival, 0.5);
  EXPECT_EQ(survival.censored(), 1);
}

TEST(Survival, WithoutEventsHasNoStepAndNoMedian) {
  const Survival survival = survival_of({{3.0, false}, {5.0, false}});
  EXPECT_TRUE(survival.steps().empty());
  EXPECT_FALSE(survival.median_s());
  EXPECT_EQ(survival.longest_s(), 5.0);
  EXPECT_EQ(survival_of({}).longest_s(), 0.0);
}

TEST(Survival, RoundsTimesToTenMilliseconds) {
  const Survival survival = survival_of({{1.004, true}, {0.996, true}, {-1e-9, true}});
  ASSERT_EQ(survival.steps().size(), 2U);
  EXPECT_EQ(survival.steps()[1].time_s, 1.0);
  EXPECT_EQ(survival.steps()[1].events, 2);
}

// Remission under 6-MP: Freireich et al., Blood 21, 1963; the estimates are in every textbook.
TEST(Survival, AgreesWithPublishedEstimates) {
  const Survival survival = survival_of(
      {{6, true},   {6, true},   {6, true},   {6, false},  {7, true},   {9, false},  {10, true},
       {10, false}, {11, false}, {13, true},  {16, true},  {17, false}, {19, false}, {20, false},
       {22, true},  {23, true},  {25, false}, {32, false}, {32, false}, {34, false}, {35, false}});
  const std::vector<double> expected{0.857, 0.807, 0.753, 0.690, 0.627, 0.538, 0.448};
  const std::vector<SurvivalStep> steps = survival.steps();
  ASSERT_EQ(steps.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(steps[i].survival, expected[i], 6e-4);
  }
  EXPECT_NEAR(steps.front().interval.low, 0.620, 6e-4);
  EXPECT_NEAR(steps.front().interval.high, 0.952, 6e-4);
  EXPECT_NEAR(steps.back().interval.low, 0.188, 6e-4);
  EXPECT_NEAR(steps.back().interval.high, 0.680, 6e-4);
  EXPECT_EQ(*survival.median_s(), 23.0);
}

// Exponential times with mean 10 s, censored uniformly in 0 to 30 s: S(5 s) = exp(-0.5), with a
// standard deviation below sqrt(S (1 - S) / n) of 2000 observations and 20 % more for the
// censoring.
TEST(Survival, FindsTheDistributionThroughTheCensoring) {
  localization::Rng rng = localization::substream(1, "survival");
  const auto uniform = [&] {
    return static_cast<double>(rng() >> 11U) / static_cast<double>(1ULL << 53U);
  };
  Survival survival;
  for (int i = 0; i < 2000; ++i) {
    const double time = -10.0 * std::log(1.0 - uniform());
    const double end = 30.0 * uniform();
    survival.add(std::min(time, end), time <= end);
  }
  double at_five = 1.0;
  for (const SurvivalStep& step : survival.steps()) {
    if (step.time_s <= 5.0) at_five = step.survival;
  }
  EXPECT_NEAR(at_five, std::exp(-0.5), 4 * 0.0132);
}

}  // namespace
}  // namespace castaway::testbed
