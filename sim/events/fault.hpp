/// Faults of sensors at given times of a run.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/record/happening.hpp"

namespace castaway::sim {

/// True for faults of a lidar, false for those of odometry.
constexpr bool is_lidar_fault(FaultKind kind) { return kind <= FaultKind::kLidarClock; }

/// A fault and its time. Fields that its kind does not use are ignored.
struct FaultSpec {
  FaultKind kind = FaultKind::kLidarDropout;
  double at_s = 0.0;    ///< [s] Since the start of the run.
  double for_s = 1.0;   ///< [s] Duration; ignored for a reset.
  std::string lidar{};  ///< Name of the lidar; empty: all lidars.

  double from_deg = -30.0;  ///< [deg] Start of the blocked sector, about the laser's z from its x.
  double to_deg = 30.0;   ///< [deg] End of the sector, counter-clockwise from its start; ends that
                          ///< are a turn apart (-180, 180) cover all directions.
  double distance = 0.2;  ///< [m] From the lidar to the cover.
  Pose2 mount_error{};    ///< Reported mount = this * the true mount, in base.
  double delay_s = 0.1;   ///< [s] From the last beam of a scan to its delivery.
  double offset_s = 0.1;  ///< [s] Of the lidar's clock; positive: it is fast.
  double scale = 1.1;     ///< Factor of the encoders' counts.
  bool reverse_right = true;  ///< Reverses the right wheel; false: the left one.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const FaultSpec& fault);

/// True while a fault lasts, in [at, at + for); never for a reset.
bool is_active(const FaultSpec& fault, std::chrono::nanoseconds stamp);

/// The beginning or the end of a fault.
struct FaultRecord {
  std::chrono::nanoseconds stamp{};
  FaultKind kind = FaultKind::kLidarDropout;
  std::string lidar{};  ///< Empty: all lidars, or odometry.
  bool begins = true;
  Pose2 T_map_base_true{};
};

/// Reports the beginnings and ends of faults in order of time.
class FaultTimeline {
 public:
  /// @throws as `validate`.
  explicit FaultTimeline(const std::vector<FaultSpec>& faults);

  /// Adds a fault. @throws as `validate`.
  void add(const FaultSpec& fault);

  /// Returns the beginnings and ends up to `now`, each once, with an empty robot pose.
  std::vector<FaultRecord> take_due(std::chrono::nanoseconds now);

 private:
  /// Behind those of the same time.
  void add(const FaultRecord& record);

  std::vector<FaultRecord> records_;
  std::size_t next_ = 0;
};

}  // namespace castaway::sim
