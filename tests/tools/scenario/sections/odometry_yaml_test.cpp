#include "tools/scenario/sections/odometry_yaml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/sensor/odometry_profiles.hpp"

namespace castaway::testbed {
namespace {

sim::OdometryConfig odometry_of(const std::string& text) {
  YamlDocument document = YamlDocument::parse(text, "scenario.yaml");
  YamlReader root = document.root();
  const sim::OdometryConfig odometry = read_odometry(root);
  document.reject_unknown_keys();
  return odometry;
}

TEST(OdometrySpec, WithoutTheKeyIsTheDefault) {
  EXPECT_EQ(odometry_of("{}").track_sigma, sim::OdometryConfig{}.track_sigma);
  EXPECT_FALSE(odometry_of("{}").gyro.has_value());
}

TEST(OdometrySpec, ReadsAllKeys) {
  const sim::OdometryConfig odometry = odometry_of(
      "odometry: {profile: slippery, ticks_per_turn: 512, radius_sigma: 0.01, track_sigma: 0.02, "
      "drift_along: 0.03, drift_yaw_deg: 0.4, drift_turn_deg: 0.6, unsigned_distance: true, slip: "
      "{rate_per_m: 1, length_m: 0.2, share: 0.25, "
      "collision_length_m: 0.5, zones: false, zone_spread: 0.1}, gyro: {noise_deg: 0.5}}");
  EXPECT_EQ(odometry.ticks_per_turn, 512);
  EXPECT_EQ(odometry.drift_yaw_deg, 0.4);
  EXPECT_EQ(odometry.drift_turn_deg, 0.6);
  EXPECT_TRUE(odometry.unsigned_distance);
  EXPECT_EQ(odometry.slip.rate, 1.0);
  EXPECT_EQ(odometry.slip.length, 0.2);
  EXPECT_EQ(odometry.slip.share, 0.25);
  EXPECT_EQ(odometry.slip.collision_length, 0.5);
  EXPECT_EQ(odometry.slip.zone_spread, 0.1);
  EXPECT_FALSE(odometry.slip.zones);
  EXPECT_EQ(odometry.gyro->noise_deg, 0.5);
  EXPECT_EQ(odometry.gyro->bias_deg_s, sim::GyroConfig{}.bias_deg_s);
}

TEST(OdometrySpec, DiffersFromItsProfileOnlyInWhatIsGiven) {
  const sim::OdometryConfig odometry = odometry_of("odometry: {profile: slippery, track_sigma: 0}");
  EXPECT_EQ(odometry.track_sigma, 0.0);
  EXPECT_EQ(odometry.drift_along, sim::odometry_profile("slippery")->drift_along);
}

TEST(OdometrySpec, WritesEverySettingOfItsProfile) {
  YamlDocument document = YamlDocument::parse("odometry: {profile: worn-wheels}", "a.yaml");
  YamlReader root = document.root();
  const sim::OdometryConfig odometry = read_odometry(root);
  EXPECT_THAT(document.effective(), testing::HasSubstr("collision_length_m: 0.1"));
  EXPECT_EQ(odometry_of(document.effective()).slip.rate, odometry.slip.rate);
}

TEST(OdometrySpec, ReadsFixedErrorsOfWheelsAndTrack) {
  const sim::OdometryConfig odometry = odometry_of(
      "odometry: {profile: ideal, radius_error_left: -0.01, radius_error_right: 0.02, "
      "track_error: 0.03}");
  EXPECT_EQ(odometry.radius_error_left, -0.01);
  EXPECT_EQ(odometry.radius_error_right, 0.02);
  EXPECT_EQ(odometry.track_error, 0.03);
  EXPECT_EQ(odometry_of("{}").track_error, 0.0);
  EXPECT_THROW((void)odometry_of("odometry: {track_error: 0.6}"), std::runtime_error);
  EXPECT_THROW((void)odometry_of("odometry: {radius_error_left: -0.6}"), std::runtime_error);
}

TEST(OdometrySpec, NeitherWalksByTurnNorLosesSignsByDefault) {
  EXPECT_EQ(odometry_of("{}").drift_turn_deg, 0.0);
  EXPECT_FALSE(odometry_of("{}").unsigned_distance);
}

TEST(OdometrySpec, RefusesWhatCannotBe) {
  EXPECT_THROW((void)odometry_of("odometry: {drift_turn_deg: -0.1}"), std::runtime_error);
  EXPECT_THROW((void)odometry_of("odometry: {unsigned_distance: 2}"), std::runtime_error);
  EXPECT_THROW((void)odometry_of("odometry: {slip: {share: 0.9}}"), std::runtime_error);
  EXPECT_THROW((void)odometry_of("odometry: {slip: {share: 1.5}}"), std::runtime_error);
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
