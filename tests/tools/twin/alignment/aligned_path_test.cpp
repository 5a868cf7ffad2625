#include "tools/twin/alignment/aligned_path.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "localization/geometry/transform_buffer.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

/// Odometry every 10 ms until 4 s, by time in seconds.
template <typename PoseAt>
AlignedLog log_moving(const PoseAt& T_odom_base_at) {
  AlignedLog log;
  log.T_path_base = localization::TransformBuffer({.length = std::chrono::hours(1)});
  for (int k = 0; k <= 400; ++k) {
    log.T_path_base.add(milliseconds(10 * k), T_odom_base_at(0.01 * k));
  }
  return log;
}

/// Stands for 0.5 s, then drives on at 1 m/s.
SE2 stand_then_drive(double t) { return {std::max(t - 0.5, 0.0), 0.0, 0.0}; }

void add_aligned(Stamp stamp, const SE2& T_map_base, AlignedLog& log) {
  AlignedScan aligned;
  aligned.scan.stamp = stamp;
  aligned.T_map_base = T_map_base;
  log.scans.push_back(aligned);
}

TEST(AlignedPath, KeepsThePosesOfTheScans) {
  AlignedLog log = log_moving(&stand_then_drive);
  add_aligned(milliseconds(70), {1.0, 2.0, 3.0}, log);
  add_aligned(milliseconds(170), {-4.0, 5.0, -3.0}, log);
  add_aligned(milliseconds(230), {7.0, 8.0, 0.5}, log);
  const std::vector<PathPose> path = path_of(log);
  ASSERT_EQ(path.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(path[k].stamp, log.scans[k].scan.stamp);
    EXPECT_EQ(path[k].T_map_base, log.scans[k].T_map_base);
  }
}

TEST(AlignedPath, DividesGapsIntoEqualPartsOfAtMost100Milliseconds) {
  AlignedLog log = log_moving(&stand_then_drive);
  for (const int ms : {0, 100, 201, 501}) add_aligned(milliseconds(ms), {}, log);
  std::vector<std::int64_t> microseconds;
  for (const PathPose& pose : path_of(log)) microseconds.push_back(pose.stamp.count() / 1000);
  EXPECT_EQ(microseconds,
            (std::vector<std::int64_t>{0, 100000, 150500, 201000, 301000, 401000, 501000}));
}

TEST(AlignedPath, HasTheShapeOfOdometry) {
  AlignedLog log = log_moving(&stand_then_drive);
  const SE2 T_map_odom{3.0, 4.0, 0.7};
  add_aligned(milliseconds(0), T_map_odom, log);
  add_aligned(milliseconds(1000), T_map_odom * stand_then_drive(1.0), log);
  const std::vector<PathPose> path = path_of(log);
  ASSERT_EQ(path.size(), 11U);
  for (std::size_t k = 0; k < path.size(); ++k) {
    const SE2 T_map_base = T_map_odom * stand_then_drive(0.1 * static_cast<double>(k));
    EXPECT_LT(localization::distance(path[k].T_map_base, T_map_base), 1e-9) << k;
    EXPECT_LT(localization::yaw_distance(path[k].T_map_base, T_map_base), 1e-9) << k;
  }
}

TEST(AlignedPath, IsBentToEndAtTheNextScan) {
  AlignedLog log = log_moving([](double t) { return SE2{t, 0.0, 0.0}; });
  add_aligned(milliseconds(0), {}, log);
  // Odometry says 1 m ahead.
  add_aligned(milliseconds(1000), {1.1, 0.2, 0.1}, log);
  const std::vector<PathPose> path = path_of(log);
  ASSERT_EQ(path.size(), 11U);
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double part = 0.1 * static_cast<double>(k);
    EXPECT_NEAR(path[k].T_map_base.x, 1.1 * part, 1e-9);
    EXPECT_NEAR(path[k].T_map_base.y, 0.2 * part, 1e-9);
    EXPECT_NEAR(path[k].T_map_base.yaw, 0.1 * part, 1e-9);
  }
}

TEST(AlignedPath, TurnsTheWayThatOdometryDid) {
  // Three quarters of a turn to the left, which would be one to the right by the shorter way.
  AlignedLog log = log_moving([](double t) { return SE2{0.0, 0.0, 1.5 * std::numbers::pi * t}; });
  add_aligned(milliseconds(0), {}, log);
  add_aligned(milliseconds(1000), {0.0, 0.0, -0.5 * std::numbers::pi}, log);
  const std::vector<PathPose> path = path_of(log);
  ASSERT_EQ(path.size(), 11U);
  EXPECT_NEAR(path[4].T_map_base.yaw, 0.6 * std::numbers::pi, 1e-9);
}

TEST(AlignedPath, HasNothingBetweenWhereTheRobotWasMoved) {
  AlignedLog log = log_moving(&stand_then_drive);
  add_aligned(milliseconds(0), {}, log);
  add_aligned(milliseconds(1000), {9.0, 9.0, 0.0}, log);
  log.scans.back().breaks = true;
  add_aligned(milliseconds(1200), {9.2, 9.0, 0.0}, log);
  EXPECT_EQ(path_of(log).size(), 4U);
}

TEST(AlignedPath, HasNothingBetweenWhereOdometryIsUnknown) {
  AlignedLog log = log_moving(&stand_then_drive);
  add_aligned(milliseconds(3900), {}, log);
  add_aligned(milliseconds(5000), {}, log);  // odometry ends at 4 s
  EXPECT_EQ(path_of(log).size(), 2U);
}

TEST(AlignedPath, LeavesOutScansThatAreNotLater) {
  AlignedLog log = log_moving(&stand_then_drive);
  add_aligned(milliseconds(100), {1.0, 0.0, 0.0}, log);
  add_aligned(milliseconds(100), {2.0, 0.0, 0.0}, log);
  add_aligned(milliseconds(50), {3.0, 0.0, 0.0}, log);
  add_aligned(milliseconds(200), {4.0, 0.0, 0.0}, log);
  const std::vector<PathPose> path = path_of(log);
  ASSERT_EQ(path.size(), 2U);
  EXPECT_EQ(path[0].T_map_base.x, 1.0);
  EXPECT_EQ(path[1].T_map_base.x, 4.0);
}

TEST(PlayedTimes, AreThoseFromTheFirstAlignedScanToTheLast) {
  AlignedLog log;
  add_aligned(milliseconds(200), {}, log);
  add_aligned(milliseconds(500), {}, log);
  for (const int ms : {100, 200, 400, 300, 500, 600}) log.stamps.push_back(milliseconds(ms));
  EXPECT_EQ(played_times(log), (std::vector<Stamp>{milliseconds(0), milliseconds(100),
                                                   milliseconds(200), milliseconds(300)}));
}

TEST(PlayedTimes, OfALogWithOneScanIsItsBeginning) {
  AlignedLog log;
  add_aligned(milliseconds(200), {}, log);
  for (const int ms : {100, 200, 300}) log.stamps.push_back(milliseconds(ms));
  EXPECT_EQ(played_times(log), std::vector<Stamp>{Stamp{}});
}

}  // namespace
}  // namespace castaway::testbed
