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

TEST(Shares, LeaveRoomForPlacesLeftOut) {
  NullHypothesis null{kNothing};
  null.left_out = std::log(3.0);
  EXPECT_NEAR(shares(make_hypotheses({0.0}), null)[0], 0.25, 1e-12);
}

TEST(AdvanceLeftOut, FollowsTheBestHypothesis) {
  std::vector<Hypothesis> two = make_hypotheses({0.0, 0.0});
  two[0].log_likelihood = -7.0;
  two[1].log_likelihood = -1.0;
  NullHypothesis null;
  advance_left_out({}, 0.5, 0.0, two, null);
  EXPECT_EQ(null.left_out, kNothing);
  null.left_out = -2.0;
  advance_left_out({}, 0.5, 0.0, two, null);
  EXPECT_DOUBLE_EQ(null.left_out, -2.5);
  advance_left_out({}, 0.5, 0.0, {}, null);
  EXPECT_DOUBLE_EQ(null.left_out, -2.5);
}

TEST(AdvanceLeftOut, KeepsItsOddsToTheHypotheses) {
  NullHypothesisConfig config;
  config.left_out_as_listed = true;
  const std::vector<Hypothesis> two = make_hypotheses({-3.0, -5.0});
  NullHypothesis null;
  null.left_out = -2.0;
  advance_left_out(config, 0.5, -1.0, two, null);
  EXPECT_DOUBLE_EQ(null.left_out, -2.0 + listed_log_weight(two) + 1.0);
  advance_left_out(config, 0.5, kNothing, {}, null);
  EXPECT_DOUBLE_EQ(null.left_out, -2.0 + listed_log_weight(two) + 1.0);
}

TEST(TakeLeftOut, HalvesTheWeightBeforeUnlessAListIsComplete) {
  NullHypothesis null;
  take_left_out(-5.0, null);
  EXPECT_DOUBLE_EQ(null.left_out, -5.0);
  take_left_out(-9.0, null);  // What this list left out fits the scans before badly.
  EXPECT_NEAR(null.left_out, -5.0 + std::log(0.5), 1e-12);
  take_left_out(-3.0, null);
  EXPECT_DOUBLE_EQ(null.left_out, -3.0);
  take_left_out(std::nullopt, null);
  EXPECT_EQ(null.left_out, kNothing);
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
  NullHypothesisConfig config;
  config.watch_missed = 0.0;
  NullHypothesis null{5.0, -2.0};
  bound_null_of_output(config, 5.0, 1.0, null);
  EXPECT_NEAR(null.log_weight, 1.0 - 3.0, 1e-12);
  bound_null_of_output(config, -4.0, 1.0, null);  // Already smaller.
  EXPECT_NEAR(null.log_weight, -2.0, 1e-12);
  bound_null_of_output(config, 50.0, 1.0, null);
  EXPECT_NEAR(null.log_weight, 1.0 - 7.2, 1e-12);
}

TEST(BoundNullOfOutput, CountsThatTheSearchFoundNothing) {
  NullHypothesis null{-1.0, -2.0};
  bound_null_of_output({}, 0.5, 0.0, null);
  EXPECT_NEAR(null.log_weight, -1.0 - 2.3, 1e-12);
}

TEST(LimitSurprise, LetsOneScanOfARobotAtRestGainLittle) {
  // An unlisted place has -2 - 6 = -8; the scan at the output is 10 nats below that. Its misfit is
  // 8 - log(22 / 4) = 6.3 nats, more than a scan may count.
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

TEST(LimitSurprise, LetsAScanAfterALongTimeGainWhatItsMisfitSays) {
  const NullHypothesisConfig config;
  const double misfit = 8.0 - std::log(22.0 / 4.0);
  for (const double periods : {1.0, 1.3, 2.0, 50.0}) {
    NullHypothesis null{3.0, -2.0, 2.0};
    limit_surprise(config, -18.0, {0.15, -3.0, periods}, -10.0, 1.0, null);
    const double gain = std::min(misfit, 4.0 * periods) + std::log(periods) + 1.5;
    EXPECT_NEAR(null.log_weight, std::min(3.0, 1.0 - 10.0 + gain), 1e-12) << periods;
  }
}

TEST(LimitSurprise, LetsAMisfitGainNothingWhereFitsScatterAsMuch) {
  NullHypothesis null{3.0, -12.0, 3.0};  // As in a crowd: 5 nats less than usual are common.
  limit_surprise({}, -17.0, {0.15, -3.0}, -10.0, 1.0, null);
  EXPECT_NEAR(null.log_weight, 1.0 - 10.0 + 5.0 / 3.0 - std::log(22.0 / 6.0), 1e-12);
  null.log_weight = 3.0;
  limit_surprise({}, -13.0, {0.15, -3.0}, -10.0, 1.0, null);
  EXPECT_NEAR(null.log_weight, 1.0 - 10.0, 1e-12);
}

TEST(EvenDoubt, FollowsFromTheToleratedRateOfFalseAlarms) {
  NullHypothesisConfig config;
  NullHypothesis null;
  config.false_alarms_per_h = 14400.0;  // One a scan.
  EXPECT_NEAR(even_doubt(config, null), 2.2, 1e-12);
  config.false_alarms_per_h = 1440.0;
  EXPECT_NEAR(even_doubt(config, null), 2.2 + std::log(10.0), 1e-12);
  null.periods = 5.0;  // A fifth of the scans in an hour.
  EXPECT_NEAR(even_doubt(config, null), 2.2 + std::log(2.0), 1e-12);
  null.periods = 50.0;
  EXPECT_NEAR(even_doubt(config, null), 2.2, 1e-12);
}

/// A right pose scatters by 2 nats around -2; a wrong one is even over 20 nats.
const NullHypothesis kScattered{-50.0, -2.0, 2.0};
NullHypothesisConfig without_rare_misfits() {
  NullHypothesisConfig config;
  config.wrong_range = 20.0;
  config.rare_misfit = 1e-12;
  return config;
}

TEST(DoubtOf, IsTheLogarithmOfTheRatioOfTheLikelihoods) {
  const NullHypothesisConfig config = without_rare_misfits();
  // At the usual value 1 / 20 against 1 / (2 * 2); each spread below it counts one nat more.
  EXPECT_NEAR(doubt_of(config, -2.0, kScattered), std::log(4.0 / 20.0), 1e-6);
  EXPECT_NEAR(doubt_of(config, -4.0, kScattered), std::log(4.0 / 20.0) + 1.0, 1e-6);
  EXPECT_NEAR(doubt_of(config, -12.0, kScattered), std::log(4.0 / 20.0) + 5.0, 1e-6);
  EXPECT_EQ(doubt_of(config, -0.5, kScattered), doubt_of(config, -2.0, kScattered));
}

TEST(DoubtOf, IsLimitedByRareMisfits) {
  NullHypothesisConfig config = without_rare_misfits();
  config.rare_misfit = 0.01;
  EXPECT_NEAR(doubt_of(config, -100.0, kScattered), std::log(100.0), 1e-9);
}

TEST(MisfitOf, IsTheDoubtWithoutItsLimit) {
  NullHypothesisConfig config = without_rare_misfits();
  EXPECT_NEAR(misfit_of(config, -12.0, kScattered), doubt_of(config, -12.0, kScattered), 1e-6);
  config.rare_misfit = 0.01;
  EXPECT_NEAR(misfit_of(config, -102.0, kScattered), std::log(4.0 / 20.0) + 50.0, 1e-9);
}

TEST(DoubtOf, HasALeastSpread) {
  const NullHypothesisConfig config = without_rare_misfits();
  const NullHypothesis exact{0.0, -2.0, 0.1};
  EXPECT_NEAR(doubt_of(config, -2.7, exact), std::log(1.4 / 20.0) + 1.0, 1e-6);
}

TEST(TakeDoubt, GrowsWhileScansAreLessLikelyThanUsual) {
  const NullHypothesisConfig config;
  NullHypothesis null = kScattered;
  take_doubt(config, -2.0, 1.0, 0.0, null);
  EXPECT_EQ(null.doubt, 0.0);
  take_doubt(config, -9.0, 1.0, 0.0, null);
  const double once = doubt_of(config, -9.0, kScattered);
  EXPECT_GT(once, 0.0);
  EXPECT_NEAR(null.doubt, once, 1e-12);
  EXPECT_NEAR(null.log_weight, once - even_doubt(config, null), 1e-12);
  take_doubt(config, -9.0, 0.5, 0.0, null);
  EXPECT_NEAR(null.doubt, 1.5 * once, 1e-12);
  take_doubt(config, -2.0, 1.0, 0.0, null);
  EXPECT_NEAR(null.doubt, 1.5 * once + doubt_of(config, -2.0, kScattered), 1e-12);
  for (int k = 0; k < 20; ++k) take_doubt(config, -20.0, 1.0, 0.0, null);
  EXPECT_EQ(null.doubt, 25.0);
}

TEST(DoubtOfBetter, FallsToNothingWhereTheBetterPlaceFitsBadlyToo) {
  EXPECT_EQ(doubt_of_better({}, 0.0), 8.0);
  EXPECT_NEAR(doubt_of_better({}, -1.5), 4.0, 1e-12);
  EXPECT_EQ(doubt_of_better({}, -3.0), 0.0);
  EXPECT_EQ(doubt_of_better({}, -9.0), 0.0);
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
