/// Wheels that turn farther than the robot moves: on slippery floors, at random, and at collisions.
/// Wheels hardly slip in simulated physics, so slip is added to the encoders' counts.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/common/random.hpp"
#include "sim/sensor/wheel_odometry.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Slip of both drive wheels, independent of each other.
class WheelSlip {
 public:
  /// `drive`: its true geometry. @throws std::invalid_argument naming the field and the remedy.
  WheelSlip(const SlipConfig& config, const DriveGeometry& drive, std::vector<SlipZone> zones,
            Rng rng);

  /// Returns what the encoders count for true increments of the wheels' angles [rad]. `T_map_base`:
  /// the robot's pose; `collisions`: its number of collisions so far.
  WheelAngles count(const WheelAngles& increment, const Pose2& T_map_base, std::int64_t collisions);

 private:
  struct Wheel {
    double radius = 0.0;                               ///< [m]
    Eigen::Vector2d p_base = Eigen::Vector2d::Zero();  ///< [m] Where it touches the floor.
    double next_event = 0.0;                           ///< [m] Distance to the next slip event.
    double event_left = 0.0;                           ///< [m] Distance left of the current event.
    double event_share = 0.0;                          ///< Share of the distance lost in the event.
    double zone_left = 0.0;    ///< [m] Distance until the zone's slip changes.
    double zone_factor = 1.0;  ///< Factor of the zone's slip.
  };
  double count(Wheel& wheel, double angle, const Pose2& T_map_base);
  double zone_share(Wheel& wheel, double way, const Pose2& T_map_base);
  void start_event(Wheel& wheel, double length);

  SlipConfig config_;
  std::vector<SlipZone> zones_;
  Rng rng_;
  std::array<Wheel, 2> wheels_;  ///< Left, right.
  std::int64_t collisions_ = 0;
};

/// True if a point lies in a polygon. Points on its outline may lie on either side.
bool contains(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& p);

}  // namespace castaway::sim
