#include "sim/map/level_plane.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "sim/map/free_space.hpp"
#include "tests/sim/support/bridge_plane.hpp"

namespace castaway::sim {
namespace {

constexpr double kAbove = 16.0;  // [m] From the chart of the hall to that of the bridge.

TEST(LevelPlane, FindsTheFloorByItsHeight) {
  const auto plane = bridge_plane();
  const Pose2 T_map_base{10.0, 2.0, 0.5};
  EXPECT_EQ(*plane->on_plane(T_map_base, 0.1), T_map_base);
  const Pose2 up = *plane->on_plane(T_map_base, 1.7);
  EXPECT_NEAR(up.y, 2.0 + kAbove, 1e-9);
  EXPECT_NEAR(plane->in_map(up).y, 2.0, 1e-9);
  EXPECT_FALSE(plane->on_plane(T_map_base, 5.0));
  EXPECT_TRUE(plane->nearest_ground(T_map_base, 5.0));
  EXPECT_FALSE(plane->on_plane({-1.0, 2.0, 0.0}, 0.0));
  EXPECT_FALSE(plane->on_plane({3.0, 9.0, 0.0}, 0.0));
}

TEST(LevelPlane, FindsTheFloorByItsNumber) {
  const auto plane = bridge_plane();
  const Pose2 T_map_base{10.0, 2.0, 0.5};
  EXPECT_NEAR(plane->on_level(T_map_base, 1)->y, 2.0 + kAbove, 1e-9);
  EXPECT_EQ(plane->on_level(T_map_base, 0)->y, 2.0);
  EXPECT_EQ(plane->on_level(T_map_base, {})->y, 2.0);  // The lowest.
  EXPECT_FALSE(plane->on_level({1.0, 1.0, 0.0}, 1));
}

TEST(LevelPlane, ARobotOnARampIsTiltedAsTheGround) {
  const auto plane = bridge_plane();
  for (const double yaw : {0.0, 0.7, 1.6, -3.0}) {
    const Eigen::Isometry3d T_map_base = plane->standing_at({5.0, 2.0 + kAbove, yaw});
    EXPECT_NEAR(T_map_base.translation().z(), 0.9, 1e-6);
    EXPECT_NEAR(T_map_base.translation().y(), 2.0, 1e-9);
    EXPECT_NEAR(to_planar(T_map_base).yaw, yaw, 1e-9);
    const Eigen::Vector3d up = Eigen::Vector3d(-0.3, 0.0, 1.0).normalized();
    EXPECT_NEAR((T_map_base.linear().col(2) - up).norm(), 0.0, 1e-6);
    EXPECT_NEAR(T_map_base.linear().determinant(), 1.0, 1e-9);
  }
  EXPECT_NEAR(plane->slope_at({5.0, 2.0 + kAbove}), 0.3, 1e-6);
  EXPECT_EQ(plane->slope_at({1.0, 1.0}), 0.0);
}

TEST(FreeSpaceOnLevels, IsConnectedOverTheRamp) {
  const auto plane = bridge_plane();
  const FreeSpace free = FreeSpace::on_levels(plane, 0.2);
  EXPECT_TRUE(free.contains({1.0, 1.0}));
  EXPECT_TRUE(free.contains({10.0, 2.0}));
  EXPECT_TRUE(free.contains({10.0, 2.0 + kAbove}));
  EXPECT_FALSE(free.contains({10.0, 5.0 + kAbove}));  // Beside the platform.
  // Too wide for the ramp: the hall alone.
  EXPECT_FALSE(FreeSpace::on_levels(plane, 1.2).contains({10.0, 2.5 + kAbove}));
}

TEST(FreeSpaceOnLevels, CountsEveryPlaceOnce) {
  const auto plane = bridge_plane();
  const FreeSpace free = FreeSpace::on_levels(plane, 0.2);
  // The ramp's foot is in both charts; what is drawn is in its own.
  const Eigen::Vector2d twin(2.5, 2.0);
  EXPECT_TRUE(free.contains(twin));
  EXPECT_EQ(free.nearest_free(twin)->row, 20 + 160);
  Rng rng(3);
  for (int i = 0; i < 2000; ++i) {
    const Pose2 pose = *free.sample(rng);
    EXPECT_TRUE(plane->is_own(flat_index(plane->grid, cell_of(plane->grid, pose.position()))));
  }
}

}  // namespace
}  // namespace castaway::sim
