/// Checks readings before a localizer uses them: order, clocks, invalid values.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "castaway/readings.hpp"
#include "localization/geometry/pose_statistics.hpp"
#include "localization/geometry/transform_buffer.hpp"

namespace castaway::localization {

/// Detection of a clock that was set back.
struct IntakeConfig {
  TransformBufferConfig buffer;
  /// Odometry that is older than the newest by this much comes from a clock that was set back (a
  /// restarted log), not from a late message.
  Stamp set_back = std::chrono::seconds(2);
};

/// @throws std::invalid_argument unless pose and covariance are finite.
void validate(const PoseWithCovariance& start);

/// What was done with an odometry reading.
enum class OdometryIntake {
  kDropped,    ///< Late, or not finite.
  kTaken,      ///< Added to the known motion.
  kRestarted,  ///< The clock was set back: this is the first reading of a new motion.
};

/// Stores the motion of base and decides which readings can be used. Gaps of odometry of any length
/// are bridged by the step across them; scans within a gap are projected by interpolation.
class Intake {
 public:
  explicit Intake(const IntakeConfig& config) : config_(config), T_odom_base_(config.buffer) {}

  /// Takes a reading; readings out of order are dropped.
  OdometryIntake take(const Odometry& odometry);
  /// True if a scan can be used: it is newer than the last one of its lidar, its angles and mount
  /// are valid, and it began while the motion is known. Counts the scans that cannot.
  bool accept(const LaserScan& scan);
  /// Counts a scan that turned out to be unusable.
  void drop_scan() { ++dropped_scans_; }

  [[nodiscard]] const TransformBuffer& T_odom_base() const { return T_odom_base_; }
  [[nodiscard]] std::int64_t dropped_scans() const { return dropped_scans_; }
  [[nodiscard]] std::int64_t dropped_odometry() const { return dropped_odometry_; }

 private:
  IntakeConfig config_;
  TransformBuffer T_odom_base_;
  std::map<std::string, Stamp> last_scan_;  ///< By lidar.
  std::int64_t dropped_scans_ = 0;
  std::int64_t dropped_odometry_ = 0;
};

}  // namespace castaway::localization
