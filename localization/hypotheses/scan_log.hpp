/// The last scans, each compared with the one before it.
#pragma once

#include <deque>
#include <limits>
#include <optional>

#include "localization/sensor/scan_agreement.hpp"
#include "localization/sensor/scan_continuity.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// A past scan, with its effect on the posterior.
struct ScanMemory {
  ScanPoints points;           ///< In base at the scan's reference time.
  SE2 T_odom_base;             ///< Odometry at that time.
  double periods = 1.0;        ///< Periods of the rate of corrections since the scan before.
  double independence = 1.0;   ///< Share of the scan that counted as new, in (0, 1].
  double listed_before = 0.0;  ///< [nats] Log-weight of all hypotheses together before the scan.
  double null_before = 0.0;    ///< [nats] Log-weight of the null hypothesis before the scan.
  double kidnap_cue = 0.0;  ///< [nats] Evidence for a kidnap just before the scan (`kidnap_cue`).
  /// [nats] The same evidence for a place where the scan fits, at least `kidnap_cue`.
  double arrival_cue = 0.0;
  /// [nats] Log-likelihood of the scan at an unlisted place (`null_log_likelihood`); a place fits
  /// if it has at least this.
  double unlisted = -std::numeric_limits<double>::infinity();
};

/// Newest last.
using ScanHistory = std::deque<ScanMemory>;

/// Parameters of the comparison of consecutive scans. Evidence is in nats.
struct ScanComparisonConfig {
  double independent_m = 1.2;        ///< [m] Motion after which a scan is independent.
  double independent_rad = 0.6;      ///< [rad] Turn after which a scan is independent.
  double least_independence = 0.15;  ///< Independent share of a scan at rest.
  /// Consecutive scans that agree better (`scan_agreement`) are evidence against a kidnap.
  double agreeing = 0.65;
  double agreeing_slope = 30.0;  ///< Strength of this evidence, per unit of agreement.
  /// Reduction of this evidence at rest, where scans of similar places agree as well.
  double agreeing_at_rest = 6.0;
  double disagreeing = 0.5;  ///< Consecutive scans that agree worse are evidence for a kidnap.
  double disagreeing_slope = 8.0;  ///< Strength of this evidence, per unit of agreement.
};

/// Share of a scan that counts as new after this motion since the previous scan.
double independence(const ScanComparisonConfig& config, double moved_m, double turned_rad);

/// Log-odds of a kidnap between two consecutive scans, given their agreement; 0 if that is unknown.
/// `new_share` is the `independence` of the later scan.
double kidnap_cue(const ScanComparisonConfig& config, const std::optional<double>& agreement,
                  double new_share);

/// How a log compares and stores scans.
struct ScanLogConfig {
  ScanComparisonConfig comparison;
  ScanAgreementConfig agreement;
  ScanContinuityConfig continuity;
  int most = 8;  ///< Number of scans stored.
};

/// Stores scans, and the evidence for kidnaps between them.
class ScanLog {
 public:
  explicit ScanLog(const ScanLogConfig& config) : config_(config), continuity_(config.continuity) {}

  /// Removes all scans and the recent cue.
  void start();
  /// Removes all scans, because odometry is not continuous with them any more.
  void forget_motion() { scans_.clear(); }
  /// Adds a scan. Returns it with its independence and cues relative to the previous one, which
  /// replace those given.
  const ScanMemory& add(ScanMemory scan);

  [[nodiscard]] const ScanHistory& scans() const { return scans_; }
  /// Odometry at the newest scan, if any.
  [[nodiscard]] std::optional<SE2> T_odom_base() const;
  /// [nats] The highest recent arrival cue; it decays by 1 per new scan.
  [[nodiscard]] double recent_cue() const { return recent_cue_; }

 private:
  void compare(const ScanMemory& before, ScanMemory& scan);

  ScanLogConfig config_;
  ScanContinuity continuity_;
  ScanHistory scans_;
  double recent_cue_ = 0.0;
};

}  // namespace castaway::localization
