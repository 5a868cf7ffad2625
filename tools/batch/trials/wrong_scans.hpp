/// Scans on which a localizer is wrong and confident.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {

/// Number of scans of a part of a trial, or of several trials, and of the wrong ones.
struct WrongScans {
  std::int64_t scans = 0;  ///< Scans whose truth is known.
  std::int64_t wrong = 0;  ///< Scans of these that are wrong without the alarm.
  double longest_s = 0.0;  ///< [s] Longest uninterrupted time of such scans (`WrongTime`).

  /// Adds those of another trial.
  void add(const WrongScans& other);
  /// In [0, 1]: share of the wrong ones; nothing if there are no scans.
  [[nodiscard]] std::optional<double> share() const;
};

/// Counts the rows with a stamp of at least `since`; the last one lasts until `end`.
WrongScans wrong_scans_since(Stamp since, const std::vector<MetricRow>& rows, Stamp end,
                             const RecoveryConfig& config);

}  // namespace castaway::testbed
