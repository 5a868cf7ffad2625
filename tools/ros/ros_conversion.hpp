/// Converts frames of a run to ROS 2 messages and back. Only this file knows both.
#pragma once

#include <map>
#include <string>

#include <Eigen/Geometry>

#include "tools/base/formats/ros_map.hpp"
#include "tools/ros/ros_sensor.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Time 0 of a run in its bags. It is not 0, since tf2 interprets stamp 0 as "latest available".
inline constexpr Stamp kBagEpoch = std::chrono::seconds(1);

/// Converts a time of the run to a stamp of the bag.
ros::Time to_ros_time(Stamp stamp);
/// Converts a stamp to nanoseconds without an offset.
Stamp from_ros_time(const ros::Time& time);

ros::Header ros_header(Stamp stamp, const std::string& frame);

/// z, roll and pitch are 0. `from_ros_pose` returns exactly the same pose: of the quaternions near
/// the yaw's, the one is chosen that converts back exactly.
ros::Pose to_ros_pose(const SE2& pose);
/// With z, roll and pitch.
ros::Pose to_ros_pose(const Eigen::Isometry3d& T_parent_child);
/// Drops z, roll and pitch; yaw is in [-pi, pi]. Throws std::runtime_error for values that are not
/// finite.
SE2 from_ros_pose(const ros::Pose& pose);

ros::Transform to_ros_transform(const Eigen::Isometry3d& T_parent_child);
/// Throws std::runtime_error for values that are not finite or not a rotation.
Eigen::Isometry3d from_ros_transform(const ros::Transform& transform);

/// Puts the covariance of (x, y, yaw) into the 36 elements of ROS.
std::array<double, 36> to_ros_covariance(const Eigen::Matrix3d& covariance);

/// Velocity of a base that moved between the poses in `dt_s`; 0 if no robot is that fast.
ros::Twist twist_between(const SE2& from, const SE2& to, double dt_s);

ros::LaserScan to_ros_scan(const LaserScan& scan, const ScanTruth& truth, const std::string& frame);
/// Keeps stamps and does not set the mount. A sweep of more than 10 s or backwards is ignored.
/// `exact` may hold the unrounded numbers, see `exact_scan_numbers`.
LaserScan from_ros_scan(const ros::LaserScan& message,
                        const std::map<std::string, std::string>& exact);
/// Name, numbers and mount of a lidar in full precision: a LaserScan stores its angles in 32 bits,
/// and /tf_static stores its mount as several edges with quaternions.
std::map<std::string, std::string> exact_scan_numbers(const LaserScan& scan);
/// The mount in these numbers; nothing if there is none.
std::optional<Eigen::Isometry3d> exact_mount(const std::map<std::string, std::string>& exact);

ros::OccupancyGrid to_ros_grid(const RosMap& map);
/// The resolution, a float, is read as the shortest decimal that rounds to it (0.05). Throws
/// std::runtime_error for inconsistent sizes or an invalid map.
RosMap from_ros_grid(const ros::OccupancyGrid& message, const std::string& name);

}  // namespace castaway::testbed
