/// What a robot of ROS 2 publishes.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "castaway/localizer.hpp"
#include "tools/build/foreign/message_text.hpp"
#include "tools/build/ros2/ros_topic.hpp"
#include "tools/ros/bag_frames.hpp"
#include "tools/ros/ros_conversion.hpp"
#include "tools/ros/ros_sensor.hpp"
#include "tools/ros/ros_wire.hpp"
#include "tools/run/ros2_config.hpp"

namespace castaway::testbed {

/// Publishes time, sensors, frames and the map, as localizers of ROS 2 want them.
class RobotFeed {
 public:
  /// Publishes what does not change: the map, the fixed frames and the robot's description.
  RobotFeed(DdsParticipant& participant, const Ros2Config& config, const Greeting& greeting);

  /// Advances the simulated time; an earlier one is ignored.
  void set_time(Stamp now);
  void repeat_time() { clock_.publish({to_ros_time(std::max(now_, Stamp{}))}); }
  void publish(const Odometry& odometry);
  /// The topic is added with the first reading.
  void publish(const localization::Imu& imu);
  /// At the time of its last beam; of a 3-D lidar, with all its layers as points.
  void publish(const LaserScan& scan);
  void publish_initial_pose(const localization::PoseWithCovariance& pose);

  /// Of scans and points.
  [[nodiscard]] int scan_subscribers() const;
  /// True if anybody subscribes to the scans or points of this lidar.
  [[nodiscard]] bool is_heard(const std::string& lidar) const;
  /// What subscribers ask for that is not offered, in one sentence each, since the last call.
  std::vector<std::string> refused();

 private:
  /// Publishers of a lidar.
  struct LidarTopics {
    RosPublisher<ros::LaserScan> scans;
    std::optional<RosPublisher<ros::PointCloud2>> points;  ///< Of a 3-D lidar.

    [[nodiscard]] int subscribers() const;
  };
  LidarTopics& topics_of(const std::string& lidar, bool has_layers);
  void publish_frames();

  DdsParticipant& participant_;
  Ros2Config config_;
  bool several_lidars_;
  BagFrames tree_;
  RosPublisher<ros::Clock> clock_;
  RosPublisher<ros::Odometry> odometry_;
  RosPublisher<ros::TFMessage> tf_;
  RosPublisher<ros::TFMessage> tf_static_;
  RosPublisher<ros::OccupancyGrid> map_;
  RosPublisher<ros::PoseWithCovarianceStamped> initial_pose_;
  std::optional<RosPublisher<ros::String>> description_;
  std::map<std::string, LidarTopics> lidars_;  ///< By name.
  std::optional<RosPublisher<ros::Imu>> imu_;  ///< Nothing before the first reading.
  std::optional<Odometry> before_;
  Stamp now_{-1};
};

}  // namespace castaway::testbed
