#include "tools/run/metrics/run_rows.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/tools/support/metric_rows.hpp"

namespace castaway::testbed {
namespace {

MetricRow true_row(double t, const SE2& truth) {
  MetricRow row = row_at(t);
  row.T_map_base_true = truth;
  return row;
}

TEST(MetricRow, IsAnsweredWhenItIsDeliveredButNeverBeforeItsStamp) {
  MetricRow row = row_at(3.0);
  EXPECT_EQ(row.answered(), from_seconds(3.0));
  row.delivered = from_seconds(3.2);
  EXPECT_EQ(row.answered(), from_seconds(3.2));
}

TEST(PoseError, IsDistanceAndTheShorterTurn) {
  MetricRow row;
  row.T_map_base_true = SE2{1.0, 2.0, 3.0};
  row.T_map_base_estimate = SE2{4.0, -2.0, -3.0};
  const auto error = pose_error(row);
  ASSERT_TRUE(error);
  EXPECT_DOUBLE_EQ(error->position_m, 5.0);
  EXPECT_NEAR(error->yaw_rad, 2.0 * std::numbers::pi - 6.0, 1e-12);
}

TEST(PoseError, NeedsTruthAndEstimate) {
  MetricRow row = row_at(0.0);
  row.T_map_base_estimate.reset();
  EXPECT_FALSE(pose_error(row));
  row = row_at(0.0);
  row.T_map_base_true.reset();
  EXPECT_FALSE(pose_error(row));
}

TEST(Kidnaps, AreTheEventsOfThatKind) {
  RunEvent collision = kidnap_at(1.0);
  collision.what = sim::Collision{};
  const auto kidnaps = kidnaps_of({collision, kidnap_at(2.0), collision, kidnap_at(4.0)});
  ASSERT_EQ(kidnaps.size(), 2U);
  EXPECT_EQ(kidnaps[0].stamp, from_seconds(2.0));
  EXPECT_EQ(kidnaps[1].stamp, from_seconds(4.0));
}

TEST(TornRows, AreThoseThatAKidnapFallsInto) {
  std::vector<MetricRow> rows = right_rows(8);
  for (MetricRow& row : rows) row.delivered = row.stamp + from_seconds(0.9);
  RunEvent carry = kidnap_at(6.5);
  carry.since = from_seconds(4.5);
  rows = mark_torn_rows(std::move(rows), {kidnap_at(1.5), kidnap_at(3.0), carry});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool torn = i == 1 || i == 4 || i == 6;
    EXPECT_EQ(rows[i].torn, torn) << i;
    EXPECT_EQ(pose_error(rows[i]).has_value(), !torn) << i;
  }
}

TEST(DrivenDistance, FollowsTheTruthNotTheOdometry) {
  std::vector<MetricRow> rows{true_row(0.0, {0.0, 0.0, 0.0}), true_row(1.0, {3.0, 4.0, 0.0}),
                              true_row(2.0, {3.0, 3.0, 0.0})};
  EXPECT_EQ(driven_distance(rows, {}), (std::vector<double>{0.0, 5.0, 6.0}));
}

TEST(DrivenDistance, LeavesOutWhatTheRobotIsCarried) {
  RunEvent carry = kidnap_at(2.5);
  carry.since = from_seconds(0.5);
  carry.T_map_from = SE2{0.2, 0.0, 0.0};
  carry.T_map_to = SE2{9.0, 0.0, 0.0};
  std::vector<MetricRow> rows{true_row(0.0, {0.0, 0.0, 0.0}), true_row(1.0, {3.0, 0.0, 0.0}),
                              true_row(2.0, {7.0, 0.0, 0.0}), true_row(3.0, {9.3, 0.0, 0.0})};
  const auto driven = driven_distance(rows, {carry});
  EXPECT_NEAR(driven[1], 0.2, 1e-12);
  EXPECT_NEAR(driven[2], 0.2, 1e-12);
  EXPECT_NEAR(driven[3], 0.5, 1e-12);
}

TEST(DrivenDistance, FollowsOdometryWhereThereIsNoTruth) {
  std::vector<MetricRow> rows{true_row(0.0, {}), true_row(1.0, {2.0, 0.0, 0.0}), row_at(2.0),
                              row_at(3.0)};
  rows[2].T_map_base_true.reset();
  const auto driven = driven_distance(rows, {});
  EXPECT_DOUBLE_EQ(driven[1], 2.0);
  EXPECT_NEAR(driven[2], 2.1, 1e-12);  // 0.1 m per second by odometry
  EXPECT_NEAR(driven[3], 2.2, 1e-12);
}

TEST(DrivenDistance, LeavesOutTheJumpOfAKidnap) {
  const std::vector<MetricRow> rows{true_row(0.0, {}), true_row(1.0, {51.0, 0.0, 0.0})};
  RunEvent kidnap = kidnap_at(0.5);
  EXPECT_NEAR(driven_distance(rows, {kidnap})[1], 0.1, 1e-12);  // poses unknown: by odometry
  kidnap.T_map_from = SE2{0.25, 0.0, 0.0};
  kidnap.T_map_to = SE2{50.0, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(driven_distance(rows, {kidnap})[1], 1.25);
  kidnap.stamp = from_seconds(1.0);  // at the stamp of the later row, which is already displaced
  EXPECT_DOUBLE_EQ(driven_distance(rows, {kidnap})[1], 1.25);
  kidnap.stamp = from_seconds(0.0);  // at the stamp of the earlier row, which is after the kidnap
  EXPECT_DOUBLE_EQ(driven_distance(rows, {kidnap})[1], 51.0);
}

TEST(DrivenDistance, LeavesOutTwoJumpsBetweenTwoRows) {
  const std::vector<MetricRow> rows{true_row(0.0, {}), true_row(1.0, {99.0, 0.0, 0.0})};
  RunEvent first = kidnap_at(0.4);
  first.T_map_from = SE2{0.5, 0.0, 0.0};
  first.T_map_to = SE2{50.0, 0.0, 0.0};
  RunEvent second = kidnap_at(0.8);
  second.T_map_from = SE2{50.5, 0.0, 0.0};
  second.T_map_to = SE2{98.0, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(driven_distance(rows, {first, second})[1], 0.5 + 0.5 + 1.0);
}

}  // namespace
}  // namespace castaway::testbed
