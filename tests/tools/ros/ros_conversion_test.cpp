#include "tools/ros/ros_conversion.hpp"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::nanoseconds;

constexpr double kPi = std::numbers::pi;

LaserScan scan() {
  LaserScan scan;
  scan.stamp = nanoseconds(2'500'000'001);
  scan.time_increment = nanoseconds(277'777);
  scan.angle_min = -kPi;
  scan.angle_increment = 2.0 * kPi / 360;
  scan.range_min = 0.12;
  scan.range_max = 3.5;
  scan.ranges = {1.0F, std::numeric_limits<float>::infinity(), 2.0F};
  scan.lidar = "front";
  scan.T_base_laser = Eigen::Translation3d(0.1, 0.2, 0.3) *
                      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized());
  return scan;
}

TEST(RosConversion, MovesTimeZeroToASecond) {
  const ros::Time time = to_ros_time(nanoseconds(2'500'000'001));
  EXPECT_EQ(time.sec, 3);
  EXPECT_EQ(time.nanosec, 500'000'001U);
  EXPECT_EQ(from_ros_time(time), nanoseconds(3'500'000'001));
  EXPECT_EQ(to_ros_time({}).sec, 1);
}

TEST(RosConversion, BringsPosesBackToTheBit) {
  for (int i = 0; i <= 20'000; ++i) {
    const double yaw = -kPi + 2.0 * kPi * (i / 20'000.0);
    for (const double angle : {yaw, yaw * 1e-5}) {
      EXPECT_EQ(from_ros_pose(to_ros_pose({1.5, -2.5, angle})), (SE2{1.5, -2.5, angle}));
    }
  }
}

TEST(RosConversion, TellsTheYawOfAnyQuaternion) {
  const auto yaw_of = [](const Eigen::Quaterniond& q) {
    return from_ros_pose({{}, {q.x(), q.y(), q.z(), q.w()}}).yaw;
  };
  const Eigen::AngleAxisd turn(2.5, Eigen::Vector3d::UnitZ());
  const Eigen::AngleAxisd tilt(0.2, Eigen::Vector3d::UnitX());
  EXPECT_NEAR(yaw_of(Eigen::Quaterniond(turn * tilt)), 2.5, 1e-12);
  EXPECT_NEAR(yaw_of(Eigen::Quaterniond(turn)), 2.5, 1e-12);
  const Eigen::Quaterniond negative(-Eigen::Quaterniond(turn).coeffs());
  EXPECT_NEAR(yaw_of(negative), 2.5, 1e-12);
}

TEST(RosConversion, BringsMountsBack) {
  const Eigen::Isometry3d mount = Eigen::Translation3d(0.1, 0.2, 0.3) *
                                  Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(from_ros_transform(to_ros_transform(mount)).isApprox(mount, 1e-14));
}

TEST(RosConversion, RefusesTransformsWithoutNumbersOrRotation) {
  ros::Transform transform;
  transform.rotation.w = 0.0;
  EXPECT_TRUE(contains(error_of([&] { from_ros_transform(transform); }), "holds no rotation"));
  transform.translation.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(error_of([&] { from_ros_transform(transform); }), "holds no numbers"));
}

TEST(RosConversion, KeepsTheRuleOfAngles) {
  const ros::LaserScan message = to_ros_scan(scan(), {}, "laser");
  EXPECT_EQ(message.header.frame_id, "laser");
  EXPECT_NEAR((message.angle_max - message.angle_min) / 2.0F, message.angle_increment, 1e-6F);
  EXPECT_EQ(message.ranges, scan().ranges);
  EXPECT_NEAR(message.scan_time, 3 * 277.777e-6, 1e-9);
}

TEST(RosConversion, BringsAScanBackToTheBitWithItsExactNumbers) {
  EXPECT_EQ(exact_mount(exact_scan_numbers(scan()))->matrix(), scan().T_base_laser.matrix());
  EXPECT_FALSE(exact_mount({}));
  EXPECT_FALSE(exact_mount({{"castaway.T_base_laser", "1 2 3"}}));
  const LaserScan back =
      from_ros_scan(to_ros_scan(scan(), {}, "laser"), exact_scan_numbers(scan()));
  EXPECT_EQ(back.angle_min, scan().angle_min);
  EXPECT_EQ(back.angle_increment, scan().angle_increment);
  EXPECT_EQ(back.time_increment, scan().time_increment);
  EXPECT_EQ(back.range_min, scan().range_min);
  EXPECT_EQ(back.range_max, scan().range_max);
  EXPECT_EQ(back.lidar, "front");
  EXPECT_EQ(back.stamp, scan().stamp + kBagEpoch);
}

TEST(RosConversion, TakesNoNumberThatRoundsToAnother) {
  const auto exact = exact_scan_numbers(scan());
  ros::LaserScan message = to_ros_scan(scan(), {}, "laser");
  message.range_max = 10.0F;
  EXPECT_EQ(from_ros_scan(message, exact).range_max, 10.0);
}

TEST(RosConversion, TakesNoSweepThatNoLidarHas) {
  ros::LaserScan message = to_ros_scan(scan(), {}, "laser");
  for (const float increment : {1e30F, -1.0F, 4.0F}) {
    message.time_increment = increment;
    EXPECT_EQ(from_ros_scan(message, {}).time_increment, Stamp(0)) << increment;
  }
}

TEST(RosConversion, PutsAPlanarCovarianceAmongTheThirtySix) {
  Eigen::Matrix3d covariance;
  covariance << 1, 2, 3, 2, 4, 5, 3, 5, 6;
  const auto all = to_ros_covariance(covariance);
  EXPECT_EQ(all[0], 1.0);
  EXPECT_EQ(all[1], 2.0);
  EXPECT_EQ(all[5], 3.0);
  EXPECT_EQ(all[7], 4.0);
  EXPECT_EQ(all[11], 5.0);
  EXPECT_EQ(all[35], 6.0);
  EXPECT_EQ(all[14], 0.0);
}

TEST(RosConversion, TellsVelocityInBaseAndNoneOfAKidnap) {
  const ros::Twist twist = twist_between({0.0, 0.0, kPi / 2}, {0.0, 0.1, kPi / 2 + 0.05}, 0.1);
  EXPECT_NEAR(twist.linear.x, 1.0, 1e-12);
  EXPECT_NEAR(twist.linear.y, 0.0, 1e-12);
  EXPECT_NEAR(twist.angular.z, 0.5, 1e-12);
  EXPECT_EQ(twist_between({}, {9.0, 0.0, 0.0}, 0.1).linear.x, 0.0);
}

RosMap turned_map() { return {"m", 2, 3, 0.05, -1.5, 2.5, 0.25, {-1, 0, 100, 0, 50, 100}}; }

TEST(RosConversion, BringsAMapBack) {
  const RosMap back = from_ros_grid(to_ros_grid(turned_map()), "m");
  EXPECT_EQ(back.resolution, 0.05);
  EXPECT_EQ(back.width, 2);
  EXPECT_EQ(back.height, 3);
  EXPECT_EQ(back.origin_x, -1.5);
  EXPECT_EQ(back.origin_y, 2.5);
  EXPECT_NEAR(back.origin_yaw, 0.25, 1e-15);
  EXPECT_EQ(back.cells, turned_map().cells);
}

TEST(RosConversion, BelievesNoSizeOfAMap) {
  ros::OccupancyGrid message = to_ros_grid(turned_map());
  message.info.width = 4'000'000'000U;
  EXPECT_TRUE(contains(error_of([&] { from_ros_grid(message, "m"); }), "says 4000000000 x 3"));
}

}  // namespace
}  // namespace castaway::testbed
