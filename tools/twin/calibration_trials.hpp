/// Checks `castaway calibrate` on simulated logs whose settings are known.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// Simulated logs with random settings.
struct CalibrationTrialConfig {
  int trials = 20;
  double duration_s = 1800.0;  ///< [s] Of each log.
  std::uint64_t seed = 1;
};

/// A setting of a simulated log, and what was found.
struct FoundSetting {
  std::string name;
  double truth = 0.0;
  Figure found;
  double tolerance = 0.0;  ///< Largest error that is allowed, in the setting's unit.

  [[nodiscard]] bool is_near() const;
  /// True if the interval holds the truth.
  [[nodiscard]] bool is_held() const;
};

/// Simulates log `index` and calibrates on it: systematic errors of odometry, lidar noise at the
/// typical range and the share of lost beams within 10 %, random errors of odometry within 20 %,
/// the clock's offset within 5 ms, the number of people within 30 %. Deterministic. Throws as
/// `build_simulation`.
std::vector<FoundSetting> try_calibration(const CalibrationTrialConfig& config, int index);

}  // namespace castaway::testbed
