#include "tools/batch/evaluate/evaluation_row.hpp"

#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

/// A kidnap that was recovered after `time_s`.
EvaluationRow kidnap(double time_s, bool right) {
  EvaluationRow row;
  row.kidnaps = {1, 1, {time_s}, {0.1}};
  row.scans = 40;
  row.wrong_scans = 3;
  row.longest_wrong_s = time_s;
  row.calibration.add(0.995, right);
  row.detection_delay_s = {1.0 / 3.0};
  row.false_alarms = 1;
  row.watched_s = 1800.0;
  row.cpu_total_ms = 20.0;
  row.updates = 40;
  row.cpu_max_ms = 3.0;
  return row;
}

TEST(EvaluationRow, AddsUp) {
  EvaluationRow sum;
  add(kidnap(2.5, true), sum);
  add(kidnap(1.5, false), sum);
  EvaluationRow tracking;
  tracking.tracking_m = 0.02;
  tracking.tracking_yaw_rad = 0.01;
  tracking.tracking_no_alarm_m = 0.015;
  add(tracking, sum);
  EXPECT_EQ(sum.kidnaps.trials, 2);
  EXPECT_EQ(sum.kidnaps.recovered, 2);
  EXPECT_EQ(sum.kidnaps.time_s, (std::vector<double>{2.5, 1.5}));
  EXPECT_EQ(sum.starts.trials, 0);
  EXPECT_EQ(sum.scans, 80);
  EXPECT_EQ(sum.wrong_scans, 6);
  EXPECT_EQ(sum.longest_wrong_s, 2.5);
  EXPECT_EQ(sum.calibration.bins[9].scans, 2);
  EXPECT_EQ(sum.calibration.bins[9].right, 1);
  EXPECT_EQ(sum.calibration.sure.scans, 2);
  EXPECT_EQ(sum.calibration.sure.right, 1);
  EXPECT_EQ(sum.detection_delay_s.size(), 2U);
  EXPECT_EQ(false_alarms_per_h(sum), 2.0);
  EXPECT_EQ(sum.cpu_mean_ms(), 0.5);
  EXPECT_EQ(sum.cpu_max_ms, 3.0);
  EXPECT_EQ(sum.tracking_m, 0.02);
  add(EvaluationRow{}, sum);
  EXPECT_EQ(sum.tracking_no_alarm_m, 0.015);
}

TEST(EvaluationRow, IsTransferredExactly) {
  EvaluationRow row = kidnap(0.1 + 0.2, true);
  row.tracking_m = 1.0 / 3.0;
  row.tracking_no_alarm_m = 1.0 / 7.0;
  const std::string text = pack_row(row);
  EXPECT_EQ(pack_row(unpack_row(text)), text);
  const EvaluationRow same = unpack_row(text);
  EXPECT_EQ(same.tracking_m, row.tracking_m);
  EXPECT_FALSE(same.tracking_yaw_rad);
  EXPECT_EQ(same.tracking_no_alarm_m, row.tracking_no_alarm_m);
  EXPECT_EQ(to_json(same).at("tracking_no_alarm_m"), 1.0 / 7.0);
  EXPECT_EQ(same.kidnaps.time_s, row.kidnaps.time_s);
  EXPECT_EQ(same.detection_delay_s, row.detection_delay_s);
  EXPECT_EQ(to_json(same), to_json(row));
  EXPECT_EQ(same.calibration.sure.stated_sum, 0.995);
}

TEST(EvaluationRow, RefusesOtherTexts) {
  EXPECT_THROW(unpack_row("[1, 2]"), std::runtime_error);
  EXPECT_THROW(unpack_row("trial"), std::runtime_error);
}

TEST(EvaluationRow, WithoutTrialsHasNoRates) {
  const nlohmann::ordered_json json = to_json(EvaluationRow{});
  EXPECT_TRUE(json.at("false_alarms_per_h").is_null());
  EXPECT_EQ(json.at("cpu_mean_ms"), 0.0);
  EXPECT_FALSE(json.contains("tracking_m"));
}

}  // namespace
}  // namespace castaway::testbed
