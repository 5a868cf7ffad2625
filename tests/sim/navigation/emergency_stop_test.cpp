#include "sim/navigation/emergency_stop.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

// Brakes from 1 m/s within 0.5 s and 0.25 m; the footprint reaches 0.2 m further, plus 0.01 m.
const EmergencyStopConfig kBrakesWithinAQuarterMetre{0.2, 2.0, 0.125};
const Twist2 kOneMetrePerSecond{1.0, 0.0};

Eigen::Vector2d no_velocity(const Eigen::Vector2d&) { return {0.0, 0.0}; }

EmergencyStop::Order first_order(const Twist2& now, const Eigen::Vector2d& p_base,
                                 const EmergencyStop::VelocityAt& velocity_at = no_velocity) {
  return EmergencyStop(kBrakesWithinAQuarterMetre).watch(now, {p_base}, velocity_at);
}

TEST(EmergencyStop, IsOrderedBeforeAnObstacleWithinTheBrakingDistance) {
  EXPECT_TRUE(first_order(kOneMetrePerSecond, {0.45, 0.0}).stop);
  EXPECT_FALSE(first_order(kOneMetrePerSecond, {0.47, 0.0}).stop);
  EXPECT_FALSE(first_order(kOneMetrePerSecond, {0.25, 0.22}).stop);  // Beside the way.
}

TEST(EmergencyStop, LooksInTheDirectionOfTravel) {
  EXPECT_FALSE(first_order(kOneMetrePerSecond, {-0.15, 0.0}).stop);
  EXPECT_TRUE(first_order({-1.0, 0.0}, {-0.45, 0.0}).stop);
}

TEST(EmergencyStop, LetsAnObstacleMoveAway) {
  const auto leaves = [](const Eigen::Vector2d&) { return Eigen::Vector2d(1.0, 0.0); };
  EXPECT_FALSE(first_order(kOneMetrePerSecond, {0.45, 0.0}, leaves).stop);
  const auto comes = [](const Eigen::Vector2d&) { return Eigen::Vector2d(-1.0, 0.0); };
  EXPECT_TRUE(first_order(kOneMetrePerSecond, {0.45, 0.0}, comes).stop);
}

TEST(EmergencyStop, BeginsOnceAndLastsUntilAfterBraking) {
  EmergencyStop stop(kBrakesWithinAQuarterMetre);
  const EmergencyStop::Order first = stop.watch(kOneMetrePerSecond, {{0.4, 0.0}}, no_velocity);
  EXPECT_TRUE(first.begins);
  int periods = 1;
  while (stop.watch({}, {}, no_velocity).stop) ++periods;
  EXPECT_EQ(periods, 7);  // 1 s to brake and to stand, less the period in which it ends.
  EXPECT_FALSE(stop.watch({0.1, 0.0}, {{0.15, 0.0}}, no_velocity).begins);  // Too slow.
}

}  // namespace
}  // namespace castaway::sim
