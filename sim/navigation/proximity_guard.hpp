/// Keeps a robot that believes a wrong pose off what its lidar sees.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/geometry.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/readings.hpp"

namespace castaway::sim {

/// How near is too near.
struct GuardConfig {
  double radius = 0.25;           ///< [m] Of the robot, about base.
  double margin = 0.1;            ///< [m] Kept free ahead of it.
  double deceleration = 0.3;      ///< [m/s^2] With which it brakes.
  double escape_speed = 0.15;     ///< [m/s]
  double escape_turn_rate = 0.6;  ///< [rad/s]
  int escape_calls = 60;          ///< Calls for which an escape lasts.
};

/// Slows down before obstacles in the newest scan of each lidar. Blocked, the robot turns to the
/// roomier side and drives off that way for a while, whatever its commands are: it would turn back
/// to the wall.
class ProximityGuard {
 public:
  explicit ProximityGuard(const GuardConfig& config) : config_(config) {}

  /// Takes what a lidar saw.
  void on_scan(const LidarReading& scan, const LidarConfig& lidar);
  /// The velocity to drive with instead of `command`.
  Twist2 guarded(const Twist2& command);

 private:
  [[nodiscard]] double gap_ahead() const;
  [[nodiscard]] double roomier_side() const;

  GuardConfig config_;
  std::vector<std::vector<Eigen::Vector2d>> points_;  ///< [m] In base, by lidar.
  int escape_left_ = 0;
  double escape_side_ = 1.0;  ///< 1: left, -1: right.
};

}  // namespace castaway::sim
