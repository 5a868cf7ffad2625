/// Targets of kidnaps on several floors, in frame plane.
#pragma once

#include <optional>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/events/kidnap.hpp"
#include "sim/map/free_space.hpp"

namespace castaway::sim {

/// True if a pose is on the level and the kind of ground that a kidnap asks for. Without floors,
/// every pose is.
bool is_wanted_ground(const KidnapSpec& spec, const FreeSpace& free, const Pose2& T_plane_base);

/// True if a target is on another level than the robot, or `min_distance_m` away from it as seen
/// from above.
bool is_far_enough(const KidnapSpec& spec, const FreeSpace& free, const Pose2& T_plane_from,
                   const Pose2& T_plane_to);

/// The place of a lift on the wanted level, or on one drawn from the others: the free place of that
/// level nearest to the robot as seen from above; nothing if the level has none.
std::optional<Pose2> elevator_target(const KidnapSpec& spec, const FreeSpace& free,
                                     const Pose2& T_plane_base, Rng& rng);

/// The given target, on the wanted level or on the lowest ground at its place; nothing if there is
/// no ground. Without floors, the target itself.
std::optional<Pose2> target_on_plane(const KidnapSpec& spec, const LevelPlane* levels);

/// @throws std::runtime_error if a kidnap's level or ramp is nowhere in the free space.
void require_wanted_ground(const KidnapSpec& spec, const FreeSpace& free);

}  // namespace castaway::sim
