/// The robot as people see it.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

struct RobotModel;

/// Outline of a robot from above: a convex polygon in base, counter-clockwise. [m]
/// @throws std::runtime_error if a mesh cannot be read.
std::vector<Eigen::Vector2d> robot_outline(const RobotModel& robot);

/// The robot's shape and motion.
struct RobotBody {
  std::vector<Eigen::Vector2d> outline;                ///< [m] As of `robot_outline`.
  double radius = 0.2;                                 ///< [m] Disc about base.
  Pose2 T_map_base;                                    ///< True pose.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] In map.
};

/// Distance of a point from a robot's outline, and the way out.
struct OutlineDistance {
  double distance = 0.0;  ///< [m] Negative: inside.
  /// Unit vector in map along which the distance grows.
  Eigen::Vector2d away = Eigen::Vector2d::UnitX();
};

/// Distance from the outline of the robot to a point in map.
OutlineDistance distance_to(const RobotBody& robot, const Eigen::Vector2d& p_map);

}  // namespace castaway::sim
