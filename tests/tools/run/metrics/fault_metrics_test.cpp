#include "tools/run/metrics/fault_metrics.hpp"

#include <gtest/gtest.h>

#include "castaway/stamp.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

using localization::from_seconds;

RunEvent event(double t, const std::string& kind, const std::string& detail) {
  return {from_seconds(t), event_named(kind, detail).value()};
}

/// A row at `t` [s] with a position error of `error_m`.
MetricRow row(double t, double error_m, bool lost = false) {
  MetricRow result;
  result.stamp = result.delivered = from_seconds(t);
  result.T_map_base_true = SE2{};
  result.T_map_base_estimate = SE2{error_m, 0.0, 0.0};
  result.lost = lost;
  return result;
}

TEST(FaultWindows, ReachFromOnToOff) {
  const auto windows =
      fault_windows({event(2, "fault on", "lidar-late"),
                     event(3, "fault on", "lidar-dropout front"), event(4, "kidnap", "teleport"),
                     event(5, "fault off", "lidar-late"), event(6, "fault on", "odometry-reset")},
                    from_seconds(20));
  ASSERT_EQ(windows.size(), 3U);
  EXPECT_EQ(windows[0].begin, from_seconds(2));
  EXPECT_EQ(windows[0].end, from_seconds(5));
  EXPECT_EQ(windows[1].fault,
            sim::FaultEdge::What(sim::SensorFault{sim::FaultKind::kLidarDropout, "front"}));
  EXPECT_EQ(windows[1].end, from_seconds(20));  // It never ended.
  EXPECT_EQ(windows[2].end, from_seconds(6));
}

TEST(FaultMetrics, CountRowsOfTheFaultAndFiveSecondsAfter) {
  const std::vector<MetricRow> rows = {row(1, 9.0), row(2, 0.1), row(4, 0.7), row(8.9, 0.4),
                                       row(9, 9.0)};
  const FaultMetrics metrics = measure_fault(rows, {{}, from_seconds(2), from_seconds(4)});
  EXPECT_NEAR(*metrics.mean_error_m, 0.4, 1e-12);
  EXPECT_NEAR(*metrics.wrong_confident_share, 1.0 / 3.0, 1e-12);
  EXPECT_FALSE(metrics.alarm);
}

TEST(FaultMetrics, AnAlarmExcusesAWrongPose) {
  const FaultMetrics metrics =
      measure_fault({row(2, 3.0, true)}, {{}, from_seconds(2), from_seconds(4)});
  EXPECT_EQ(metrics.wrong_confident_share, 0.0);
  EXPECT_TRUE(metrics.alarm);
}

TEST(FaultMetrics, WithoutRowsThereAreNone) {
  EXPECT_FALSE(measure_fault({}, {{}, from_seconds(2), from_seconds(4)}).mean_error_m);
}

}  // namespace
}  // namespace castaway::testbed
