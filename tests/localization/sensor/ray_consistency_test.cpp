#include "localization/sensor/ray_consistency.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

ScanPoints beam_forward(float range) {
  return {{range}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {range}};
}

bool through(const OccupancyGrid& grid, const SE2& pose, float range) {
  const WallClearance walls(DistanceField(grid, 5.0));
  return !RayConsistency(&walls, pose, {}).through_wall(beam_forward(range), {{0}}).empty();
}

// Walls at x = 2.0..2.1 and x = 5.0..5.1.
OccupancyGrid corridor() {
  std::string row(60, '.');
  row[20] = '#';
  row[50] = '#';
  return test::string_map({row, row, row}, 0.1);
}

TEST(RayConsistency, FindsTheWallBeforeTheEndPoint) {
  EXPECT_TRUE(through(corridor(), {0.55, 0.15, 0.0}, 4.45F));
  EXPECT_TRUE(through(corridor(), {3.55, 0.15, 3.141592653589793}, 3.0F));
}

TEST(RayConsistency, AllowsBeamsThatEndAtTheWallOrBefore) {
  EXPECT_FALSE(through(corridor(), {0.55, 0.15, 0.0}, 1.5F));
  EXPECT_FALSE(through(corridor(), {0.55, 0.15, 0.0}, 0.7F));
  EXPECT_FALSE(through(corridor(), {3.05, 0.15, 0.0}, 2.0F));
}

TEST(RayConsistency, AllowsAMarginBehindTheWall) {
  EXPECT_FALSE(through(corridor(), {0.55, 0.15, 0.0}, 1.7F));  // 0.25 m behind the wall's surface
  EXPECT_TRUE(through(corridor(), {0.55, 0.15, 0.0}, 1.9F));   // 0.45 m
}

TEST(RayConsistency, ForgivesTheObjectThatBaseStandsIn) {
  std::string row(60, '.');
  row.replace(10, 6, "######");
  row[50] = '#';
  const OccupancyGrid grid = test::string_map({row, row, row}, 0.1);
  EXPECT_FALSE(through(grid, {1.25, 0.15, 0.0}, 3.0F));
  EXPECT_TRUE(through(grid, {1.25, 0.15, 0.0}, 4.4F));  // the wall behind it counts
}

TEST(RayConsistency, EndsQuietlyOffTheMap) {
  EXPECT_FALSE(through(corridor(), {5.55, 0.15, 0.0}, 9.0F));
  EXPECT_FALSE(through(corridor(), {-3.0, -3.0, 0.0}, 1.0F));
}

}  // namespace
}  // namespace castaway::localization
