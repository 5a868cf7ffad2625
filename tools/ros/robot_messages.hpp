/// Messages about a robot, as in a bag and on the wire.
#pragma once

#include <string>
#include <vector>

#include "castaway/localizer.hpp"
#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {

/// A pose of `child` in the header's frame; the twist is left 0.
ros::Odometry odometry_message(const ros::Header& header, const std::string& child,
                               const SE2& T_header_child);

/// The same pose as a transform.
ros::TFMessage transform_message(const ros::Header& header, const std::string& child,
                                 const ros::Pose& pose);

/// A reading of an inertial measurement unit, which states no orientation.
ros::Imu imu_message(const ros::Header& header, const localization::Imu& imu);

/// A pose with its uncertainty.
ros::PoseWithCovarianceStamped pose_message(const ros::Header& header, const SE2& T_header_base,
                                            const Eigen::Matrix3d& covariance);

/// The particles of all populations. `heights`: at the height of their mean, else at z = 0.
ros::PoseArray particles_message(const ros::Header& header,
                                 const std::vector<localization::PopulationView>& populations,
                                 bool heights = false);

}  // namespace castaway::testbed
