#include "tools/outputs/pictures/map_backdrop.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

/// A map of free cells.
RosMap free_map(int width, int height) {
  RosMap map;
  map.width = width;
  map.height = height;
  map.cells.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  return map;
}

/// Grey value of a pixel.
int gray_at(const sim::Image& image, int column, int row) {
  return image.pixels.at(3 * static_cast<std::size_t>(row * image.width + column));
}

TEST(MapBackdrop, ShowsASmallMapCellByCell) {
  RosMap map = free_map(3, 2);
  map.cells = {0, 100, -1, 0, 0, 0};  // The lower row first.
  const sim::Image image = map_backdrop(map);
  ASSERT_EQ(image.width, 3);
  ASSERT_EQ(image.height, 2);
  EXPECT_EQ(gray_at(image, 1, 1), 0);
  EXPECT_EQ(gray_at(image, 2, 1), 205);
  EXPECT_EQ(gray_at(image, 1, 0), 254);
}

TEST(MapBackdrop, KeepsEveryWallOfALargeMap) {
  RosMap map = free_map(4003, 11);  // Three cells per pixel; the last column and row are partial.
  map.cells[4 * 4003 + 1000] = 100;
  map.cells[4002] = 100;
  const sim::Image image = map_backdrop(map);
  ASSERT_EQ(image.width, 1335);
  ASSERT_EQ(image.height, 4);
  EXPECT_EQ(image.pixels.size(), 3U * 1335U * 4U);
  EXPECT_EQ(gray_at(image, 333, 2), 0);   // Row 6 from the top.
  EXPECT_EQ(gray_at(image, 1334, 3), 0);  // Row 10.
  EXPECT_EQ(gray_at(image, 334, 2), 254);
  EXPECT_EQ(gray_at(image, 333, 1), 254);
}

}  // namespace
}  // namespace castaway::testbed
