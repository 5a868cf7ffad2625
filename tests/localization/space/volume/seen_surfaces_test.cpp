#include "localization/space/volume/seen_surfaces.hpp"

#include <gtest/gtest.h>

#include "localization/space/map3d/survey_ground.hpp"
#include "tests/localization/space/volume/voxel_maps.hpp"

namespace castaway::localization {
namespace {

using Eigen::Vector3d;

/// The four faces x or y = 0 or `size` of a room 2 m high, moved outwards.
void add_faces(double size, double outwards, VoxelBuilder& builder) {
  const double low = -outwards;
  const double length = size + 2.0 * outwards;
  const Vector3d up(0.0, 0.0, 2.0);
  for (const double at : {low, size + outwards}) {
    test::add_plane({at, low, 0.0}, {0.0, length, 0.0}, up, builder);
    test::add_plane({low, at, 0.0}, {length, 0.0, 0.0}, up, builder);
  }
}

/// A closed room of 6 x 6 m with walls 0.25 m thick.
VoxelMap room() {
  VoxelBuilder builder(test::kSmallVoxel);
  for (int x = 0; x < 120; ++x) {
    for (int y = 0; y < 120; ++y) builder.add({0.05 * x + 0.025, 0.05 * y + 0.025, 0.0}, true);
  }
  test::add_plane({-0.25, -0.25, 2.0}, {6.5, 0.0, 0.0}, {0.0, 6.5, 0.0}, builder);
  add_faces(6.0, 0.0, builder);
  add_faces(6.0, 0.25, builder);
  return builder.build();
}

TEST(SeenSurfaces, LeaveOutWhatIsBehindWalls) {
  const VoxelMap map = room();
  const VoxelMap seen = seen_surfaces(map, survey_ground(map, {}, Vector3d(3.0, 3.0, 0.0)));
  EXPECT_TRUE(map.contains({30, -3, 10}));
  EXPECT_FALSE(seen.contains({30, -3, 10}));  // Outer faces.
  EXPECT_FALSE(seen.contains({62, 30, 10}));
  EXPECT_TRUE(seen.contains({30, 0, 10}));  // Inner faces.
  EXPECT_TRUE(seen.contains({60, 30, 10}));
  EXPECT_TRUE(seen.contains({30, 30, 0}));   // Floor.
  EXPECT_TRUE(seen.contains({30, 30, 20}));  // Ceiling.
  EXPECT_TRUE(seen.contains({0, 0, 0}));     // The corner of walls and floor.
  ASSERT_EQ(seen.offsets.size(), seen.size());
  ASSERT_EQ(seen.faces_up.size(), seen.size());
}

TEST(SeenSurfaces, OfNothingAreNothing) {
  const VoxelMap nothing{test::kSmallVoxel, {}, {}, {}};
  EXPECT_EQ(seen_surfaces(nothing, ElevationMap{}).size(), 0U);
}

}  // namespace
}  // namespace castaway::localization
