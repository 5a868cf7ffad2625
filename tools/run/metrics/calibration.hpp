/// Calibration of the stated probability of being right: how often outputs with a given stated
/// probability are right.
///
/// G. W. Brier, "Verification of Forecasts Expressed in Terms of Probability", Monthly Weather
/// Review 78 (1950), for two outcomes: the mean of (stated - (right ? 1 : 0))^2. 0 is perfect;
/// always stating 0.5 gives 0.25.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "tools/run/metrics/recovery.hpp"
#include "tools/run/metrics/statistics/intervals.hpp"

namespace castaway::testbed {

/// Outputs at least as probable as this are sure. Planners act on such outputs, and the highest
/// tenth of [0, 1] says little about them.
inline constexpr double kSure = 0.99;

/// Outputs whose stated probability lies in one interval.
struct CalibrationBin {
  std::int64_t scans = 0;
  std::int64_t right = 0;
  double stated_sum = 0.0;  ///< Sum of the stated probabilities.

  /// Adds an output: its stated probability, and whether it is right.
  void add(double probability, bool is_right);
  /// Adds all outputs of another bin.
  void add(const CalibrationBin& other);
  /// Mean stated probability; nothing if there are no scans.
  [[nodiscard]] std::optional<double> stated() const;
  /// Share of right outputs; nothing if there are no scans.
  [[nodiscard]] std::optional<double> observed() const;
  /// Wilson interval of that share. It is too narrow, since scans are not independent.
  [[nodiscard]] RateInterval interval() const;
};

/// The reliability diagram of a localizer; diagrams of several runs can be added.
struct Calibration {
  std::array<CalibrationBin, 10> bins;  ///< [0, 0.1), [0.1, 0.2) ... [0.9, 1].
  CalibrationBin sure;                  ///< [0.99, 1]; these outputs are in the last bin, too.
  double squares = 0.0;                 ///< Sum of (stated - outcome)^2.

  /// Adds an output: the stated probability of being right (clamped to [0, 1]), and whether it is.
  void add(double probability, bool right);
  /// Adds all outputs of another diagram.
  void add(const Calibration& other);
  [[nodiscard]] std::int64_t scans() const;
  /// Brier score; nothing if there are no scans.
  [[nodiscard]] std::optional<double> brier() const;
};

/// Calibration over the rows that have truth, an estimate and a stated probability.
Calibration calibration_of(const std::vector<MetricRow>& rows, const RecoveryConfig& config);

}  // namespace castaway::testbed
