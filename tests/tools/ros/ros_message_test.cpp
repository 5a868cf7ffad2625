// The definitions that bags hold, as the build makes them from tools/ros/msg/.
#include <string>

#include <gtest/gtest.h>

#include "tools/ros/ros_sensor.hpp"
#include "tools/ros/ros_visualization.hpp"

namespace castaway::testbed {
namespace {

const std::string kLine = std::string(80, '=') + "\n";

TEST(RosMessage, DefinesAScanAsRosDoes) {
  EXPECT_EQ(ros::LaserScan::kDefinition,
            "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\n"
            "float32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\n"
            "float32 range_min\nfloat32 range_max\nfloat32[] ranges\nfloat32[] intensities\n" +
                kLine + "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" +
                kLine + "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
}

TEST(RosMessage, DefinesAMapAsRosDoes) {
  const std::string text = ros::OccupancyGrid::kDefinition;
  EXPECT_EQ(text.substr(0, text.find("====")),
            "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data\n");
  EXPECT_NE(text.find("MSG: nav_msgs/MapMetaData\nbuiltin_interfaces/Time map_load_time\n"
                      "float32 resolution\nuint32 width\nuint32 height\n"
                      "geometry_msgs/Pose origin\n"),
            std::string::npos);
}

TEST(RosMessage, DefinesEachPartOnce) {
  const std::string text = ros::MarkerArray::kDefinition;
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find("MSG: std_msgs/Header\n", at)) != std::string::npos;
       ++at) {
    ++count;
  }
  EXPECT_EQ(count, 1U);
  EXPECT_NE(text.find("MSG: std_msgs/ColorRGBA\nfloat32 r\n"), std::string::npos);
}

TEST(RosMessage, DefinesCovariancesAsFixedArrays) {
  EXPECT_NE(std::string(ros::Odometry::kDefinition).find("float64[36] covariance\n"),
            std::string::npos);
}

TEST(RosMessage, HasTheDefaultsOfItsDefinition) {
  EXPECT_EQ(ros::Quaternion{}.w, 1.0);
  EXPECT_EQ(ros::Marker{}.scale.x, 0.0);
}

}  // namespace
}  // namespace castaway::testbed
