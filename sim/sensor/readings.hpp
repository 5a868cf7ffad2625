/// Readings of the robot's sensors, with the true state.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "sim/casting/surfaces.hpp"
#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// One reading of wheel odometry.
struct OdometryReading {
  std::chrono::nanoseconds stamp{};
  Pose2 T_odom_base;  ///< Accumulated from the start of the run; continuous, drifting.
  Pose2 T_map_base_true;
  /// Height, roll and pitch of base.
  Eigen::Isometry3d T_footprint_base_true = Eigen::Isometry3d::Identity();
};

/// State of a person at a time.
struct PersonReading {
  int person = 0;      ///< Number of the person.
  Pose2 T_map_person;  ///< Its x axis points where the person faces.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] In map.
  /// [m] Between the robot's outline and the disc of the body; <= 0: they touch.
  double gap = 0.0;
};

/// One scan; of a 3-D lidar, one revolution of all layers.
struct LidarReading {
  std::chrono::nanoseconds stamp{};           ///< Of the first beam, by the lidar's clock.
  std::chrono::nanoseconds time_increment{};  ///< Between two beams; 0 without sweep.
  int layers = 1;             ///< Beams come layer by layer, in order of the layers' indices.
  std::vector<float> ranges;  ///< [m] +inf: nothing within range, -inf: too close.
  /// Same length as `ranges`: index of the object hit, or kHitNothing, kHitFloor, kHitDust,
  /// kHitPerson + number of the person.
  std::vector<int> hit_object;
  /// Same length as `ranges`, or empty if the lidar has no intensities.
  std::vector<float> intensities{};
  Pose2 T_map_base_true;  ///< At the first beam.
  /// At the first beam: height, roll and pitch of base.
  Eigen::Isometry3d T_footprint_base_true = Eigen::Isometry3d::Identity();
  std::vector<PersonReading> people;  ///< All people, at the stamp or up to 50 ms later.
  std::size_t lidar = 0;              ///< Index into `SimulationConfig::lidars`.
  /// Error of the reported mount: reported T_base_laser = this * the true one.
  std::optional<Pose2> mount_error{};
};

}  // namespace castaway::sim
