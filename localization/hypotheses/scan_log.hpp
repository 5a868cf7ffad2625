/// The last scans, each compared with the one before it.
#pragma once

#include <optional>

#include "localization/hypotheses/null_hypothesis.hpp"
#include "localization/hypotheses/scan_history.hpp"
#include "localization/sensor/scan_agreement.hpp"

namespace castaway::localization {

/// Stores scans, and the evidence for kidnaps between them.
class ScanLog {
 public:
  /// Stores at most `most` scans.
  ScanLog(const PosteriorConfig& posterior, const ScanAgreementConfig& agreement, int most)
      : posterior_(posterior), agreement_(agreement), most_(static_cast<std::size_t>(most)) {}

  /// Removes all scans and the recent cue.
  void start();
  /// Removes all scans, because odometry is not continuous with them any more.
  void forget_motion() { scans_.clear(); }
  /// Adds a scan. Returns it with its independence and kidnap cue relative to the previous one.
  /// `listed` and `null` are the log-weights of all hypotheses and of the null hypothesis before
  /// the scan.
  const ScanMemory& add(const ScanPoints& points, const SE2& T_odom_base, double listed,
                        double null);

  [[nodiscard]] const ScanHistory& scans() const { return scans_; }
  /// Odometry at the newest scan, if any.
  [[nodiscard]] std::optional<SE2> T_odom_base() const;
  /// [nats] The highest recent kidnap cue; it decays by 1 per new scan.
  [[nodiscard]] double recent_cue() const { return recent_cue_; }

 private:
  PosteriorConfig posterior_;
  ScanAgreementConfig agreement_;
  std::size_t most_;
  ScanHistory scans_;
  double recent_cue_ = 0.0;
};

}  // namespace castaway::localization
