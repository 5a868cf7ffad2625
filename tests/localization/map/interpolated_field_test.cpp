#include "localization/map/interpolated_field.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

InterpolatedField identity_field(const OccupancyGrid& grid) {
  return {DistanceField(grid, 3.0), [](double d) { return d; }};
}

TEST(InterpolatedField, HasTheCellsValueAtItsCentre) {
  const InterpolatedField field = identity_field(test::string_map({"#....", "....."}, 1.0));
  EXPECT_FLOAT_EQ(field.at_cells(0.5F, 1.5F), 0.0F);
  EXPECT_FLOAT_EQ(field.at_cells(2.5F, 1.5F), 2.0F);
}

TEST(InterpolatedField, IsLinearBetweenCentres) {
  const InterpolatedField field = identity_field(test::string_map({"#....", "#...."}, 1.0));
  EXPECT_FLOAT_EQ(field.at_cells(1.0F, 1.0F), 0.5F);
  EXPECT_FLOAT_EQ(field.at_cells(1.75F, 1.25F), 1.25F);
}

TEST(InterpolatedField, IsTheFarthestValueOffTheMap) {
  const InterpolatedField field = identity_field(test::string_map({"#"}, 1.0));
  EXPECT_FLOAT_EQ(field.at_cells(-50.0F, 0.5F), 3.0F);
  EXPECT_FLOAT_EQ(field.at_cells(0.5F, 1e9F), 3.0F);
  EXPECT_FLOAT_EQ(field.at_cells(std::numeric_limits<float>::quiet_NaN(), 0.5F), 3.0F);
  EXPECT_FLOAT_EQ(field.at_cells(-std::numeric_limits<float>::infinity(), 1e38F), 3.0F);
  EXPECT_FLOAT_EQ(field.at_cells(2.5F, 0.5F), 3.0F);
}

TEST(InterpolatedField, OfFourPointsIsThatOfEach) {
  const InterpolatedField field = identity_field(test::string_map({"#....", "..#.."}, 0.7));
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  const std::array<float, 8> values{-1e30F, -0.3F, 0.123F, 1.777F, 2.5F, 4.9F, 1e9F, kNaN};
  for (const float x : values) {
    for (const float y : values) {
      const FourFloats xs{x, y, 1.9F, 3.3F};
      const FourFloats ys{y, 0.6F, x, 1.1F};
      const FourFloats four = field.at_cells(xs, ys);
      for (int i = 0; i < 4; ++i) EXPECT_EQ(four[i], field.at_cells(xs[i], ys[i])) << x << " " << y;
    }
  }
}

TEST(InterpolatedField, NeedsNoMoreMemoryForTheFinestCells) {
  const InterpolatedField field = identity_field(test::string_map({"#....", "....."}, 1e-6));
  EXPECT_FLOAT_EQ(field.at_cells(2.5F, 1.5F), 2e-6F);
}

}  // namespace
}  // namespace castaway::localization
