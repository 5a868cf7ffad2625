/// Chooses where a kidnap takes the robot.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/events/kidnap.hpp"

namespace castaway::sim {

class FreeSpace;
class LookAlikes;

/// State of the world that the choice depends on.
struct KidnapScene {
  Pose2 T_map_base;                       ///< True pose of base now; on levels, in frame plane.
  const FreeSpace& free;                  ///< For the robot's footprint plus the kidnap's margin.
  std::vector<Eigen::Vector2d> people{};  ///< [m] Positions of people in map.
  double keep_clear = 0.0;  ///< [m] Distance that the robot's centre keeps from each person.
  const LookAlikes* look_alikes = nullptr;  ///< Required by kLookAlike.
};

/// A chosen place.
struct KidnapTarget {
  Pose2 T_map_base;
  std::optional<double> unlikeness{};  ///< As in `KidnapRecord`.
  bool too_near = false;               ///< As in `KidnapRecord`.
};

/// Returns the place of a kidnap; the farthest one if none is `min_distance_m` away. Returns
/// nothing if there is none right now, because of people or because of what is next to the robot:
/// ask again later.
/// @throws std::runtime_error if there can never be one: the given target is in an obstacle, or
/// nothing is free.
std::optional<KidnapTarget> kidnap_target(const KidnapSpec& spec, const KidnapScene& scene,
                                          Rng& rng);

}  // namespace castaway::sim
