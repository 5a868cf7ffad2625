#include "sim/scene/scene.hpp"

#include <gtest/gtest.h>

#include "sim/scene/primitives.hpp"

namespace castaway::sim {
namespace {

using Eigen::Vector3f;

SceneItem box_at(const Vector3f& center) {
  SceneItem item;
  item.mesh = box_mesh({1.0F, 2.0F, 3.0F});
  item.T_map_mesh.translation() = center;
  return item;
}

TEST(BoundsOf, IsAroundTheItemWhereItStands) {
  EXPECT_TRUE(bounds_of(SceneItem{}).isEmpty());
  const Eigen::AlignedBox3f bounds = bounds_of(box_at({10.0F, 0.0F, 0.0F}));
  EXPECT_TRUE(bounds.min().isApprox(Vector3f(9.5F, -1.0F, -1.5F)));
  EXPECT_TRUE(bounds.max().isApprox(Vector3f(10.5F, 1.0F, 1.5F)));
}

TEST(LitBounds, LeaveOutWhatIsNotLit) {
  Scene scene;
  EXPECT_TRUE(lit_bounds(scene).isEmpty());
  scene.items = {box_at({10.0F, 0.0F, 0.0F}), SceneItem{}, box_at({90.0F, 0.0F, 0.0F})};
  scene.items.back().shaded = false;
  EXPECT_NEAR(lit_bounds(scene).max().x(), 10.5F, 1e-5F);
}

TEST(StandingHeight, LeavesOutRoofs) {
  EXPECT_EQ(standing_height({}), 0.0F);
  std::vector<SceneItem> items{box_at({0.0F, 0.0F, 1.5F}), box_at({0.0F, 0.0F, 5.0F})};
  items.back().casts_shadow = false;
  EXPECT_NEAR(standing_height(items), 3.0F, 1e-5F);
}

}  // namespace
}  // namespace castaway::sim
