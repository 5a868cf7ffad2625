#include "localization/hypotheses/null_hypothesis.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();

std::vector<Hypothesis> make_hypotheses(std::initializer_list<double> log_weights) {
  std::vector<Hypothesis> hypotheses;
  for (const double w : log_weights) {
    hypotheses.emplace_back();
    hypotheses.back().log_weight = w;
  }
  return hypotheses;
}

TEST(LogSumExp, IsExactAndSurvivesExtremes) {
  EXPECT_NEAR(log_sum_exp({std::log(2.0), std::log(3.0)}), std::log(5.0), 1e-12);
  EXPECT_NEAR(log_sum_exp({-10000.0, -10000.0}), -10000.0 + std::log(2.0), 1e-9);
  EXPECT_EQ(log_sum_exp({}), kNothing);
  EXPECT_EQ(log_sum_exp({kNothing, kNothing}), kNothing);
}

TEST(Shares, SumToOneWithTheNullHypothesis) {
  const auto all = shares(make_hypotheses({std::log(6.0), std::log(3.0)}), {std::log(1.0), -3.0});
  EXPECT_NEAR(all[0], 0.6, 1e-12);
  EXPECT_NEAR(all[1], 0.3, 1e-12);
}

TEST(AdvanceNull, AddsKidnapsFromTheListedMass) {
  const NullHypothesisConfig config;
  NullHypothesis null{-4.0, -2.0};
  advance_null(config, 0.5, 3.0, -1.5, null);
  // A place of the null hypothesis scores usual - 6 = -8; the cue makes a kidnap less likely
  // by 1.5.
  EXPECT_NEAR(null.log_weight, log_sum_exp({-4.0 - 0.5 * 8.0, 3.0 - 8.0 - 1.5 - 8.0}), 1e-12);
}

TEST(LearnUsual, FollowsConfidentScansAndHowMuchTheyVary) {
  NullHypothesis null{0.0, -3.0, 2.0};
  learn_usual({}, -1.0, 0.5, null);
  EXPECT_DOUBLE_EQ(null.usual, -2.9);
  EXPECT_DOUBLE_EQ(null.spread, 2.0);  // Because the output was off by two nats.
  learn_usual({}, -2.9, 0.5, null);
  EXPECT_DOUBLE_EQ(null.spread, 1.9);
}

TEST(LearnUsual, LetsOneOddScanCountForLittleOfTheSpread) {
  NullHypothesis null{0.0, -1.0, 1.0};
  learn_usual({}, -21.0, 1.0, null);
  EXPECT_DOUBLE_EQ(null.usual, -2.0);
  EXPECT_DOUBLE_EQ(null.spread, 1.15);  // As if the output had been off by 2.5 nats.
}

TEST(DoubtOutput, MakesAKidnapAsLikelyAsNoneWhereNothingFits) {
  NullHypothesis null{-20.0, -8.0};
  doubt_output({}, -23.9, -1.0, null);
  EXPECT_DOUBLE_EQ(null.log_weight, -20.0);
  doubt_output({}, -24.1, -1.0, null);
  EXPECT_DOUBLE_EQ(null.log_weight, -1.0);
  doubt_output({}, -25.0, -3.0, null);  // It never supports the output.
  EXPECT_DOUBLE_EQ(null.log_weight, -1.0);
}

TEST(LowerUsual, FollowsASearchThatFindsNothingSoGood) {
  NullHypothesis null{0.0, -2.0};
  lower_usual({}, -1.0, null);
  EXPECT_DOUBLE_EQ(null.usual, -2.0);
  lower_usual({}, -8.0, null);
  EXPECT_DOUBLE_EQ(null.usual, -5.0);
}

TEST(BoundNull, HoldsASearchToWhatItCanMiss) {
  // Odds of a miss: exp(-3 + 0.35 * 2) = exp(-2.3).
  NullHypothesis null{0.0, -2.0};
  bound_null({}, {-2.0, 0.0}, -15.0, null);
  EXPECT_NEAR(null.log_weight, -17.3, 1e-12);
  // Already smaller: nothing changes.
  bound_null({}, {-20.0, 0.0}, -15.0, null);
  EXPECT_NEAR(null.log_weight, -17.3, 1e-12);
}

TEST(BoundNull, TrustsALeadUpToALimit) {
  NullHypothesis null{0.0, -2.0};
  bound_null({}, {-2.0, 5.0}, 0.0, null);
  EXPECT_NEAR(null.log_weight, -3.0 + 0.7 - 1.5, 1e-12);
  bound_null({}, {-2.0, 1e9}, 0.0, null);
  EXPECT_NEAR(null.log_weight, -3.0 + 0.7 - 3.6, 1e-12);
}

TEST(BoundNullOfOutput, CountsItsLeadAlone) {
  NullHypothesis null{5.0, -2.0};
  bound_null_of_output({}, 5.0, 1.0, null);
  EXPECT_NEAR(null.log_weight, 1.0 - 3.0, 1e-12);
  bound_null_of_output({}, -4.0, 1.0, null);  // Already smaller.
  EXPECT_NEAR(null.log_weight, -2.0, 1e-12);
  bound_null_of_output({}, 50.0, 1.0, null);
  EXPECT_NEAR(null.log_weight, 1.0 - 7.2, 1e-12);
}

TEST(LimitSurprise, LetsOneScanOfARobotAtRestGainLittle) {
  // An unlisted place has -2 - 6 = -8; the scan at the output is 10 nats below that.
  NullHypothesis null{3.0, -2.0, 2.0};
  limit_surprise({}, -18.0, {0.15, -3.0}, -10.0, 1.0, null);
  EXPECT_NEAR(null.log_weight, 1.0 - 10.0 + 4.0 + 1.5, 1e-12);
  null.log_weight = 3.0;
  limit_surprise({}, -18.0, {0.15, 2.0}, -10.0, 1.0, null);
  EXPECT_NEAR(null.log_weight, 1.0 - 10.0 + 4.0 + 1.5 + 2.0, 1e-12);
  null.log_weight = -30.0;
  limit_surprise({}, -18.0, {0.15, 2.0}, -10.0, 1.0, null);
  EXPECT_EQ(null.log_weight, -30.0);
}

TEST(TakeDoubt, GrowsWhileScansAreLessLikelyThanUsual) {
  NullHypothesis null{-50.0, -2.0, 2.0};  // A slack of 1.5 * 2 = 3.
  take_doubt({}, -4.9, 1.0, 0.0, null);
  EXPECT_EQ(null.doubt, 0.0);
  take_doubt({}, -9.0, 1.0, 0.0, null);
  EXPECT_NEAR(null.doubt, 4.0, 1e-12);
  EXPECT_NEAR(null.log_weight, -6.0, 1e-12);  // Even odds at a doubt of 10.
  take_doubt({}, -9.0, 0.5, 0.0, null);
  EXPECT_NEAR(null.doubt, 6.0, 1e-12);
  take_doubt({}, -1.0, 1.0, 0.0, null);
  EXPECT_NEAR(null.doubt, 2.0, 1e-12);
  for (int k = 0; k < 20; ++k) take_doubt({}, -20.0, 1.0, 0.0, null);
  EXPECT_EQ(null.doubt, 25.0);
}

TEST(TakeDoubt, HasALeastSlack) {
  NullHypothesis null{0.0, -2.0, 0.1};
  take_doubt({}, -4.0, 1.0, 0.0, null);
  EXPECT_NEAR(null.doubt, 1.0, 1e-12);
}

TEST(SettleDoubt, CorrectsWhatIsUsualDownwardsOnly) {
  NullHypothesis null{0.0, -2.0, 2.0, 8.0};
  settle_doubt({}, -6.0, null);
  EXPECT_EQ(null.doubt, 0.0);
  EXPECT_NEAR(null.usual, -4.0, 1e-12);
  EXPECT_NEAR(null.spread, 2.4, 1e-12);
  settle_doubt({}, -1.0, null);
  EXPECT_NEAR(null.usual, -4.0, 1e-12);
  EXPECT_NEAR(null.spread, 2.4, 1e-12);
}

TEST(NullLogLikelihood, HasAFloor) {
  EXPECT_DOUBLE_EQ(null_log_likelihood({}, {0.0, -2.0}), -8.0);
  EXPECT_DOUBLE_EQ(null_log_likelihood({}, {0.0, -20.0}), -22.0);
}

TEST(NullLogLikelihood, IsNearerToTheUsualWhereRightPosesHardlyVary) {
  EXPECT_DOUBLE_EQ(null_log_likelihood({}, {0.0, -2.0, 5.0}), -8.0);
  EXPECT_DOUBLE_EQ(null_log_likelihood({}, {0.0, -2.0, 1.5}), -6.5);
  EXPECT_DOUBLE_EQ(null_log_likelihood({}, {0.0, -2.0, 0.1}), -5.0);
}

TEST(IsHopeless, WhereEveryHypothesisIs) {
  std::vector<Hypothesis> all = make_hypotheses({0.0, 0.0});
  all[0].log_likelihood = -24.1;
  all[1].log_likelihood = -23.9;
  EXPECT_FALSE(is_hopeless({}, all));
  all[1].log_likelihood = -24.1;
  EXPECT_TRUE(is_hopeless({}, all));
}

}  // namespace
}  // namespace castaway::localization
