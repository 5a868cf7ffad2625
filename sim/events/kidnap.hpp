/// Kidnaps: the robot is moved without its knowledge.
#pragma once

#include <chrono>
#include <optional>

#include "sim/common/geometry.hpp"
#include "sim/events/kidnap_trigger.hpp"
#include "sim/events/lift.hpp"
#include "sim/record/happening.hpp"

namespace castaway::sim {

/// A closed interval.
struct Bounds {
  double min = 0.0;
  double max = 0.0;
};

/// A scheduled kidnap. It changes the true pose only: odometry continues from where it was.
struct KidnapSpec {
  KidnapKind kind = KidnapKind::kTeleportRandom;
  KidnapTrigger when{};
  /// [m] Least distance between old and new place (random, look-alike).
  double min_distance_m = 3.0;
  double margin_m = 0.05;         ///< [m] Room around the robot's footprint.
  std::optional<Pose2> target{};  ///< Required by kTeleportTo; destination of kCarry.
  std::optional<int> level{};     ///< On which a target is; empty: on any (given: the lowest).
  bool ramp = false;              ///< A drawn target is on a ramp.
  Bounds nudge{0.3, 1.0};         ///< [m] Range of the distance.
  Bounds turn{0.785, 3.1416};     ///< [rad] Range of the angle, in (0, pi].
  LiftConfig lift{};              ///< Used by kCarry and kSpin.
  /// Sensors are off from pick-up to put-down; odometry starts from zero afterwards.
  bool power_cycle = false;
};

/// A kidnap that has happened.
struct KidnapRecord {
  std::chrono::nanoseconds stamp{};  ///< Time at which the robot stands at its new place.
  KidnapKind kind = KidnapKind::kTeleportRandom;
  Pose2 T_map_from;  ///< True pose of base before.
  Pose2 T_map_to;    ///< True pose of base after.
  /// Time at which it was taken; equals `stamp` if the kidnap takes no time.
  std::chrono::nanoseconds since{};
  /// [m] Of kLookAlike: mean difference between the ranges of the two scans, each capped at 1 m.
  std::optional<double> unlikeness{};
  bool too_near = false;  ///< No place was `min_distance_m` away: the farthest one was taken.
  double z_from = 0.0;    ///< [m] Height of the ground before.
  double z_to = 0.0;      ///< [m] Height of the ground after.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const KidnapSpec& spec);

}  // namespace castaway::sim
