#include "localization/space/volume/surface_along.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/localization/space/volume/voxel_maps.hpp"

namespace castaway::localization {
namespace {

constexpr float kFarthestSurface = 0.3F;  // [m]
constexpr double kNearEnough = 0.01;      // [m] A tenth of a voxel's edge.

/// The plane z = 0.03 of 2 m x 2 m.
SurfaceField plane() {
  VoxelBuilder builder(test::kSmallVoxel);
  test::add_plane({0.0, 0.0, 0.03}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, builder);
  return SurfaceField(builder.build(), 0.4);
}

TEST(SurfaceAlong, IsMeasuredAheadAndBack) {
  const FourFloats zero{};
  const FourPoints from{zero + 1.0F, zero + 1.0F, {0.13F, -0.07F, 0.13F, 0.03F}};
  const float s = std::sqrt(0.5F);
  const FourPoints down{{0.0F, 0.0F, s, s}, zero, {-1.0F, -1.0F, -s, -s}};
  const FourPoints up{{0.0F, 0.0F, -s, -s}, zero, {1.0F, 1.0F, s, s}};
  const SurfaceField field = plane();
  const FourFloats expected{0.1F, 0.1F, 0.1F / s, 0.0F};
  for (const FourPoints& direction : {down, up}) {
    const FourFloats found = surface_along(field, from, direction, kFarthestSurface);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(found[k], expected[k], kNearEnough) << k;
  }
}

TEST(SurfaceAlong, IsTheReachWhereThereIsNone) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const FourFloats zero{};
  const FourPoints from{{1.0F, 1.0F, 50.0F, kNan}, zero + 1.0F, {0.5F, 0.2F, 0.1F, 0.1F}};
  const FourPoints direction{{0.0F, 1.0F, 0.0F, 0.0F}, zero, {-1.0F, 0.0F, -1.0F, -1.0F}};
  const FourFloats found = surface_along(plane(), from, direction, kFarthestSurface);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(found[k], kFarthestSurface) << k;
}

}  // namespace
}  // namespace castaway::localization
