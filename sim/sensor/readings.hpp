/// What the robot's sensors deliver, and the truth beside it.
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
};

/// Where a person was.
struct PersonReading {
  int person = 0;                                      ///< Its number.
  Pose2 T_map_person;                                  ///< x where it faces.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] In map.
  double gap =
      0.0;  ///< [m] Between the robot's outline and the disc of the body; <= 0: they touch.
};

/// The robot ran into a person.
struct PersonHit {
  std::chrono::nanoseconds stamp{};
  int person = 0;  ///< Its number.
  Pose2 T_map_base_true;
};

/// One scan, of a 3-D lidar one turn of all layers.
struct LidarReading {
  std::chrono::nanoseconds stamp{};           ///< Of the first beam, by the lidar's clock.
  std::chrono::nanoseconds time_increment{};  ///< Between two beams; 0 without sweep.
  int layers = 1;                             ///< Beams come layer by layer, lowest index first.
  std::vector<float> ranges;                  ///< [m] +inf: nothing within range, -inf: too close.
  /// Same length: index of the object, or kHitNothing, kHitFloor, kHitDust, kHitPerson + index of
  /// the person.
  std::vector<int> hit_object;
  std::vector<float> intensities{};   ///< Same length, or empty if the lidar tells none.
  Pose2 T_map_base_true;              ///< When the first beam was taken.
  std::vector<PersonReading> people;  ///< All there are, at the stamp or up to 50 ms later.
  std::size_t lidar = 0;              ///< Index into `SimulationConfig::lidars`.
  /// Error of the mount that the localizers are told: told T_base_laser = this * the true one.
  std::optional<Pose2> mount_error{};
};

}  // namespace castaway::sim
