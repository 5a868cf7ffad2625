/// On which side to pass those who come towards the robot, or are caught up with.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/navigation/movers.hpp"
#include "sim/navigation/route_runner.hpp"
#include "sim/world/free_space.hpp"

namespace castaway::sim {

/// How people are passed.
struct PassingConfig {
  double radius = 0.25;  ///< [m] Of the robot.
  double room = 0.25;    ///< [m] Wanted between it and a mover's disc.
  double ahead = 6.0;    ///< [m] Within which they are minded.
  double right = 0.4;    ///< [m] Kept to the right of the lane where there is room.
};

/// The speed at which to meet movers (in map) that are on the lane ahead or come near it: slower
/// the nearer they are, so that both have the time to make room. At most `max_speed`. [m/s]
double passing_pace(const Lane& lane, const std::vector<Mover>& movers, double max_speed);

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
