/// Frames of a run as ROS 2 messages, and back. The one place that knows both.
#pragma once

#include <map>
#include <string>

#include <Eigen/Geometry>

#include "tools/formats/ros_map.hpp"
#include "tools/ros/ros_sensor.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// A run's time 0 in its bags: tf2 takes stamp 0 for "the newest there is", so no bag holds it.
inline constexpr Stamp kBagEpoch = std::chrono::seconds(1);

/// A time of the run as a stamp of the bag.
ros::Time to_ros_time(Stamp stamp);
/// Nanoseconds of a stamp, as they are.
Stamp from_ros_time(const ros::Time& time);

ros::Header ros_header(Stamp stamp, const std::string& frame);

/// z, roll and pitch are 0. `from_ros_pose` gives the same pose to the last bit: the quaternion is
/// the one of those next to the yaw's that turns back into it.
ros::Pose to_ros_pose(const SE2& pose);
/// z, roll and pitch are dropped; yaw in [-pi, pi]. Throws std::runtime_error if it holds no
/// numbers.
SE2 from_ros_pose(const ros::Pose& pose);

ros::Transform to_ros_transform(const Eigen::Isometry3d& T_parent_child);
/// Throws std::runtime_error if it holds no numbers, or no rotation.
Eigen::Isometry3d from_ros_transform(const ros::Transform& transform);

/// Covariance of (x, y, yaw) among the 36 of ROS.
std::array<double, 36> to_ros_covariance(const Eigen::Matrix3d& covariance);

/// Velocity of a base that went from one pose to the other in `dt_s`; 0 where no robot does that.
ros::Twist twist_between(const SE2& from, const SE2& to, double dt_s);

ros::LaserScan to_ros_scan(const LaserScan& scan, const ScanTruth& truth, const std::string& frame);
/// Stamps as they are; the mount is left alone; a sweep of more than 10 s or backwards is none.
/// `exact` may hold the numbers that the message rounds, as `exact_scan_numbers` gives them.
LaserScan from_ros_scan(const ros::LaserScan& message,
                        const std::map<std::string, std::string>& exact);
/// Name, numbers and mount of a lidar at full length: a LaserScan holds its angles as 32 bits, and
/// /tf_static its mount as several edges of quaternions.
std::map<std::string, std::string> exact_scan_numbers(const LaserScan& scan);
/// The mount among them; nothing if there is none.
std::optional<Eigen::Isometry3d> exact_mount(const std::map<std::string, std::string>& exact);

ros::OccupancyGrid to_ros_grid(const RosMap& map);
/// The resolution, a float, is read as the shortest decimal that rounds to it (0.05). Throws
/// std::runtime_error if sizes do not fit or it is no map.
RosMap from_ros_grid(const ros::OccupancyGrid& message, const std::string& name);

}  // namespace castaway::testbed
