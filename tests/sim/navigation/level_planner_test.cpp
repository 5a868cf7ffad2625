#include "sim/navigation/level_planner.hpp"

#include <gtest/gtest.h>

#include "sim/navigation/route_runner.hpp"
#include "tests/sim/support/bridge_plane.hpp"

namespace castaway::sim {
namespace {

const Eigen::Vector2d kHall{10.0, 5.0};
const Eigen::Vector2d kPlatform{10.0, 18.0};

TEST(LevelPlanner, GoesAroundToTheRampAndUp) {
  const FreeSpace free = FreeSpace::on_levels(bridge_plane(), 0.2);
  const auto path = plan_over_levels(free, kHall, kPlatform, {});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->front().z(), 0.0);
  EXPECT_NEAR(path->back().z(), 1.8, 1e-6);
  double length = 0.0;
  for (std::size_t i = 1; i < path->size(); ++i) {
    const Eigen::Vector3d way = (*path)[i] - (*path)[i - 1];
    EXPECT_LT(way.head<2>().norm(), 0.15);
    EXPECT_LT(std::abs(way.z()), 0.05);  // Nowhere a jump.
    length += way.norm();
  }
  EXPECT_GT(length, 15.0);  // 3 m as the crow flies.
}

TEST(LevelPlanner, APathEndsBehindItsChart) {
  const FreeSpace free = FreeSpace::on_levels(bridge_plane(), 0.2);
  const auto path = plan_path(free, kHall, kPlatform);
  ASSERT_TRUE(path);
  EXPECT_LT(path->back().y(), 6.0);  // In the hall's chart.
  EXPECT_NEAR(path->back().x(), 3.0, 0.15);
  const auto within = plan_path(free, {6.0, 18.0}, kPlatform);
  ASSERT_TRUE(within);
  EXPECT_NEAR((within->back() - kPlatform).norm(), 0.0, 0.1);
}

TEST(LevelPlanner, NoPathWhereTheRampIsTooNarrow) {
  const auto plane = bridge_plane();
  const FreeSpace wide = FreeSpace::on_levels(plane, 1.2);
  const auto path = plan_over_levels(wide, kHall, kPlatform, {});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->back().z(), 0.0);  // The free place nearest to the goal in the plane.
}

/// A point robot that follows its commands exactly, and whose pose is in the chart of its ground.
TEST(RouteRunnerOnLevels, DrivesUpAndDownAgain) {
  const auto plane = bridge_plane();
  RouteConfig config;
  config.waypoints = {kPlatform, kHall};
  config.loop = false;
  RouteRunner route(config, FreeSpace::on_levels(plane, 0.2));
  Pose2 pose{12.0, 5.0, 0.0};
  double highest = 0.0;
  for (int i = 0; i < 4000 && !route.done(); ++i) {
    const Twist2 twist = route.command(pose);
    pose = {pose.x + 0.05 * twist.v * std::cos(pose.yaw),
            pose.y + 0.05 * twist.v * std::sin(pose.yaw), pose.yaw + 0.05 * twist.w};
    const double z = plane->p_map(pose.position()).z();
    pose = plane->on_plane(plane->in_map(pose), z).value();
    highest = std::max(highest, z);
  }
  EXPECT_TRUE(route.done());
  EXPECT_EQ(route.waypoints_reached(), 2);
  EXPECT_NEAR(highest, 1.8, 1e-6);
  EXPECT_LT((pose.position() - kHall).norm(), 0.2);
}

}  // namespace
}  // namespace castaway::sim
