/// Checks whether the robot makes progress: a run without progress says nothing about localizers.
#pragma once

#include <chrono>
#include <optional>

#include "sim/common/geometry.hpp"
#include "sim/record/happening.hpp"

namespace castaway::sim {

/// The reason why a run is void.
struct VoidRecord {
  VoidReason reason = VoidReason::kStuck;
  std::chrono::nanoseconds since{};  ///< Beginning of the problem.
};

/// Thresholds of progress.
struct ProgressConfig {
  /// [m] Displacement from the start that counts as the first move; also progress with a waypoint.
  double first_way = 0.1;
  double first_turn = 0.5;  ///< [rad] Turn from the start that counts as the first move.
  /// [m] Displacement since the last progress that counts as progress; less may be rocking.
  double way = 1.0;
  double turn = 1e9;       ///< [rad] Turn since the last progress that counts as progress.
  double contact_s = 1.0;  ///< [s] From the start; a contact for half of it makes the run void.
  /// [s] Time of wanting to drive without a first move that makes the run void.
  double never_s = 5.0;
  /// [s] Time of wanting to drive without progress after which the robot is stuck.
  double stuck_s = 20.0;
  /// A run is void if the robot was stuck for this share of the time of wanting to drive.
  double stuck_share = 0.5;
};

/// State of the robot at a time.
struct ProgressInput {
  std::chrono::nanoseconds now{};
  Pose2 T_map_base;       ///< True pose of base.
  bool touching = false;  ///< In contact with something other than the floor.
  /// It is meant to drive, and no person, hand or wrong estimate keeps it from driving.
  bool wants = false;
  int passed = 0;  ///< Waypoints reached so far: reaching one while moving is progress.
};

/// Watches the progress of a run.
class ProgressWatch {
 public:
  explicit ProgressWatch(const ProgressConfig& config) : config_(config) {}

  /// Takes the state at a time; calls come in order of time.
  void update(const ProgressInput& input);
  /// Ends a standstill, since the robot was put elsewhere.
  void on_teleport();
  /// Returns why the run is void if it ends now; nothing if it is not.
  [[nodiscard]] std::optional<VoidRecord> verdict() const;

 private:
  void watch_contact(const ProgressInput& input, double dt);
  void leave();

  ProgressConfig config_;
  std::optional<std::chrono::nanoseconds> first_;
  std::chrono::nanoseconds last_{};
  double contact_s_ = 0.0;  ///< [s] Of contact, in the first `contact_s`.
  bool touched_at_once_ = false;
  bool moved_ = false;
  double wanted_s_ = 0.0;    ///< [s] Of wanting to drive, in total.
  double stuck_s_ = 0.0;     ///< [s] Part of that spent in finished standstills.
  double standing_s_ = 0.0;  ///< [s] Of wanting to drive, since the last progress.
  int passed_ = 0;
  std::optional<Pose2> started_;
  std::optional<Pose2> stood_;        ///< Pose at the last progress.
  std::chrono::nanoseconds since_{};  ///< Time of the last progress.
  std::optional<std::chrono::nanoseconds> first_stuck_;
};

}  // namespace castaway::sim
