#include "tools/scenario/sections/lidar_profile.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using testing::HasSubstr;

TEST(LidarProfiles, AreManyAndAllReadable) {
  const auto names = lidar_profile_names();
  EXPECT_GE(names.size(), 12U);
  for (const std::string& name : names) {
    const LidarProfile profile = load_lidar_profile(name);
    EXPECT_FALSE(profile.device.empty()) << name;
    EXPECT_FALSE(profile.source.empty()) << name;
    const sim::LidarConfig lidar = with_profile({}, name);
    EXPECT_LT(std::abs(lidar.angle_increment) * lidar.beams, 6.2832) << name;
    EXPECT_GT(lidar.range_max, lidar.range_min) << name;
    EXPECT_GT(lidar.noise.sigma + lidar.noise.sigma_relative, 0.0) << name;
  }
}

TEST(LidarProfiles, KeepNameFrameAndMount) {
  sim::LidarConfig lidar;
  lidar.name = "front";
  lidar.frame = "front_laser";
  lidar.T_base_laser = Eigen::Translation3d(1.0, 2.0, 3.0);
  const sim::LidarConfig device = with_profile(lidar, "lds-01");
  EXPECT_EQ(device.name, "front");
  EXPECT_EQ(device.frame, "front_laser");
  EXPECT_EQ(device.T_base_laser.translation().z(), 3.0);
  EXPECT_EQ(device.range_max, 3.5);
  EXPECT_NEAR(device.angle_increment, std::numbers::pi / 180.0, 1e-12);
}

TEST(LidarProfiles, TheIdealOneErrsInNothing) {
  sim::LidarConfig lidar = with_profile({}, "ust-10lx");
  lidar = with_profile(lidar, "ideal");
  EXPECT_EQ(lidar.noise.sigma, 0.0);
  EXPECT_EQ(lidar.noise.bias, 0.0);
  EXPECT_EQ(lidar.light.dropout, 0.0);
  EXPECT_EQ(lidar.light.divergence_deg, 0.0);
  EXPECT_FALSE(lidar.light.glass);
  EXPECT_EQ(lidar.beams, 1081);
}

TEST(LidarProfiles, OfTheRobotChangesNothing) {
  EXPECT_EQ(with_profile({}, "robot").noise.sigma, sim::LidarConfig{}.noise.sigma);
}

TEST(LidarProfiles, HaveTheirLayers) {
  EXPECT_EQ(with_profile({}, "vlp-16").elevations.size(), 16U);
  EXPECT_NEAR(with_profile({}, "vlp-16").elevations[7], -std::numbers::pi / 180.0, 1e-12);
  EXPECT_EQ(with_profile({}, "os1-32").elevations.size(), 32U);
}

TEST(LidarProfiles, NameTheNearestOfThoseThatAreKnown) {
  try {
    (void)with_profile({}, "lds01");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("lidar profile 'lds01' not found"));
    EXPECT_THAT(error.what(), HasSubstr("'lds-01'"));
  }
}

}  // namespace
}  // namespace castaway::testbed
