#include "tools/map3d/run_volume.hpp"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tools/map3d/survey_world.hpp"

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

}  // namespace
}  // namespace castaway::testbed
