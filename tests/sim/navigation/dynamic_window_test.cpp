#include "sim/navigation/dynamic_window.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

const DynamicWindowConfig kWindowConfig{};
const Twist2 kRolling{0.4, 0.0};

/// Points from `a` to `b` every 2 cm.
std::vector<Eigen::Vector2d> wall(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  std::vector<Eigen::Vector2d> points;
  const int count = static_cast<int>((b - a).norm() / 0.02) + 1;
  for (int i = 0; i <= count; ++i) points.emplace_back(a + (b - a) * i / count);
  return points;
}

/// Least distance between the robot's disc and a point along 1.6 s at a velocity, in fine steps.
double room_of(const Twist2& twist, const std::vector<Eigen::Vector2d>& points) {
  double room = 100.0;
  for (double t = 0.0; t <= kWindowConfig.horizon; t += 0.01) {
    const Eigen::Vector2d p = arc(twist.v * t, twist.w * t).position();
    for (const auto& point : points)
      room = std::min(room, (point - p).norm() - kWindowConfig.radius);
  }
  return room;
}

TEST(DynamicWindow, DrivesStraightWhereTheWayIsClear) {
  const auto twist = best_twist(kWindowConfig, kRolling, {2.0, 0.0}, {});
  ASSERT_TRUE(twist);
  EXPECT_NEAR(twist->v, 0.5, 1e-9);
  EXPECT_NEAR(twist->w, 0.0, 1e-9);
}

TEST(DynamicWindow, TurnsTowardsItsTarget) {
  EXPECT_GT(best_twist(kWindowConfig, kRolling, {1.0, 1.0}, {})->w, 0.2);
  EXPECT_LT(best_twist(kWindowConfig, kRolling, {1.0, -1.0}, {})->w, -0.2);
}

TEST(DynamicWindow, StaysWithinWhatTheDriveCanDo) {
  const auto twist = best_twist(kWindowConfig, {0.1, 0.0}, {2.0, 0.0}, {});
  EXPECT_LE(twist->v, 0.1 + 0.5 * 0.4 + 1e-9);
}

TEST(DynamicWindow, PassesAPillarOnTheTargetsSideWithItsMargin) {
  const std::vector<Eigen::Vector2d> pillar{{0.8, -0.05}, {0.8, 0.0}};
  const auto twist = best_twist(kWindowConfig, kRolling, {2.0, 0.3}, pillar);
  ASSERT_TRUE(twist);
  EXPECT_GT(twist->w, 0.0);
  EXPECT_GT(room_of(*twist, pillar), 0.0);
}

TEST(DynamicWindow, NeverChoosesWhatRunsIntoAWall) {
  for (double distance = 0.3; distance < 1.5; distance += 0.05) {
    const auto points = wall({distance, -2.0}, {distance, 2.0});
    const auto twist = best_twist(kWindowConfig, kRolling, {2.0, 0.5}, points);
    if (twist) {
      EXPECT_GT(room_of(*twist, points), std::min(0.0, distance - kWindowConfig.radius) - 1e-9);
    }
  }
}

TEST(DynamicWindow, StandsBeforeAWallThatFillsTheWay) {
  const auto points = wall({0.32, -2.0}, {0.32, 2.0});
  const auto twist = best_twist(kWindowConfig, {}, {1.0, 0.0}, points);
  EXPECT_TRUE(!twist || twist->v < 0.05);
}

TEST(DynamicWindow, ComesOffWhatIsTooNear) {
  const auto points = wall({-0.26, -0.5}, {-0.26, 0.5});  // behind the robot, within the margin
  const auto twist = best_twist(kWindowConfig, {}, {1.0, 0.0}, points);
  ASSERT_TRUE(twist);
  EXPECT_GT(twist->v, 0.0);
}

TEST(DynamicWindow, MeetsWhoMovesWhereTheyWillBe) {
  const Mover crossing{{0.9, -1.2}, {0.0, 1.2}};  // blocks the way in a second
  const auto twist = best_twist(kWindowConfig, kRolling, {2.0, 0.0}, {}, {crossing});
  ASSERT_TRUE(twist);
  for (double t = 0.0; t <= kWindowConfig.horizon; t += 0.2) {
    const Eigen::Vector2d p = arc(twist->v * t, twist->w * t).position();
    EXPECT_GT((crossing.p + t * crossing.velocity - p).norm(), kWindowConfig.radius + kMoverRadius)
        << t;
  }
  const Mover leaving{{0.9, 0.0}, {0.0, 1.2}};  // blocks the way now, but not later
  const auto straight = best_twist(kWindowConfig, kRolling, {2.0, 0.0}, {}, {leaving});
  EXPECT_NEAR(straight->v, 0.5, 1e-9);
}

TEST(DynamicWindow, WaitsForWhoStandsTooNearAhead) {
  EXPECT_FALSE(best_twist(kWindowConfig, {}, {2.0, 0.0}, {}, {{{0.5, 0.0}, {-0.3, 0.0}}}));
  EXPECT_TRUE(best_twist(kWindowConfig, {}, {2.0, 0.0}, {}, {{{-0.5, 0.0}, {-0.3, 0.0}}}));
}

}  // namespace
}  // namespace castaway::sim
