/// Messages of sensor_msgs and nav_msgs, as ROS 2 defines them. See `ros_message.hpp`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/ros/ros_geometry.hpp"

namespace castaway::testbed::ros {

/// A sweep of a planar lidar; the stamp is that of the first beam.
struct LaserScan {
  static constexpr const char* kType = "sensor_msgs/msg/LaserScan";
  Header header;
  float angle_min = 0.0F;        ///< [rad]
  float angle_max = 0.0F;        ///< [rad]
  float angle_increment = 0.0F;  ///< [rad]
  float time_increment = 0.0F;   ///< [s]
  float scan_time = 0.0F;        ///< [s]
  float range_min = 0.0F;        ///< [m]
  float range_max = 0.0F;        ///< [m]
  std::vector<float> ranges;     ///< [m] REP-117.
  std::vector<float> intensities;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("angle_min", self.angle_min);
    visitor("angle_max", self.angle_max);
    visitor("angle_increment", self.angle_increment);
    visitor("time_increment", self.time_increment);
    visitor("scan_time", self.scan_time);
    visitor("range_min", self.range_min);
    visitor("range_max", self.range_max);
    visitor("ranges", self.ranges);
    visitor("intensities", self.intensities);
  }
};

/// Joints by name. Positions and velocities: as many as names.
struct JointState {
  static constexpr const char* kType = "sensor_msgs/msg/JointState";
  Header header;
  std::vector<std::string> name;
  std::vector<double> position;  ///< [rad]
  std::vector<double> velocity;  ///< [rad/s]
  std::vector<double> effort;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("name", self.name);
    visitor("position", self.position);
    visitor("velocity", self.velocity);
    visitor("effort", self.effort);
  }
};

/// A picture.
struct CompressedImage {
  static constexpr const char* kType = "sensor_msgs/msg/CompressedImage";
  Header header;
  std::string format;  ///< "png"
  std::vector<std::uint8_t> data;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("format", self.format);
    visitor("data", self.data);
  }
};

/// Where the cells of a map lie.
struct MapMetaData {
  static constexpr const char* kType = "nav_msgs/msg/MapMetaData";
  Time map_load_time;
  float resolution = 0.0F;   ///< [m]
  std::uint32_t width = 0;   ///< [cells]
  std::uint32_t height = 0;  ///< [cells]
  Pose origin;               ///< Of the corner of cell (0, 0).

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("map_load_time", self.map_load_time);
    visitor("resolution", self.resolution);
    visitor("width", self.width);
    visitor("height", self.height);
    visitor("origin", self.origin);
  }
};

/// A map; -1 unknown, 0 free ... 100 occupied.
struct OccupancyGrid {
  static constexpr const char* kType = "nav_msgs/msg/OccupancyGrid";
  Header header;
  MapMetaData info;
  std::vector<std::int8_t> data;  ///< Rows from the smallest y.

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("info", self.info);
    visitor("data", self.data);
  }
};

/// A pose in the header's frame, velocities in the child's.
struct Odometry {
  static constexpr const char* kType = "nav_msgs/msg/Odometry";
  Header header;
  std::string child_frame_id;
  PoseWithCovariance pose;
  TwistWithCovariance twist;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("child_frame_id", self.child_frame_id);
    visitor("pose", self.pose);
    visitor("twist", self.twist);
  }
};

}  // namespace castaway::testbed::ros
