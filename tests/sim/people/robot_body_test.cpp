#include "sim/people/robot_body.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

TEST(RobotOutline, OfABoxIsItsRectangle) {
  const auto outline = robot_outline(test_robot());
  ASSERT_EQ(outline.size(), 4U);
  EXPECT_NEAR(outline[0].x(), -0.197, 1e-9);
  EXPECT_NEAR(outline[0].y(), -0.153, 1e-9);
  EXPECT_NEAR(outline[2].x(), 0.069, 1e-9);
}

TEST(RobotOutline, WithoutShapesIsTheFootprint) {
  RobotModel robot = test_robot();
  robot.collisions.clear();
  for (const Eigen::Vector2d& p : robot_outline(robot)) EXPECT_NEAR(p.norm(), 0.25, 1e-12);
}

TEST(OutlineDistance, IsToSidesAndCorners) {
  const RobotBody robot = square_robot({1.0, 2.0, 0.0});
  EXPECT_NEAR(distance_to(robot, {1.5, 2.1}).distance, 0.3, 1e-12);
  EXPECT_NEAR(distance_to(robot, {1.5, 2.1}).away.x(), 1.0, 1e-12);
  const OutlineDistance corner = distance_to(robot, {1.5, 2.5});
  EXPECT_NEAR(corner.distance, std::hypot(0.3, 0.3), 1e-12);
  EXPECT_NEAR(corner.away.y(), std::sqrt(0.5), 1e-12);
}

TEST(OutlineDistance, IsNegativeInsideAndPointsOutTheShortWay) {
  const OutlineDistance inside = distance_to(square_robot({0.0, 0.0, 0.0}), {0.05, -0.12});
  EXPECT_NEAR(inside.distance, -0.08, 1e-12);
  EXPECT_NEAR(inside.away.y(), -1.0, 1e-12);
}

TEST(OutlineDistance, TurnsWithTheRobot) {
  const OutlineDistance turned =
      distance_to(square_robot({0.0, 0.0, std::numbers::pi / 4}), {1.0, 0.0});
  EXPECT_NEAR(turned.distance, 1.0 - 0.2 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(turned.away.x(), 1.0, 1e-12);
}

}  // namespace
}  // namespace castaway::sim
