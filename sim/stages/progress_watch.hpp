/// Does the robot of a run get anywhere? A run in which it does not says nothing about localizers.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// Why a run is void.
enum class VoidReason : std::uint8_t {
  kContactFromStart,  ///< The robot touches something from its first second on.
  kNeverMoved,        ///< It was to drive and never did.
  kStuck,             ///< It was to drive and no longer did, until the end or for most of the run.
};

/// A run found void.
struct VoidRecord {
  VoidReason reason = VoidReason::kStuck;
  std::chrono::nanoseconds since{};  ///< When that began.
};

/// How much is getting on.
struct ProgressConfig {
  double first_way = 0.1;   ///< [m] Of the first move, or with a waypoint passed...
  double first_turn = 0.5;  ///< [rad] ...or turn, from the start.
  double way = 1.0;         ///< [m] Later: from where it got on last; less is rocking to and fro...
  double turn = 1e9;        ///< [rad] ...and so is less of a turn.
  double contact_s = 1.0;   ///< [s] From the start; touching for half of it is void.
  double never_s = 5.0;     ///< [s] Of wanting to drive, without ever getting on.
  double stuck_s = 20.0;    ///< [s] Of wanting to drive, since it got on last.
  double stuck_share = 0.5;  ///< Of all the time of wanting to drive, spent in being stuck.
};

/// What the robot does at a moment.
struct ProgressInput {
  std::chrono::nanoseconds now{};
  Pose2 T_map_base;       ///< True pose of base.
  bool touching = false;  ///< It is in contact with what is not the floor.
  /// It is to drive, and neither people, nor somebody's hands, nor a wrong belief keep it from it.
  bool wants = false;
  int passed = 0;  ///< Waypoints so far: passing one on the move is getting on.
};

/// Follows a run.
class ProgressWatch {
 public:
  explicit ProgressWatch(const ProgressConfig& config) : config_(config) {}

  /// Calls come in order of time.
  void update(const ProgressInput& input);
  /// The robot was put elsewhere: what it was stuck in, it has left.
  void on_teleport();
  /// The reason, were the run to end now.
  [[nodiscard]] std::optional<VoidRecord> verdict() const;

 private:
  void watch_contact(const ProgressInput& input, double dt);
  void leave();

  ProgressConfig config_;
  std::optional<std::chrono::nanoseconds> first_;
  std::chrono::nanoseconds last_{};
  double contact_s_ = 0.0;  ///< [s] Touching, in the first `contact_s`.
  bool touched_at_once_ = false;
  bool moved_ = false;
  double wanted_s_ = 0.0;    ///< [s] Of wanting to drive, in all.
  double stuck_s_ = 0.0;     ///< [s] Of that, in standstills that are over.
  double standing_s_ = 0.0;  ///< [s] Of wanting to drive, since it got on last.
  int passed_ = 0;
  std::optional<Pose2> started_;
  std::optional<Pose2> stood_;        ///< Where it got on last...
  std::chrono::nanoseconds since_{};  ///< ...and when.
  std::optional<std::chrono::nanoseconds> first_stuck_;
};

}  // namespace castaway::sim
