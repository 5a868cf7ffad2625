#include "sim/stages/drive_space.hpp"

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

TEST(DriveSpace, ATallRobotMeetsBoardsBetweenAnyTwoHeights) {
  SimulationConfig config = test_simulation();
  config.robot.height = 1.2;
  WorldObject board = box_on_floor("board", {0.5, 0.5, 0.05}, {-1.0, 1.0});
  for (const double z : {0.25, 0.42, 0.75, 1.05}) {
    board.T_map_object.translation().z() = z;
    config.world.objects = {board};
    const Grid grid = drive_grid(config);
    EXPECT_EQ(cell_at(grid, {-1.0, 1.0}), Cell::kOccupied) << z;
  }
  config.robot.height = 0.15;
  const Grid below = drive_grid(config);
  EXPECT_EQ(cell_at(below, {-1.0, 1.0}), Cell::kFree);
}

}  // namespace
}  // namespace castaway::sim
