/// Builds bags of other robots for tests, message by message.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/ros/cdr.hpp"
#include "tools/ros/ros_visualization.hpp"
#include "tools/ros/storage/mcap_writer.hpp"

namespace castaway::testbed {

/// Writes messages as another recorder does.
class ForeignBag {
 public:
  explicit ForeignBag(const std::filesystem::path& path) : writer_(path) {}

  template <typename Message>
  void add(const std::string& topic, std::int64_t log_time_ns, const Message& message) {
    const auto [channel, first] = channels_.try_emplace(topic);
    if (first) {
      const auto schema = writer_.add_schema({Message::kType, "ros2msg", Message::kDefinition});
      channel->second = writer_.add_channel({schema, topic, "cdr", {}});
    }
    writer_.write(channel->second, log_time_ns, CdrWriter::encode(message));
  }
  void finish() { writer_.finish(); }

 private:
  McapWriter writer_;
  std::map<std::string, std::uint16_t> channels_;
};

inline ros::Header header_at(double t, const std::string& frame) {
  const auto ns = static_cast<std::int64_t>(t * 1e9 + 0.5);
  return {{static_cast<std::int32_t>(ns / 1'000'000'000),
           static_cast<std::uint32_t>(ns % 1'000'000'000)},
          frame};
}

inline ros::LaserScan ros_scan_at(double t, const std::string& frame) {
  ros::LaserScan scan;
  scan.header = header_at(t, frame);
  scan.angle_min = -1.0F;
  scan.angle_max = 1.0F;
  scan.angle_increment = 1.0F;
  scan.range_max = 8.0F;
  scan.ranges = {1.0F, 2.0F, 3.0F};
  return scan;
}

inline ros::Odometry ros_odometry_at(double t, double x) {
  ros::Odometry odometry;
  odometry.header = header_at(t, "odom");
  odometry.child_frame_id = "base_link";
  odometry.pose.pose.position.x = x;
  return odometry;
}

inline ros::TFMessage ros_edge(double t, const std::string& parent, const std::string& child,
                               double x) {
  ros::TransformStamped edge;
  edge.header = header_at(t, parent);
  edge.child_frame_id = child;
  edge.transform.translation.x = x;
  return {{edge}};
}

}  // namespace castaway::testbed
