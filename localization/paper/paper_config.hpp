/// Settings of the paper's MH-AMCL.
#pragma once

#include "localization/filter/reseed.hpp"
#include "localization/hypotheses/spawn.hpp"
#include "localization/input/sensor_input.hpp"
#include "localization/motion/odometry_noise.hpp"
#include "localization/paper/paper_cascade.hpp"
#include "localization/paper/quality_rules.hpp"
#include "localization/paper/reseed_losers.hpp"

namespace castaway::localization {

/// All settings of the paper's MH-AMCL: the paper's values, and our choices where it is silent.
struct PaperMhAmclConfig {
  SensorInputConfig input;
  OdometryNoiseConfig motion;
  RayLocalConfig sensor;
  LoserReseedConfig reseed;
  PaperCascadeConfig cascade;
  QualityRules rules;
  double match_period_s = 3.0;   ///< [s] "Every few seconds" in the paper.
  double candidate_sigma = 0.1;  ///< [m] Position spread of a candidate of the cascade.
  /// [rad] Yaw spread of such a candidate: half the step of the orientations.
  double candidate_sigma_yaw = 0.1;
  SpawnConfig spawn;  ///< Added to the spread of a candidate or of a start.
  ReseedConfig size;  ///< Number of particles of a new population.
};

/// @throws std::invalid_argument naming a value that is out of range.
void validate(const PaperMhAmclConfig& config);

}  // namespace castaway::localization
