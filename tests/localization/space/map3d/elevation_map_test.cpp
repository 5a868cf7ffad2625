#include "localization/space/map3d/elevation_map.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

/// Two cells of 1 m from (10, 5): a floor at 0 under a ramp at 3 m, and nothing.
ElevationMap two_cells() {
  ElevationMap map;
  map.frame = {2, 1, 1.0, {10.0, 5.0, 0.0}};
  map.first = {0, 2, 2};
  map.surfaces = {{0.0F, 0.0F, 0.0F, 2.8F, 0, true}, {3.0F, 0.2F, -0.1F, 9.0F, 1, true}};
  map.levels = {0.0F, 3.0F};
  return map;
}

TEST(ElevationMapTest, HoldsSeveralSurfacesInACell) {
  const ElevationMap map = two_cells();
  EXPECT_NO_THROW(validate(map));
  EXPECT_EQ(map.at({0, 0}).size(), 2U);
  EXPECT_TRUE(map.at({1, 0}).empty());
  EXPECT_TRUE(map.at({-1, 0}).empty());
}

TEST(ElevationMapTest, TheNearestSurfaceInHeightIsMeant) {
  const ElevationMap map = two_cells();
  EXPECT_EQ(surface_near(map, {10.5, 5.5}, 1.4), &map.surfaces[0]);
  EXPECT_EQ(surface_near(map, {10.5, 5.5}, 1.6), &map.surfaces[1]);
  EXPECT_EQ(surface_near(map, {11.5, 5.5}, 0.0), nullptr);
  EXPECT_EQ(surface_near(map, {10.5, 4.5}, 0.0), nullptr);
}

TEST(ElevationMapTest, GroundRisesWithItsSlopeWithinACell) {
  const ElevationMap map = two_cells();
  EXPECT_NEAR(ground_height(map, {10.5, 5.5}, 3.0), 3.0, 1e-6);
  EXPECT_NEAR(ground_height(map, {10.9, 5.3}, 3.0), 3.0 + 0.08 + 0.02, 1e-6);
  EXPECT_NEAR(ground_height(map, {10.9, 5.3}, 0.4), 0.0, 1e-6);
  EXPECT_TRUE(std::isnan(ground_height(map, {11.5, 5.5}, 0.0)));
}

TEST(ElevationMapTest, ATurnedGridTurnsItsSlopes) {
  ElevationMap map = two_cells();
  map.frame.T_map_grid.yaw = M_PI_2;  // x of the grid is y of the map.
  EXPECT_NEAR(ground_height(map, {9.5, 5.9}, 3.0), 3.0 + 0.08, 1e-6);
}

TEST(ElevationMapTest, PartsThatDoNotFitAreRefused) {
  ElevationMap map = two_cells();
  map.first = {0, 3, 2};
  EXPECT_THROW(validate(map), std::invalid_argument);
  map = two_cells();
  map.surfaces[0].level = 2;
  EXPECT_THROW(validate(map), std::invalid_argument);
  map = two_cells();
  map.surfaces[0].z = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(validate(map), std::invalid_argument);
  map = two_cells();
  map.levels.clear();
  EXPECT_THROW(validate(map), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
