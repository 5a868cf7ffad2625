/// Faults of sensors on a run's timeline.
#pragma once

#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// What goes wrong.
enum class FaultKind {
  kLidarDropout,      ///< No scans.
  kLidarFrozen,       ///< The last scan, over and over, with new stamps.
  kLidarBlocked,      ///< Something near covers a sector.
  kLidarMount,        ///< The lidar sits elsewhere than everybody is told.
  kLidarLate,         ///< Scans are delivered late.
  kLidarClock,        ///< Scans carry stamps of a clock that is off.
  kOdometryFrozen,    ///< Readings stand still; the way meanwhile is lost.
  kOdometryScale,     ///< Wheels count too much or too little.
  kOdometryReversed,  ///< One wheel counts backwards.
  kOdometryDropout,   ///< No readings; the way meanwhile comes with the next one.
  kOdometryReset,     ///< A power cycle: odometry starts from zero.
};

/// Their names, in order.
inline constexpr std::array<const char*, 11> kFaultNames = {
    "lidar-dropout",     "lidar-frozen",     "lidar-blocked",   "lidar-mount",
    "lidar-late",        "lidar-clock",      "odometry-frozen", "odometry-scale",
    "odometry-reversed", "odometry-dropout", "odometry-reset"};

/// "lidar-dropout" and so on.
constexpr const char* to_string(FaultKind kind) {
  return kFaultNames[static_cast<std::size_t>(kind)];
}
/// True for faults of a lidar, false for those of odometry.
constexpr bool is_lidar_fault(FaultKind kind) { return kind <= FaultKind::kLidarClock; }

/// A fault and when. Only the fields of its kind matter.
struct FaultSpec {
  FaultKind kind = FaultKind::kLidarDropout;
  double at_s = 0.0;    ///< [s] Since the start of the run.
  double for_s = 1.0;   ///< [s] How long; of no meaning for a reset.
  std::string lidar{};  ///< Name of the lidar; empty: all of them.

  double from_deg = -30.0;    ///< [deg] Blocked sector about the laser's z, from its x...
  double to_deg = 30.0;       ///< [deg] ...counter-clockwise to here.
  double distance = 0.2;      ///< [m] From the lidar to what blocks it.
  Pose2 mount_error{};        ///< What is told: this * the true mount, in base.
  double delay_s = 0.1;       ///< [s] Of late scans, beyond their last beam.
  double offset_s = 0.1;      ///< [s] Of the clock; above 0: it is fast.
  double scale = 1.1;         ///< Of the wheels' counts.
  bool reverse_right = true;  ///< Which wheel is reversed; false: the left one.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const FaultSpec& fault);

/// True while it lasts, [at, at + for); a reset never does.
bool is_active(const FaultSpec& fault, std::chrono::nanoseconds stamp);

/// A fault that begins or ends.
struct FaultRecord {
  std::chrono::nanoseconds stamp{};
  FaultKind kind = FaultKind::kLidarDropout;
  std::string lidar{};  ///< Empty: all of them, or odometry.
  bool begins = true;
  Pose2 T_map_base_true{};
};

/// Tells in order of time what begins and what ends.
class FaultTimeline {
 public:
  /// @throws as `validate`.
  explicit FaultTimeline(const std::vector<FaultSpec>& faults);

  /// Beginnings and ends up to `now`, once each, without the robot's pose.
  std::vector<FaultRecord> reached(std::chrono::nanoseconds now);

 private:
  std::vector<FaultRecord> records_;
  std::size_t next_ = 0;
};

}  // namespace castaway::sim
