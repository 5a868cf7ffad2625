/// Kidnaps as typed, scheduled objects.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "sim/geometry.hpp"
#include "sim/random.hpp"

namespace castaway::sim {

class FreeSpace;

/// What happens to the robot.
enum class KidnapKind {
  kTeleportRandom,  ///< To a random pose in reachable free space, far enough away.
  kTeleportTo,      ///< To `target`.
};

/// A scheduled kidnap. It moves the truth only: odometry and wheels notice nothing.
struct KidnapSpec {
  KidnapKind kind = KidnapKind::kTeleportRandom;
  double at_s = 30.0;           ///< [s] Since the start of the run.
  double min_distance_m = 3.0;  ///< [m] Of the new place from the old one (random only).
  double margin_m = 0.05;       ///< [m] Room around the robot's footprint.
  std::optional<Pose2> target;  ///< Needed by kTeleportTo.
};

/// A kidnap that happened.
struct KidnapRecord {
  std::chrono::nanoseconds stamp{};
  KidnapKind kind = KidnapKind::kTeleportRandom;
  Pose2 T_map_from;  ///< True pose of base before.
  Pose2 T_map_to;    ///< True pose of base after.
};

/// "teleport" or "teleport_to": as logs and scenarios name it.
std::string to_string(KidnapKind kind);

/// Where the robot goes. `free` is the free space of the robot's footprint plus the margin.
/// @throws std::runtime_error if there is no such place or the target is in collision.
Pose2 kidnap_target(const KidnapSpec& spec, const Pose2& T_map_from, const FreeSpace& free,
                    Rng& rng);

}  // namespace castaway::sim
