#include "tools/build/map3d/run_volume.hpp"

#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tools/build/map3d/survey_world.hpp"

namespace castaway::testbed {
namespace {

using localization::Volume;

sim::WorldObject box(const std::string& name, const Eigen::Vector3d& size,
                     const Eigen::Vector3d& centre) {
  sim::WorldObject object;
  object.name = name;
  object.shape = sim::BoxShape{size};
  object.T_map_object = Eigen::Translation3d(centre);
  return object;
}

/// A floor of 6 x 6 m with the board of a table above its middle, 2 x 2 m, from 0.7 m up.
sim::SimulationConfig room_with_a_table(double robot_height) {
  sim::SimulationConfig config;
  config.world.name = "room";
  config.world.min_corner = {0.0, 0.0};
  config.world.max_corner = {6.0, 6.0};
  config.world.objects = {box("wall", {6.0, 0.2, 1.5}, {3.0, 0.1, 0.75}),
                          box("board", {2.0, 2.0, 0.05}, {3.0, 3.0, 0.725})};
  config.robot.height = robot_height;
  return config;
}

bool has_ground(const Volume& volume, double x, double y) {
  const auto pose = volume.atlas().to_atlas({x, y, 0.0}, 0.0);
  return pose && volume.lift(*pose);
}

TEST(RunVolume, GroundIsWhereTheRobotsBodyFits) {
  const auto low = volume_of(room_with_a_table(0.3))(0.1);
  const auto tall = volume_of(room_with_a_table(0.9))(0.1);
  EXPECT_TRUE(has_ground(*low, 1.0, 3.0));
  EXPECT_TRUE(has_ground(*low, 3.0, 3.0));
  EXPECT_TRUE(has_ground(*tall, 1.0, 3.0));
  EXPECT_FALSE(has_ground(*tall, 3.0, 3.0));
}

TEST(RunVolume, AKnownMapOfTheWorldIsTaken) {
  const sim::SimulationConfig config = room_with_a_table(0.9);
  const auto known = std::make_shared<const Map3d>(survey_world(config.world, {}));
  const auto taken = volume_of(room_with_a_table(0.3), known)(0.1);
  EXPECT_EQ(taken->atlas().ground().surfaces.size(), known->ground.surfaces.size());
  EXPECT_FALSE(has_ground(*taken, 3.0, 3.0));
  EXPECT_TRUE(has_ground(*volume_of(room_with_a_table(0.3), known)(0.15), 3.0, 3.0));
}

TEST(StanceOf, ARobotStandsOnItsWheelsAndCasters) {
  sim::RobotModel robot;
  EXPECT_FALSE(stance_of(robot).is_known());
  robot.chassis_mass = 3.0;
  robot.p_base_com = {-0.04, 0.0, 0.1};
  robot.wheels.resize(2);
  for (sim::DriveWheel& wheel : robot.wheels) wheel.mass = 0.5;
  robot.wheels[0].p_base_wheel = {0.0, 0.2, 0.06};
  robot.wheels[1].p_base_wheel = {0.0, -0.2, 0.06};
  robot.casters = {{{-0.1, 0.0, 0.02}, 0.02}};
  const localization::WheelStance wheels = stance_of(robot);
  ASSERT_EQ(wheels.contacts().size(), 3U);
  EXPECT_EQ(wheels.contacts()[1], Eigen::Vector2d(0.0, -0.2));
  EXPECT_EQ(wheels.contacts()[2], Eigen::Vector2d(-0.1, 0.0));
  EXPECT_TRUE(wheels.p_base_com().isApprox(Eigen::Vector3d(-0.03, 0.0, 0.09)));
}

TEST(RunVolume, TiltsTheRobotAsItsWheelsAre) {
  sim::SimulationConfig config = room_with_a_table(0.3);
  config.world.objects.push_back(box("kerb", {2.0, 6.0, 0.06}, {5.0, 3.0, 0.03}));
  config.robot.wheels.resize(2);
  config.robot.wheels[0].p_base_wheel = {0.0, 0.2, 0.06};
  config.robot.wheels[1].p_base_wheel = {0.0, -0.2, 0.06};
  config.robot.casters = {{{-0.5, 0.0, 0.02}, 0.02}};
  const auto volume = volume_of(config)(0.1);
  const auto on_the_kerb = volume->atlas().to_atlas({4.25, 3.0, 0.0}, 0.06);
  ASSERT_TRUE(on_the_kerb);
  const auto pose = volume->lift(*on_the_kerb);  // Its wheels are on it, its caster is below.
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->T_map_base.translation().z(), 0.06, 0.005);
  EXPECT_NEAR(std::atan(pose->T_map_base(2, 0)), std::atan(0.06 / 0.5), 0.01);
}

}  // namespace
}  // namespace castaway::testbed
