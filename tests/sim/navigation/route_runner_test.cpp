#include "sim/navigation/route_runner.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/map/rasterise.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

constexpr double kControlPeriod = 0.05;  // [s]

FreeSpace room() { return {rasterise(test_room(), 0.2, 0.05), 0.3}; }

RouteConfig route(std::vector<Eigen::Vector2d> waypoints, bool loop) {
  RouteConfig config;
  config.waypoints = std::move(waypoints);
  config.loop = loop;
  return config;
}

/// Exact unicycle motion.
Pose2 moved(const Pose2& pose, const Twist2& twist) {
  const double yaw = pose.yaw + 0.5 * twist.w * kControlPeriod;
  return {pose.x + twist.v * kControlPeriod * std::cos(yaw),
          pose.y + twist.v * kControlPeriod * std::sin(yaw),
          wrap_angle(pose.yaw + twist.w * kControlPeriod)};
}

TEST(RouteRunner, ReachesItsWaypointsAndStops) {
  RouteRunner runner(route({{2.5, -1.5}, {-3.0, 2.0}}, false), room());
  Pose2 pose{-3.0, -2.0, 1.0};
  double nearest_first = 10.0;
  for (int i = 0; i < 2000; ++i) {
    pose = moved(pose, runner.command(pose));
    nearest_first = std::min(nearest_first, std::hypot(pose.x - 2.5, pose.y + 1.5));
  }
  EXPECT_LT(nearest_first, 0.11);
  EXPECT_NEAR(pose.x, -3.0, 0.14);
  EXPECT_NEAR(pose.y, 2.0, 0.14);
  EXPECT_EQ(runner.command(pose).v, 0.0);
  EXPECT_TRUE(runner.path().empty());
}

/// Waypoints outside the room are replaced by the nearest free places.
TEST(RouteRunner, PassesNoWaypointFarFromWhichItStays) {
  RouteRunner runner(route({{2.5, -1.5}, {-3.0, 20.0}, {-3.0, 30.0}}, false), room());
  Pose2 pose{-3.0, -2.0, 1.0};
  for (int i = 0; i < 3000; ++i) pose = moved(pose, runner.command(pose));
  EXPECT_TRUE(runner.done());
  EXPECT_EQ(runner.waypoints_reached(), 1);
}

TEST(RouteRunner, NeverLeavesTheFreeSpace) {
  const FreeSpace tight(rasterise(test_room(), 0.2, 0.05), 0.2);
  RouteRunner runner(route({{2.5, -1.5}, {2.5, 2.0}, {-2.0, 2.0}, {-3.0, -2.0}}, true), room());
  Pose2 pose{-3.0, -2.0, 0.0};
  double way = 0.0;
  for (int i = 0; i < 6000; ++i) {
    const Twist2 twist = runner.command(pose);
    pose = moved(pose, twist);
    way += twist.v * kControlPeriod;
    ASSERT_TRUE(tight.contains(pose.position())) << i;
  }
  EXPECT_GT(way, 80.0);
}

TEST(RouteRunner, PlansAnewAfterAJump) {
  RouteRunner runner(route({{2.5, -1.5}}, false), room());
  runner.command(Pose2{-3.0, -2.0, 0.0});
  const Pose2 elsewhere{-1.0, 2.0, 0.0};
  runner.command(elsewhere);
  ASSERT_FALSE(runner.path().empty());
  EXPECT_LT((runner.path().front() - elsewhere.position()).norm(), 0.05);
}

TEST(RouteRunner, DetoursUntilTheNextWaypoint) {
  RouteRunner runner(route({{2.5, -1.5}}, false), room());
  Pose2 pose{-3.0, -2.0, 0.0};
  runner.command(pose);
  const auto passes = [&runner](const Eigen::Vector2d& p_map) {
    for (const Eigen::Vector2d& p : runner.path()) {
      if ((p - p_map).norm() < 0.3) return true;
    }
    return false;
  };
  const Eigen::Vector2d in_the_way(0.0, -1.8);
  WorldSpec blocked = test_room();
  blocked.objects.push_back(box_on_floor("crate", {0.6, 1.0, 1.0}, in_the_way));
  ASSERT_TRUE(passes(in_the_way));
  runner.detour(pose, FreeSpace(rasterise(blocked, 0.2, 0.05), 0.3));
  EXPECT_FALSE(passes(in_the_way));
  for (int i = 0; i < 1500; ++i) pose = moved(pose, runner.command(pose));
  EXPECT_LT((pose.position() - Eigen::Vector2d(2.5, -1.5)).norm(), 0.15);
}

TEST(RouteRunner, DrivesUpToAPlaceThatIsAStepAway) {
  RouteRunner runner(route({{0.0, -1.8}, {2.5, -1.5}}, false), room());
  Pose2 pose{-0.25, -1.8, 0.0};
  runner.command(pose);
  const RoundObstacle around_it{{-0.25, -1.8},
                                0.1};  // Its own place is occupied: the path has one point.
  runner.detour(pose, runner.free().with_discs({&around_it, 1}));
  for (int i = 0; i < 1500; ++i) pose = moved(pose, runner.command(pose));
  EXPECT_LT((pose.position() - Eigen::Vector2d(2.5, -1.5)).norm(), 0.15);
}

TEST(RouteRunner, TurnsOnTheSpotTowardsWhatIsBehind) {
  RouteRunner runner(route({{2.5, -1.5}}, false), room());
  const Twist2 twist = runner.command(Pose2{-3.0, -1.9, 3.0});
  EXPECT_EQ(twist.v, 0.0);
  EXPECT_GT(std::abs(twist.w), 0.5);
}

TEST(RouteRunner, StandsWithoutAPoseOrARoute) {
  RouteRunner runner(route({{2.5, -1.5}}, false), room());
  EXPECT_EQ(runner.command(std::nullopt).v, 0.0);
  RouteRunner idle(route({}, true), room());
  EXPECT_EQ(idle.command(Pose2{}).v, 0.0);
}

}  // namespace
}  // namespace castaway::sim
