#include "tools/pages/run/map_svg.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

/// Cells with different values, so that each is known again.
RosMap numbered_map(double yaw) {
  RosMap map;
  map.name = "numbers";
  map.width = 10;
  map.height = 8;
  map.resolution = 0.5;
  map.origin_x = 1.0;
  map.origin_y = 2.0;
  map.origin_yaw = yaw;
  for (int i = 0; i < 80; ++i) map.cells.push_back(static_cast<std::int8_t>(i));
  return map;
}

void expect_point(const Eigen::Vector2d& point, double x, double y) {
  EXPECT_NEAR(point.x(), x, 1e-9);
  EXPECT_NEAR(point.y(), y, 1e-9);
}

/// Every cell of a part is that of the map at the same point.
void expect_part_of(const RosMap& map, const RosMap& part) {
  ASSERT_EQ(part.cells.size(), static_cast<std::size_t>(part.width * part.height));
  for (int row = 0; row < part.height; ++row) {
    for (int column = 0; column < part.width; ++column) {
      const Eigen::Vector2d p_map = part.to_map({column + 0.5, row + 0.5});
      const Eigen::Vector2d pixel = map_pixel(map, p_map);
      const int in_map =
          map.at(static_cast<int>(pixel.x()), static_cast<int>(map.height - pixel.y()));
      EXPECT_EQ(part.at(column, row), in_map) << column << " " << row;
    }
  }
}

TEST(MapPixel, IsInCellsFromTheUpperLeftCorner) {
  const RosMap map = numbered_map(0.0);
  expect_point(map_pixel(map, {1.0, 2.0}), 0.0, 8.0);
  expect_point(map_pixel(map, {6.0, 6.0}), 10.0, 0.0);
  expect_point(map_pixel(map, {2.25, 3.0}), 2.5, 6.0);
}

TEST(MapPixel, FollowsARotatedGrid) {
  const RosMap map = numbered_map(0.5 * std::numbers::pi);  // its x is map's y
  expect_point(map_pixel(map, {1.0, 2.0}), 0.0, 8.0);
  expect_point(map_pixel(map, {1.0, 4.0}), 4.0, 8.0);
  expect_point(map_pixel(map, {-0.5, 2.0}), 0.0, 5.0);
  const RosMap slanted = numbered_map(0.3);
  const Eigen::Vector2d p_map = slanted.to_map({2.5, 6.0});
  expect_point(map_pixel(slanted, p_map), 2.5, 2.0);
}

TEST(CutOut, IsThePartWithinReach) {
  const RosMap map = numbered_map(0.0);
  const RosMap part = cut_out(map, {3.5, 4.0}, 1.0);  // cell corner (5, 4), 2 cells around
  EXPECT_EQ(part.width, 4);
  EXPECT_EQ(part.height, 4);
  EXPECT_DOUBLE_EQ(part.origin_x, 2.5);
  EXPECT_DOUBLE_EQ(part.origin_y, 3.0);
  EXPECT_EQ(part.resolution, 0.5);
  EXPECT_EQ(part.at(0, 0), 23);
  EXPECT_EQ(part.at(3, 3), 56);
  expect_part_of(map, part);
}

TEST(CutOut, FollowsARotatedGrid) {
  for (const double yaw : {0.3, -2.0, 0.5 * std::numbers::pi}) {
    const RosMap map = numbered_map(yaw);
    const Eigen::Vector2d p_map = map.to_map({5.25, 4.25});
    const RosMap part = cut_out(map, p_map, 1.0);
    EXPECT_EQ(part.origin_yaw, yaw);
    EXPECT_EQ(part.width, 4);
    EXPECT_EQ(part.height, 4);
    expect_part_of(map, part);
    // The point is where it was.
    expect_point(map_pixel(part, p_map), 5.25 - 3.0, 4.0 - (4.25 - 2.0));
  }
}

TEST(CutOut, EndsWithTheMap) {
  const RosMap map = numbered_map(0.0);
  const RosMap corner = cut_out(map, {1.0, 2.0}, 1.0);
  EXPECT_EQ(corner.width, 2);
  EXPECT_EQ(corner.height, 2);
  expect_part_of(map, corner);
  const RosMap other = cut_out(map, {6.0, 6.0}, 1.0);
  EXPECT_EQ(other.width, 2);
  EXPECT_EQ(other.at(1, 1), 79);
  expect_part_of(map, other);
  const RosMap all = cut_out(map, {3.0, 3.0}, 100.0);
  EXPECT_EQ(all.cells, map.cells);
  expect_part_of(map, all);
}

TEST(CutOut, OffTheMapIsTheNearestCell) {
  const RosMap map = numbered_map(0.0);
  EXPECT_EQ(cut_out(map, {-9.0, -9.0}, 1.0).cells, (std::vector<std::int8_t>{0}));
  EXPECT_EQ(cut_out(map, {90.0, 90.0}, 1.0).cells, (std::vector<std::int8_t>{79}));
}

TEST(MapSvg, HoldsMapContentAndScale) {
  RosMap map;
  map.width = 200;
  map.height = 100;
  map.cells.assign(20000, 0);
  EXPECT_DOUBLE_EQ(map_stroke(map), 0.5);
  const std::string svg = map_svg(map, true, "<path id=\"x\"/>", "a < b");
  EXPECT_TRUE(contains(svg, "viewBox=\"0 0 200 105.5\""));
  EXPECT_TRUE(contains(svg, "aria-label=\"a &lt; b\""));
  EXPECT_TRUE(contains(svg, "<image width=\"200\" height=\"100\" href=\"data:image/png;base64,"));
  EXPECT_TRUE(contains(svg, "<path id=\"x\"/>"));
  EXPECT_TRUE(contains(svg, "h40.0v"));  // 2 m
  EXPECT_TRUE(contains(svg, ">2 m</text>"));
  EXPECT_FALSE(contains(map_svg(map, false, "", ""), "<image"));
}

}  // namespace
}  // namespace castaway::testbed
