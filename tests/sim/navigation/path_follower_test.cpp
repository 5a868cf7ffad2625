#include "sim/navigation/path_follower.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

const Eigen::Vector2d kGoal(-3.0, 2.0);

PathFollower to_goal() { return {FollowerConfig{}, {{-1.0, 5.0}, {-2.0, 3.0}, kGoal}}; }

/// A pose at a distance from the goal, in a direction from it.
Pose2 beside_goal(double distance, double direction) {
  const Eigen::Vector2d p =
      kGoal + distance * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  return {p.x(), p.y(), 0.3};
}

TEST(PathFollower, ArrivesFromEverySide) {
  const double tolerance = FollowerConfig{}.goal_tolerance;
  for (int degree = 0; degree < 360; degree += 10) {
    const double direction = degree * std::numbers::pi / 180.0;
    EXPECT_TRUE(to_goal().has_arrived(beside_goal(0.99 * tolerance, direction))) << degree;
    EXPECT_FALSE(to_goal().has_arrived(beside_goal(1.01 * tolerance, direction))) << degree;
  }
}

TEST(PathFollower, IsAsFarOffThePathAsFromItsNearestPoint) {
  const PathFollower follower = to_goal();
  EXPECT_EQ(follower.nearest(), Eigen::Vector2d(-1.0, 5.0));
  EXPECT_NEAR(follower.off_path({-1.3, 5.4, 2.0}), 0.5, 1e-12);
}

}  // namespace
}  // namespace castaway::sim
