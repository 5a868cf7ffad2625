#include "localization/space/map3d/voxel_columns.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "localization/space/map3d/voxel_builder.hpp"

namespace castaway::localization {
namespace {

TEST(FindTops, KeepsWhatFacesUpWithRoomAbove) {
  VoxelBuilder builder(0.1);
  builder.add({0.03, 0.05, 0.02});        // Too low under the next one.
  builder.add({0.05, 0.05, 0.52});        // A step,
  builder.add({0.05, 0.05, 2.0}, false);  // the underside of a roof,
  builder.add({0.05, 0.05, 2.2});         // and the roof.
  builder.add({0.35, 0.25, -1.0});
  const VoxelColumns columns = find_tops(builder.build(), 1.0);
  EXPECT_EQ(columns.frame.width, 4);
  EXPECT_EQ(columns.frame.height, 3);
  const auto tops = columns.at({0, 0});
  ASSERT_EQ(tops.size(), 2U);
  EXPECT_NEAR(tops[0].p.z(), 0.52, 0.001);
  EXPECT_NEAR(tops[0].clearance, 1.48, 0.001);
  EXPECT_TRUE(std::isinf(tops[1].clearance));
  ASSERT_EQ(columns.at({3, 2}).size(), 1U);
  EXPECT_NEAR(columns.at({3, 2})[0].p.x(), 0.0, 0.001);  // From the cell's centre.
  EXPECT_TRUE(columns.at({1, 0}).empty());
  EXPECT_TRUE(columns.at({-1, 0}).empty());
}

}  // namespace
}  // namespace castaway::localization
