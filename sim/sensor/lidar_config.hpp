/// What a planar lidar is and where it sits.
#pragma once

#include <numbers>

#include <Eigen/Geometry>

#include "sim/sensor/range_noise.hpp"

namespace castaway::sim {

struct RobotModel;

/// A planar lidar. Beam i points to `angle_min + i * angle_increment` about the laser's z.
struct LidarConfig {
  Eigen::Isometry3d T_base_laser{Eigen::Translation3d(0.0, 0.0, 0.2)};  ///< Any mount in 3-D.
  int beams = 360;                                                      ///< [1, 100000]
  double angle_min = -std::numbers::pi;                                 ///< [rad]
  double angle_increment = 2.0 * std::numbers::pi / 360;                ///< [rad] Signed.
  double range_min = 0.12;  ///< [m] Shorter returns are reported as -inf.
  double range_max = 12.0;  ///< [m] Longer returns are reported as +inf.
  double rate_hz = 10.0;    ///< [Hz] Turns a second.
  bool sweep = true;        ///< Each beam at its own time; false: all at the stamp of the scan.
  RangeNoise noise;
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const LidarConfig& config);

/// The lidar that the robot's description carries; what it does not say keeps its default.
LidarConfig lidar_of(const RobotModel& robot);

}  // namespace castaway::sim
