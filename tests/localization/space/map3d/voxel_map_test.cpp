#include "localization/space/map3d/voxel_map.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(VoxelKeys, GiveTheIndexBack) {
  for (const Eigen::Vector3i& index :
       {Eigen::Vector3i(0, 0, 0), Eigen::Vector3i(-1, 2, -3),
        Eigen::Vector3i(kMaxVoxelIndex, -kMaxVoxelIndex, kMaxVoxelIndex)}) {
    EXPECT_EQ(voxel_index(voxel_key(index)), index);
  }
}

TEST(VoxelKeys, AreOrderedByHeightFirst) {
  EXPECT_LT(voxel_key({9, 9, -1}), voxel_key({-9, -9, 0}));
  EXPECT_LT(voxel_key({9, -1, 0}), voxel_key({-9, 0, 0}));
  EXPECT_LT(voxel_key({-1, 0, 0}), voxel_key({0, 0, 0}));
}

TEST(VoxelOf, IsTheVoxelThatBeginsBelowThePoint) {
  EXPECT_EQ(voxel_of({0.0, 0.19, -0.01}, 0.1), Eigen::Vector3i(0, 1, -1));
}

VoxelMap two_voxels() {
  return {0.5, {voxel_key({-1, 0, 0}), voxel_key({2, 0, 0})}, {{0, 0, 0}, {128, 64, 255}}, {1, 1}};
}

TEST(VoxelMapTest, TakesTwelveBytesAVoxel) {
  VoxelMap map;
  map.keys.assign(10, 0);
  map.offsets.assign(10, {});
  map.faces_up.assign(10, 0);
  EXPECT_EQ(map.bytes(), 120U);
}

TEST(VoxelMapTest, FindsWhatIsOccupied) {
  const VoxelMap map = two_voxels();
  EXPECT_EQ(map.find({2, 0, 0}), 1U);
  EXPECT_TRUE(map.contains({-1, 0, 0}));
  EXPECT_FALSE(map.contains({0, 0, 0}));
}

TEST(VoxelMapTest, PointsAreInTheirVoxels) {
  const Eigen::Vector3d p = two_voxels().point(1);
  EXPECT_NEAR(p.x(), 1.25, 0.001);
  EXPECT_NEAR(p.y(), 0.125, 0.001);
  EXPECT_NEAR(p.z(), 0.5, 0.001);
  EXPECT_LT(p.z(), 0.5);
}

TEST(VoxelMapTest, IsRoughWhereNoSurfacePointsAreStated) {
  VoxelMap map = two_voxels();
  EXPECT_FALSE(is_rough(map));
  map.offsets = {{127, 127, 127}, {127, 127, 127}};
  EXPECT_TRUE(is_rough(map));
}

TEST(VoxelMapTest, WhatIsNoMapIsRefused) {
  VoxelMap map = two_voxels();
  EXPECT_NO_THROW(validate(map));
  std::swap(map.keys[0], map.keys[1]);
  EXPECT_THROW(validate(map), std::invalid_argument);
  map.keys[1] = map.keys[0];
  EXPECT_THROW(validate(map), std::invalid_argument);
  map = two_voxels();
  map.offsets.pop_back();
  EXPECT_THROW(validate(map), std::invalid_argument);
  map = two_voxels();
  map.resolution = 0.0;
  EXPECT_THROW(validate(map), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
