#include "localization/space/volume/surface_patches.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/space/volume/voxel_maps.hpp"

namespace castaway::localization {
namespace {

TEST(SurfacePatches, OfATiltedPlaneHaveItsNormal) {
  const Eigen::Vector3d s(2.0, 0.3, 0.5);
  const Eigen::Vector3d t(-0.2, 2.0, 0.3);
  VoxelBuilder builder(test::kSmallVoxel);
  test::add_plane({0.03, 0.04, 0.05}, s, t, builder);
  const VoxelMap map = builder.build();
  const Eigen::Vector3f normal = s.cross(t).normalized().cast<float>();
  const auto patches = surface_patches(map);
  ASSERT_EQ(patches.size(), map.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Eigen::Vector3d p = map.point(i);
    if (p.x() < 0.3 || p.x() > 1.6 || p.y() < 0.5 || p.y() > 1.8) continue;  // Near its edges.
    ASSERT_EQ(patches[i].shape, PatchShape::kPlane);
    EXPECT_GT(std::abs(patches[i].axis.dot(normal)), 0.999F);
  }
}

TEST(SurfacePatches, BesideACornerThePlanesAreKeptApart) {
  VoxelBuilder builder(test::kSmallVoxel);
  test::add_plane({0.05, 0.05, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, builder);
  test::add_plane({0.05, 0.05, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 2.0}, builder);
  const VoxelMap map = builder.build();
  const auto patches = surface_patches(map);
  const auto beside = map.find({1, 0, 10});
  ASSERT_TRUE(beside);
  EXPECT_GT(std::abs(patches[*beside].axis.y()), 0.99F);
}

TEST(SurfacePatches, APoleIsALineAndASinglePointAPoint) {
  VoxelBuilder builder(test::kSmallVoxel);
  for (int i = 0; i < 200; ++i) builder.add({0.53, 0.56, 0.01 * i});
  builder.add({5.03, 0.02, 0.07});
  const VoxelMap map = builder.build();
  const auto patches = surface_patches(map);
  const auto pole = map.find({5, 5, 10});
  const auto point = map.find({50, 0, 0});
  ASSERT_TRUE(pole && point);
  EXPECT_EQ(patches[*pole].shape, PatchShape::kLine);
  EXPECT_GT(std::abs(patches[*pole].axis.z()), 0.999F);
  EXPECT_EQ(patches[*point].shape, PatchShape::kPoint);
}

TEST(WayFrom, IsStraightAwayFromPlanesAndLinesUpToTheirEnds) {
  const Eigen::Vector3f p(0.5F, 0.3F, 2.0F);
  const SurfacePatch plane{Eigen::Vector3f::UnitZ(), PatchShape::kPlane};
  EXPECT_TRUE(way_from(plane, p).isApprox(Eigen::Vector3f(0.0F, 0.0F, 2.0F)));
  const SurfacePatch line{Eigen::Vector3f::UnitZ(), PatchShape::kLine};
  EXPECT_TRUE(way_from(line, p).isApprox(Eigen::Vector3f(0.5F, 0.3F, 1.25F)));
  EXPECT_EQ(way_from({}, p), p);
  const Eigen::Vector3f beside(1.75F, 0.0F, 0.2F);
  EXPECT_TRUE(way_from(plane, beside).isApprox(Eigen::Vector3f(1.0F, 0.0F, 0.2F)));
}

}  // namespace
}  // namespace castaway::localization
