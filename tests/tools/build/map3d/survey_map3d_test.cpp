#include "tools/build/map3d/survey_world.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/build/map3d/level_picture.hpp"
#include "tools/build/map3d/map3d_files.hpp"

namespace castaway::testbed {
namespace {

sim::WorldObject object(sim::ObjectShape shape, const Eigen::Vector3d& at) {
  sim::WorldObject made;
  made.shape = std::move(shape);
  made.T_map_object.translation() = at;
  return made;
}

/// 12 m x 8 m; over the half x > 6 a deck at 3 m, to which a ramp of 20 % leads in its first lane.
sim::WorldSpec deck() {
  sim::WorldSpec world;
  world.name = "deck";
  world.min_corner = {-10.0, 0.0};
  world.max_corner = {12.0, 8.0};
  world.objects.push_back(object(sim::BoxShape{{6.0, 8.0, 0.2}}, {9.0, 4.0, 2.9}));
  world.objects.push_back(object(sim::RampShape{{15.0, 2.0, 3.0}}, {-1.5, 1.0, 1.5}));
  return world;
}

TEST(SurveyMap3d, AWorldOfTwoFloorsHasTwoLevels) {
  const Map3d map = survey_world(deck(), {});
  ASSERT_EQ(map.ground.levels.size(), 2U);
  EXPECT_NEAR(map.ground.levels[0], 0.0, 0.003);
  EXPECT_NEAR(map.ground.levels[1], 3.0, 0.003);
  EXPECT_NEAR(drivable_area(map.ground, 1), 6.0 * 8.0, 8.0);  // Less its edges, and the ramp's end.
  const auto* ramp = localization::surface_near(map.ground, {-1.5, 1.0}, 1.5);
  ASSERT_NE(ramp, nullptr);
  EXPECT_TRUE(ramp->drivable);
  EXPECT_NEAR(ramp->slope_x, 0.2, 0.02);
  EXPECT_NEAR(localization::ground_height(map.ground, {-1.5, 1.0}, 1.5), 1.5, 0.01);
  // The floor goes on under the deck, and is not there within the ramp.
  EXPECT_EQ(localization::surface_near(map.ground, {9.0, 4.0}, 0.0)->level, 0);
  EXPECT_GT(localization::surface_near(map.ground, {4.0, 1.0}, 0.0)->z, 2.0F);
}

TEST(SurveyMap3d, APointCloudIsSurveyedAlike) {
  std::vector<Eigen::Vector3d> points;
  const Map3d map = survey_world(deck(), {});
  for (std::size_t i = 0; i < map.voxels.size(); ++i) points.push_back(map.voxels.point(i));
  const Map3d again = survey_map3d(points, {});
  EXPECT_EQ(again.voxels.keys, map.voxels.keys);
  EXPECT_EQ(again.ground.levels.size(), 2U);
}

TEST(Map3dFiles, AreChosenByTheEndsOfTheirNames) {
  const TemporaryFolder folder;
  const Map3d map = survey_world(deck(), {});
  for (const char* name : {"a.map3d", "a.bt", "a.ot"}) {
    const auto file = folder.path() / name;
    ASSERT_TRUE(is_map3d_target(file));
    write_file(file, encode_map3d_file(map, file));
    const Map3d read = read_map3d_file(file, {});
    EXPECT_EQ(read.voxels.keys, map.voxels.keys) << name;
    EXPECT_EQ(read.ground.levels.size(), 2U) << name;
  }
  EXPECT_TRUE(is_map3d_source("a.ply"));
  EXPECT_FALSE(is_map3d_target("a.ply"));
  EXPECT_FALSE(is_map3d_source("lab"));
}

TEST(Map3dFiles, AMapWithoutSurfacesIsNamed) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "empty.bt";
  write_file(file, encode_map3d_file({{0.1, {}, {}, {}}, {}}, file));
  try {
    (void)read_map3d_file(file, {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), file.string() + ": a 3-D map without surfaces has no ground");
  }
}

std::uint32_t pixel(const sim::Image& image, int x, int y) {
  const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x));
  return static_cast<std::uint32_t>(image.pixels[at]) << 16U |
         static_cast<std::uint32_t>(image.pixels[at + 1]) << 8U | image.pixels[at + 2];
}

TEST(LevelPicture, ShowsTheLevelsSideBySide) {
  const sim::Image image = level_picture(survey_world(deck(), {}).ground);
  EXPECT_EQ(image.width, 12 + 2 * (221 + 12));
  EXPECT_EQ(image.height, 20 + 81 + 12);
  const int row = 20 + 80 - 60;                        // y = 6 m.
  EXPECT_NE(pixel(image, 12 + 190, row), 0xffffffU);   // The floor under the deck.
  EXPECT_NE(pixel(image, 245 + 190, row), 0xffffffU);  // The deck.
  EXPECT_EQ(pixel(image, 245 + 50, row), 0xffffffU);   // Beside it.
}

}  // namespace
}  // namespace castaway::testbed
