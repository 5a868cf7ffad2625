/// Whether the stated probability of being right can be believed: how often outputs of which it is
/// said are right.
///
/// G. W. Brier, "Verification of Forecasts Expressed in Terms of Probability", Monthly Weather
/// Review 78 (1950), for two outcomes: the mean of (stated - (right ? 1 : 0))^2; 0 is perfect, 0.25
/// is what always stating 0.5 gives.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "tools/metrics/recovery.hpp"
#include "tools/metrics/statistics/intervals.hpp"

namespace castaway::testbed {

/// Outputs whose stated probability lies in one tenth of [0, 1].
struct CalibrationBin {
  std::int64_t scans = 0;
  std::int64_t right = 0;
  double stated_sum = 0.0;  ///< Of their stated probabilities.

  /// Mean stated probability; nothing without scans.
  [[nodiscard]] std::optional<double> stated() const;
  /// Share that is right; nothing without scans.
  [[nodiscard]] std::optional<double> observed() const;
  /// Interval of that share (`wilson_interval`). Scans are not independent, so it is too narrow.
  [[nodiscard]] RateInterval interval() const;
};

/// The reliability diagram of a localizer, to be added up over runs.
struct Calibration {
  std::array<CalibrationBin, 10> bins;  ///< [0, 0.1), [0.1, 0.2) ... [0.9, 1].
  double squares = 0.0;                 ///< Sum of (stated - outcome)^2.

  /// An output stated to be right with this probability (cut to [0, 1]), and whether it is.
  void add(double probability, bool right);
  /// All that another one holds.
  void add(const Calibration& other);
  [[nodiscard]] std::int64_t scans() const;
  /// Brier score; nothing without scans.
  [[nodiscard]] std::optional<double> brier() const;
};

/// The rows with truth and estimate.
Calibration calibration_of(const std::vector<MetricRow>& rows, const RecoveryConfig& config);

}  // namespace castaway::testbed
