#include "tools/build/map3d/level_maps.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/map_value.hpp"
#include "tests/tools/support/two_floors.hpp"
#include "tools/build/map3d/level_plane_of.hpp"

namespace castaway::testbed {
namespace {

TEST(LevelMaps, AreOneForEachFloor) {
  const LevelMaps levels = level_maps(*level_plane_of(two_floors()));
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_NEAR(levels[0].z, 0.0, 0.02);
  EXPECT_NEAR(levels[1].z, 2.0, 0.02);
  EXPECT_EQ(levels[0].map.width, levels[1].map.width);
  EXPECT_EQ(levels[0].map.cells.size(), levels[1].map.cells.size());
}

TEST(LevelMaps, ShowGroundWhereItIs) {
  const LevelMaps levels = level_maps(*level_plane_of(two_floors()));
  EXPECT_EQ(value_at(levels[0].map, 4.05, 7.05), 0);   // Beside the upper floor.
  EXPECT_EQ(value_at(levels[1].map, 4.05, 2.55), 0);   // On it.
  EXPECT_EQ(value_at(levels[1].map, 4.05, 7.05), -1);  // There is none.
}

TEST(LevelMaps, DrawARampDarkOnTheFloorFromWhichItRises) {
  const LevelMaps levels = level_maps(*level_plane_of(two_floors()));
  EXPECT_NEAR(value_at(levels[0].map, 10.65, 2.55), 45, 2);  // 150 times a slope of 0.3.
  EXPECT_EQ(value_at(levels[1].map, 10.65, 2.55), -1);
}

TEST(LevelMaps, DrawARimAroundGround) {
  const RosMap map = level_maps(*level_plane_of(two_floors()))[1].map;
  double y = 3.05;
  while (value_at(map, 4.05, y) == 0) y += map.resolution;
  EXPECT_NEAR(y, 5.0, 0.3);
  EXPECT_EQ(value_at(map, 4.05, y), 100);
  EXPECT_EQ(value_at(map, 4.05, y + map.resolution), -1);
}

TEST(LevelMaps, AreTheSameOfAMapAsOfItsPlane) {
  const Map3d map = two_floors();
  const LevelMaps ours = level_maps(map.ground);
  const LevelMaps of_plane = level_maps(*level_plane_of(map));
  ASSERT_EQ(ours.size(), of_plane.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_EQ(ours[i].z, of_plane[i].z);
    for (double x = 0.25; x < 15.7; x += 0.5) {
      for (double y = 0.25; y < 7.7; y += 0.5) {
        EXPECT_EQ(value_at(ours[i].map, x, y), value_at(of_plane[i].map, x, y)) << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace castaway::testbed
