#include "tools/run/metrics/localizer_metrics.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/metric_rows.hpp"

namespace castaway::testbed {
namespace {

LocalizerMetrics measured(const std::vector<MetricRow>& rows, const std::vector<RunEvent>& events,
                          bool known_start = true) {
  return measure(rows, events, known_start, from_seconds(static_cast<double>(rows.size())));
}

TEST(LocalizerMetrics, TakeErrorsOverAllRowsWithTruthAndEstimate) {
  std::vector<MetricRow> rows = rows_with({0.1, 0.3, 9.0, 9.0});
  rows[1] = row_at(1.0, 0.3, -0.2);
  rows[2].T_map_base_true.reset();
  rows[3].T_map_base_estimate.reset();
  const LocalizerMetrics metrics = measured(rows, {});
  EXPECT_DOUBLE_EQ(metrics.position_error_m->mean, 0.2);
  EXPECT_DOUBLE_EQ(metrics.position_error_m->max, 0.3);
  EXPECT_DOUBLE_EQ(metrics.yaw_error_rad->mean, 0.1);
  EXPECT_DOUBLE_EQ(metrics.tracking_error_m->mean, 0.2);
}

TEST(LocalizerMetrics, TrackingLeavesOutTheTimeFromAKidnapToItsRecovery) {
  std::vector<double> errors(20, 0.1);
  errors[5] = errors[6] = 3.0;
  const LocalizerMetrics metrics = measured(rows_with(errors), {kidnap_at(5.0)});
  EXPECT_DOUBLE_EQ(metrics.tracking_error_m->max, 0.1);
  EXPECT_DOUBLE_EQ(metrics.position_error_m->max, 3.0);
  EXPECT_EQ(metrics.events, 1);
  EXPECT_EQ(metrics.recovered, 1);
  EXPECT_EQ(metrics.success, 1.0);
  EXPECT_DOUBLE_EQ(metrics.recovery_time_s->mean, 2.0);
  EXPECT_NEAR(metrics.recovery_distance_m->mean, 0.2, 1e-12);
}

TEST(LocalizerMetrics, CountEveryScoredEvent) {
  std::vector<double> errors(30, 0.0);
  errors[19] = 3.0;  // no recovery from the second kidnap
  const LocalizerMetrics metrics =
      measured(rows_with(errors), {kidnap_at(5.0), kidnap_at(12.0), kidnap_at(20.0),
                                   kidnap_at(28.0)});  // the last one leaves only 2 s
  EXPECT_EQ(metrics.events, 3);
  EXPECT_EQ(metrics.recovered, 2);
  EXPECT_DOUBLE_EQ(*metrics.success, 2.0 / 3.0);
  EXPECT_EQ(metrics.windows.size(), 4U);
}

TEST(LocalizerMetrics, AnUnknownStartIsAnEventWithoutDetection) {
  const LocalizerMetrics metrics =
      measured(rows_with({5.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}), {}, false);
  EXPECT_EQ(metrics.events, 1);
  EXPECT_EQ(metrics.recovered, 1);
  EXPECT_DOUBLE_EQ(metrics.recovery_time_s->mean, 3.0);
  EXPECT_DOUBLE_EQ(metrics.tracking_error_m->max, 0.0);
  EXPECT_FALSE(metrics.detection_delay_s);
  EXPECT_EQ(metrics.undetected, 0);
}

TEST(LocalizerMetrics, WrongLockIsWrongWithoutAlarm) {
  std::vector<MetricRow> rows = rows_with({0.0, 0.5, 2.0, 2.0, 0.0, 0.0, 9.0, 9.0});
  rows[3].lost = true;
  rows[4] = row_at(4.0, 0.0, 0.4);
  rows[6].T_map_base_true.reset();
  rows[7].T_map_base_estimate.reset();
  EXPECT_DOUBLE_EQ(*measured(rows, {}).wrong_lock_share, 3.0 / 6.0);  // rows 1, 2 and 4 of 0 to 5
}

TEST(LocalizerMetrics, DetectionDelayIsFromTheKidnapToTheDeliveredAnswer) {
  std::vector<MetricRow> rows = rows_with(std::vector<double>(20, 3.0));
  rows[6].lost = true;
  rows[6].delivered = from_seconds(6.25);
  const LocalizerMetrics metrics = measured(rows, {kidnap_at(4.0)});
  ASSERT_TRUE(metrics.detection_delay_s);
  EXPECT_DOUBLE_EQ(metrics.detection_delay_s->mean, 2.25);
  EXPECT_EQ(metrics.undetected, 0);
}

TEST(LocalizerMetrics, DetectionMayComeFromAScanThatBeganBeforeTheKidnap) {
  std::vector<MetricRow> rows = rows_with(std::vector<double>(20, 3.0));
  rows[4].lost = true;
  rows[4].delivered = from_seconds(4.75);
  const LocalizerMetrics metrics = measured(rows, {kidnap_at(4.5)});
  ASSERT_TRUE(metrics.detection_delay_s);
  EXPECT_DOUBLE_EQ(metrics.detection_delay_s->max, 0.25);
}

TEST(LocalizerMetrics, KidnapsThatNobodyNoticesAreCounted) {
  const LocalizerMetrics metrics =
      measured(rows_with(std::vector<double>(20, 3.0)), {kidnap_at(4.0), kidnap_at(12.0)});
  EXPECT_FALSE(metrics.detection_delay_s);
  EXPECT_EQ(metrics.undetected, 2);
}

TEST(LocalizerMetrics, CompareStatedProbabilityAndOutcome) {
  std::vector<MetricRow> rows = rows_with({0.0, 0.0, 3.0});
  for (MetricRow& row : rows) row.probability = 0.6;
  const LocalizerMetrics metrics = measured(rows, {});
  EXPECT_EQ(metrics.calibration.bins[6].scans, 3);
  EXPECT_EQ(metrics.calibration.bins[6].right, 2);
}

TEST(LocalizerMetrics, TellHowLongTheOutputWasWrongWithoutSayingSo) {
  std::vector<MetricRow> rows = rows_with({2.0, 0.0, 2.0, 2.0, 2.0, 0.0, 2.0});
  rows[6].lost = true;
  const LocalizerMetrics metrics = measured(rows, {});
  EXPECT_DOUBLE_EQ(metrics.wrong_lock_s, 4.0);
  EXPECT_DOUBLE_EQ(metrics.longest_wrong_lock_s, 3.0);
}

TEST(LocalizerMetrics, TheLastScanIsWrongUntilTheEnd) {
  const LocalizerMetrics metrics = measure(rows_with({0.0, 0.0, 2.0}), {}, true, from_seconds(6.5));
  EXPECT_DOUBLE_EQ(metrics.wrong_lock_s, 4.5);
  EXPECT_DOUBLE_EQ(metrics.longest_wrong_lock_s, 4.5);
}

TEST(LocalizerMetrics, AvailabilityIsTheShareOfScansAnsweredWithoutAlarm) {
  std::vector<MetricRow> rows = rows_with({0.0, 3.0, 0.0, 0.0, 0.0});
  rows[2].lost = true;
  rows[3].T_map_base_estimate.reset();
  rows[4].T_map_base_true.reset();  // not scored
  EXPECT_DOUBLE_EQ(*measured(rows, {}).availability, 0.5);
}

TEST(LocalizerMetrics, ApeTakesTornScansToo) {
  std::vector<MetricRow> rows = rows_with({0.0, 4.0, 0.0, 0.0});
  rows[1].delivered = from_seconds(1.9);
  const LocalizerMetrics metrics = measured(rows, {kidnap_at(1.5)});
  EXPECT_EQ(metrics.position_error_m->max, 0.0);
  EXPECT_EQ(metrics.ape->pairs, 4U);
  EXPECT_EQ(metrics.ape->max, 4.0);
}

TEST(LocalizerMetrics, ErrorsHaveIntervalsOnceThereAreTwoBlocksOfFiveSeconds) {
  EXPECT_FALSE(
      measured(rows_with(std::vector<double>(9, 0.1)), {}).position_error_m->mean_interval);
  const LocalizerMetrics metrics = measured(rows_with(std::vector<double>(10, 0.125)), {});
  ASSERT_TRUE(metrics.position_error_m->mean_interval);
  EXPECT_DOUBLE_EQ(metrics.position_error_m->mean_interval->low, 0.125);
  EXPECT_DOUBLE_EQ(metrics.tracking_error_m->median_interval->high, 0.125);
}

TEST(FalseAlarms, AreOnsetsWhileTheOutputIsRight) {
  std::vector<MetricRow> rows = right_rows(36);
  rows[3].lost = rows[4].lost = true;  // one alarm over two rows
  rows[10].lost = true;
  rows[20] = row_at(20.0, 3.0);
  rows[20].lost = true;  // output is wrong: a true alarm
  EXPECT_DOUBLE_EQ(*measured(rows, {}).false_alarms_per_h, 2.0 * 3600.0 / 36.0);
  EXPECT_EQ(measured(rows, {}).false_alarms, 2);
  EXPECT_DOUBLE_EQ(measured(rows, {}).watched_s, 36.0);
}

TEST(FalseAlarms, WithinFiveSecondsOfAKidnapAreItsAnswer) {
  std::vector<MetricRow> rows = right_rows(41);
  rows[14].lost = true;  // 4 s after the kidnap, although the output is already right
  const double watched_s = 41.0 - 5.0;
  EXPECT_EQ(measured(rows, {kidnap_at(10.0)}).false_alarms_per_h, 0.0);
  rows[16].lost = true;
  EXPECT_DOUBLE_EQ(*measured(rows, {kidnap_at(10.0)}).false_alarms_per_h, 3600.0 / watched_s);
}

TEST(FalseAlarms, AreTimedByDelivery) {
  std::vector<MetricRow> rows = right_rows(41);
  rows[9].lost = true;
  EXPECT_GT(*measured(rows, {kidnap_at(9.5)}).false_alarms_per_h, 0.0);
  rows[9].delivered = from_seconds(9.75);  // its last beams were taken after the kidnap
  EXPECT_EQ(measured(rows, {kidnap_at(9.5)}).false_alarms_per_h, 0.0);
  rows[9].lost = false;
  rows[14].lost = true;
  rows[14].delivered = from_seconds(14.75);  // its first beam is within 5 s, its answer is not
  EXPECT_GT(*measured(rows, {kidnap_at(9.5)}).false_alarms_per_h, 0.0);
}

TEST(FalseAlarms, DoNotCountBeforeTheRecovery) {
  std::vector<double> errors(40, 0.0);
  errors[18] = 3.0;
  std::vector<MetricRow> rows = rows_with(errors);
  rows[16].lost = true;  // right by chance, 8 s before the recovery is stable
  EXPECT_EQ(measured(rows, {kidnap_at(10.0)}).false_alarms_per_h, 0.0);
}

TEST(LocalizerMetrics, AreNothingWithoutTruth) {
  std::vector<MetricRow> rows = right_rows(20);
  for (MetricRow& row : rows) row.T_map_base_true.reset();
  const LocalizerMetrics metrics = measured(rows, {});
  EXPECT_FALSE(metrics.position_error_m);
  EXPECT_FALSE(metrics.tracking_error_m);
  EXPECT_FALSE(metrics.wrong_lock_share);
  EXPECT_FALSE(metrics.success);
  EXPECT_FALSE(metrics.false_alarms_per_h);
}

TEST(LocalizerMetrics, OfNoEstimateAreAnUnrecoveredEvent) {
  std::vector<MetricRow> rows = right_rows(20);
  for (MetricRow& row : rows) row.T_map_base_estimate.reset();
  const LocalizerMetrics metrics = measured(rows, {}, false);
  EXPECT_FALSE(metrics.position_error_m);
  EXPECT_EQ(metrics.events, 1);
  EXPECT_EQ(metrics.success, 0.0);
  EXPECT_FALSE(metrics.recovery_time_s);
  EXPECT_FALSE(metrics.wrong_lock_share);
}

TEST(LocalizerMetrics, OfNoRowsAreNothing) {
  const LocalizerMetrics metrics = measured({}, {kidnap_at(1.0)}, false);
  EXPECT_EQ(metrics.events, 0);
  EXPECT_FALSE(metrics.position_error_m);
  EXPECT_FALSE(metrics.false_alarms_per_h);
}

}  // namespace
}  // namespace castaway::testbed
