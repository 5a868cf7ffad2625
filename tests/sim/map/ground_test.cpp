#include "sim/map/ground.hpp"

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"
#include "sim/map/rasterise.hpp"
#include "sim/stages/drive_space.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

WorldObject ramp(const std::string& name, double x, double yaw) {
  WorldObject object;
  object.name = name;
  object.shape = RampShape{{2.0, 2.0, 0.2}};
  object.T_map_object =
      Eigen::Translation3d(x, 3.0, 0.1) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  object.drivable = true;
  return object;
}

/// A ramp up, a deck of 3 m x 2 m, and a ramp down, along y = 3 from x = 3 to x = 10.
WorldSpec bridge() {
  WorldSpec world;
  world.name = "bridge";
  world.max_corner = {13.0, 6.0};
  WorldObject deck = box_on_floor("deck", {3.0, 2.0, 0.2}, {6.5, 3.0});
  deck.drivable = true;
  world.objects = {ramp("up", 4.0, 0.0), deck, ramp("down", 9.0, 3.141592653589793)};
  return world;
}

TEST(Ground, IsAsHighAsItsSurfaces) {
  const WorldSpec world = bridge();
  const Grid grid = rasterise(world, 1.0, 0.05);
  const auto heights = ground_heights(world, grid);
  const auto at = [&](double x, double y) {
    return static_cast<double>(heights.at(flat_index(grid, cell_of(grid, {x, y}))));
  };
  EXPECT_NEAR(at(4.025, 3.025), 0.1025, 1e-6);
  EXPECT_NEAR(at(6.5, 3.5), 0.2, 1e-6);
  EXPECT_NEAR(at(9.025, 2.525), 0.0975, 1e-6);
  EXPECT_EQ(at(6.5, 4.5), 0.0);
  EXPECT_TRUE(ground_heights(test_room(), grid).empty());
}

TEST(Ground, IsTheLowestFloorUnderAnother) {
  WorldSpec world = bridge();
  const Grid grid = rasterise(world, 1.0, 0.05);
  const std::vector<float> heights = ground_heights(world, grid);
  WorldObject upper;
  upper.name = "upper";
  upper.shape = BoxShape{{12.0, 8.0, 0.2}};
  upper.T_map_object.translation() = Eigen::Vector3d(6.0, 4.0, 2.9);
  upper.drivable = true;
  world.objects.push_back(upper);
  EXPECT_EQ(ground_heights(world, grid), heights);
}

/// A ramp can be driven along but not across its sides, and nobody is put down on it.
TEST(Ground, LeadsUpTheRampAndNotOverItsEdges) {
  SimulationConfig config;
  config.world = bridge();
  config.robot = test_robot();
  config.map = rasterise(config.world, 0.13, 0.05);  // The map shows the deck as an obstacle.
  EXPECT_EQ(cell_at(config.map, {6.5, 3.0}), Cell::kOccupied);
  const Grid drive = drive_grid(config);
  const FreeSpace way(drive, 0.25);
  EXPECT_TRUE(way.contains_segment({1.0, 3.0}, {12.0, 3.0}));
  EXPECT_FALSE(way.contains_segment({6.5, 3.0}, {6.5, 5.0}));
  EXPECT_FALSE(way.contains_segment({4.8, 3.0}, {4.8, 5.0}));
  const FreeSpace landing(landing_grid(config, drive), 0.25);
  EXPECT_FALSE(landing.contains({6.5, 3.0}));
  EXPECT_FALSE(landing.contains({4.0, 3.0}));
  EXPECT_TRUE(landing.contains({6.5, 5.0}));
}

TEST(Ground, IsDrivenOver) {
  SimulationConfig config = test_simulation();
  config.world = bridge();
  config.map = rasterise(config.world, 0.13, 0.05);
  config.start = {1.0, 3.0, 0.0};
  config.drive.waypoints = {{12.0, 3.0}};
  config.drive.loop = false;
  config.duration = std::chrono::seconds(30);
  Simulation simulation(config, test_streams(1));
  double last_x = 1.0;
  while (const auto frame = simulation.next()) {
    const Pose2 pose = simulation.true_pose();
    EXPECT_NEAR(pose.y, 3.0, 0.1);
    EXPECT_GT(pose.x, last_x - 0.01);
    last_x = pose.x;
  }
  EXPECT_NEAR(simulation.true_pose().x, 12.0, 0.2);
  EXPECT_EQ(simulation.collisions(), 0);
}

}  // namespace
}  // namespace castaway::sim
