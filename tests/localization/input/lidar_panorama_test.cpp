#include "localization/input/sensor_input.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

using std::chrono::milliseconds;

ScanPoints one_point(float x, float y, float origin_x) {
  ScanPoints points;
  points.x = {x};
  points.y = {y};
  points.z = {0.1F};
  points.origin_x = {origin_x};
  points.origin_y = {0.0F};
  points.origin_z = {0.3F};
  points.range = {x - origin_x};
  return points;
}

TEST(LidarPanorama, IsTheScanItselfForOneLidar) {
  LidarPanorama panorama(milliseconds(250));
  const ScanPoints points = one_point(2.0F, 0.5F, 0.2F);
  EXPECT_EQ(panorama.add("", points, milliseconds(0), {}).x, points.x);
  EXPECT_EQ(panorama.add("", points, milliseconds(100), {1.0, 0.0, 0.0}).x, points.x);
}

TEST(LidarPanorama, MovesPointsOfOtherLidarsToWhereBaseIsNow) {
  LidarPanorama panorama(milliseconds(250));
  panorama.add("rear", one_point(-3.0F, 0.0F, -0.2F), milliseconds(0), {});
  // Base moved 1 m forward and turned left by 90 degrees.
  const SE2 now{1.0, 0.0, std::numbers::pi / 2.0};
  const ScanPoints all = panorama.add("front", one_point(2.0F, 0.0F, 0.2F), milliseconds(50), now);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_FLOAT_EQ(all.x[0], 2.0F);
  EXPECT_NEAR(all.x[1], 0.0F, 1e-6F);
  EXPECT_NEAR(all.y[1], 4.0F, 1e-6F);
  EXPECT_NEAR(all.origin_y[1], 1.2F, 1e-6F);
  EXPECT_FLOAT_EQ(all.z[1], 0.1F);
  EXPECT_FLOAT_EQ(all.origin_z[1], 0.3F);
  EXPECT_FLOAT_EQ(all.range[1], -2.8F);
}

TEST(LidarPanorama, ForgetsOldScansAndTakesTheNewestOfEachLidar) {
  LidarPanorama panorama(milliseconds(250));
  panorama.add("rear", one_point(-3.0F, 0.0F, 0.0F), milliseconds(0), {});
  panorama.add("rear", one_point(-4.0F, 0.0F, 0.0F), milliseconds(100), {});
  const ScanPoints front = one_point(2.0F, 0.0F, 0.0F);
  EXPECT_EQ(panorama.add("front", front, milliseconds(350), {}).x,
            (std::vector<float>{2.0F, -4.0F}));
  EXPECT_EQ(panorama.add("front", front, milliseconds(351), {}).x, front.x);
}

TEST(LidarPanorama, KeepsTheKindsOfBeamsOfAllLidars) {
  ScanPoints tilted = one_point(1.0F, 0.0F, 0.0F);
  tilted.kinds = {BeamKind::kTilted};
  LidarPanorama panorama(milliseconds(250));
  panorama.add("dome", tilted, milliseconds(0), {});
  const ScanPoints all = panorama.add("front", one_point(2.0F, 0.0F, 0.2F), milliseconds(0), {});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all.kind(0), BeamKind::kLevel);
  EXPECT_EQ(all.kind(1), BeamKind::kTilted);
  const ScanPoints again = panorama.add("dome", tilted, milliseconds(0), {});
  EXPECT_EQ(again.kind(0), BeamKind::kTilted);
  EXPECT_EQ(again.kind(1), BeamKind::kLevel);
}

}  // namespace
}  // namespace castaway::localization
