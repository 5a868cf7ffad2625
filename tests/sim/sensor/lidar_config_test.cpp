#include "sim/sensor/lidar_config.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using testing::HasSubstr;

using std::numbers::pi;

TEST(LidarConfig, NamesTheFieldThatIsWrong) {
  LidarConfig config;
  config.angle_increment = 2.0 * pi / 359.0;  // The last beam would repeat the first.
  try {
    validate(config);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("angle_increment"));
  }
}

TEST(LidarConfig, TakesAMillionRaysASweepAtMost) {
  LidarConfig config;
  config.beams = 100000;
  config.angle_increment = 6.2e-5;
  config.elevations.assign(10, 0.0);
  EXPECT_NO_THROW(validate(config));
  config.elevations.assign(11, 0.0);
  EXPECT_THROW(validate(config), std::invalid_argument);
}

TEST(LidarConfig, TheMostLevelLayerStandsForAllUnlessOneIsChosen) {
  LidarConfig config;
  config.elevations = {-0.3, -0.1, 0.05, 0.2};
  EXPECT_EQ(level_layer(config), 2);
  EXPECT_EQ(level_slice(config).elevations, std::vector<double>{0.05});
  config.planar_layer = 0;
  EXPECT_EQ(level_layer(config), 0);
  EXPECT_EQ(level_slice(config).elevations, std::vector<double>{-0.3});
  config.planar_layer = 4;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

TEST(LidarConfig, BeamsPointByLayerAndAngle) {
  LidarConfig config;
  config.beams = 4;
  config.angle_min = 0.0;
  config.angle_increment = 0.5 * std::numbers::pi;
  config.elevations = {0.0, std::numbers::pi / 6.0};
  config.T_base_laser = Eigen::Translation3d(0.1, 0.0, 0.3);
  const auto off = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).cwiseAbs().maxCoeff();
  };
  EXPECT_LT(off(beam_direction(config, 1), {0.0, 1.0, 0.0}), 1e-15);
  EXPECT_LT(off(beam_direction(config, 6), {-std::sqrt(0.75), 0.0, 0.5}), 1e-15);
  EXPECT_LT(off(beam_point(config, 1, 2.0), {0.1, 2.0, 0.3}), 1e-15);
  EXPECT_LT(off(beam_point(config, 6, 2.0), {0.1 - std::sqrt(3.0), 0.0, 1.3}), 1e-15);
}

TEST(LidarConfig, RefusesScanTimesThatGoBackOrAreNegative) {
  using std::chrono::milliseconds;
  LidarConfig config;
  const auto error_with = [&](std::vector<std::chrono::nanoseconds> times) -> std::string {
    config.scan_times = std::move(times);
    try {
      validate(config);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_with({}), "");
  EXPECT_EQ(error_with({milliseconds(0), milliseconds(5), milliseconds(5), milliseconds(6)}), "");
  EXPECT_THAT(error_with({milliseconds(1), milliseconds(3), milliseconds(2)}),
              HasSubstr("scan times go back"));
  EXPECT_THAT(error_with({milliseconds(-1), milliseconds(2)}), HasSubstr("scan time is negative"));
}

TEST(LidarConfig, RefusesErrorsOfStampsThatCannotBe) {
  LidarConfig config;
  for (const double sigma : {-0.01, 10.1, std::nan("")}) {
    config.stamp_sigma = sigma;
    EXPECT_THROW(validate(config), std::invalid_argument) << sigma;
  }
  for (const double sigma : {0.0, 10.0}) {
    config.stamp_sigma = sigma;
    EXPECT_NO_THROW(validate(config)) << sigma;
  }
}

}  // namespace
}  // namespace castaway::sim
