/// Continuity of successive scans: whether the robot moved on as odometry says, judged without the
/// map and much more strictly than by `scan_agreement` alone.
///
/// A kidnap to a place that looks alike leaves most end points on something that the scan before
/// saw. What then changes is how exactly they agree. How exactly the scans of one place agree
/// depends on lidar, odometry and crowd, so the usual agreement and its spread are learned in the
/// run.
#pragma once

#include "localization/sensor/scan_agreement.hpp"

namespace castaway::localization {

/// Parameters of the continuity.
struct ScanContinuityConfig {
  /// Strict comparison of two scans of a robot at rest.
  ScanAgreementConfig agreement{0.04, 0.015, 0.2, 15};
  double tolerance_per_m = 0.1;    ///< [m] Growth of the tolerance per metre moved.
  double tolerance_per_rad = 0.1;  ///< Growth of the tolerance's share of the range per radian.
  double most_moved = 2.5;         ///< [m] Scans that are farther apart are not compared.
  double most_turned = 1.2;        ///< [rad] Scans that are turned by more are not compared.
  double spread_start = 0.05;      ///< Initial value of the spread.
  double least_spread = 0.01;      ///< Lower limit of the spread.
  double rate = 0.05;              ///< Least weight of a scan in both running averages.
  double limit = 2.5;              ///< Largest deviation learned, as a multiple of the spread.
  double free = 3.0;               ///< Deviation without an effect, as a multiple of the spread.
  double most = 15.0;              ///< [nats] Upper limit of the cue.
};

/// Compares each scan with the one before.
class ScanContinuity {
 public:
  explicit ScanContinuity(const ScanContinuityConfig& config) : config_(config) { start(); }

  /// Forgets what is usual.
  void start();
  /// Returns the evidence that the robot did not move on from one scan to the next by
  /// `T_before_now` (odometry's step of base): one nat for each spread by which the scans agree
  /// less than usual, beyond `free`; 0 to `most` [nats]. 0 if the scans cannot be compared. Learns
  /// from the result.
  double take(const ScanPoints& before, const ScanPoints& now, const SE2& T_before_now);

  [[nodiscard]] double usual() const { return usual_; }
  [[nodiscard]] double spread() const { return spread_; }

 private:
  void learn(double deviation);

  ScanContinuityConfig config_;
  double usual_ = 0.0;   ///< Running average of the agreement.
  double spread_ = 0.0;  ///< Running average of its absolute deviation.
  int learned_ = 0;      ///< Number of scans learned.
};

}  // namespace castaway::localization
