#include "localization/input/intake.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

LaserScan scan_of(const std::string& lidar, Stamp stamp) {
  LaserScan scan;
  scan.lidar = lidar;
  scan.stamp = stamp;
  scan.angle_increment = 0.1;
  return scan;
}

TEST(Intake, TakesOdometryInOrderAndCountsTheRest) {
  Intake intake({});
  EXPECT_EQ(intake.take({seconds(10), {1.0, 0.0, 0.0}}), OdometryIntake::kTaken);
  EXPECT_EQ(intake.take({seconds(11), {2.0, 0.0, 0.0}}), OdometryIntake::kTaken);
  EXPECT_EQ(intake.take({seconds(11), {9.0, 0.0, 0.0}}), OdometryIntake::kDropped);
  EXPECT_EQ(intake.take({milliseconds(9001), {9.0, 0.0, 0.0}}), OdometryIntake::kDropped);
  EXPECT_EQ(intake.take({seconds(12), {kNotANumber, 0.0, 0.0}}), OdometryIntake::kDropped);
  EXPECT_EQ(intake.dropped_odometry(), 3);
  EXPECT_EQ(intake.T_odom_base().at(milliseconds(10500)), (SE2{1.5, 0.0, 0.0}));
}

TEST(Intake, BeginsAnewWhenTheClockIsSetBack) {
  Intake intake({});
  intake.take({seconds(100), {1.0, 0.0, 0.0}});
  ASSERT_TRUE(intake.accept(scan_of("", seconds(100))));
  EXPECT_EQ(intake.take({seconds(98), {5.0, 0.0, 0.0}}), OdometryIntake::kRestarted);
  EXPECT_EQ(intake.T_odom_base().newest(), seconds(98));
  EXPECT_FALSE(intake.T_odom_base().at(seconds(100)));
  EXPECT_TRUE(intake.accept(scan_of("", seconds(98))));
  EXPECT_EQ(intake.dropped_odometry(), 0);
}

TEST(Intake, KeepsTheOrderOfEachLidar) {
  Intake intake({});
  EXPECT_FALSE(intake.accept(scan_of("front", seconds(1))));  // no odometry yet
  intake.take({seconds(1), {}});
  intake.take({seconds(2), {}});
  EXPECT_TRUE(intake.accept(scan_of("front", milliseconds(1500))));
  EXPECT_TRUE(intake.accept(scan_of("rear", milliseconds(1500))));
  EXPECT_FALSE(intake.accept(scan_of("rear", milliseconds(1500))));
  EXPECT_FALSE(intake.accept(scan_of("front", milliseconds(1400))));
  EXPECT_TRUE(intake.accept(scan_of("rear", milliseconds(1600))));
  EXPECT_EQ(intake.dropped_scans(), 3);
}

TEST(Intake, RefusesScansFromOutsideOfTheMotionKnownAndWithoutNumbers) {
  Intake intake({});
  intake.take({seconds(1), {}});
  EXPECT_FALSE(intake.accept(scan_of("", milliseconds(999))));
  EXPECT_FALSE(intake.accept(scan_of("", milliseconds(1501))));  // held for 0.5 s
  EXPECT_TRUE(intake.accept(scan_of("", milliseconds(1500))));
  LaserScan scan = scan_of("other", seconds(1));
  scan.angle_increment = kNotANumber;
  EXPECT_FALSE(intake.accept(scan));
  scan.angle_increment = 0.1;
  scan.T_base_laser.translation().x() = kNotANumber;
  EXPECT_FALSE(intake.accept(scan));
  EXPECT_EQ(intake.dropped_scans(), 4);
}

TEST(Start, MustBeNumbers) {
  PoseWithCovariance start;
  EXPECT_NO_THROW(validate(start));
  start.covariance(1, 1) = kNotANumber;
  EXPECT_THROW(validate(start), std::invalid_argument);
  start.covariance.setZero();
  start.T_map_base.yaw = kNotANumber;
  EXPECT_THROW(validate(start), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
