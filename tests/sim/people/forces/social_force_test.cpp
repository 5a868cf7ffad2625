#include "sim/people/forces/social_force.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

const SocialForceConfig kForceConfig;

TEST(DrivingForce, ClosesTheDifferenceInTheRelaxationTime) {
  const Eigen::Vector2d force = driving_force(kForceConfig, {1.0, 0.5}, {1.5, 0.0});
  EXPECT_DOUBLE_EQ(force.x(), 1.0);
  EXPECT_DOUBLE_EQ(force.y(), -1.0);
}

TEST(SocialForce, OfSomebodyAtRestIsTheFormulaByHand) {
  // At rest D = e, so B = 0.35 and theta = 0: -A e^{-1/0.35} along e, the same to the right.
  const Eigen::Vector2d force = social_force(kForceConfig, {1.0, 0.0}, {0.0, 0.0});
  const double strength = 2.1 * std::exp(-1.0 / 0.35);
  EXPECT_NEAR(force.x(), -strength, 1e-12);
  EXPECT_NEAR(force.y(), -strength, 1e-12);
}

TEST(SocialForce, OfTwoWhoMeetIsTheFormulaByHand) {
  // Closing at 2 m/s, the other 2 m ahead and 0.5 m to the left.
  const Eigen::Vector2d offset(2.0, 0.5);
  const double d = std::sqrt(4.25);
  const Eigen::Vector2d D(4.0 + 2.0 / d, 0.5 / d);
  const double B = 0.35 * D.norm();
  const double theta = std::atan2(0.5, 2.0) - std::atan2(D.y(), D.x());
  const double slow = 2.1 * std::exp(-d / B - std::pow(3.0 * B * theta, 2));
  const double turn = 2.1 * std::exp(-d / B - std::pow(2.0 * B * theta, 2));
  const Eigen::Vector2d t = D.normalized();
  const Eigen::Vector2d force = social_force(kForceConfig, offset, {2.0, 0.0});
  EXPECT_GT(theta, 0.0);
  EXPECT_NEAR(force.dot(t), -slow, 1e-12);
  EXPECT_NEAR(force.dot(Eigen::Vector2d(-t.y(), t.x())), -turn, 1e-12);
  EXPECT_LT(force.y(), 0.0);  // To the right.
}

TEST(SocialForce, IsMirroredLeftAndRight) {
  const Eigen::Vector2d left = social_force(kForceConfig, {1.0, 0.3}, {1.0, 0.0});
  const Eigen::Vector2d right = social_force(kForceConfig, {1.0, -0.3}, {1.0, 0.0});
  EXPECT_NEAR(left.x(), right.x(), 1e-12);
  EXPECT_NEAR(left.y(), -right.y(), 1e-12);
}

TEST(SocialForce, EndsWithDistance) {
  EXPECT_EQ(social_force(kForceConfig, {5.1, 0.0}, {3.0, 0.0}).norm(), 0.0);
  EXPECT_EQ(social_force(kForceConfig, {0.0, 0.0}, {1.0, 0.0}).norm(), 0.0);
  EXPECT_GT(social_force(kForceConfig, {0.5, 0.0}, {0.0, 0.0}).norm(),
            social_force(kForceConfig, {0.8, 0.0}, {0.0, 0.0}).norm());
}

TEST(ObstacleForce, FallsToAnEthInItsRange) {
  EXPECT_DOUBLE_EQ(obstacle_force(kForceConfig, 0.0, {0.0, 1.0}).y(), 10.0);
  EXPECT_DOUBLE_EQ(obstacle_force(kForceConfig, 0.2, {0.0, 1.0}).y(), 10.0 * std::exp(-1.0));
  EXPECT_EQ(obstacle_force(kForceConfig, 3.0, {0.0, 1.0}).norm(), 0.0);
}

}  // namespace
}  // namespace castaway::sim
