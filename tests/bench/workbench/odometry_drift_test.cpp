#include "tests/bench/workbench/odometry_drift.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

/// A straight drive of `metres` in steps of 0.5 m; odometry reports `scale` times the distance.
Frames straight(int metres, double scale) {
  Frames frames;
  for (int i = 0; i <= 2 * metres; ++i) {
    OdometryFrame frame;
    frame.odometry.T_odom_base = {0.5 * i * scale, 0.0, 0.0};
    frame.true_pose = SE2{0.5 * i, 0.0, 0.0};
    frames.emplace_back();
    frames.back().stamp = Stamp(i);
    frames.back().data = frame;
  }
  return frames;
}

TEST(OdometryDrift, OfAWrongScaleIsItsError) {
  const auto segments = drift_segments(straight(20, 1.05), 10.0);
  ASSERT_EQ(segments.size(), 11U);  // One from every metre, 0 to 10.
  EXPECT_NEAR(mean_drift(segments)->percent, 5.0, 1e-9);
  EXPECT_NEAR(mean_drift(segments)->deg_per_m, 0.0, 1e-9);
}

TEST(OdometryDrift, OfATurnIsItsAngleOverTheLength) {
  Frames frames = straight(10, 1.0);
  std::get<OdometryFrame>(frames.back().data).odometry.T_odom_base.yaw =
      -20.0 * std::numbers::pi / 180.0;
  EXPECT_NEAR(mean_drift(drift_segments(frames, 10.0))->deg_per_m, 2.0, 1e-9);
}

TEST(OdometryDrift, AKidnapIsInNoSegment) {
  Frames frames = straight(12, 1.0);
  const Frames more = straight(12, 1.0);
  frames.emplace_back();
  frames.back().data = RunEvent{Stamp(1), KidnapEvent{}};
  frames.insert(frames.end(), more.begin(), more.end());
  const auto segments = drift_segments(frames, 10.0);
  EXPECT_EQ(segments.size(), 6U);
  EXPECT_NEAR(mean_drift(segments)->percent, 0.0, 1e-9);
}

TEST(OdometryDrift, OfAShortDriveThereIsNone) {
  EXPECT_FALSE(mean_drift(drift_segments(straight(9, 1.0), 10.0)).has_value());
}

}  // namespace
}  // namespace castaway::testbed
