/// What comes in, checked before a localizer sees it: order, clocks, nonsense.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "localization/geometry/pose_statistics.hpp"
#include "localization/geometry/transform_buffer.hpp"
#include "localization/sensor/readings.hpp"

namespace castaway::localization {

/// When a clock has been set back.
struct IntakeConfig {
  TransformBufferConfig buffer;
  /// Odometry that is so much older than the newest comes from a clock set back (a log that begins
  /// again), not from a late message.
  Stamp set_back = std::chrono::seconds(2);
};

/// Throws std::invalid_argument unless pose and covariance are numbers.
void validate(const PoseWithCovariance& start);

/// What became of a reading of odometry.
enum class OdometryIntake {
  kDropped,    ///< Late, or not a number.
  kTaken,      ///< Part of the motion known.
  kRestarted,  ///< The clock was set back: this is the first of a new motion.
};

/// Keeps the motion of base and says what may be used. Gaps of odometry of any length are bridged
/// by the step across them; scans from within a gap are projected by interpolation.
class Intake {
 public:
  explicit Intake(const IntakeConfig& config) : config_(config), T_odom_base_(config.buffer) {}

  /// Takes a reading; readings out of order are dropped.
  OdometryIntake take(const Odometry& odometry);
  /// Whether a scan may be used: newer than the last one of its lidar, its angles and its mount
  /// numbers, and begun while the motion is known. Counts those that may not.
  bool accept(const LaserScan& scan);
  /// Counts a scan that turned out to be of no use.
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
