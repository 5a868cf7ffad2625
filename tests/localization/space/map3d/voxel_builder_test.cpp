#include "localization/space/map3d/voxel_builder.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(VoxelBuilderTest, AVoxelHoldsTheMeanOfItsPoints) {
  VoxelBuilder builder(0.1);
  builder.add({0.02, 0.05, -0.05});
  builder.add({0.31, 0.0, 0.0});
  builder.add({0.06, 0.05, -0.03});
  const VoxelMap map = builder.build();
  ASSERT_EQ(map.size(), 2U);
  EXPECT_EQ(voxel_index(map.keys[0]), Eigen::Vector3i(0, 0, -1));
  EXPECT_LT((map.point(0) - Eigen::Vector3d(0.04, 0.05, -0.04)).norm(), 0.0005);
  EXPECT_NO_THROW(validate(map));
}

TEST(VoxelBuilderTest, ManyPointsTakeTheMemoryOfTheirVoxels) {
  VoxelBuilder builder(0.1);
  constexpr int kPoints = 1'200'000;  // More than are kept one by one.
  for (int i = 0; i < kPoints; ++i) builder.add({i % 2 == 0 ? 0.05 : 5.05, 0.02, 0.01 * (i % 10)});
  const VoxelMap map = builder.build();
  ASSERT_EQ(map.size(), 2U);
  EXPECT_NEAR(map.point(0).z(), 0.04, 0.001);
  EXPECT_NEAR(map.point(1).z(), 0.05, 0.001);
}

TEST(VoxelBuilderTest, AVoxelFacesUpIfAnyOfItsPointsDoes) {
  VoxelBuilder builder(0.1);
  builder.add({0.02, 0.0, 0.0}, false);
  builder.add({5.0, 0.0, 0.0}, false);
  builder.add({0.03, 0.0, 0.0}, true);
  EXPECT_EQ(builder.build().faces_up, (std::vector<std::uint8_t>{1, 0}));
}

TEST(VoxelBuilderTest, IsEmptyAfterwards) {
  VoxelBuilder builder(0.1);
  builder.add({1.0, 1.0, 1.0});
  EXPECT_EQ(builder.build().size(), 1U);
  EXPECT_EQ(builder.build().size(), 0U);
}

TEST(VoxelBuilderTest, PointsThatAreNowhereAreRefused) {
  VoxelBuilder builder(0.1);
  EXPECT_THROW(builder.add({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}),
               std::invalid_argument);
  EXPECT_THROW(builder.add({0.0, -1e9, 0.0}), std::invalid_argument);
  EXPECT_THROW(VoxelBuilder(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
