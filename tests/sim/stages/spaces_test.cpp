#include "sim/stages/spaces.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/stages/drive_space.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

TEST(Spaces, AreTheSameAsThoseComputedAlone) {
  const SimulationConfig config = test_simulation();
  const Grid drive = drive_grid(config);
  Spaces spaces;
  for (const double radius : {0.3, 0.1, 0.3}) {
    EXPECT_EQ(spaces.on_map(config.map, radius).grid().cells,
              FreeSpace(config.map, radius).grid().cells);
    EXPECT_EQ(spaces.driving(config, radius).grid().cells, FreeSpace(drive, radius).grid().cells);
    EXPECT_EQ(spaces.landing(config, radius).clearance(),
              FreeSpace(landing_grid(config, drive), radius).clearance());
  }
}

TEST(Spaces, AreComputedOnce) {
  const SimulationConfig config = test_simulation();
  Spaces spaces;
  EXPECT_EQ(&spaces.driving(config, 0.2).grid(), &spaces.driving(config, 0.2).grid());
  EXPECT_NE(&spaces.driving(config, 0.2).grid(), &spaces.landing(config, 0.2).grid());
  EXPECT_EQ(spaces.walking(config.world, config.map), spaces.walking(config.world, config.map));
}

TEST(Spaces, AreOfOneWorld) {
  SimulationConfig config = test_simulation();
  Spaces spaces;
  spaces.driving(config, 0.2);
  config.world.objects.push_back(box_on_floor("box", {0.5, 0.5, 0.2}, {1.0, 1.0}));
  EXPECT_THROW(spaces.landing(config, 0.2), std::logic_error);
  EXPECT_THROW(spaces.walking(config.world, config.map), std::logic_error);
}

TEST(Spaces, DependOnTheHeightOfTheRobot) {
  SimulationConfig config = test_simulation();
  WorldObject beam = box_on_floor("beam", {0.5, 0.5, 0.2}, {1.0, 1.0});
  beam.T_map_object.translation().z() = 1.5;
  config.world.objects.push_back(beam);
  Spaces spaces;
  config.robot.height = 0.5;
  EXPECT_TRUE(spaces.driving(config, 0.1).contains({1.0, 1.0}));
  config.robot.height = 2.0;
  EXPECT_FALSE(spaces.driving(config, 0.1).contains({1.0, 1.0}));
}

TEST(Spaces, KeepAFewOnly) {
  const SimulationConfig config = test_simulation();
  Spaces spaces;
  const FreeSpace first = spaces.driving(config, 0.05);
  for (int i = 1; i < 20; ++i) spaces.driving(config, 0.05 + 0.01 * i);
  EXPECT_NE(&spaces.driving(config, 0.05).grid(), &first.grid());
  EXPECT_EQ(spaces.driving(config, 0.05).grid().cells, first.grid().cells);
}

}  // namespace
}  // namespace castaway::sim
