#include "tools/build/map3d/level_plane_of.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/two_floors.hpp"

namespace castaway::testbed {
namespace {

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
