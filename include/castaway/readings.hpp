/// Sensor readings that a localizer takes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "castaway/pose.hpp"
#include "castaway/stamp.hpp"

namespace castaway::localization {

/// One reading of wheel odometry.
struct Odometry {
  Stamp stamp{};
  SE2 T_odom_base;  ///< Accumulated from an arbitrary start; continuous, drifting (REP-105).
};

/// One reading of an inertial measurement unit, in base (REP-145).
struct Imu {
  Stamp stamp{};
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< [rad/s]
  /// [m/s^2] Specific force: at rest on level ground (0, 0, 9.81).
  Eigen::Vector3d linear_acceleration = Eigen::Vector3d::Zero();
};

/// A layer of a lidar of several: beams on a cone about the lidar's z.
struct ScanLayer {
  double elevation = 0.0;  ///< [rad] Above the lidar's plane.
  std::vector<float>
      ranges;  ///< [m] Along the beams; as many as `LaserScan::ranges`, at its angles.
};

/// One sweep of a lidar with any mount.
struct LaserScan {
  Stamp stamp{};                 ///< Time of the first beam.
  Stamp time_increment{};        ///< Time between two beams; 0 if all were taken at once.
  double angle_min = 0.0;        ///< [rad] Angle of the first beam about the lidar's z, from its x.
  double angle_increment = 0.0;  ///< [rad] Signed step between two beams.
  double range_min = 0.0;        ///< [m] Shorter returns are invalid.
  double range_max = 0.0;        ///< [m] Longer returns are invalid.
  std::vector<float> ranges;     ///< [m] REP-117: +inf no return, -inf too close, NaN invalid.
  Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();  ///< The lidar's mount.
  std::string lidar;  ///< Name of the lidar if there are several; scans are ordered per lidar.
  /// All layers of a 3-D lidar, of which `ranges` is a planar cut. Empty: a planar lidar.
  std::vector<ScanLayer> layers{};

  /// Time of beam `index`.
  [[nodiscard]] Stamp beam_stamp(std::size_t index) const {
    return stamp + time_increment * static_cast<std::int64_t>(index);
  }
  /// Angle of beam `index` in the lidar's plane. [rad]
  [[nodiscard]] double beam_angle(std::size_t index) const {
    return angle_min + angle_increment * static_cast<double>(index);
  }
};

}  // namespace castaway::localization

namespace castaway {

using localization::Imu;
using localization::LaserScan;
using localization::Odometry;
using localization::ScanLayer;

}  // namespace castaway
