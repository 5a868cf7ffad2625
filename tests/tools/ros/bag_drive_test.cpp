#include "tools/ros/bag_drive.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

const DriveNow kNow{0.4, -0.2, {{"wheel_left", 3.0}, {"wheel_right", 2.5}}};

TEST(BagDrive, CommandsAreTwistsOfBase) {
  const ros::TwistStamped message = command_message(std::chrono::seconds(2), kNow);
  EXPECT_EQ(message.header.frame_id, "base_footprint");
  EXPECT_EQ(message.header.stamp.sec, 3);  // Time 0 of a run is 1 s in its bag.
  EXPECT_EQ(message.twist.linear.x, 0.4);
  EXPECT_EQ(message.twist.angular.z, -0.2);
}

TEST(BagDrive, JointsHaveAnglesAndVelocities) {
  const DriveNow before{0.0, 0.0, {{"wheel_left", 2.9}, {"wheel_right", 2.5}}};
  const ros::JointState message = joints_message(std::chrono::seconds(2), kNow, before, 0.05);
  EXPECT_EQ(message.name, (std::vector<std::string>{"wheel_left", "wheel_right"}));
  EXPECT_EQ(message.position, (std::vector<double>{3.0, 2.5}));
  ASSERT_EQ(message.velocity.size(), 2U);
  EXPECT_NEAR(message.velocity[0], 2.0, 1e-9);
  EXPECT_EQ(message.velocity[1], 0.0);
  EXPECT_EQ(joints_message(std::chrono::seconds(2), kNow, std::nullopt, 0.0).velocity[0], 0.0);
}

}  // namespace
}  // namespace castaway::testbed
