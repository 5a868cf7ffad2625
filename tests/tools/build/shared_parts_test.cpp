#include "tools/build/shared_models.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/build/shared_worlds.hpp"

namespace castaway::testbed {
namespace {

const char* const kTwoRooms = R"(name: rooms
extent: {min: [0, 0], max: [8, 6]}
start: [1, 3, 0]
objects:
  - wall: {name: outer, closed: true, points: [[0.1, 0.1], [7.9, 0.1], [7.9, 5.9], [0.1, 5.9]]}
  - box: {name: crate, at: [5, 3], size: [0.6, 0.6, 1], movable: true}
)";

TEST(SharedParts, BuildAWorldOnceForEveryWayOfSurveyingIt) {
  const TemporaryFolder folder;
  const WorldChoice choice{folder.put("rooms.yaml", kTwoRooms).string()};
  SharedWorlds worlds;
  const SurveyOptions low{.lidar_height = 0.2};
  const auto world = worlds.get(choice, folder.path(), low);
  EXPECT_EQ(worlds.get(choice, folder.path(), low), world);
  SurveyOptions other_seed = low;
  other_seed.seed = 7;
  EXPECT_EQ(worlds.get(choice, folder.path(), other_seed), world);
  EXPECT_NE(worlds.get(choice, folder.path(), {.lidar_height = 1.5}), world);
  EXPECT_EQ(world->grid.cells, build_world(choice, folder.path(), low).grid.cells);
}

TEST(SharedParts, BuildAWorldWithDifferencesForEachRun) {
  const TemporaryFolder folder;
  const std::string text = std::string(kTwoRooms) + "differences: {remove: 1}\n";
  const WorldChoice changed{folder.put("rooms.yaml", text).string()};
  WorldChoice plain = changed;
  plain.differences.emplace();
  SharedWorlds worlds;
  const auto without = worlds.get(plain, folder.path(), {});
  EXPECT_FALSE(without->difference.has_value());
  EXPECT_EQ(worlds.get(plain, folder.path(), {}), without);
  const auto with = worlds.get(changed, folder.path(), {});
  EXPECT_TRUE(with->difference.has_value());
  EXPECT_NE(worlds.get(changed, folder.path(), {}), with);
}

TEST(SharedParts, BuildModelsOnceForASettingAndAMap) {
  const localization::OccupancyGrid office = test::office();
  SharedModels shared;
  const auto models = shared.get("a", {}, office);
  EXPECT_EQ(shared.get("a", {}, office), models);
  EXPECT_NE(shared.get("b", {}, office), models);
  localization::OccupancyGrid other = office;
  other.cells.front() = localization::CellState::kFree;
  EXPECT_NE(shared.get("a", {}, other), models);
}

}  // namespace
}  // namespace castaway::testbed
