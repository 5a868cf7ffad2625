#include "tools/batch/trials/place_finder.hpp"

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
  EXPECT_LT(distance(places[0].T_map_base, pose), 0.05);
  EXPECT_LT(yaw_distance(places[0].T_map_base, pose), 0.02);
  const FoundPlace there = finder.refine(test::points_from(office, pose), pose);
  EXPECT_NEAR(there.log_likelihood, places[0].log_likelihood, 0.5);
}

TEST(PlaceFinder, CountsBeamsThatEndBeforeTheMapsWalls) {
  const localization::OccupancyGrid office = test::office();
  const PlaceFinder finder({}, office);
  const localization::SE2 pose{7.3, 2.1, -0.8};
  localization::ScanPoints points = test::points_from(office, pose);
  EXPECT_EQ(finder.blocked_share(points, pose), 0.0);
  const std::size_t blocked = points.size() / 3;
  for (std::size_t i = 0; i < blocked; ++i) {  // a person 0.5 m away; the walls are farther
    points.x[i] *= 0.5F / points.range[i];
    points.y[i] *= 0.5F / points.range[i];
    points.range[i] = 0.5F;
  }
  EXPECT_NEAR(finder.blocked_share(points, pose), 1.0 / 3.0, 0.02);
}

TEST(PlaceFinder, FindsNothingForAnEmptyScan) {
  const localization::OccupancyGrid office = test::office();
  EXPECT_TRUE(PlaceFinder({}, office).find({}).empty());
}

}  // namespace
}  // namespace castaway::testbed
