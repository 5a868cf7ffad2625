/// What the robot's sensors deliver, and the truth beside it.
#pragma once

#include <chrono>
#include <vector>

#include "sim/geometry.hpp"

namespace castaway::sim {

/// One reading of wheel odometry.
struct OdometryReading {
  std::chrono::nanoseconds stamp{};
  Pose2 T_odom_base;  ///< Accumulated from the start of the run; continuous, drifting.
  Pose2 T_map_base_true;
};

/// What a beam hit, besides the index of an object in `WorldSpec::objects`.
inline constexpr int kHitNothing = -1;
inline constexpr int kHitFloor = -2;
/// Person i is kHitPerson + i; there are never so many objects.
inline constexpr int kHitPerson = 1 << 24;
/// True if a beam ended on a person.
constexpr bool is_person(int hit) { return hit >= kHitPerson; }

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

/// One scan.
struct LidarReading {
  std::chrono::nanoseconds stamp{};           ///< Of the first beam.
  std::chrono::nanoseconds time_increment{};  ///< Between two beams; 0 without sweep.
  std::vector<float> ranges;                  ///< [m] +inf: nothing within range, -inf: too close.
  /// Same length: index of the object, or kHitNothing, kHitFloor, kHitPerson + index of the person.
  std::vector<int> hit_object;
  Pose2 T_map_base_true;              ///< At the stamp.
  std::vector<PersonReading> people;  ///< All there are, at the stamp or up to 50 ms later.
};

}  // namespace castaway::sim
