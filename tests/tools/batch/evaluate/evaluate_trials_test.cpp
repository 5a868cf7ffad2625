// Trials on several recordings of one place.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_office.hpp"
#include "tools/batch/evaluate/evaluation.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

/// Two starts, a kidnap, and tracking.
EvaluationConfig each_kind() {
  EvaluationConfig config;
  config.starts = 2;
  config.kidnaps = 1;
  config.window_s = 8.0;
  config.scans_before_kidnap = 10;
  return config;
}

/// The same frames with true poses 2 m off.
Frames with_wrong_truth(Frames frames) {
  for (Frame& frame : frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      scan->true_pose = SE2{2.0, 0.0, 0.0} * scan->true_pose->T_map_base;
    }
  }
  return frames;
}

/// The text of a row without CPU times.
std::string without_cpu(EvaluationRow row) {
  row.cpu_total_ms = row.cpu_max_ms = 0.0;
  return pack_row(row);
}

TEST(EvaluateTrials, AreStartsThenKidnapsThenTrackingOfEachRecording) {
  const RecordedPlace place = recorded_office(120);
  const Frames wrong = with_wrong_truth(place.frames);
  int done = 0;
  const auto rows = evaluate_trials(place, {&place.frames, &wrong}, parse_localizer("mh_amcl"),
                                    each_kind(), [&] { ++done; });
  EXPECT_EQ(done, 8);
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& recording : rows) {
    ASSERT_EQ(recording.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(recording[i].starts.trials, i < 2 ? 1 : 0) << i;
      EXPECT_EQ(recording[i].kidnaps.trials, i == 2 ? 1 : 0) << i;
      EXPECT_EQ(recording[i].tracking_m.has_value(), i == 3) << i;
    }
  }
  for (const std::size_t start : {0U, 1U}) {
    EXPECT_EQ(rows[0][start].starts.recovered, 1);
    EXPECT_EQ(rows[1][start].starts.recovered, 0);
  }
}

TEST(EvaluateTrials, OfEachRecordingAreThoseOfThatRecordingAlone) {
  const RecordedPlace place = recorded_office(120);
  RecordedPlace other = place;
  other.frames = with_wrong_truth(place.frames);
  const LocalizerSpec amcl = parse_localizer("amcl");
  EvaluationConfig config = each_kind();
  const auto rows = evaluate_trials(place, {&place.frames, &other.frames}, amcl, config);
  EXPECT_EQ(without_cpu(sum_trials(place, amcl, rows[0])),
            without_cpu(evaluate(place, amcl, config)));
  EXPECT_EQ(without_cpu(sum_trials(place, amcl, rows[1])),
            without_cpu(evaluate(other, amcl, config)));
  EXPECT_NE(without_cpu(sum_trials(place, amcl, rows[0])),
            without_cpu(sum_trials(place, amcl, rows[1])));
  config.tracking = false;
  config.run = run_at_once(2);
  const auto untracked = evaluate_trials(place, {&place.frames, &other.frames}, amcl, config);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(untracked[k].size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(without_cpu(untracked[k][i]), without_cpu(rows[k][i])) << k << " " << i;
    }
  }
}

TEST(SumTrials, NamesTheLogAndSortsTheTimes) {
  RecordedPlace place;
  place.name = "hall";
  EvaluationRow slow;
  slow.starts = {1, 1, {9.0}, {4.0}};
  EvaluationRow fast;
  fast.starts = {1, 1, {2.0}, {7.0}};
  const EvaluationRow sum = sum_trials(place, parse_localizer("amcl"), {slow, fast});
  EXPECT_EQ(sum.log, "hall");
  EXPECT_EQ(sum.localizer, "amcl");
  EXPECT_EQ(sum.starts.recovered, 2);
  EXPECT_EQ(sum.starts.time_s, (std::vector<double>{2.0, 9.0}));
  EXPECT_EQ(sum.starts.distance_m, (std::vector<double>{4.0, 7.0}));
}

TEST(ScanOfTrial, IsEvenlySpreadAwayFromTheEnd) {
  EXPECT_EQ(scan_of_trial(120, 0, 4), 0U);  // 80 scans are far enough from the end
  EXPECT_EQ(scan_of_trial(120, 1, 4), 20U);
  EXPECT_EQ(scan_of_trial(120, 3, 4), 60U);
  EXPECT_EQ(scan_of_trial(30, 3, 4), 0U);
}

TEST(TrackingWithoutAlarm, IsThatOfAllScansForALocalizerWithoutAlarms) {
  EvaluationConfig config = each_kind();
  config.starts = config.kidnaps = 0;
  const RecordedPlace place = recorded_office(60);
  const EvaluationRow row = evaluate(place, parse_localizer("amcl"), config);
  ASSERT_TRUE(row.tracking_m && row.tracking_no_alarm_m);
  EXPECT_GT(*row.tracking_m, 0.0);
  EXPECT_DOUBLE_EQ(*row.tracking_no_alarm_m, *row.tracking_m);
}

TEST(TrackingWithoutAlarm, LeavesOutTheScansWithTheAlarm) {
  EvaluationConfig config = each_kind();
  config.starts = config.kidnaps = 0;
  // In the second half, the lidar is wrapped up at an unknown place.
  RecordedPlace place = recorded_office(80);
  for (Frame& frame : place.frames) {
    auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan == nullptr || frame.stamp < std::chrono::seconds(8)) continue;
    scan->scan.ranges.assign(scan->scan.ranges.size(), 0.3F);
    scan->true_pose = SE2{2.0, 0.0, 0.0} * scan->true_pose->T_map_base;
  }
  const EvaluationRow row = evaluate(place, parse_localizer("mh_amcl"), config);
  ASSERT_TRUE(row.tracking_m && row.tracking_no_alarm_m);
  EXPECT_GT(*row.tracking_m, 0.9);  // 2 m in half of the scans
  EXPECT_LT(*row.tracking_no_alarm_m, 0.5);
}

}  // namespace
}  // namespace castaway::testbed
