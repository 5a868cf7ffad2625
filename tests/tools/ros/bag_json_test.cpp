#include "tools/ros/bag_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/ros/cdr.hpp"
#include "tools/ros/ros_geometry.hpp"

namespace castaway::testbed {
namespace {

TEST(BagJson, ShowsMessagesOfKnownTypes) {
  const auto json = message_json("std_msgs/msg/String", CdrWriter::encode(ros::String{"hello"}));
  ASSERT_TRUE(json);
  EXPECT_EQ(json->dump(), R"({"data":"hello"})");
}

TEST(BagJson, LeavesOtherTypesAlone) {
  EXPECT_FALSE(message_json("sensor_msgs/msg/MultiEchoLaserScan", "anything"));
}

TEST(BagJson, RefusesBrokenMessages) {
  EXPECT_THROW(message_json("std_msgs/msg/String", "abc"), std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
