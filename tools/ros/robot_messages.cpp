#include "tools/ros/robot_messages.hpp"

namespace castaway::testbed {

ros::Odometry odometry_message(const ros::Header& header, const std::string& child,
                               const SE2& T_header_child) {
  ros::Odometry message;
  message.header = header;
  message.child_frame_id = child;
  message.pose.pose = to_ros_pose(T_header_child);
  return message;
}

ros::TFMessage transform_message(const ros::Header& header, const std::string& child,
                                 const ros::Pose& pose) {
  const ros::Point& p = pose.position;
  return {{{header, child, {{p.x, p.y, p.z}, pose.orientation}}}};
}

ros::Imu imu_message(const ros::Header& header, const localization::Imu& imu) {
  const Eigen::Vector3d& w = imu.angular_velocity;
  const Eigen::Vector3d& a = imu.linear_acceleration;
  ros::Imu message;
  message.header = header;
  message.orientation_covariance.front() = -1.0;
  message.angular_velocity = {w.x(), w.y(), w.z()};
  message.linear_acceleration = {a.x(), a.y(), a.z()};
  return message;
}

ros::PoseWithCovarianceStamped pose_message(const ros::Header& header, const SE2& T_header_base,
                                            const Eigen::Matrix3d& covariance) {
  return {header, {to_ros_pose(T_header_base), to_ros_covariance(covariance)}};
}

ros::PoseArray particles_message(const ros::Header& header,
                                 const std::vector<localization::PopulationView>& populations,
                                 bool heights) {
  ros::PoseArray message{header, {}};
  for (const auto& population : populations) {
    const double z = heights && population.footing ? population.footing->z : 0.0;
    for (const SE2& particle : population.particles) {
      message.poses.push_back(to_ros_pose(particle));
      message.poses.back().position.z = z;
    }
  }
  return message;
}

}  // namespace castaway::testbed
