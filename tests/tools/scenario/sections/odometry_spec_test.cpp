#include "tools/scenario/sections/odometry_spec.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

OdometrySpec odometry_of(const std::string& text) {
  YamlDocument document = YamlDocument::parse(text, "scenario.yaml");
  YamlReader root = document.root();
  const OdometrySpec odometry = read_odometry(root);
  document.reject_unknown_keys();
  return odometry;
}

TEST(OdometrySpec, WithoutTheKeyIsTheDefault) {
  EXPECT_EQ(odometry_of("{}").profile, "default");
  EXPECT_FALSE(odometry_of("{}").gyro.has_value());
}

TEST(OdometrySpec, ReadsAllKeys) {
  const OdometrySpec odometry = odometry_of(
      "odometry: {profile: slippery, ticks_per_turn: 512, radius_sigma: 0.01, track_sigma: 0.02, "
      "drift_along: 0.03, drift_yaw_deg: 0.4, slip: {rate_per_m: 1, length_m: 0.2, share: 0.25, "
      "collision_length_m: 0.5, zones: false, zone_spread: 0.1}, gyro: {noise_deg: 0.5}}");
  EXPECT_EQ(odometry.profile, "slippery");
  EXPECT_EQ(odometry.ticks_per_turn, 512);
  EXPECT_EQ(odometry.drift_yaw_deg, 0.4);
  EXPECT_EQ(odometry.slip.at("rate_per_m"), 1.0);
  EXPECT_EQ(odometry.slip.size(), kSlipKeys.size());
  EXPECT_EQ(odometry.slip_zones, false);
  EXPECT_EQ(odometry.gyro->noise_deg, 0.5);
  EXPECT_EQ(odometry.gyro->bias_deg_s, sim::GyroConfig{}.bias_deg_s);
}

TEST(OdometrySpec, NamesTheNearestProfile) {
  try {
    (void)odometry_of("odometry: {profile: worn-wheel}");
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'worn-wheels'"));
  }
}

}  // namespace
}  // namespace castaway::testbed
