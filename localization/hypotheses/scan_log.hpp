/// The last scans, each compared with the one before it.
#pragma once

#include <optional>

#include "localization/hypotheses/scan_history.hpp"
#include "localization/hypotheses/unlisted.hpp"
#include "localization/sensor/scan_agreement.hpp"

namespace castaway::localization {

/// Keeps scans and the cue of a kidnap in them.
class ScanLog {
 public:
  /// Keeps at most `most` scans.
  ScanLog(const PosteriorConfig& posterior, const ScanAgreementConfig& agreement, int most)
      : posterior_(posterior), agreement_(agreement), most_(static_cast<std::size_t>(most)) {}

  /// Begins anew.
  void start();
  /// Forgets the scans: odometry does not lead back to them any more.
  void forget_motion() { scans_.clear(); }
  /// Adds a scan and says how much of it is new and whether it agrees with the one before.
  /// `listed` and `unlisted`: logs of the masses before it.
  const ScanMemory& add(const ScanPoints& points, const SE2& T_odom_base, double listed,
                        double unlisted);

  [[nodiscard]] const ScanHistory& scans() const { return scans_; }
  /// Odometry at the newest scan, if any.
  [[nodiscard]] std::optional<SE2> T_odom_base() const;
  /// The highest cue of a kidnap lately: it fades by a nat per new scan.
  [[nodiscard]] double recent_cue() const { return recent_cue_; }

 private:
  PosteriorConfig posterior_;
  ScanAgreementConfig agreement_;
  std::size_t most_;
  ScanHistory scans_;
  double recent_cue_ = 0.0;
};

}  // namespace castaway::localization
