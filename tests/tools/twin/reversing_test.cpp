#include "tools/twin/odometry/odometry_fit.hpp"

#include <gtest/gtest.h>

#include "tests/tools/twin/random_drive.hpp"

namespace castaway::testbed {
namespace {

/// A leg that odometry and the map state so far ahead; the map turns by `yaw`.
Leg leg_along(double by_odometry, double by_map, double yaw = 0.0) {
  Leg leg;
  leg.steps.push_back({0.5 * by_odometry, 0.01, 0.5 * yaw, 0.5 * std::abs(by_odometry)});
  leg.steps.push_back({0.5 * by_odometry, 0.01, 0.5 * yaw, 0.5 * std::abs(by_odometry)});
  leg.T_start_end = {by_map, 0.0, yaw};
  leg.way = std::abs(by_odometry);
  return leg;
}

/// Some legs of each kind, mixed with driving ahead.
std::vector<Leg> legs_reversing(int counted_ahead, int counted_back) {
  std::vector<Leg> legs(50, leg_along(0.1, 0.1));
  legs.insert(legs.end(), static_cast<std::size_t>(counted_ahead), leg_along(0.1, -0.1));
  legs.insert(legs.end(), static_cast<std::size_t>(counted_back), leg_along(-0.1, -0.1));
  return legs;
}

TEST(Reversing, IsCountedAheadInMostOfTheLegsOfSuchOdometry) {
  EXPECT_TRUE(is_distance_unsigned(legs_reversing(10, 0)));
  EXPECT_TRUE(is_distance_unsigned(legs_reversing(21, 20)));
  EXPECT_FALSE(is_distance_unsigned(legs_reversing(20, 20)));
  EXPECT_FALSE(is_distance_unsigned(legs_reversing(0, 50)));
}

TEST(Reversing, IsNotToldByFewerThanTenLegs) {
  EXPECT_FALSE(is_distance_unsigned(legs_reversing(9, 0)));
  EXPECT_FALSE(is_distance_unsigned({}));
}

TEST(Reversing, IsNotToldByLegsThatAreShortOrTurnOrBreak) {
  EXPECT_FALSE(is_distance_unsigned(std::vector<Leg>(50, leg_along(0.02, -0.02))));
  EXPECT_FALSE(is_distance_unsigned(std::vector<Leg>(50, leg_along(0.1, -0.1, 0.6))));
  EXPECT_FALSE(is_distance_unsigned(std::vector<Leg>(50, leg_along(0.1, -0.1, -0.6))));
  EXPECT_TRUE(is_distance_unsigned(std::vector<Leg>(50, leg_along(0.1, -0.1, 0.4))));
  std::vector<Leg> broken(50, leg_along(0.1, -0.1));
  for (Leg& leg : broken) leg.breaks = true;
  EXPECT_FALSE(is_distance_unsigned(broken));
}

// 12 mm of error in each aligned pose; a leg is 20 mm.
TEST(Reversing, IsNotToldByErrorsOfTheAlignmentOfASlowRobot) {
  const RandomDrive slow{
      .legs = 40000, .slowest = 0.1, .fastest = 0.1, .bend = 0.0, .match = 0.012};
  EXPECT_FALSE(is_distance_unsigned(legs_of(slow)));
}

TEST(SignedDistances, HaveTheSignOfTheMap) {
  const std::vector<Leg> legs =
      sign_distances({leg_along(0.1, -0.1, 0.2), leg_along(0.1, 0.1, 0.2), leg_along(-0.1, -0.1),
                      leg_along(-0.1, 0.1), leg_along(0.02, -0.02), leg_along(0.1, -0.1, 0.6)});
  const auto along = [&](std::size_t i) {
    return legs.at(i).steps[0].along + legs.at(i).steps[1].along;
  };
  ASSERT_EQ(legs.size(), 6U);
  EXPECT_DOUBLE_EQ(along(0), -0.1);
  EXPECT_DOUBLE_EQ(along(1), 0.1);
  EXPECT_DOUBLE_EQ(along(2), -0.1);
  EXPECT_DOUBLE_EQ(along(3), 0.1);
  EXPECT_DOUBLE_EQ(along(4), 0.02);  // as sure as no sign
  EXPECT_DOUBLE_EQ(along(5), 0.1);
  EXPECT_DOUBLE_EQ(legs[0].steps[1].across, -0.01);
  EXPECT_DOUBLE_EQ(legs[1].steps[1].across, 0.01);
  EXPECT_DOUBLE_EQ(legs[0].steps[1].turn, 0.1);  // its sign is known
  EXPECT_DOUBLE_EQ(legs[0].steps[1].way, 0.05);
  EXPECT_DOUBLE_EQ(legs[0].T_start_end.x, -0.1);
}

}  // namespace
}  // namespace castaway::testbed
