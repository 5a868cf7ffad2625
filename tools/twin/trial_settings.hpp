/// Settings of simulated logs, for trials of the calibration.
#pragma once

#include <cstdint>
#include <string>

#include "localization/geometry/se2.hpp"

namespace castaway::testbed {

inline constexpr double kTrialTrack = 0.4;  ///< [m] Of the robot of the trials.

/// Settings of a simulated log.
struct TrialSettings {
  std::string world;
  double radius_error_left = 0.0;
  double radius_error_right = 0.0;
  double track_error = 0.0;
  double drift_along = 0.0;
  double drift_yaw_deg = 0.0;
  double sigma_m = 0.0;
  double sigma_relative = 0.0;
  double resolution_m = 0.0;
  double dropout = 0.0;
  double dropout_far = 0.0;
  double dropout_grazing = 0.0;
  double offset_s = 0.0;
  int people = 0;
  double drift_turn_deg = 0.0;
  double stamp_sigma_s = 0.0;
  double beam_bias_sigma_m = 0.0;
  double dust_per_m = 0.0;
  localization::SE2 mount;  ///< The stated mount of the lidar is wrong by this.
};

/// Draws the settings of a trial.
TrialSettings draw_settings(std::uint64_t seed, int index);

/// The scenario of a log with these settings.
std::string trial_scenario(const TrialSettings& settings, double duration_s);

}  // namespace castaway::testbed
