#include "sim/robot/robot_sensors.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using std::numbers::pi;

TEST(RobotSensors, AFullCircleDoesNotRepeatItsFirstBeam) {
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

TEST(RobotSensors, ALidarOfNoDescriptionStandsFreeOfTheBody) {
  RobotModel robot;
  robot.height = 0.15;
  EXPECT_EQ(lidar_of(robot).T_base_laser.translation().z(), 0.2);
  robot.height = 0.2;
  EXPECT_NEAR(lidar_of(robot).T_base_laser.translation().z(), 0.22, 1e-12);
  robot.height = 1.1;
  EXPECT_NEAR(lidar_of(robot).T_base_laser.translation().z(), 1.12, 1e-12);
}

TEST(RobotSensors, LayersComeFromTheDescription) {
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

TEST(RobotSensors, LidarsOfOneMacroGetNamesOfTheirOwn) {
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

TEST(RobotSensors, DriveGeometryIsTheWheelsAndTheAxle) {
  RobotModel robot;
  robot.wheel_radius = 0.1;
  robot.track = 0.4;
  robot.p_base_axle = {0.05, -0.01};
  const DriveGeometry drive = drive_geometry(robot);
  EXPECT_EQ(drive.radius_left, 0.1);
  EXPECT_EQ(drive.radius_right, 0.1);
  EXPECT_EQ(drive.track, 0.4);
  EXPECT_EQ(drive.p_base_axle, Eigen::Vector2d(0.05, -0.01));
}

}  // namespace
}  // namespace castaway::sim
