/// On which side to pass people who approach the robot or whom it overtakes.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/map/free_space.hpp"
#include "sim/navigation/movers.hpp"
#include "sim/navigation/route_runner.hpp"

namespace castaway::sim {

/// Parameters of passing people.
struct PassingConfig {
  double radius = 0.25;  ///< [m] Of the robot.
  double room = 0.25;    ///< [m] Wanted between the robot and a mover's disc.
  double ahead = 6.0;    ///< [m] People farther ahead than this are ignored.
  double right = 0.4;    ///< [m] Offset to the right of the lane where there is room.
};

/// Parameters of the pace near people.
struct PaceConfig {
  double max_speed = 0.5;     ///< [m/s]
  double deceleration = 0.4;  ///< [m/s^2] Braking that the robot can count on.
  double radius = 0.25;       ///< [m] Of the robot.
};

/// Returns the speed near `movers` (in map) for a robot that drives `offset` [m] to the left of its
/// lane. For people in its way the robot can stop before they reach it, even if they walk straight
/// on; beside others it slows down, so that both have time to make room. [m/s]
double passing_pace(const PaceConfig& config, const Lane& lane, double offset,
                    const std::vector<Mover>& movers);

/// Chooses how far beside its lane the robot drives. Without people nearby it keeps to the right
/// where there is room, as people do: whoever approaches then passes on its left.
class Passing {
 public:
  explicit Passing(const PassingConfig& config) : config_(config) {}

  /// Returns the point in map to drive to instead of the lane's end, so that the robot passes the
  /// movers (in map) with room at `speed` [m/s]. The point is free on `mapped`.
  Eigen::Vector2d choose_target(const Lane& lane, double speed, const std::vector<Mover>& movers,
                                const FreeSpace& mapped);

 private:
  [[nodiscard]] double missing_room(double offset, const Lane& lane, double speed,
                                    const std::vector<Mover>& movers) const;

  PassingConfig config_;
  double offset_ = 0.0;  ///< [m] Last choice; left positive.
};

}  // namespace castaway::sim
