/// Wheels that turn further than the robot moves: on slippery floors, now and then, and where it
/// runs into something. Physics lets wheels roll almost cleanly: slip is what the encoders count
/// on top.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/common/random.hpp"
#include "sim/sensor/wheel_odometry.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// Slip of both drive wheels, each by itself.
class WheelSlip {
 public:
  /// `drive`: the true one. @throws std::invalid_argument naming the field and the remedy.
  WheelSlip(const SlipConfig& config, const DriveGeometry& drive, std::vector<SlipZone> zones,
            Rng rng);

  /// What the encoders count for a true increment of the wheels' angles [rad]. `T_map_base`: where
  /// the robot is, `collisions`: how many it has had.
  WheelAngles counted(const WheelAngles& increment, const Pose2& T_map_base,
                      std::int64_t collisions);

 private:
  struct Wheel {
    double radius = 0.0;                               ///< [m]
    Eigen::Vector2d p_base = Eigen::Vector2d::Zero();  ///< [m] Where it touches the floor.
    double next_event = 0.0;                           ///< [m] Of way until it slips...
    double event_left = 0.0;                           ///< [m] ...and until that is over.
    double event_share = 0.0;                          ///< Of the way, lost meanwhile.
    double zone_left = 0.0;                            ///< [m] Until the floor is another.
    double zone_factor = 1.0;                          ///< Of the zone's slip.
  };
  double counted(Wheel& wheel, double angle, const Pose2& T_map_base);
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
