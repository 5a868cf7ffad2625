#include "tools/base/formats/carmen_writer.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tools/base/formats/carmen_log.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

constexpr float kNoReturn = std::numeric_limits<float>::infinity();

CarmenScan scan() {
  CarmenScan scan;
  scan.angle_min = -0.5;
  scan.angle_increment = 0.25;
  scan.range_max = 8.0;
  scan.ranges = {1.5F, kNoReturn, -kNoReturn, std::numeric_limits<float>::quiet_NaN(), 0.1F};
  scan.T_odom_laser = {1.25, 2.0, 0.5};
  scan.T_odom_base = {1.0, 2.0, 0.5};
  return scan;
}

TEST(CarmenWriter, WritesLinesByTheBook) {
  EXPECT_EQ(carmen_param_line("robot_front_laser_max", 8.5),
            "PARAM robot_front_laser_max 8.5 castaway 0\n");
  EXPECT_EQ(carmen_odometry_line(milliseconds(1500), {1.0, -2.0, 0.25}, 0.5, 0.125),
            "ODOM 1 -2 0.25 0.5 0.125 0 1.500000000 castaway 1.500000000\n");
  EXPECT_EQ(carmen_truth_line(milliseconds(250), {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}),
            "TRUEPOS 1 2 3 4 5 6 0.250000000 castaway 0.250000000\n");
  EXPECT_EQ(carmen_scan_line(milliseconds(250), scan()),
            "ROBOTLASER1 0 -0.5 1 0.25 8 0.01 0 5 1.5 8 0 0 0.1 0 1.25 2 0.5 1 2 0.5 0 0 0 0 0 "
            "0.250000000 castaway 0.250000000\n");
}

TEST(CarmenWriter, IsReadBackToTheBit) {
  CarmenScan written = scan();
  written.angle_min = -3.141592653589793;
  written.T_odom_base = {1.0 / 3.0, 2.0 / 7.0, -0.1};
  std::string line = carmen_scan_line(milliseconds(100), written);
  line.pop_back();  // Readers take lines without the newline.
  const auto message = parse_carmen_line(line);
  ASSERT_TRUE(message);
  const auto& laser = std::get<CarmenLaser>(*message);
  EXPECT_EQ(laser.device->angle_min, written.angle_min);
  EXPECT_EQ(laser.device->angle_increment, 0.25);
  EXPECT_EQ(laser.device->range_max, 8.0);
  EXPECT_EQ(laser.T_odom_base.x, 1.0 / 3.0);
  EXPECT_EQ(laser.T_odom_base.y, 2.0 / 7.0);
  EXPECT_NEAR(laser.T_odom_base.yaw, -0.1, 1e-15);
  EXPECT_EQ(laser.ranges, (std::vector<float>{1.5F, 8.0F, 0.0F, 0.0F, 0.1F}));
  EXPECT_EQ(laser.time_s, 0.1);
}

}  // namespace
}  // namespace castaway::testbed
