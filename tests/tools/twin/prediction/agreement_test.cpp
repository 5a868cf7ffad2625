#include "tools/twin/prediction/agreement.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/twin/prediction/prediction_rows.hpp"

namespace castaway::testbed {
namespace {

void expect_figure(const std::vector<PredictionRow>& rows, double value, double low, double high) {
  const auto tau = rank_agreement(rows);
  ASSERT_TRUE(tau);
  EXPECT_DOUBLE_EQ(tau->value, value);
  ASSERT_TRUE(tau->interval);
  EXPECT_DOUBLE_EQ(tau->interval->low, low);
  EXPECT_DOUBLE_EQ(tau->interval->high, high);
}

/// The rows, and the same of another log.
std::vector<PredictionRow> of_two_logs(std::vector<PredictionRow> rows) {
  std::vector<PredictionRow> both = rows;
  for (PredictionRow& row : rows) {
    row.log.log = row.twin.log = "other";
    both.push_back(row);
  }
  return both;
}

TEST(ByLocalizer, IsTheMeanOverLogsThatCountTheSame) {
  const auto found = by_localizer({
      prediction_row("short", "a", {true, false}, {1.0, 1.0}),
      prediction_row("short", "b", {false, false}, {0.0, 0.0}),
      prediction_row("long", "a", {true, true, true, true}, {0.5, 0.7, 0.3, 0.5}),
      prediction_row("long", "b", {true, false, false, false}, {0.2, 0.0, 0.0, 0.0}),
  });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].localizer, "a");
  EXPECT_DOUBLE_EQ(found[0].measured, 0.75);   // of 1/2 and 4/4
  EXPECT_DOUBLE_EQ(found[0].predicted, 0.75);  // of 1 and 0.5
  EXPECT_DOUBLE_EQ(found[0].apart, 0.5);       // 0.5 each, one above and one below
  EXPECT_EQ(found[1].localizer, "b");
  EXPECT_DOUBLE_EQ(found[1].measured, 0.125);   // of 0 and 1/4
  EXPECT_DOUBLE_EQ(found[1].predicted, 0.025);  // of 0 and 0.05
  EXPECT_DOUBLE_EQ(found[1].apart, 0.1);        // of 0 and 0.2
}

TEST(ByLocalizer, CountsLogsWhoseTrackingErrorIsWithinAQuarter) {
  const auto row = [](const std::string& log, std::optional<double> log_m,
                      std::optional<double> twin_m) {
    return with_tracking(equal_trials(log, "a", true, 1.0), log_m, twin_m);
  };
  const auto near_of = [&](const std::vector<PredictionRow>& rows) {
    const LocalizerAgreement a = by_localizer(rows).at(0);
    return std::pair(a.tracked_near, a.tracked);
  };
  EXPECT_EQ(near_of({row("l", 0.4, 0.49)}), std::pair(1, 1));
  EXPECT_EQ(near_of({row("l", 0.4, 0.51)}), std::pair(0, 1));
  EXPECT_EQ(near_of({row("l", 0.4, 0.31)}), std::pair(1, 1));
  EXPECT_EQ(near_of({row("l", 0.4, 0.29)}), std::pair(0, 1));
  EXPECT_EQ(near_of({row("k", 0.4, 0.4), row("l", {}, 0.4), row("m", 0.4, {}), row("n", 0.4, 0.8)}),
            std::pair(1, 2));
}

TEST(ByLocalizer, HasNothingOfNoRows) { EXPECT_TRUE(by_localizer({}).empty()); }

TEST(RankAgreement, IsOneForTheSameOrderAndMinusOneForTheReverse) {
  expect_figure(
      of_two_logs({equal_trials("l", "a", true, 0.6), equal_trials("l", "b", false, 0.5)}), 1.0,
      1.0, 1.0);
  expect_figure(
      of_two_logs({equal_trials("l", "a", true, 0.5), equal_trials("l", "b", false, 0.6)}), -1.0,
      -1.0, -1.0);
}

TEST(RankAgreement, OfOneLogHasNoInterval) {
  const auto tau =
      rank_agreement({equal_trials("l", "a", true, 0.6), equal_trials("l", "b", false, 0.5)});
  ASSERT_TRUE(tau);
  EXPECT_DOUBLE_EQ(tau->value, 1.0);
  EXPECT_FALSE(tau->interval);
}

TEST(RankAgreement, CountsTies) {
  const std::vector<bool> half{true, false};
  const auto tau = rank_agreement({prediction_row("l", "a", {true, true}, {0.5, 0.5}),
                                   prediction_row("l", "b", half, {0.5, 0.5}),
                                   prediction_row("l", "c", {false, false}, {0.0, 0.0})});
  ASSERT_TRUE(tau);
  EXPECT_DOUBLE_EQ(tau->value, 2.0 / std::sqrt(3.0 * 2.0));  // a and b are equal in the twin
}

TEST(RankAgreement, IsOfMeansOverLogs) {
  // Both recover in two trials of six, but a in all of the short log; the long one alone prefers b.
  expect_figure(
      {
          equal_trials("short", "a", true, 0.6),
          equal_trials("short", "b", false, 0.4),
          prediction_row("long", "a", {0, 0, 0, 0}, {0.6, 0.6, 0.6, 0.6}),
          prediction_row("long", "b", {0, 0, 1, 1}, {0.4, 0.4, 0.4, 0.4}),
      },
      1.0, -1.0, 1.0);
}

TEST(RankAgreement, IsUncertainWhereTrialsDecide) {
  // a is better by one trial of ten, and they fail in different ones.
  const std::vector<double> six(10, 0.6);
  const std::vector<double> four(10, 0.4);
  const PredictionRow a = prediction_row("l", "a", {1, 1, 1, 1, 1, 0, 0, 0, 0, 0}, six);
  const PredictionRow b = prediction_row("l", "b", {0, 0, 0, 0, 0, 0, 1, 1, 1, 1}, four);
  expect_figure(of_two_logs({a, b}), 1.0, -1.0, 1.0);
}

TEST(RankAgreement, DrawsTheSameTrialsForAllLocalizers) {
  // Wherever b recovers, a does, too: no sample of the trials puts b first.
  const std::vector<double> six(10, 0.6);
  const std::vector<double> four(10, 0.4);
  const PredictionRow a = prediction_row("l", "a", {1, 1, 1, 1, 1, 0, 0, 0, 0, 0}, six);
  const PredictionRow b = prediction_row("l", "b", {1, 1, 1, 1, 0, 0, 0, 0, 0, 0}, four);
  expect_figure(of_two_logs({a, b}), 1.0, 1.0, 1.0);
}

TEST(RankAgreement, IsUncertainWhereLogsDisagree) {
  // Of three drawn logs, two or three are the third with a probability of 7/27.
  std::vector<PredictionRow> rows;
  for (const std::string log : {"k", "l", "m"}) {
    rows.push_back(equal_trials(log, "a", log != "m", 0.8));
    rows.push_back(equal_trials(log, "b", log == "m", 0.2));
  }
  expect_figure(rows, 1.0, -1.0, 1.0);
}

TEST(RankAgreement, IsNothingWithoutARanking) {
  EXPECT_FALSE(rank_agreement({}));
  EXPECT_FALSE(rank_agreement({equal_trials("l", "a", true, 0.5)}));
  EXPECT_FALSE(
      rank_agreement({equal_trials("l", "a", true, 0.5), equal_trials("l", "b", true, 0.1)}));
  EXPECT_FALSE(
      rank_agreement({equal_trials("l", "a", true, 0.5), equal_trials("l", "b", false, 0.5)}));
  EXPECT_FALSE(
      rank_agreement({prediction_row("l", "a", {}, {}), prediction_row("l", "b", {}, {})}));
}

}  // namespace
}  // namespace castaway::testbed
