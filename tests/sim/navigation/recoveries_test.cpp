#include "sim/navigation/recoveries.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

constexpr double kPeriod = 0.05;  // [s]

Recoveries fresh() { return {RecoveryTimes{}, 0.3, kPeriod}; }

/// Watches a stationary robot until a behaviour begins.
std::optional<Recovery> wait_for(Recoveries& recoveries, const Pose2& T_odom_base) {
  for (int i = 0; i < 300; ++i) {
    if (const auto begun = recoveries.watch(T_odom_base)) return begun;
  }
  return std::nullopt;
}

/// Executes the current behaviour with a robot that follows commands exactly; returns its final
/// pose.
Pose2 play(Recoveries& recoveries, Pose2 T_odom_base,
           const std::vector<Eigen::Vector2d>& p_base = {}) {
  for (int i = 0; i < 1000; ++i) {
    const auto twist = recoveries.command(T_odom_base, p_base);
    if (!twist) return T_odom_base;
    T_odom_base = T_odom_base * arc(twist->v * kPeriod, twist->w * kPeriod);
  }
  ADD_FAILURE() << "never ends";
  return T_odom_base;
}

TEST(Recoveries, LeaveARobotThatGetsOnAlone) {
  Recoveries recoveries = fresh();
  for (int i = 0; i < 1000; ++i) {
    ASSERT_FALSE(recoveries.watch({0.005 * i, 0.0, 0.0}));  // 0.1 m/s
    ASSERT_FALSE(recoveries.command({0.005 * i, 0.0, 0.0}, {}));
  }
}

TEST(Recoveries, BeginAfterTenSecondsAndEscalate) {
  Recoveries recoveries = fresh();
  int calls = 0;
  std::optional<Recovery> first;
  for (; calls < 300 && !first; ++calls) first = recoveries.watch({});
  EXPECT_EQ(first, Recovery::kWait);
  EXPECT_NEAR(calls, 200, 1);
  EXPECT_EQ(play(recoveries, {}), Pose2{});
  EXPECT_EQ(wait_for(recoveries, {}), Recovery::kReplan);
  EXPECT_EQ(play(recoveries, {}), Pose2{});
  EXPECT_EQ(wait_for(recoveries, {}), Recovery::kBackUp);
  const Pose2 back = play(recoveries, {});
  EXPECT_NEAR(back.x, -0.3, 0.01);
  EXPECT_EQ(wait_for(recoveries, back), Recovery::kSpin);
  const Pose2 turned = play(recoveries, back);
  EXPECT_NEAR(std::abs(turned.yaw), 1.57, 0.04);
}

TEST(Recoveries, BeginAnewAfterAMetre) {
  Recoveries recoveries = fresh();
  EXPECT_EQ(wait_for(recoveries, {}), Recovery::kWait);
  play(recoveries, {});
  recoveries.watch({1.1, 0.0, 0.0});
  EXPECT_EQ(wait_for(recoveries, {1.1, 0.0, 0.0}), Recovery::kWait);
}

TEST(Recoveries, DoNotBackIntoWhatTheLidarSees) {
  Recoveries recoveries = fresh();
  for (int i = 0; i < 3; ++i) {
    wait_for(recoveries, {});
    EXPECT_EQ(play(recoveries, {}, {{-0.32, 0.0}}), Pose2{});
  }
}

TEST(Recoveries, SpinToTheRoomierSide) {
  for (const double side : {1.0, -1.0}) {
    Recoveries recoveries = fresh();
    const std::vector<Eigen::Vector2d> beside{{0.0, -0.6 * side}};
    for (int i = 0; i < 3; ++i) {
      wait_for(recoveries, {});
      play(recoveries, {}, {{-0.32, 0.0}});
    }
    EXPECT_EQ(wait_for(recoveries, {}), Recovery::kSpin);
    EXPECT_GT(side * play(recoveries, {}, beside).yaw, 1.0);
  }
}

}  // namespace
}  // namespace castaway::sim
