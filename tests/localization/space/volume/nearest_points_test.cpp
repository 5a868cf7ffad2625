#include "localization/space/volume/nearest_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/localization/space/volume/voxel_maps.hpp"

namespace castaway::localization {
namespace {

/// The squared distance from a voxel's centre to the i-th surface point, in edges of a voxel.
float square_to(const VoxelMap& map, std::size_t i, const Eigen::Vector3i& voxel) {
  const Eigen::Vector3f to_voxel = (voxel_index(map.keys[i]) - voxel).cast<float>();
  return (to_voxel + point_in_voxel(map, i) - Eigen::Vector3f::Constant(0.5F)).squaredNorm();
}

float least_square(const VoxelMap& map, const Eigen::Vector3i& voxel) {
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < map.size(); ++i) least = std::min(least, square_to(map, i, voxel));
  return least;
}

/// Calls `f(voxel, place, nearest points of its block)` for all voxels near surfaces.
template <typename Function>
void for_each_voxel(const VoxelMap& map, float radius, const Function& f) {
  const VoxelBlocks blocks(map, static_cast<int>(std::ceil(radius)));
  const SurfacePoints points(map, blocks, radius);
  blocks.for_each([&](const Eigen::Vector3i& block, std::uint32_t) {
    const NearestPoints nearest = points.nearest(block);
    for (std::uint32_t place = 0; place < VoxelBlocks::kVoxels; ++place) {
      f(Eigen::Vector3i(blocks.corner(block) + corner_in_block(place).cast<int>()), place, nearest);
    }
  });
}

void expect_those_of_all_points(float radius, int count) {
  Rng rng(31);
  const VoxelMap map = test::scattered(rng, count);
  for_each_voxel(
      map, radius,
      [&](const Eigen::Vector3i& voxel, std::uint32_t place, const NearestPoints& nearest) {
        const float least = least_square(map, voxel);
        EXPECT_NEAR(nearest.squares[place], std::min(least, radius * radius), 1e-3F);
        if (least > radius * radius - 1e-3F) return;
        EXPECT_NEAR(square_to(map, nearest.points[place], voxel), least, 1e-3F)
            << voxel.transpose();
      });
}

TEST(NearestPointsTest, AreThoseOfAllPoints) {
  expect_those_of_all_points(2.5F, 600);
  expect_those_of_all_points(4.0F, 150);
  expect_those_of_all_points(6.3F, 40);
}

/// The point that is taken for a voxel (first coordinate), of two in one row that are equally near.
std::uint32_t taken_of_two(int first, int second, int voxel) {
  const VoxelMap map{test::kSmallVoxel,
                     {voxel_key({first, 0, 0}), voxel_key({second, 0, 0})},
                     {{127, 128, 128}, {128, 128, 128}},
                     {1, 1}};
  std::uint32_t taken = 2;
  for_each_voxel(map, 4.0F,
                 [&](const Eigen::Vector3i& at, std::uint32_t place, const NearestPoints& nearest) {
                   if (at == Eigen::Vector3i(voxel, 0, 0)) taken = nearest.points[place];
                 });
  EXPECT_EQ(square_to(map, 0, {voxel, 0, 0}), square_to(map, 1, {voxel, 0, 0}));
  return taken;
}

// Blocks begin 6 voxels before the first point: at 0 they are of voxels -6 to -3, -2 to 1, 2 to 5.
TEST(NearestPointsTest, OfTwoThatAreEquallyNearOneOfTheBlockItselfIsTaken) {
  EXPECT_EQ(taken_of_two(0, 4, 2), 1U);
  EXPECT_EQ(taken_of_two(0, 2, 1), 0U);
}

TEST(NearestPointsTest, OfTwoThatAreEquallyNearTheFirstOneIsTaken) {
  EXPECT_EQ(taken_of_two(0, 6, 3), 0U);
  EXPECT_EQ(taken_of_two(0, 8, 4), 0U);
}

}  // namespace
}  // namespace castaway::localization
