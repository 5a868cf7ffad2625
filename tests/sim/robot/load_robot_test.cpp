#include "sim/robot/load_robot.hpp"

#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/robot_sensors.hpp"
#include "sim/robot/robot_visuals.hpp"
#include "sim/sensor/lidar_config.hpp"

namespace castaway::sim {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

const std::string kRobots = CASTAWAY_TEST_DATA "/robots/";

std::string error_of(const std::string& path) {
  try {
    load_robot(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(LoadRobot, ReadsARobotWithRolledWheelsAndACasterBox) {
  const RobotModel robot = load_robot(kRobots + "burger_like.urdf");
  ASSERT_EQ(robot.wheels.size(), 2U);
  EXPECT_EQ(robot.wheels[0].joint, "r1_wheel_left_joint");
  EXPECT_NEAR(robot.wheel_radius, 0.033, 1e-12);
  EXPECT_NEAR(robot.track, 0.16, 1e-12);
  EXPECT_NEAR(robot.wheels[0].inertia_spin, 1.8e-5, 1e-9);
  ASSERT_EQ(robot.casters.size(), 1U);
  EXPECT_NEAR(robot.casters[0].p_base_caster.x(), -0.081, 1e-3);
  EXPECT_DOUBLE_EQ(robot.casters[0].p_base_caster.z(), robot.casters[0].radius);
  EXPECT_NEAR(robot.chassis_mass, 0.949, 1e-12);
}

TEST(LoadRobot, KeepsTheFramesOfFixedLinks) {
  const RobotModel robot = load_robot(kRobots + "burger_like.urdf");
  EXPECT_TRUE(robot.frames.at("r1_base_scan")
                  .translation()
                  .isApprox(Eigen::Vector3d(-0.032, 0.0, 0.182), 1e-9));
  EXPECT_EQ(robot.lidar->link, "r1_base_scan");
  EXPECT_FALSE(robot.lidar->specs.has_value());
}

TEST(LoadRobot, WarnsOfAMissingMeshAndPutsABox) {
  const RobotModel robot = load_robot(kRobots + "burger_like.urdf");
  EXPECT_THAT(robot.warnings, Contains(AllOf(HasSubstr("r1_base_link"), HasSubstr("body.stl"))));
  ASSERT_EQ(robot.visuals.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<BoxShape>(robot.visuals[0].shape));
  EXPECT_TRUE(robot.visuals[0].color->isApprox(Eigen::Vector3f(0.1F, 0.2F, 0.8F)));
}

TEST(LoadRobot, ReadsARobotWhoseRootIsAboveTheFloor) {
  const RobotModel robot = load_robot(kRobots + "pioneer_like.urdf");
  EXPECT_NEAR(robot.frames.at("base_link").translation().z(), 0.0975 - 0.091, 1e-9);
  EXPECT_NEAR(robot.wheels[0].p_base_wheel.z(), robot.wheel_radius, 1e-12);
  EXPECT_GT(robot.wheels[0].p_base_wheel.y(), 0.0);
  EXPECT_NEAR(robot.track, 0.316, 1e-12);
}

TEST(LoadRobot, TakesASwivelsWheelForACaster) {
  const RobotModel robot = load_robot(kRobots + "pioneer_like.urdf");
  ASSERT_EQ(robot.casters.size(), 1U);
  EXPECT_NEAR(robot.casters[0].p_base_caster.x(), -0.211, 1e-6);
  EXPECT_NEAR(robot.casters[0].radius, 0.0375, 1e-3);
}

TEST(LoadRobot, RepairsImpossibleInertias) {
  const RobotModel robot = load_robot(kRobots + "pioneer_like.urdf");
  for (const char* link : {"base_link", "left_wheel", "caster_wheel"}) {
    EXPECT_THAT(robot.warnings, Contains(AllOf(HasSubstr(link), HasSubstr("inertia"))));
  }
  EXPECT_GT(robot.chassis_mass, 1.0);
  EXPECT_GT(robot.wheels[0].inertia_spin, 0.0);
  EXPECT_NEAR(robot.wheels[0].mass, 1.5, 1e-12);
}

TEST(LoadRobot, ReadsTheLidarsTag) {
  const RobotModel robot = load_robot(kRobots + "pioneer_like.urdf");
  ASSERT_TRUE(robot.lidar && robot.lidar->specs);
  EXPECT_EQ(robot.lidar->link, "front_sensor");
  const LidarConfig lidar = lidar_of(robot);
  EXPECT_EQ(lidar.beams, 181);
  EXPECT_NEAR(lidar.angle_increment, std::numbers::pi / 180.0, 1e-9);
  EXPECT_EQ(lidar.range_max, 30.0);
  EXPECT_EQ(lidar.rate_hz, 12.5);
  EXPECT_EQ(lidar.noise.sigma, 0.005);
  // Upside down, and moved up by the sensor's own pose.
  EXPECT_NEAR(lidar.T_base_laser.linear()(2, 2), -1.0, 1e-9);
  EXPECT_NEAR(lidar.T_base_laser.translation().z(), 0.28 + 0.02 + 0.0065, 1e-9);
}

TEST(LoadRobot, FindsCastersInFrontAndBehind) {
  const RobotModel robot = load_robot(kRobots + "create_like.urdf");
  ASSERT_EQ(robot.casters.size(), 2U);
  EXPECT_NEAR(robot.footprint_radius, 0.166, 0.001);
  EXPECT_FALSE(robot.lidar.has_value());
}

TEST(LoadRobot, ReadsTheWaffle) {
  const RobotModel robot = load_robot(CASTAWAY_ROBOTS "/waffle/waffle.urdf");
  EXPECT_TRUE(robot.warnings.empty()) << robot.warnings.front();
  EXPECT_NEAR(robot.track, 0.287, 1e-12);
  EXPECT_NEAR(robot.wheel_radius, 0.033, 1e-12);
  EXPECT_NEAR(robot.lidar->T_base_laser.translation().z(), 0.132, 1e-12);
  const LidarConfig lidar = lidar_of(robot);
  EXPECT_EQ(lidar.beams, 360);
  EXPECT_NEAR(lidar.angle_increment, std::numbers::pi / 180.0, 1e-9);
  EXPECT_EQ(lidar.range_max, 3.5);
}

TEST(RobotVisuals, ShowTheWaffleWhereItsShapesAre) {
  const auto items = robot_visuals(load_robot(CASTAWAY_ROBOTS "/waffle/waffle.urdf"));
  ASSERT_EQ(items.size(), 4U);
  Eigen::AlignedBox3f box;
  for (const SceneItem& item : items) {
    for (const auto& v : item.mesh.vertices) box.extend(Eigen::Vector3f(item.T_map_mesh * v));
  }
  EXPECT_NEAR(box.min().z(), 0.0F, 1e-3F);
  EXPECT_NEAR(box.sizes().y(), 0.305F, 2e-3F);
  EXPECT_NEAR(box.max().z(), 0.150F, 2e-3F);
}

TEST(LoadRobotErrors, NameTheMissingFile) {
  EXPECT_THAT(error_of("/nowhere/robot.urdf"),
              AllOf(HasSubstr("/nowhere/robot.urdf"), HasSubstr("cannot read")));
}

TEST(LoadRobotErrors, NameTheLineOfBrokenXml) {
  EXPECT_THAT(error_of(kRobots + "broken.urdf"), HasSubstr("broken.urdf:5: not well-formed"));
}

TEST(LoadRobotErrors, SayWhatADriveNeeds) {
  EXPECT_THAT(error_of(kRobots + "no_wheels.urdf"),
              AllOf(HasSubstr("no_wheels.urdf"), HasSubstr("no drive wheels"),
                    HasSubstr("lone_joint"), HasSubstr("continuous")));
}

TEST(LoadRobotErrors, PassOnWhatUrdfdomSays) {
  testing::internal::CaptureStderr();
  EXPECT_THAT(error_of(kRobots + "two_roots.urdf"),
              AllOf(HasSubstr("two_roots.urdf"), HasSubstr("missing_link")));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(LoadRobotErrors, NameTheLineOfWhatXacroMisses) {
  EXPECT_THAT(error_of(kRobots + "needs_xacro.urdf"),
              AllOf(HasSubstr("needs_xacro.urdf:3: <xacro:include>"), HasSubstr("wheels.xacro"),
                    HasSubstr("does not exist")));
}

TEST(LoadRobotErrors, SayThatAFileOfMacrosIsNoRobot) {
  const std::string path = testing::TempDir() + "castaway-macros.xacro";
  std::ofstream(path) << "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro "
                         "name='wheel' params='name'><link name='${name}'/></xacro:macro></robot>";
  EXPECT_THAT(error_of(path), HasSubstr("it has no <link>; if it defines macros only"));
  std::filesystem::remove(path);
}

TEST(LoadRobotErrors, RefuseOtherXml) {
  EXPECT_THAT(error_of(CASTAWAY_TEST_DATA "/meshes/cube.obj"), HasSubstr("cube.obj"));
}

}  // namespace
}  // namespace castaway::sim
