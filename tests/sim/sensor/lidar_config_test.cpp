#include "sim/sensor/lidar_config.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/urdf/robot_model.hpp"

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

TEST(LidarConfig, AFullCircleDoesNotRepeatItsFirstBeam) {
  RobotModel robot;
  robot.lidar = LidarMount{"scan", Eigen::Isometry3d::Identity(), LidarSpecs{}};
  robot.lidar->specs->samples = 360;
  robot.lidar->specs->angle_max = 6.28319;
  EXPECT_NEAR(lidar_of(robot).angle_increment, 2.0 * pi / 360.0, 1e-9);
  EXPECT_NO_THROW(validate(lidar_of(robot)));
  robot.lidar->specs->angle_min = -pi / 2;
  robot.lidar->specs->angle_max = pi / 2;
  robot.lidar->specs->samples = 181;
  EXPECT_NEAR(lidar_of(robot).angle_increment, pi / 180.0, 1e-9);
}

TEST(LidarConfig, OfARobotWithoutOneStandsFreeOfItsBody) {
  RobotModel robot;
  robot.height = 0.15;
  EXPECT_EQ(lidar_of(robot).T_base_laser.translation().z(), 0.2);
  robot.height = 0.2;
  EXPECT_NEAR(lidar_of(robot).T_base_laser.translation().z(), 0.22, 1e-12);
  robot.height = 1.1;
  EXPECT_NEAR(lidar_of(robot).T_base_laser.translation().z(), 1.12, 1e-12);
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

TEST(LidarConfig, LayersComeFromTheDescription) {
  RobotModel robot;
  robot.lidar = LidarMount{"scan", Eigen::Isometry3d::Identity(), LidarSpecs{}};
  robot.lidar->specs->angle_max = 3.0;
  EXPECT_EQ(lidar_of(robot).elevations, std::vector<double>{0.0});
  robot.lidar->specs->layers = 3;
  robot.lidar->specs->layer_min = -0.2;
  robot.lidar->specs->layer_max = 0.4;
  const std::vector<double> elevations = lidar_of(robot).elevations;
  ASSERT_EQ(elevations.size(), 3U);
  EXPECT_NEAR(elevations[1], 0.1, 1e-12);
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

TEST(LidarConfig, LidarsOfOneMacroGetNamesOfTheirOwn) {
  RobotModel robot;
  for (const char* link : {"front", "rear"}) {
    robot.lidars.push_back({link, Eigen::Isometry3d::Identity(), std::nullopt, "scanner"});
  }
  robot.lidar = robot.lidars.front();
  const auto lidars = lidars_of(robot);
  ASSERT_EQ(lidars.size(), 2U);
  EXPECT_EQ(lidars[0].name, "scanner");
  EXPECT_EQ(lidars[1].name, "scanner_rear");
  EXPECT_EQ(lidars[1].frame, "rear");
}

}  // namespace
}  // namespace castaway::sim
