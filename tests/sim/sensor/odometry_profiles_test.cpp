#include "sim/sensor/odometry_profiles.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

TEST(OdometryProfiles, AreAllRunnable) {
  for (const std::string& name : odometry_profile_names()) {
    const auto profile = odometry_profile(name);
    ASSERT_TRUE(profile.has_value()) << name;
    EXPECT_NO_THROW(validate(*profile)) << name;
  }
  EXPECT_FALSE(odometry_profile("flying").has_value());
}

TEST(OdometryProfiles, GrowWorseInTheirOrder) {
  double before = -1.0;
  for (const std::string& name : odometry_profile_names()) {
    const double drift = odometry_profile(name)->drift_yaw_deg;
    EXPECT_GT(drift, before) << name;
    before = drift;
  }
}

TEST(OdometryProfiles, TheDefaultIsWhatAConfigurationStartsWith) {
  EXPECT_EQ(odometry_profile("default")->radius_sigma, OdometryConfig{}.radius_sigma);
  EXPECT_EQ(odometry_profile("default")->slip.rate, 0.0);
}

}  // namespace
}  // namespace castaway::sim
