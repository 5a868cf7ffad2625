#include "tools/map3d/level_plane_of.hpp"

#include <gtest/gtest.h>

#include "localization/map3d/voxel_builder.hpp"
#include "tools/map3d/survey_map3d.hpp"

namespace castaway::testbed {
namespace {

/// A floor of 8 m x 8 m with another one of 8 m x 5 m above it, at 2 m, and a ramp beside.
Map3d two_floors() {
  localization::VoxelBuilder builder(0.1);
  for (double x = 0.025; x < 16.0; x += 0.05) {
    for (double y = 0.025; y < 8.0; y += 0.05) {
      builder.add({x, y, 0.0}, true);
      if (x < 8.0 && y < 5.0) builder.add({x, y, 2.0}, true);
      if (x >= 8.0 && x < 14.67 && y > 1.0 && y < 4.0) builder.add({x, y, 0.3 * (14.67 - x)}, true);
    }
  }
  Map3dOptions options;
  options.ground.max_slope = 0.5;
  return survey_map3d(builder.build(), options);
}

TEST(LevelPlaneOf, HasEverySurfaceOnce) {
  const Map3d map = two_floors();
  const auto plane = level_plane_of(map);
  EXPECT_EQ(plane->levels, 2);
  std::size_t own = 0;
  for (std::size_t i = 0; i < plane->cells.size(); ++i) {
    own += plane->is_own(i) ? 1U : 0U;
    EXPECT_EQ(plane->grid.cells[i] == sim::Cell::kFree, plane->cells[i].own >= 0);
  }
  std::size_t drivable = 0;
  for (const auto& surface : map.ground.surfaces) drivable += surface.drivable ? 1U : 0U;
  EXPECT_EQ(own, drivable);
}

TEST(LevelPlaneOf, KnowsHeightsAndSlopes) {
  const auto plane = level_plane_of(two_floors());
  const sim::Pose2 below = plane->on_level({4.0, 2.5, 0.0}, 0).value();
  const sim::Pose2 above = plane->on_level({4.0, 2.5, 0.0}, 1).value();
  EXPECT_NEAR(plane->p_map(below.position()).z(), 0.0, 0.01);
  EXPECT_NEAR(plane->p_map(above.position()).z(), 2.0, 0.01);
  const sim::Pose2 ramp = plane->on_plane({10.67, 2.5, 0.0}, 1.2).value();
  EXPECT_NEAR(plane->p_map(ramp.position()).z(), 1.2, 0.02);
  EXPECT_NEAR(plane->slope_at(ramp.position()), 0.3, 0.02);
}

}  // namespace
}  // namespace castaway::testbed
