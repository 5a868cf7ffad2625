/// Stops the robot before it runs into something.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// Parameters of the emergency stop.
struct EmergencyStopConfig {
  double radius = 0.2;        ///< [m] Of the footprint.
  double deceleration = 1.0;  ///< [m/s^2] When braking.
  double period = 0.05;       ///< [s] Between two calls.
};

/// Watches for obstacles that the robot would hit before it could brake. A stop lasts until the
/// robot stands, and for a short pause.
class EmergencyStop {
 public:
  explicit EmergencyStop(const EmergencyStopConfig& config) : config_(config) {}

  /// Velocity of the obstacle at a point, both in base. [m/s]
  using VelocityAt = std::function<Eigen::Vector2d(const Eigen::Vector2d& p_base)>;

  /// What the robot has to do.
  struct Order {
    bool stop = false;
    bool begins = false;  ///< An emergency begins.
  };
  /// Judges the velocity `now` of the robot among end points of beams in base, and advances by a
  /// period.
  Order watch(const Twist2& now, const std::vector<Eigen::Vector2d>& p_base,
              const VelocityAt& velocity_at);

 private:
  EmergencyStopConfig config_;
  double left_ = 0.0;  ///< [s] Of the stop.
};

}  // namespace castaway::sim
