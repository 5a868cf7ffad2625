#include "tools/twin/odometry/stretch.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

/// A leg straight on, which the map says is `by_map` long.
Leg straight_leg(double along, double by_map) {
  Leg leg;
  leg.steps.push_back({along, 0.0, 0.0, along});
  leg.T_start_end = {by_map, 0.0, 0.0};
  leg.way = along;
  return leg;
}

/// A leg with these steps, which the map confirms.
Leg leg_with(const std::vector<OdometryStep>& steps) {
  Leg leg;
  leg.steps = steps;
  leg.T_start_end = correct_motion(steps, {});
  for (const OdometryStep& step : steps) leg.way += step.way;
  return leg;
}

OdometryStep ahead_by(double along) { return {along, 0.0, 0.0, along}; }
OdometryStep turn_by(double turn) { return {0.0, 0.0, turn, 0.2 * std::abs(turn)}; }

void expect_pair(const Eigen::Vector2d& pair, double x, double y) {
  EXPECT_NEAR(pair.x(), x, 1e-9);
  EXPECT_NEAR(pair.y(), y, 1e-9);
}

TEST(Stretches, AreAsLongAsAskedForOrALittleLonger) {
  const auto stretches = take_stretches(std::vector<Leg>(11, straight_leg(0.4, 0.5)), 1.0);
  ASSERT_EQ(stretches.size(), 3U);  // of three legs each; the last two do not make one
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(stretches[k].way, 1.2, 1e-12);
    EXPECT_NEAR(stretches[k].T_start_end.x, 1.5, 1e-12);
    EXPECT_EQ(stretches[k].steps.size(), 3U);
    EXPECT_EQ(stretches[k].leg, 3 * k);
  }
}

TEST(Stretches, DoNotReachAcrossBreaks) {
  std::vector<Leg> legs(9, straight_leg(0.4, 0.4));
  legs[1].breaks = legs[5].breaks = true;
  const auto stretches = take_stretches(legs, 1.0);
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_EQ(stretches[0].leg, 2U);
  EXPECT_EQ(stretches[1].leg, 6U);
  EXPECT_NEAR(stretches[1].way, 1.2, 1e-12);
}

TEST(Stretches, AreNotMuchLonger) {
  const std::vector<Leg> legs{straight_leg(3.1, 3.1), straight_leg(0.5, 0.5),
                              straight_leg(2.4, 2.4), straight_leg(1.0, 1.0)};
  const auto stretches = take_stretches(legs, 1.0);
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_NEAR(stretches[0].way, 2.9, 1e-12);
  EXPECT_EQ(stretches[0].leg, 1U);
  EXPECT_EQ(stretches[1].leg, 3U);
  EXPECT_TRUE(take_stretches({}, 1.0).empty());
}

TEST(Stretches, SumTurnsToEitherSide) {
  const auto stretches =
      take_stretches({leg_with({ahead_by(1.0), turn_by(0.5), turn_by(-0.75)})}, 1.0);
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_NEAR(stretches[0].turn, 1.25, 1e-12);
}

TEST(Stretches, KnowWhatATurnAtTheBeginningMoves) {
  const auto stretches = take_stretches({leg_with({turn_by(kQuarterTurn), ahead_by(2.0)})}, 1.0);
  ASSERT_EQ(stretches.size(), 1U);
  const double turning = 0.2 * kQuarterTurn;
  expect_pair(stretches[0].walk, turning + 2.0, 0.0);
  expect_pair(stretches[0].sway, 0.0, 4.0 * turning);  // 2 m ahead of the turn
  expect_pair(stretches[0].swing, 0.0, 4.0 * kQuarterTurn);
}

TEST(Stretches, KnowWhatTravelBeforeATurnMoves) {
  const auto stretches =
      take_stretches({leg_with({ahead_by(0.5), turn_by(-kQuarterTurn), ahead_by(2.0)})}, 1.0);
  ASSERT_EQ(stretches.size(), 1U);
  const double turning = 0.2 * kQuarterTurn;
  expect_pair(stretches[0].walk, turning + 2.0, 0.5);
  expect_pair(stretches[0].sway, 0.0, 4.0 * (turning + 0.5));
}

// The end is 1 m ahead of the turn at the beginning, and 1.5 m to its left.
TEST(Stretches, KnowThatTurnsMoveTheEndBackWhereItIsBeside) {
  const auto stretches = take_stretches(
      {leg_with({turn_by(0.5), ahead_by(1.0), turn_by(kQuarterTurn), ahead_by(1.5)})}, 2.0);
  ASSERT_EQ(stretches.size(), 1U);
  expect_pair(stretches[0].swing, 0.5, 1.5 * 1.5 * (0.5 + kQuarterTurn));
}

TEST(Stretches, KnowHowFastTheRobotIsAtBothEnds) {
  Leg first = leg_with({ahead_by(0.6)});
  first.rate_at_start = {0.5, 0.0};
  first.rate_at_end = {9.0, 9.0};
  Leg last = leg_with({turn_by(kQuarterTurn / 1.5), ahead_by(0.7)});  // 60 degrees
  last.rate_at_start = {9.0, 9.0};
  last.rate_at_end = {-0.8, -0.4};
  const auto stretches = take_stretches({first, last}, 1.0);
  ASSERT_EQ(stretches.size(), 1U);
  expect_pair(stretches[0].speeds, 0.25 * 0.25 + 0.64, 0.25 * 0.75);
  EXPECT_NEAR(stretches[0].turn_rates, 0.16, 1e-12);
  first.rate_at_start.turn = -0.3;
  EXPECT_NEAR(take_stretches({first, last}, 1.0).at(0).turn_rates, 0.09 + 0.16, 1e-12);
}

TEST(StretchMiss, IsWhereOdometryEndsSeenFromTheMapsEnd) {
  Leg leg = leg_with({ahead_by(2.0)});
  leg.T_start_end = {1.0, 0.5, kQuarterTurn};
  const auto stretches = take_stretches({leg}, 1.0);
  ASSERT_EQ(stretches.size(), 1U);
  const SE2 miss = miss_of(stretches[0], {});
  EXPECT_NEAR(miss.x, -0.5, 1e-12);
  EXPECT_NEAR(miss.y, -1.0, 1e-12);
  EXPECT_NEAR(miss.yaw, -kQuarterTurn, 1e-12);
  const SE2 longer = miss_of(stretches[0], {{.scale = 0.25}, {}});
  EXPECT_NEAR(longer.x, -0.5, 1e-12);
  EXPECT_NEAR(longer.y, -1.5, 1e-12);
  const SE2 turned = miss_of(stretches[0], {{}, {0.0, 0.0, kQuarterTurn}});  // rolls to the left
  EXPECT_NEAR(turned.x, 1.5, 1e-12);
  EXPECT_NEAR(turned.y, 1.0, 1e-12);
}

}  // namespace
}  // namespace castaway::testbed
