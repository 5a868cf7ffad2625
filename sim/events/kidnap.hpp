/// Kidnaps as typed, scheduled objects.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "sim/common/geometry.hpp"
#include "sim/events/kidnap_trigger.hpp"
#include "sim/events/lift.hpp"

namespace castaway::sim {

/// What happens to the robot.
enum class KidnapKind : std::uint8_t {
  kTeleportRandom,  ///< To a random pose in reachable free space, far enough away.
  kTeleportTo,      ///< To `target`.
  kLookAlike,       ///< To the pose, far enough away, whose scan is most like the present one.
  kNudge,           ///< Pushed aside: `nudge` far, through free space, heading kept to 0.3 rad.
  kTurn,            ///< Turned in place by `turn`, to either side.
  kCarry,           ///< Lifted, carried through free space to `target` or a random pose, put down.
  kSpin,            ///< Lifted while its wheels go on, and put down where it was.
};

/// From and to.
struct Bounds {
  double min = 0.0;
  double max = 0.0;
};

/// A scheduled kidnap. It moves the truth only: odometry goes on from where it was.
struct KidnapSpec {
  KidnapKind kind = KidnapKind::kTeleportRandom;
  KidnapTrigger when{};
  double min_distance_m = 3.0;    ///< [m] Of the new place from the old one (random, look-alike).
  double margin_m = 0.05;         ///< [m] Room around the robot's footprint.
  std::optional<Pose2> target{};  ///< Needed by kTeleportTo; where kCarry goes.
  Bounds nudge{0.3, 1.0};         ///< [m]
  Bounds turn{0.785, 3.1416};     ///< [rad] In (0, pi].
  LiftConfig lift{};              ///< Of kCarry and kSpin.
  /// Sensors off from pick-up to put-down, odometry from zero afterwards.
  bool power_cycle = false;
};

/// A kidnap that happened.
struct KidnapRecord {
  std::chrono::nanoseconds stamp{};  ///< The robot stands there.
  KidnapKind kind = KidnapKind::kTeleportRandom;
  Pose2 T_map_from;                  ///< True pose of base before.
  Pose2 T_map_to;                    ///< True pose of base after.
  std::chrono::nanoseconds since{};  ///< It was taken; equals `stamp` where that takes no time.
  /// [m] Of kLookAlike: mean difference of the two scans' ranges, each at most 1 m.
  std::optional<double> unlikeness{};
  bool too_near = false;  ///< No place was `min_distance_m` away: it is the farthest one.
};

/// "teleport", "teleport_to", "look_alike", "nudge", "turn", "carry", "spin": as logs and scenarios
/// name it.
std::string to_string(KidnapKind kind);

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const KidnapSpec& spec);

}  // namespace castaway::sim
