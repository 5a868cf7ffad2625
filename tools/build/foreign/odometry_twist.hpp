/// The velocity between two readings of odometry.
#pragma once

#include <optional>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Mean velocity since the reading before, in base: [m/s], [m/s], [rad/s]. Zero without one.
inline Eigen::Vector3d twist_between(const std::optional<Odometry>& before, const Odometry& now) {
  const double dt = before ? seconds(now.stamp - before->stamp) : 0.0;
  if (dt <= 0.0) return Eigen::Vector3d::Zero();
  const SE2 step = before->T_odom_base.inverse() * now.T_odom_base;
  return Eigen::Vector3d(step.x, step.y, step.yaw) / dt;
}

}  // namespace castaway::testbed
