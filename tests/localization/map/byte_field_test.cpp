#include "localization/map/byte_field.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

TEST(ByteField, TakesTheBestOfEveryCoarseCell) {
  const OccupancyGrid grid = test::string_map({"......", "......", "......", "#....."}, 0.1);
  const ByteField field(grid, DistanceField(grid, 5.0), {0.2, 0.1, 1.0});
  EXPECT_EQ(field.frame().width, 3);
  EXPECT_EQ(field.frame().height, 2);
  EXPECT_DOUBLE_EQ(field.frame().resolution, 0.2);
  EXPECT_EQ(*field.cell(0, 0), 255);
  EXPECT_EQ(*field.cell(1, 0), std::lround(255.0 * std::exp(-2.0)));  // nearest fine cell: 0.2 m
  EXPECT_EQ(*field.cell(-3, 1), 0);                                   // padding
}

TEST(ByteField, IsFreeWhereAnyFineCellIs) {
  const OccupancyGrid grid = test::string_map({"##  ", "##. "}, 0.1);
  const ByteField field(grid, DistanceField(grid, 5.0), {0.2, 0.1, 1.0});
  EXPECT_FALSE(field.is_free(0, 0));
  EXPECT_TRUE(field.is_free(1, 0));
}

}  // namespace
}  // namespace castaway::localization
