#include "tools/ros/bag_json.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tools/ros/ros_sensor.hpp"

namespace castaway::testbed {
namespace {

TEST(RosJson, ListsTheFieldsInOrder) {
  ros::LaserScan scan;
  scan.header.frame_id = "laser";
  scan.ranges = {0.5F, std::numeric_limits<float>::infinity(),
                 -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()};
  EXPECT_EQ(RosJson::of(scan).dump(),
            R"({"header":{"stamp":{"sec":0,"nanosec":0},"frame_id":"laser"},"angle_min":0.0,)"
            R"("angle_max":0.0,"angle_increment":0.0,"time_increment":0.0,"scan_time":0.0,)"
            R"("range_min":0.0,"range_max":0.0,"ranges":[0.5,"inf","-inf","nan"],)"
            R"("intensities":[]})");
}

}  // namespace
}  // namespace castaway::testbed
