#include "sim/events/lift.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

const Pose2 kFrom{1.0, 1.0, 3.0};
const Pose2 kTo{5.0, 4.0, -3.0};
const std::vector<Eigen::Vector3d> kCorner{{5.0, 1.0, 0.0}};

TEST(Lift, BeginsAndEndsOnTheFloorWhereItShould) {
  const Lift lift({}, {kFrom, kTo, kCorner});
  EXPECT_TRUE(lift.at(0.0).isApprox(to_isometry(kFrom), 1e-12));
  EXPECT_TRUE(lift.at(lift.duration()).isApprox(to_isometry(kTo), 1e-12));
}

TEST(Lift, TakesTheWayAtItsSpeedAndTheLifting) {
  const LiftConfig config{.height = 0.6, .seconds = 1.0, .speed = 2.0};
  EXPECT_NEAR(Lift(config, {kFrom, kTo, kCorner}).duration(), 7.0 / 2.0 + 2.0, 1e-12);
  EXPECT_EQ(Lift({.seconds = 20.0}, {kFrom, kTo, kCorner}).duration(), 20.0);
}

TEST(Lift, FollowsThePathAtItsHeightAndTurnsTheShortWay) {
  const Lift lift({.height = 0.5}, {kFrom, kTo, kCorner});
  const Eigen::Isometry3d half = lift.at(0.5 * lift.duration());
  EXPECT_NEAR(half.translation().x(), 4.5, 1e-9);  // 3.5 of 7 m
  EXPECT_NEAR(half.translation().y(), 1.0, 1e-9);
  EXPECT_NEAR(half.translation().z(), 0.5, 1e-9);
  EXPECT_NEAR(std::abs(to_planar(half).yaw), 3.14159265, 1e-6);  // from 3 to -3 through pi
}

TEST(Lift, MovesWithoutJumps) {
  const Lift lift({}, {kFrom, kTo, kCorner});
  Eigen::Isometry3d before = lift.at(0.0);
  for (double t = 0.002; t < lift.duration(); t += 0.002) {
    const Eigen::Isometry3d now = lift.at(t);
    ASSERT_LT((now.translation() - before.translation()).norm(), 0.01);
    before = now;
  }
}

TEST(Lift, InPlaceOnlyRisesAndSinks) {
  const Lift lift({.height = 0.05, .seconds = 4.0}, {kFrom, kFrom});
  EXPECT_EQ(lift.duration(), 4.0);
  const Eigen::Isometry3d half = lift.at(2.0);
  EXPECT_NEAR(half.translation().z(), 0.05, 1e-12);
  EXPECT_NEAR((half.translation().head<2>() - kFrom.position()).norm(), 0.0, 1e-12);
}

TEST(HeldTwist, IsTheCommandOrCoastsOrStops) {
  const Twist2 now{0.5, 1.0};
  const Twist2 commanded{0.4, -0.2};
  EXPECT_EQ(held_twist(HeldWheels::kDriven, now, commanded, 0.01).v, 0.4);
  EXPECT_EQ(held_twist(HeldWheels::kDriven, now, commanded, 0.01).w, -0.2);
  EXPECT_EQ(held_twist(HeldWheels::kLocked, now, commanded, 0.01).v, 0.0);
  EXPECT_NEAR(held_twist(HeldWheels::kFree, now, commanded, 0.2).v, 0.5 * std::exp(-1.0), 1e-12);
  EXPECT_NEAR(held_twist(HeldWheels::kFree, now, commanded, 0.2).w, std::exp(-1.0), 1e-12);
}

TEST(LiftConfig, RefusesWhatNobodyCanDo) {
  EXPECT_THROW(validate(LiftConfig{.height = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(LiftConfig{.seconds = -1.0}), std::invalid_argument);
  EXPECT_THROW(validate(LiftConfig{.speed = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
