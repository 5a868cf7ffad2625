#include "tools/twin/likeness.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

/// 101 scans, 0.1 m apart on a straight line, by odometry that measures `scale` times the way.
AlignedLog driven_log(double scale) {
  AlignedLog log;
  log.T_odom_base = localization::TransformBuffer({.length = std::chrono::hours(1)});
  const SE2 T_map_odom{3.0, -2.0, 0.8};
  for (int k = 0; k <= 100; ++k) {
    AlignedScan aligned;
    aligned.scan.stamp = milliseconds(100 * k);
    aligned.T_map_base = T_map_odom * SE2{0.1 * k, 0.0, 0.0};
    log.scans.push_back(aligned);
    log.T_odom_base.add(aligned.scan.stamp, {scale * 0.1 * k, 0.0, 0.0});
  }
  return log;
}

TEST(Drift, OfExactOdometryIsZero) {
  const std::vector<Drift> drifts = drifts_over(driven_log(1.0), 0.95);
  ASSERT_EQ(drifts.size(), 10U);
  for (const Drift& drift : drifts) {
    EXPECT_NEAR(drift.way_m, 1.0, 1e-9);
    EXPECT_NEAR(drift.miss_m, 0.0, 1e-9);
  }
}

TEST(Drift, OfAWrongScaleIsItsShareOfTheWay) {
  for (const double scale : {1.02, 0.98}) {
    const std::vector<Drift> drifts = drifts_over(driven_log(scale), 0.95);
    ASSERT_EQ(drifts.size(), 10U);
    for (const Drift& drift : drifts) {
      EXPECT_NEAR(drift.way_m, scale * 1.0, 1e-9);  // as measured
      EXPECT_NEAR(drift.miss_m, 0.02, 1e-9);
    }
    EXPECT_NEAR(*drift_rms(drifts), 0.02, 1e-9);
  }
}

TEST(Drift, CountsTheWayOfTheWheels) {
  // A turn on the spot by 0.2 rad between scans; odometry is exact.
  AlignedLog log = driven_log(1.0);
  log.T_odom_base = localization::TransformBuffer({.length = std::chrono::hours(1)});
  for (int k = 0; k <= 100; ++k) {
    const SE2 turned{0.0, 0.0, 0.2 * k};
    log.scans[static_cast<std::size_t>(k)].T_map_base = turned;
    log.T_odom_base.add(milliseconds(100 * k), turned);
  }
  const double per_leg = 0.1 * kTwinTrack;  // half the track times 0.2 rad
  const std::vector<Drift> drifts = drifts_over(log, 9.5 * per_leg);
  ASSERT_EQ(drifts.size(), 10U);
  EXPECT_NEAR(drifts[0].way_m, 10.0 * per_leg, 1e-9);
  EXPECT_NEAR(drifts[0].miss_m, 0.0, 1e-9);
}

TEST(Drift, BeginsAgainWhereTheRobotWasMoved) {
  AlignedLog log = driven_log(1.0);
  log.scans[5].breaks = true;
  for (std::size_t k = 5; k < log.scans.size(); ++k) log.scans[k].T_map_base.y += 7.0;
  const std::vector<Drift> drifts = drifts_over(log, 0.95);
  EXPECT_EQ(drifts.size(), 9U);  // the first 0.4 m and the jump are lost
  for (const Drift& drift : drifts) EXPECT_NEAR(drift.miss_m, 0.0, 1e-9);
}

TEST(Drift, HasNothingOfAShortWay) { EXPECT_TRUE(drifts_over(driven_log(1.0), 10.05).empty()); }

TEST(DriftRms, IsOverFourStretchesOrMore) {
  EXPECT_FALSE(drift_rms({}));
  EXPECT_FALSE(drift_rms({{1.0, 0.1}, {1.0, 0.1}, {1.0, 0.1}}));
  EXPECT_DOUBLE_EQ(*drift_rms({{1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}, {1.0, 5.0}}), std::sqrt(7.0));
}

}  // namespace
}  // namespace castaway::testbed
