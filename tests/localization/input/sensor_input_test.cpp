#include "localization/input/sensor_input.hpp"

#include <limits>

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

using std::chrono::milliseconds;

SensorInputConfig config() { return {10.0, 5.0, 0.5, {}, {}, milliseconds(250)}; }

/// One beam straight ahead, 2 m long.
LaserScan beam(Stamp stamp) {
  LaserScan scan;
  scan.stamp = stamp;
  scan.range_max = 10.0;
  scan.ranges = {2.0F};
  return scan;
}

TEST(SensorInput, StepsFromTurnToTurn) {
  SensorInput input(config());
  EXPECT_FALSE(input.take(Odometry{milliseconds(100), {1.0, 2.0, 0.5}}).step);  // the first reading
  const SE2 u{0.3, 0.1, 0.2};
  const SE2 next = SE2{1.0, 2.0, 0.5} * u;
  EXPECT_FALSE(input.take(Odometry{milliseconds(150), {1.5, 2.0, 0.5}}).step);  // not due
  const auto step = input.take(Odometry{milliseconds(200), next}).step;
  ASSERT_TRUE(step);
  EXPECT_NEAR(step->x, u.x, 1e-12);
  EXPECT_NEAR(step->y, u.y, 1e-12);
  EXPECT_NEAR(step->yaw, u.yaw, 1e-12);
}

TEST(SensorInput, DoesNotStepWhereTheRobotStands) {
  SensorInput input(config());
  input.take(Odometry{milliseconds(100), {1.0, 2.0, 0.0}});
  EXPECT_FALSE(input.take(Odometry{milliseconds(200), {1.0, 2.0, 0.0}}).step);
  EXPECT_TRUE(input.take(Odometry{milliseconds(300), {1.0, 2.1, 0.0}}).step);
}

TEST(SensorInput, TurnsAsTheGyroOfItsInertialUnitSays) {
  SensorInput input(config());
  const Imu imu{milliseconds(100), {0.0, 0.0, 0.5}, {0.0, 0.0, 9.81}};
  input.take(imu);
  input.take(Odometry{milliseconds(100), {}});
  const auto step = input.take(Odometry{milliseconds(200), {0.0, 0.0, 0.09}}).step;
  ASSERT_TRUE(step);
  EXPECT_NEAR(step->yaw, 0.05, 1e-12);
}

TEST(SensorInput, BringsAScanToTheNewestOdometry) {
  SensorInput input(config());
  EXPECT_FALSE(input.take(beam(milliseconds(100))));  // no odometry yet
  EXPECT_EQ(input.intake().dropped_scans(), 1);
  input.take(Odometry{milliseconds(100), {}});
  input.take(Odometry{milliseconds(120), {0.5, 0.0, 0.0}});
  const auto turn = input.take(beam(milliseconds(100)));
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->now, milliseconds(120));
  EXPECT_EQ(turn->T_odom_base, (SE2{0.5, 0.0, 0.0}));
  EXPECT_TRUE(turn->counts);
  ASSERT_EQ(turn->points.size(), 1U);
  EXPECT_NEAR(turn->points.x[0], 1.5, 1e-6);  // the robot has moved 0.5 m forward since
  ASSERT_TRUE(turn->step);
  EXPECT_NEAR(turn->step->x, 0.5, 1e-12);
  EXPECT_NEAR(input.T_now_base(milliseconds(100)).x, -0.5, 1e-12);  // base was further back
  EXPECT_EQ(input.T_now_base(milliseconds(1)), SE2{});              // unknown
}

TEST(SensorInput, CountsScansAtTheirRateIfTheySeeAnything) {
  SensorInput input(config());
  input.take(Odometry{milliseconds(100), {}});
  LaserScan blind = beam(milliseconds(100));
  blind.ranges = {std::numeric_limits<float>::infinity()};
  EXPECT_FALSE(input.take(blind)->counts);
  input.take(Odometry{milliseconds(110), {}});
  EXPECT_TRUE(input.take(beam(milliseconds(110)))->counts);  // the scan without returns took no
                                                             // turn
  input.take(Odometry{milliseconds(200), {}});
  EXPECT_FALSE(input.take(beam(milliseconds(200)))->counts);
  input.take(Odometry{milliseconds(300), {}});
  EXPECT_TRUE(input.take(beam(milliseconds(300)))->counts);
}

TEST(SensorInput, TellsThePeriodsSinceTheLastScanThatCounts) {
  SensorInput input(config());
  const auto periods_at = [&](Stamp stamp) {
    input.take(Odometry{stamp, {}});
    return input.take(beam(stamp))->periods;
  };
  EXPECT_EQ(periods_at(milliseconds(5000)), 1.0);  // the first one
  EXPECT_EQ(periods_at(milliseconds(5190)), 1.0);  // early, but not less
  EXPECT_EQ(periods_at(milliseconds(5250)), 1.0);  // not counted
  EXPECT_NEAR(periods_at(milliseconds(6190)), 5.0, 1e-9);
  EXPECT_EQ(periods_at(milliseconds(100)), 1.0);  // the clock was set back
}

TEST(SensorInput, ReseedsWithScansThatCount) {
  SensorInput input(config());
  input.take(Odometry{milliseconds(1750), {}});
  EXPECT_FALSE(input.take(beam(milliseconds(1750)))->reseeds);  // 1.8 s, a tenth early
  input.take(Odometry{milliseconds(1850), {}});
  EXPECT_FALSE(input.take(beam(milliseconds(1850)))->reseeds);  // it is not counted
  input.take(Odometry{milliseconds(1950), {}});
  EXPECT_TRUE(input.take(beam(milliseconds(1950)))->reseeds);
  input.take(Odometry{milliseconds(2150), {}});
  EXPECT_FALSE(input.take(beam(milliseconds(2150)))->reseeds);
}

TEST(SensorInput, BeginsAnewWhereTheClockIsSetBack) {
  SensorInput input(config());
  input.take(Odometry{std::chrono::seconds(100), {}});
  EXPECT_TRUE(input.take(beam(std::chrono::seconds(100)))->counts);
  const OdometryTurn turn = input.take(Odometry{milliseconds(100), {7.0, 0.0, 0.0}});
  EXPECT_TRUE(turn.restarted);
  EXPECT_FALSE(turn.step);  // no step between the motions before and after the restart
  EXPECT_TRUE(input.take(beam(milliseconds(100)))->counts);
  EXPECT_FALSE(input.take(Odometry{milliseconds(50), {}}).restarted);  // late, but the clock was
                                                                       // not set back
}

TEST(SensorInputConfig, RefusesRatesOfZeroAndInvalidBeams) {
  const SensorInputConfig valid;
  EXPECT_NO_THROW(validate(valid));
  for (double SensorInputConfig::*rate :
       {&SensorInputConfig::predict_rate_hz, &SensorInputConfig::correct_rate_hz,
        &SensorInputConfig::reseed_rate_hz}) {
    SensorInputConfig wrong = valid;
    wrong.*rate = 0.0;
    EXPECT_THROW(validate(wrong), std::invalid_argument);
  }
  SensorInputConfig wrong = valid;
  wrong.beams.max_beams = 0;
  EXPECT_THROW(validate(wrong), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
