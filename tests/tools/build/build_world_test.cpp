#include "tools/build/build_world.hpp"

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

const std::string kRoom =
    "name: room\nextent: {min: [0, 0], max: [6, 4]}\nstart: [1, 1, 0]\nobjects:\n"
    "  - wall: {points: [[0.1, 0.1], [5.9, 0.1], [5.9, 3.9], [0.1, 3.9]], closed: true}\n"
    "  - box: {name: crate, at: [4, 3], size: [0.4, 0.4, 0.4]}\n";

TEST(BuildWorld, SurveysTheWorldAsItsFileHasIt) {
  const TemporaryFolder folder;
  folder.put("w.yaml", kRoom);
  const LoadedWorld world = build_world({"w.yaml", {}, {}}, folder.path(), {});
  EXPECT_EQ(world.grid.width, 120);
  EXPECT_EQ(sim::cell_at(world.grid, {4.0, 3.0}), sim::Cell::kOccupied);
  EXPECT_FALSE(world.difference.has_value());
  EXPECT_FALSE(differs_from_map(world.file.spec));
  EXPECT_TRUE(world.has_start);
}

TEST(BuildWorld, ChangesItAfterTheSurvey) {
  const TemporaryFolder folder;
  folder.put("w.yaml", kRoom + "differences: {changes: [{remove: {name: crate}}]}\n");
  const LoadedWorld world = build_world({"w.yaml", {}, {}}, folder.path(), {});
  EXPECT_EQ(sim::cell_at(world.grid, {4.0, 3.0}), sim::Cell::kOccupied);
  ASSERT_TRUE(world.difference.has_value());
  EXPECT_EQ(world.difference->removed, 1);
  EXPECT_TRUE(differs_from_map(world.file.spec));
}

TEST(BuildWorld, TakesTheScenariosDifferencesInPlaceOfTheFiles) {
  const TemporaryFolder folder;
  folder.put("w.yaml", kRoom + "differences: {remove: 1}\n");
  sim::DifferenceSpec boxes;
  boxes.add_boxes = 1;
  const LoadedWorld world = build_world({"w.yaml", {}, boxes}, folder.path(), {});
  ASSERT_TRUE(world.difference.has_value());
  EXPECT_EQ(world.difference->removed, 0);
  EXPECT_EQ(world.difference->added, 1);
  const LoadedWorld plain = build_world({"w.yaml", {}, sim::DifferenceSpec{}}, folder.path(), {});
  EXPECT_FALSE(plain.difference.has_value());
}

TEST(BuildWorld, GivesLocalizersAnotherMapIfAsked) {
  const TemporaryFolder folder;
  folder.put("w.yaml", kRoom);
  RosMap map;
  map.width = 3;
  map.height = 2;
  map.resolution = 0.2;
  map.cells = {0, 100, 0, 100, 100, 0};
  write_ros_map(map, folder.path() / "m.yaml");
  const LoadedWorld world = build_world({.file = "w.yaml", .map = "m.yaml"}, folder.path(), {});
  EXPECT_EQ(world.map.cells, map.cells);
  EXPECT_EQ(world.map.resolution, 0.2);
  EXPECT_EQ(world.grid.width, 120);  // the world's own survey
  EXPECT_EQ(sim::cell_at(world.grid, {4.0, 3.0}), sim::Cell::kOccupied);
}

TEST(BuildWorld, NamesAMapThatIsMissing) {
  const TemporaryFolder folder;
  folder.put("w.yaml", kRoom);
  const std::string error =
      error_of([&] { build_world({.file = "w.yaml", .map = "gone.yaml"}, folder.path(), {}); });
  EXPECT_TRUE(contains(error, (folder.path() / "gone.yaml").string()));
}

TEST(BuildWorld, SaysWhatANameCouldMean) {
  const TemporaryFolder folder;
  folder.put("w.yaml", kRoom + "differences: {changes: [{remove: {name: crates}}]}\n");
  const std::string error = error_of([&] { build_world({"w.yaml", {}, {}}, folder.path(), {}); });
  EXPECT_TRUE(contains(error, "no object 'crates'"));
  EXPECT_TRUE(contains(error, "'crate'"));
}

TEST(BuildWorld, SurveysTheSpaceAroundAGivenPointOfAnSdfWorld) {
  const TemporaryFolder folder;
  std::string walls;
  const auto wall = [&walls](const std::string& pose, const std::string& size) {
    walls += "<collision name='c" + std::to_string(walls.size()) + "'><pose>" + pose +
             " 0.5 0 0 0</pose><geometry><box><size>" + size +
             " 1</size></box></geometry></collision>";
  };
  wall("0 2", "4 0.1");
  wall("0 -2", "4 0.1");
  wall("2 0", "0.1 4.1");
  wall("-2 0", "0.1 4.1");
  wall("20 0", "0.1 4.1");  // The large open space is outside.
  folder.put("w.sdf",
             "<sdf version='1.6'><world name='w'><model name='m'><static>1</static>"
             "<link name='l'>" +
                 walls + "</link></model></world></sdf>");
  SurveyOptions options;
  const LoadedWorld inside = build_world({"w.sdf", {}, {}}, folder.path(), options);
  EXPECT_FALSE(inside.has_start);
  EXPECT_EQ(sim::cell_at(inside.grid, {0.0, 0.0}), sim::Cell::kFree);
  EXPECT_EQ(sim::cell_at(inside.grid, {10.0, 0.0}), sim::Cell::kUnknown);
  options.inside = Eigen::Vector2d(10.0, 0.0);
  const LoadedWorld outside = build_world({"w.sdf", {}, {}}, folder.path(), options);
  EXPECT_EQ(sim::cell_at(outside.grid, {0.0, 0.0}), sim::Cell::kUnknown);
  EXPECT_EQ(sim::cell_at(outside.grid, {10.0, 0.0}), sim::Cell::kFree);
}

/// A world with one wall of 1 m x 4 m and further elements.
std::string wall_and(const std::string& more) {
  return "<sdf version='1.6'><world name='w'><model name='m'><static>1</static><pose>0 0 0.5 0 0 0"
         "</pose><link name='l'><collision name='c'><geometry><box><size>1 4 1</size></box>"
         "</geometry></collision></link></model>" +
         more + "</world></sdf>";
}

TEST(BuildWorld, GoesOnWhereTheGroundDoes) {
  const TemporaryFolder folder;
  const auto plane = [](const std::string& size) {
    return "<model name='g'><static>1</static><link name='l'><collision name='c'><geometry><plane>"
           "<normal>0 0 1</normal><size>" +
           size +
           "</size></plane></geometry></collision></link>"
           "</model>";
  };
  folder.put("none.sdf", wall_and(""));
  folder.put("small.sdf", wall_and(plane("12 14")));
  folder.put("large.sdf", wall_and(plane("100 100")));
  folder.put("endless.sdf", wall_and(plane("1 1")));
  const auto size_of = [&](const char* file) -> Eigen::Vector2d {
    const sim::WorldSpec spec = build_world({file, {}, {}}, folder.path(), {}).file.spec;
    return spec.max_corner - spec.min_corner;
  };
  EXPECT_TRUE(size_of("none.sdf").isApprox(Eigen::Vector2d(1.0, 4.0), 1e-9));
  EXPECT_TRUE(size_of("small.sdf").isApprox(Eigen::Vector2d(12.0, 14.0), 1e-9));
  // 5 m around the wall, in which the robot stays, and 1 m more.
  EXPECT_TRUE(size_of("large.sdf").isApprox(Eigen::Vector2d(13.0, 16.0), 0.02));
  EXPECT_TRUE(size_of("endless.sdf").isApprox(Eigen::Vector2d(13.0, 16.0), 0.02));
}

/// A house with a doorway of 1 m in its southern wall, on a plane, and a tree outside.
TEST(BuildWorld, KeepsTheRobotInTheHouseUnlessToldOtherwise) {
  const TemporaryFolder folder;
  std::string house =
      "<model name='g'><static>1</static><link name='l'><collision name='c'><geometry><plane>"
      "<normal>0 0 1</normal><size>100 100</size></plane></geometry></collision></link></model>";
  const auto box = [&](const std::string& name, const std::string& pose, const std::string& size) {
    house += "<model name='" + name + "'><static>1</static><pose>" + pose +
             " 0.5 0 0 0</pose><link name='l'><collision name='c'><geometry><box><size>" + size +
             " 1</size></box></geometry></collision></link></model>";
  };
  box("north", "0 3", "8 0.1");
  box("west", "-4 0", "0.1 6");
  box("east", "4 0", "0.1 6");
  box("south-west", "-2.25 -3", "3.5 0.1");
  box("south-east", "2.25 -3", "3.5 0.1");
  box("tree", "0 -20", "0.3 0.3");
  folder.put("w.sdf", "<sdf version='1.6'><world name='w'>" + house + "</world></sdf>");
  const LoadedWorld world = build_world({"w.sdf", {}, {}}, folder.path(), {});
  EXPECT_EQ(sim::cell_at(world.grid, {0.02, 0.02}), sim::Cell::kFree);
  EXPECT_EQ(sim::cell_at(world.grid, {0.02, -5.02}), sim::Cell::kUnknown);
  EXPECT_LT((world.file.spec.max_corner - world.file.spec.min_corner).maxCoeff(), 11.0);
  EXPECT_LT(world.map.height * world.map.resolution, 10.0);
  ASSERT_EQ(world.warnings.size(), 1U);
  EXPECT_TRUE(contains(world.warnings.front(), "robots keep to what walls enclose"));
  SurveyOptions outside;
  outside.inside = Eigen::Vector2d(0.0, -10.0);
  const LoadedWorld told = build_world({"w.sdf", {}, {}}, folder.path(), outside);
  EXPECT_EQ(sim::cell_at(told.grid, {0.02, -10.02}), sim::Cell::kFree);
}

TEST(BuildWorld, IsNotBlownUpBySpecks) {
  const TemporaryFolder folder;
  const auto speck = [](const std::string& name, const std::string& x) {
    return "<model name='" + name + "'><static>1</static><pose>" + x +
           " 0 0.2 0 0 0</pose><link name='l'><collision name='c'><geometry><box><size>0.01 0.01 "
           "0.4</size></box></geometry></collision></link></model>";
  };
  folder.put("w.sdf", wall_and(speck("a", "-400") + speck("b", "401")));
  const LoadedWorld world = build_world({"w.sdf", {}, {}}, folder.path(), {});
  EXPECT_LT((world.file.spec.max_corner - world.file.spec.min_corner).maxCoeff(), 10.0);
  EXPECT_EQ(world.grid.resolution, 0.05);
}

TEST(BuildWorld, KeepsTheRobotInSightOfSomethingOnAPlain) {
  const TemporaryFolder folder;
  const auto plane =
      "<model name='g'><static>1</static><link name='l'><collision name='c'><geometry><plane>"
      "<normal>0 0 1</normal><size>100 100</size></plane></geometry></collision></link></model>";
  folder.put("w.sdf", wall_and(plane));
  const auto cell = [&](const SurveyOptions& options, double x, double y) {
    const LoadedWorld world = build_world({"w.sdf", {}, {}}, folder.path(), options);
    return sim::cell_at(world.grid, {x, y});
  };
  EXPECT_EQ(cell({}, 4.0, 0.0), sim::Cell::kFree);
  EXPECT_EQ(cell({}, 30.0, 30.0), sim::Cell::kUnknown);
  SurveyOptions started;
  started.inside = Eigen::Vector2d(30.0, 30.0);  // A start there selects this region.
  EXPECT_EQ(cell(started, 30.0, 30.0), sim::Cell::kFree);
}

TEST(BuildWorld, TakesLargerCellsForALargeWorld) {
  const TemporaryFolder folder;
  folder.put(
      "w.yaml",
      "name: plain\nextent: {min: [0, 0], max: [900, 900]}\nstart: [1, 1, 0]\nobjects: []\n");
  const LoadedWorld world = build_world({"w.yaml", {}, {}}, folder.path(), {});
  EXPECT_EQ(world.grid.resolution, 0.2);
  ASSERT_EQ(world.warnings.size(), 1U);
  EXPECT_TRUE(contains(world.warnings.front(), "cells of 0.2 m"));
}

TEST(BuildWorld, StandsOnTheSlabThatTheStartIsOn) {
  const TemporaryFolder folder;
  folder.put("w.yaml", kRoom + "  - box: {name: slab, at: [3, 2], size: [5.6, 3.6, 0.034]}\n");
  const LoadedWorld world = build_world({"w.yaml", {}, {}}, folder.path(), {});
  EXPECT_EQ(sim::cell_at(world.grid, {1.0, 1.0}), sim::Cell::kFree);
  for (const sim::WorldObject& object : world.file.spec.objects) EXPECT_NE(object.name, "slab");
}

}  // namespace
}  // namespace castaway::testbed
