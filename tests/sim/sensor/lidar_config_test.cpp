#include "sim/sensor/lidar_config.hpp"

#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/robot_model.hpp"

namespace castaway::sim {
namespace {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

TEST(LidarConfig, NamesTheFieldThatIsWrong) {
  LidarConfig config;
  config.angle_increment = 2.0 * kPi / 359.0;  // The last beam would repeat the first.
  try {
    validate(config);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("angle_increment"));
  }
}

TEST(LidarConfig, AFullCircleDoesNotRepeatItsFirstBeam) {
  RobotModel robot;
  robot.lidar = LidarMount{"scan", Eigen::Isometry3d::Identity(), LidarSpecs{}};
  robot.lidar->specs->samples = 360;
  robot.lidar->specs->angle_max = 6.28319;
  EXPECT_NEAR(lidar_of(robot).angle_increment, 2.0 * kPi / 360.0, 1e-9);
  EXPECT_NO_THROW(validate(lidar_of(robot)));
  robot.lidar->specs->angle_min = -kPi / 2;
  robot.lidar->specs->angle_max = kPi / 2;
  robot.lidar->specs->samples = 181;
  EXPECT_NEAR(lidar_of(robot).angle_increment, kPi / 180.0, 1e-9);
}

}  // namespace
}  // namespace castaway::sim
