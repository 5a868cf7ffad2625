/// Settings of the paper's MH-AMCL.
#pragma once

#include "localization/filter/reseed.hpp"
#include "localization/hypotheses/spawn.hpp"
#include "localization/motion/odometry_noise.hpp"
#include "localization/paper/paper_cascade.hpp"
#include "localization/paper/quality_rules.hpp"
#include "localization/paper/reseed_losers.hpp"
#include "localization/sensor/intake.hpp"

namespace castaway::localization {

/// Everything that the paper's MH-AMCL can be told: the paper's figures, and what was chosen where
/// it is silent.
struct PaperMhAmclConfig {
  double predict_rate_hz = 100.0;
  double correct_rate_hz = 10.0;
  double reseed_rate_hz = 0.3;
  BeamSelection beams;
  OdometryNoiseConfig motion;
  RayLocalConfig sensor;
  LoserReseedConfig reseed;
  PaperCascadeConfig cascade;
  QualityRules rules;
  double match_period_s = 3.0;       ///< [s] "Every few seconds".
  double candidate_sigma = 0.1;      ///< [m] Spread of a candidate of the cascade...
  double candidate_sigma_yaw = 0.1;  ///< [rad] ...half the step of its orientations.
  SpawnConfig spawn;                 ///< Added to the spread of a candidate or of a start.
  ReseedConfig size;                 ///< How many particles a new population has.
  IntakeConfig intake;
  Stamp lidar_memory =
      std::chrono::milliseconds(250);  ///< So long scans of other lidars are joined to a new one.
};

/// Throws std::invalid_argument naming the figure that is out of its range.
void validate(const PaperMhAmclConfig& config);

}  // namespace castaway::localization
