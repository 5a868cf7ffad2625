/// Where kidnaps take the robot.
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

/// What the choice of a place depends on.
struct KidnapScene {
  Pose2 T_map_base;                       ///< True pose of base now.
  const FreeSpace& free;                  ///< Of the robot's footprint plus the kidnap's margin.
  std::vector<Eigen::Vector2d> people{};  ///< [m] Where in map people are...
  double keep_clear = 0.0;  ///< [m] ...and how far from each the robot's centre stays.
  const LookAlikes* look_alikes = nullptr;  ///< Needed by kLookAlike.
};

/// A place found.
struct KidnapTarget {
  Pose2 T_map_base;
  std::optional<double> unlikeness{};  ///< As in `KidnapRecord`.
  bool too_near = false;               ///< As in `KidnapRecord`.
};

/// The place; the farthest one where none is `min_distance_m` away. Nothing where there is none
/// right now, because of people or because of what is next to the robot: ask again later.
/// @throws std::runtime_error if there can be none: the given target is in an obstacle, or nothing
/// is free.
std::optional<KidnapTarget> kidnap_target(const KidnapSpec& spec, const KidnapScene& scene,
                                          Rng& rng);

}  // namespace castaway::sim
