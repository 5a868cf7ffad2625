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

/// Simulates log `index` and calibrates on it. Tolerances: 10 % of systematic errors of odometry,
/// of lidar noise, losses, dust and offsets of beams; 20 % of random errors of odometry and stamps;
/// 5 ms of the clock's offset; 15 mm and 0.3 degrees of the mount; 30 % of the people.
/// Deterministic. Throws as `build_simulation`.
std::vector<FoundSetting> try_calibration(const CalibrationTrialConfig& config, int index);

}  // namespace castaway::testbed
