/// Since when the scans after a kidnap distinguish the robot's place from the one where it would be
/// without the kidnap. Before, a localizer has no evidence of the kidnap but the jump itself.
#pragma once

#include <optional>

#include "localization/geometry/rate.hpp"
#include "localization/hypotheses/scan_log.hpp"
#include "localization/input/sensor_input.hpp"
#include "localization/sensor/evidence_model.hpp"

namespace castaway::testbed {

/// Parameters of the comparison of the two places.
struct DistinguishabilityConfig {
  double enough = 15.0;  ///< [nats] Sum of evidence at which the places are distinguishable.
  /// Highest rate of the compared scans: that of the scans by which localizers correct.
  double rate_hz = localization::SensorInputConfig{}.correct_rate_hz;
  localization::ScanComparisonConfig comparison;  ///< Shares of scans that count as new.
};

/// Sums the evidence of the scans after one kidnap.
class Distinguishability {
 public:
  /// `evidence` must outlive it. The kidnap moved base from `T_map_from` to `T_map_to`.
  Distinguishability(const localization::EvidenceModel& evidence,
                     const localization::SE2& T_map_from, const localization::SE2& T_map_to,
                     const DistinguishabilityConfig& config = {});

  /// Takes the next scan after the kidnap, with the true pose at which it was taken. Adds the
  /// evidence for that pose over the pose without the kidnap, times the new share of the scan: by
  /// the true motion since the previous scan, or for the first one since the kidnap. Both poses are
  /// refined on the scan, and the one without the kidnap is tracked, as by a localizer that has not
  /// noticed it.
  void take(localization::Stamp stamp, const localization::ScanPoints& points,
            const localization::SE2& T_map_base_true);

  /// Stamp of the first scan at which the sum was enough; nothing if there was none. It stays when
  /// later scans reduce the sum.
  [[nodiscard]] const std::optional<localization::Stamp>& since() const { return since_; }
  /// [nats] Positive: the scans speak for the true pose.
  [[nodiscard]] double sum() const { return sum_; }

 private:
  [[nodiscard]] localization::SE2 refined(const localization::ScanPoints& points,
                                          const localization::SE2& T_map_base) const;

  const localization::EvidenceModel& evidence_;
  DistinguishabilityConfig config_;
  localization::SE2 T_unkidnapped_map_;    ///< From true poses to poses without the kidnap.
  localization::SE2 T_map_base_previous_;  ///< True pose at the previous scan.
  localization::Rate rate_;
  double sum_ = 0.0;
  std::optional<localization::Stamp> since_;
};

}  // namespace castaway::testbed
