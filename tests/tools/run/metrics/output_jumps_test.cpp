#include "tools/run/metrics/output_jumps.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/metric_rows.hpp"

namespace castaway::testbed {
namespace {

TEST(OutputJumps, OfAnOutputThatMovesAsOdometryDoesAreNone) {
  const OutputJumps jumps = jumps_of(rows_with({0.4, 0.4, 0.4, 0.4}), {});
  EXPECT_EQ(jumps.count, 0);
  EXPECT_NEAR(jumps.largest_m, 0.0, 1e-12);
}

TEST(OutputJumps, AreCountedFromTheirThresholdsOn) {
  std::vector<MetricRow> rows = rows_with({0.0, 0.19, 0.4, 0.4, 0.4});
  rows[3].T_map_base_estimate->yaw = 0.15;
  rows[4].T_map_base_estimate->yaw = -0.1;
  const OutputJumps jumps = jumps_of(rows, {});
  EXPECT_EQ(jumps.count, 2);  // 0.21 m to row 2, 0.25 rad to row 4
  EXPECT_EQ(jumps.while_tracking, 2);
  EXPECT_NEAR(jumps.largest_m, 0.21, 1e-12);
}

TEST(OutputJumps, AreSeenAcrossRowsWithoutAnswer) {
  std::vector<MetricRow> rows = rows_with({0.0, 0.0, 1.0});
  rows[1].T_map_base_estimate.reset();
  EXPECT_EQ(jumps_of(rows, {}).count, 1);
}

TEST(OutputJumps, OfARecoveryAreNotWhileTracking) {
  RecoveryWindow window;
  window.taken = window.begin = from_seconds(0.5);
  window.recovered = from_seconds(2.0);
  window.end = from_seconds(10.0);
  const OutputJumps jumps = jumps_of(rows_with({0.0, 4.0, 0.0, 0.0, 1.0}), {window});
  EXPECT_EQ(jumps.count, 3);
  EXPECT_EQ(jumps.while_tracking, 1);  // the jump at 4 s
  EXPECT_NEAR(jumps.largest_m, 4.0, 1e-12);
}

}  // namespace
}  // namespace castaway::testbed
