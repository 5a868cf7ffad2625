#include "tools/build/ros2/ros_names.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

// ROS 2's design: design.ros2.org/articles/topic_and_service_names.html
TEST(RosNames, NamesWithoutASlashAreInTheNamespace) {
  EXPECT_EQ(full_topic("", "scan"), "/scan");
  EXPECT_EQ(full_topic("/", "scan"), "/scan");
  EXPECT_EQ(full_topic("robot1", "scan"), "/robot1/scan");
  EXPECT_EQ(full_topic("/fleet/robot1", "front/scan"), "/fleet/robot1/front/scan");
  EXPECT_EQ(full_topic("robot1", "/tf"), "/tf");
}

TEST(RosNames, RefusesWhatRos2Refuses) {
  for (const char* name :
       {"", "/", "2scans", "scan/", "a//b", "scan-front", "~scan", "a__b", "ä"}) {
    EXPECT_THROW(full_topic("", name), std::invalid_argument) << name;
  }
  EXPECT_THROW(full_topic("my robot", "scan"), std::invalid_argument);
}

TEST(RosNames, AreMangledForTheWire) {
  EXPECT_EQ(dds_topic_name("/robot1/scan"), "rt/robot1/scan");
  EXPECT_EQ(dds_type_name("sensor_msgs/msg/LaserScan"), "sensor_msgs::msg::dds_::LaserScan_");
  EXPECT_EQ(dds_type_name("tf2_msgs/msg/TFMessage"), "tf2_msgs::msg::dds_::TFMessage_");
}

}  // namespace
}  // namespace castaway::testbed
