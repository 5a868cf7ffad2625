#include "localization/map/ray_cast.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

const OccupancyGrid kRoom = test::string_map(
    {
        "......",
        "...#..",
        "......",
        "..... ",
    },
    1.0);

Eigen::Vector2d towards(double x, double y) { return Eigen::Vector2d(x, y).normalized(); }

TEST(CastRay, EndsAtTheBorderOfTheFirstWall) {
  EXPECT_DOUBLE_EQ(cast_ray(kRoom, {0.5, 2.5}, {1.0, 0.0}, 10.0), 2.5);
  EXPECT_DOUBLE_EQ(cast_ray(kRoom, {5.75, 2.5}, {-1.0, 0.0}, 10.0), 1.75);
  EXPECT_DOUBLE_EQ(cast_ray(kRoom, {3.5, 0.25}, {0.0, 1.0}, 10.0), 1.75);
}

TEST(CastRay, CrossesCellsAtTheirBorders) {
  // From (1.5, 0.25) along (2, 3): x = 3 is reached at y = 2.5, in the side of the wall.
  EXPECT_NEAR(cast_ray(kRoom, {1.5, 0.25}, towards(2.0, 3.0), 10.0), std::hypot(1.5, 2.25), 1e-12);
  // A steeper ray reaches y = 3 at x = 2.6 and passes.
  EXPECT_NEAR(cast_ray(kRoom, {1.5, 0.25}, towards(1.1, 2.75), 10.0), std::hypot(1.5, 3.75), 1e-12);
}

TEST(CastRay, EndsAtUnknownCellsAndAtTheEdge) {
  EXPECT_DOUBLE_EQ(cast_ray(kRoom, {0.5, 0.5}, {1.0, 0.0}, 10.0), 4.5);
  EXPECT_DOUBLE_EQ(cast_ray(kRoom, {0.5, 0.5}, {-1.0, 0.0}, 10.0), 0.5);
  EXPECT_DOUBLE_EQ(cast_ray(kRoom, {0.5, 0.5}, {0.0, 1.0}, 10.0), 3.5);
}

TEST(CastRay, GoesNoFartherThanAsked) {
  EXPECT_EQ(cast_ray(kRoom, {0.5, 2.5}, {1.0, 0.0}, 2.0), 2.0);
}

TEST(CastRay, HasNoWayFromWithinAWall) {
  EXPECT_EQ(cast_ray(kRoom, {3.5, 2.5}, {1.0, 0.0}, 10.0), 0.0);
  EXPECT_EQ(cast_ray(kRoom, {-3.0, 2.5}, {1.0, 0.0}, 10.0), 0.0);
}

TEST(CastRay, AgreesWithSmallSteps) {
  const OccupancyGrid office = test::office();
  const Eigen::Vector2d from(4.31, 3.02);
  for (int i = 0; i < 90; ++i) {
    const double heading = 0.0698 * i + 0.01;
    const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
    const double cells = cast_ray(office, from / 0.05, direction, 1000.0);
    EXPECT_NEAR(cells * 0.05, test::cast(office, from, heading, 20.0), 0.0021) << heading;
  }
}

}  // namespace
}  // namespace castaway::localization
