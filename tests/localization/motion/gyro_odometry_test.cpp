#include "localization/motion/gyro_odometry.hpp"

#include <chrono>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

using std::chrono::milliseconds;

constexpr double kSkidTick = 0.01;  // [s]
constexpr double kSkidRate = 0.8;   // [rad/s]

/// A skid steer that drives a circle: its odometry turns too far.
class Skidder {
 public:
  /// One tick; returns what the filter makes of odometry.
  SE2 step(GyroOdometry& gyro, double speed, bool measures) {
    stamp_ += milliseconds(10);
    truth_ = truth_ * arc(speed * kSkidTick, kSkidRate * kSkidTick);
    T_odom_base_ = T_odom_base_ * arc(speed * kSkidTick, 1.3 * kSkidRate * kSkidTick);
    if (measures) gyro.add(stamp_, kSkidRate);
    return gyro.take(stamp_, T_odom_base_);
  }
  [[nodiscard]] const SE2& truth() const { return truth_; }
  [[nodiscard]] const SE2& odometry() const { return T_odom_base_; }
  [[nodiscard]] Stamp stamp() const { return stamp_; }

 private:
  /// A short arc as a chord.
  static SE2 arc(double length, double turn) {
    return {length * std::cos(0.5 * turn), length * std::sin(0.5 * turn), turn};
  }

  Stamp stamp_{};
  SE2 truth_;
  SE2 T_odom_base_;
};

TEST(GyroOdometry, TurnsAsTheGyroSays) {
  GyroOdometry gyro;
  gyro.add(Stamp{}, kSkidRate);
  gyro.take(Stamp{}, {});
  Skidder robot;
  SE2 fused;
  for (int i = 0; i < 300; ++i) fused = robot.step(gyro, 0.5, true);
  EXPECT_LT(distance(fused, robot.truth()), 1e-9);
  EXPECT_LT(yaw_distance(fused, robot.truth()), 1e-9);
  EXPECT_GT(distance(robot.odometry(), robot.truth()), 0.3);
}

TEST(GyroOdometry, ChangesNothingWithoutAGyro) {
  GyroOdometry gyro;
  Skidder robot;
  for (int i = 0; i < 50; ++i) EXPECT_EQ(robot.step(gyro, 0.5, false), robot.odometry());
}

/// Readings of the gyro between, and some ticks behind, those of odometry.
TEST(GyroOdometry, IsExactWhereItsReadingsComeAtOtherTimes) {
  GyroOdometry gyro;
  gyro.add(Stamp{}, kSkidRate);
  gyro.take(Stamp{}, {});
  Skidder robot;
  SE2 fused;
  for (int i = 0; i < 300; ++i) {
    fused = robot.step(gyro, 0.0, false);
    if (i % 3 == 1) gyro.add(robot.stamp() - milliseconds(4), kSkidRate);
  }
  EXPECT_LT(yaw_distance(fused, robot.truth()), 1e-9);
}

TEST(GyroOdometry, TurnsAsOdometryDoesWhileTheGyroIsSilent) {
  GyroOdometry gyro;
  gyro.add(Stamp{}, kSkidRate);
  gyro.take(Stamp{}, {});
  Skidder robot;
  for (int i = 0; i < 20; ++i) robot.step(gyro, 0.5, true);
  for (int i = 0; i < 20; ++i) robot.step(gyro, 0.5, false);
  const SE2 before = robot.step(gyro, 0.5, false);
  const SE2 odometry = robot.odometry();
  const SE2 after = robot.step(gyro, 0.5, false);
  const SE2 expected = odometry.inverse() * robot.odometry();
  EXPECT_NEAR((before.inverse() * after).yaw, expected.yaw, 1e-12);
  robot.step(gyro, 0.5, true);
  const SE2 again = robot.step(gyro, 0.5, true);
  EXPECT_NEAR((again.inverse() * robot.step(gyro, 0.5, true)).yaw, kSkidRate * kSkidTick, 1e-12);
}

TEST(GyroOdometry, RestsWithTheWheels) {
  GyroOdometry gyro;
  const SE2 there{1.0, 2.0, 0.5};
  for (int i = 0; i < 20; ++i) {
    gyro.add(milliseconds(10 * i), 0.001);  // A bias.
    EXPECT_EQ(gyro.take(milliseconds(10 * i), there), there);
  }
}

TEST(GyroOdometry, DropsWhatItCannotUse) {
  GyroOdometry gyro;
  gyro.add(milliseconds(10), kSkidRate);
  gyro.add(milliseconds(20), std::numeric_limits<double>::quiet_NaN());
  gyro.add(milliseconds(5), 100.0);
  gyro.take(milliseconds(10), {});
  const SE2 broken{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};
  EXPECT_TRUE(std::isnan(gyro.take(milliseconds(15), broken).x));
  EXPECT_EQ(gyro.take(milliseconds(5), {7.0, 0.0, 0.0}), (SE2{7.0, 0.0, 0.0}));
  const SE2 next = gyro.take(milliseconds(20), {0.1, 0.0, 0.05});
  EXPECT_NEAR(next.yaw, kSkidRate * 0.01, 1e-12);
}

TEST(GyroOdometry, BeginsAnew) {
  GyroOdometry gyro;
  gyro.add(milliseconds(10), kSkidRate);
  gyro.take(milliseconds(10), {});
  gyro.clear();
  EXPECT_EQ(gyro.take(milliseconds(5), {1.0, 0.0, 0.3}), (SE2{1.0, 0.0, 0.3}));
  EXPECT_EQ(gyro.take(milliseconds(15), {1.1, 0.0, 0.4}), (SE2{1.1, 0.0, 0.4}));
}

}  // namespace
}  // namespace castaway::localization
