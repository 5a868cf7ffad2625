#include "tools/twin/alignment/expected_scan.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/twin/room_log.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

constexpr double kRoot2 = std::numbers::sqrt2;

/// A scan in the middle of the room, aligned with the grid's axes unless `yaw` turns it.
AlignedScan middle_scan(const AlignedLog& log, double yaw = 0.0) {
  AlignedScan aligned;
  aligned.T_map_base = log.grid.frame.T_map_grid * SE2{4.0, 3.0, yaw};
  aligned.scan = room_scan(log.grid, aligned.T_map_base);
  return aligned;
}

/// The beam of a scan of 360 beams from -180 degrees at an angle in the lidar's plane.
const ExpectedBeam& beam_at(const std::vector<ExpectedBeam>& beams, int degrees) {
  return beams[static_cast<std::size_t>(degrees + 180)];
}

void expect_wall(const ExpectedBeam& beam, double range, double cosine) {
  EXPECT_NEAR(beam.range, range, 1e-5);
  EXPECT_TRUE(beam.wall);
  EXPECT_TRUE(beam.straight);
  EXPECT_NEAR(beam.cosine, cosine, 1e-5);
}

TEST(ExpectedScan, IsRangeAndIncidenceOnTheWalls) {
  const AlignedLog log = standing_log(room_grid());
  const auto beams = expect_scan(log, middle_scan(log), 20.0);
  ASSERT_EQ(beams.size(), 360U);
  expect_wall(beam_at(beams, 0), 3.8, 1.0);
  expect_wall(beam_at(beams, 90), 2.8, 1.0);
  expect_wall(beam_at(beams, 45), 2.8 * kRoot2, 0.5 * kRoot2);
  expect_wall(beam_at(beams, -120), 2.8 * 2.0 / std::sqrt(3.0), 0.5 * std::sqrt(3.0));
  expect_wall(beam_at(beams, 30), 3.8 * 2.0 / std::sqrt(3.0), 0.5 * std::sqrt(3.0));
}

TEST(ExpectedScan, TurnsWithTheRobot) {
  const AlignedLog log = standing_log(room_grid());
  const auto beams = expect_scan(log, middle_scan(log, 0.5 * std::numbers::pi), 20.0);
  expect_wall(beam_at(beams, 0), 2.8, 1.0);
  expect_wall(beam_at(beams, -60), 3.8 * 2.0 / std::sqrt(3.0), 0.5 * std::sqrt(3.0));
}

TEST(ExpectedScan, StartsAtTheLidar) {
  const AlignedLog log = standing_log(room_grid());
  AlignedScan aligned = middle_scan(log);
  aligned.scan.T_base_laser = localization::to_se3({0.3, -0.2, 0.5 * std::numbers::pi});
  const auto beams = expect_scan(log, aligned, 20.0);
  expect_wall(beam_at(beams, 0), 3.0, 1.0);    // to the left of the robot
  expect_wall(beam_at(beams, -90), 3.5, 1.0);  // ahead
  // Upside down, its angles run clockwise.
  aligned.scan.T_base_laser.linear() =
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).matrix();
  expect_wall(beam_at(expect_scan(log, aligned, 20.0), 90), 2.6, 1.0);
}

TEST(ExpectedScan, IsNotStraightAtCorners) {
  const AlignedLog log = standing_log(room_grid());
  const auto beams = expect_scan(log, middle_scan(log), 20.0);
  const double corner = std::atan2(2.8, 3.8) * 180.0 / std::numbers::pi;  // 36.4 degrees
  const int before = static_cast<int>(corner);
  for (const int degrees : {before, before + 1, -before, 180 - before}) {
    EXPECT_TRUE(beam_at(beams, degrees).wall);
    EXPECT_FALSE(beam_at(beams, degrees).straight) << degrees;
    EXPECT_EQ(beam_at(beams, degrees).cosine, 0.0F);
  }
  EXPECT_TRUE(beam_at(beams, before - 4).straight);
  EXPECT_TRUE(beam_at(beams, before + 5).straight);
  EXPECT_FALSE(beams.front().straight);  // without a neighbour
  EXPECT_FALSE(beams.back().straight);
}

TEST(ExpectedScan, IsNotStraightOnThinPillarsAndFarSparseWalls) {
  const AlignedLog pillars = pillars_log(1);
  const auto on_pillars = expect_scan(pillars, pillars.scans[0], 20.0);
  EXPECT_TRUE(std::any_of(on_pillars.begin(), on_pillars.end(), [](auto& b) { return b.wall; }));
  EXPECT_TRUE(
      std::none_of(on_pillars.begin(), on_pillars.end(), [](auto& b) { return b.straight; }));
  const AlignedLog log = standing_log(room_grid());
  AlignedScan sparse = middle_scan(log);
  sparse.scan = room_scan(log.grid, sparse.T_map_base, {}, 12);  // ends are 1.5 m and more apart
  const auto beams = expect_scan(log, sparse, 20.0);
  EXPECT_TRUE(std::none_of(beams.begin(), beams.end(), [](auto& b) { return b.straight; }));
}

TEST(ExpectedScan, EndsAtTheRangeAskedFor) {
  const AlignedLog log = standing_log(room_grid());
  const auto beams = expect_scan(log, middle_scan(log), 3.0);
  EXPECT_FLOAT_EQ(beam_at(beams, 0).range, 3.0F);
  EXPECT_FALSE(beam_at(beams, 0).wall);
  EXPECT_FALSE(beam_at(beams, 0).straight);
  expect_wall(beam_at(beams, 90), 2.8, 1.0);
}

TEST(ExpectedScan, EndsAtUnknownCellsWithoutAWall) {
  AlignedLog log = standing_log(room_grid());
  test::fill(log.grid, 6.0, 0.2, 7.8, 5.8, localization::CellState::kUnknown);
  const auto beams = expect_scan(log, middle_scan(log), 20.0);
  EXPECT_NEAR(beam_at(beams, 0).range, 2.0, 1e-5);
  EXPECT_FALSE(beam_at(beams, 0).wall);
  EXPECT_FALSE(beam_at(beams, 0).straight);
  expect_wall(beam_at(beams, -90), 2.8, 1.0);
}

TEST(ExpectedScan, OfASweepFollowsTheRobot) {
  AlignedLog log = standing_log(room_grid());
  log.T_path_base = localization::TransformBuffer({.hold = milliseconds(0)});
  const SE2 T_path_first{5.0, 1.0, 2.0};
  log.T_path_base.add(milliseconds(1000), T_path_first);
  log.T_path_base.add(milliseconds(1360), T_path_first * SE2{0.36, 0.0, 0.0});
  AlignedScan aligned = middle_scan(log);
  aligned.scan.stamp = milliseconds(1000);
  aligned.scan.time_increment = milliseconds(1);
  const auto beams = expect_scan(log, aligned, 20.0);
  ASSERT_EQ(beams.size(), 360U);
  for (const int degrees : {-170, -100, -90, 0, 10, 90, 170}) {
    const SE2 T_map_base = aligned.T_map_base * SE2{0.001 * (degrees + 180), 0.0, 0.0};
    const LaserScan there = room_scan(log.grid, T_map_base);
    EXPECT_NEAR(beam_at(beams, degrees).range,
                there.ranges[static_cast<std::size_t>(degrees + 180)], 1e-5);
  }
  EXPECT_NEAR(beam_at(beams, 0).range, 3.8 - 0.18, 1e-5);
}

TEST(ExpectedScan, IsEmptyWhereTheMotionIsUnknown) {
  AlignedLog log = standing_log(room_grid());
  log.T_path_base = localization::TransformBuffer({.hold = milliseconds(100)});
  log.T_path_base.add(milliseconds(1000), {});
  AlignedScan aligned = middle_scan(log);
  aligned.scan.stamp = milliseconds(999);
  EXPECT_TRUE(expect_scan(log, aligned, 20.0).empty());
  aligned.scan.stamp = milliseconds(1050);
  EXPECT_FALSE(expect_scan(log, aligned, 20.0).empty());
  aligned.scan.time_increment = milliseconds(1);  // its last beams come too late
  EXPECT_TRUE(expect_scan(log, aligned, 20.0).empty());
}

TEST(SpreadScans, AreEvenlySpreadAndAtMostAll) {
  const AlignedLog log = pillars_log(10);
  EXPECT_EQ(spread_scans(log, 4), (std::vector<std::size_t>{0, 2, 5, 7}));
  EXPECT_EQ(spread_scans(log, 1000).size(), 10U);
}

TEST(ExpectedScan, EqualsScansCastFromAnywhere) {
  const AlignedLog log = room_log(50);
  for (const AlignedScan& aligned : log.scans) {
    const auto beams = expect_scan(log, aligned, 12.0);
    ASSERT_EQ(beams.size(), 360U);
    for (std::size_t i = 0; i < beams.size(); ++i) {
      ASSERT_NEAR(beams[i].range, aligned.scan.ranges[i], 1e-4);
    }
  }
}

}  // namespace
}  // namespace castaway::testbed
