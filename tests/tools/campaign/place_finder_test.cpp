#include "tools/campaign/place_finder.hpp"

#include <gtest/gtest.h>

#include "tests/support/scan_points.hpp"

namespace castaway::testbed {
namespace {

TEST(PlaceFinder, FindsWhereAScanWasTaken) {
  const localization::OccupancyGrid office = test::office();
  const PlaceFinder finder({}, office);
  const localization::SE2 pose{7.3, 2.1, -0.8};
  const auto places = finder.find(test::points_from(office, pose));
  ASSERT_FALSE(places.empty());
  EXPECT_LT(distance(places[0], pose), 0.05);
  EXPECT_LT(yaw_distance(places[0], pose), 0.02);
}

TEST(PlaceFinder, FindsNothingForAnEmptyScan) {
  const localization::OccupancyGrid office = test::office();
  EXPECT_TRUE(PlaceFinder({}, office).find({}).empty());
}

}  // namespace
}  // namespace castaway::testbed
