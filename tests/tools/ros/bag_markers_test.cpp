#include "tools/ros/bag_markers.hpp"

#include <gtest/gtest.h>

#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

TEST(BagMarkers, StandPeopleOnTheFloor) {
  const auto message =
      people_markers(std::chrono::seconds(1), {{7, {1.0, 2.0, 0.5}, {0.0, 0.0}, 1.0}});
  ASSERT_EQ(message.markers.size(), 1U);
  const ros::Marker& person = message.markers[0];
  EXPECT_EQ(person.id, 7);
  EXPECT_EQ(person.header.stamp.sec, 2);
  EXPECT_EQ(person.pose.position.x, 1.0);
  EXPECT_EQ(person.pose.position.z, 0.5 * person.scale.z);
}

TEST(BagMarkers, TellHypothesesApart) {
  const auto message = hypothesis_markers(
      {}, {{0, {}, 0.5, 0.75, true, {}}, {1, {3.0, 0.0, 0.0}, 0.5, 0.25, false, {}}});
  ASSERT_EQ(message.markers.size(), 3U);
  EXPECT_EQ(message.markers[0].action, 3);  // Delete all.
  EXPECT_GT(message.markers[1].scale.x, message.markers[2].scale.x);
  EXPECT_GT(message.markers[1].color.a, message.markers[2].color.a);
  EXPECT_NE(message.markers[1].color.r, message.markers[2].color.r);
  EXPECT_EQ(message.markers[2].pose.position.x, 3.0);
}

}  // namespace
}  // namespace castaway::testbed
