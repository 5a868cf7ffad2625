/// What moves around the robot, as its lidars see it.
#pragma once

#include <vector>

#include "sim/map/free_space.hpp"
#include "sim/navigation/live_scan.hpp"
#include "sim/navigation/movers.hpp"

namespace castaway::sim {

/// Movers in frame b, given in frame a.
std::vector<Mover> transform_movers(std::vector<Mover> movers, const Pose2& T_b_a);

/// Tracks people by the end points of beams that are not on the map.
class MoverWatch {
 public:
  /// `map`: known to the robot; may differ from the world.
  explicit MoverWatch(const Grid& map);

  /// Updates the tracks with the new scans. Poses are estimates.
  void update(LiveScan& live, const Pose2& T_map_base);

  /// Tracked people, in base.
  [[nodiscard]] const std::vector<Mover>& seen() const { return seen_; }
  /// Those of them that move, in base.
  [[nodiscard]] const std::vector<Mover>& moving() const { return moving_; }
  /// Velocity, in base, of the mover that a point belongs to, by the mover's position now or when
  /// the point was seen. Zero for other points and for points on the map: a wall does not move with
  /// a person who passes it.
  [[nodiscard]] Eigen::Vector2d velocity_at(const Eigen::Vector2d& p_base,
                                            const Pose2& T_map_base) const;
  /// The space without mapped obstacles.
  [[nodiscard]] const FreeSpace& mapped() const { return mapped_; }

 private:
  FreeSpace mapped_;
  Movers movers_;
  std::vector<Mover> seen_;
  std::vector<Mover> moving_;
};

}  // namespace castaway::sim
