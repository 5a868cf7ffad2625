/// On which side to pass those who come towards the robot, or are caught up with.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/map/free_space.hpp"
#include "sim/navigation/movers.hpp"
#include "sim/navigation/route_runner.hpp"

namespace castaway::sim {

/// How people are passed.
struct PassingConfig {
  double radius = 0.25;  ///< [m] Of the robot.
  double room = 0.25;    ///< [m] Wanted between it and a mover's disc.
  double ahead = 6.0;    ///< [m] Within which they are minded.
  double right = 0.4;    ///< [m] Kept to the right of the lane where there is room.
};

/// How fast people are met.
struct PaceConfig {
  double max_speed = 0.5;     ///< [m/s]
  double deceleration = 0.4;  ///< [m/s^2] That the robot can count on.
  double radius = 0.25;       ///< [m] Of the robot.
};

/// The speed at which to meet movers (in map) for a robot that drives `offset` [m] to the left of
/// its lane. Before those in its way it can come to stand before they are there, even if they walk
/// straight on; beside others it slows down, so that both have the time to make room. [m/s]
double passing_pace(const PaceConfig& config, const Lane& lane, double offset,
                    const std::vector<Mover>& movers);

/// Chooses how far beside its lane the robot drives. Without anybody about it keeps to the right
/// where there is room, as people do: whoever comes towards it then passes on the left.
class Passing {
 public:
  explicit Passing(const PassingConfig& config) : config_(config) {}

  /// Where to drive to instead of the lane's end, in map, so that the movers (in map) are passed
  /// with room at `speed` [m/s]. Only where the robot can be, going by `mapped`.
  Eigen::Vector2d aside(const Lane& lane, double speed, const std::vector<Mover>& movers,
                        const FreeSpace& mapped);

 private:
  [[nodiscard]] double crowding(double offset, const Lane& lane, double speed,
                                const std::vector<Mover>& movers) const;

  PassingConfig config_;
  double offset_ = 0.0;  ///< [m] Chosen last; left positive.
};

}  // namespace castaway::sim
