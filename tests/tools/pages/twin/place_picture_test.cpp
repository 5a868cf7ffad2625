#include "tools/pages/twin/place_picture.hpp"
#include "localization/geometry/se2.hpp"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

/// 50 x 40 m with cells of 0.5 m.
RosMap hall_map() {
  RosMap map;
  map.width = 100;
  map.height = 80;
  map.resolution = 0.5;
  map.cells.assign(8000, 0);
  return map;
}

/// Beams at right angles, the first one ahead.
LaserScan beams_of(std::vector<float> ranges) {
  LaserScan scan;
  scan.angle_min = 0.0;
  scan.angle_increment = 0.5 * std::numbers::pi;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  scan.ranges = std::move(ranges);
  return scan;
}

/// The dots of one colour: the group's content.
std::string dots_in(const std::string& svg, const std::string& color) {
  const std::string begin = "<g style=\"fill:" + color + "\">";
  const std::size_t at = svg.find(begin);
  if (at == std::string::npos) return "none";
  return svg.substr(at + begin.size(), svg.find("</g>", at) - at - begin.size());
}

// Around (25, 20) m, the picture begins at (13, 8) m: 12 m are 24 cells.
TEST(PlacePicture, ShowsTheMapWithinTwelveMetres) {
  const std::string svg = place_picture(hall_map(), {25.0, 20.0, 0.0}, beams_of({}), beams_of({}));
  EXPECT_TRUE(contains(svg, "<image width=\"48\" height=\"48\""));
  EXPECT_TRUE(contains(svg, "d=\"M24.0 24.0L25.2 24.0\""));  // the robot, 0.6 m ahead
  EXPECT_EQ(dots_in(svg, kLogColor), "");
  EXPECT_EQ(dots_in(svg, kTwinColor), "");
}

TEST(PlacePicture, ShowsTheEndsOfBothScans) {
  const std::string svg =
      place_picture(hall_map(), {25.0, 20.0, 0.0}, beams_of({2.0F}), beams_of({3.0F, 1.0F}));
  EXPECT_EQ(dots_in(svg, kLogColor), "<circle cx=\"28.0\" cy=\"24.0\" r=\"0.17\"/>");
  EXPECT_EQ(dots_in(svg, kTwinColor),
            "<circle cx=\"30.0\" cy=\"24.0\" r=\"0.10\"/>"
            "<circle cx=\"24.0\" cy=\"22.0\" r=\"0.10\"/>");  // to the left: up
}

TEST(PlacePicture, TurnsWithTheRobotAndItsLidar) {
  LaserScan scan = beams_of({2.0F});
  scan.T_base_laser = localization::to_se3({1.0, 0.0, 0.5 * std::numbers::pi});
  const std::string svg =
      place_picture(hall_map(), {25.0, 20.0, 0.5 * std::numbers::pi}, scan, beams_of({}));
  // The lidar is at (25, 21) m and looks along -x.
  EXPECT_EQ(dots_in(svg, kLogColor), "<circle cx=\"20.0\" cy=\"22.0\" r=\"0.17\"/>");
}

TEST(PlacePicture, LeavesOutBeamsWithoutReturnAndFarOnes) {
  const float none = std::numeric_limits<float>::infinity();
  for (const float r :
       {none, -none, std::numeric_limits<float>::quiet_NaN(), 0.05F, 12.5F, 30.0F}) {
    const std::string svg =
        place_picture(hall_map(), {25.0, 20.0, 0.0}, beams_of({r}), beams_of({}));
    EXPECT_EQ(dots_in(svg, kLogColor), "") << r;
  }
}

}  // namespace
}  // namespace castaway::testbed
