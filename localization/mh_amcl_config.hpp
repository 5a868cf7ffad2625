/// Settings of MH-AMCL.
#pragma once

#include "localization/hypotheses/create.hpp"
#include "localization/hypotheses/destroy.hpp"
#include "localization/hypotheses/lost_and_found.hpp"
#include "localization/hypotheses/match_schedule.hpp"
#include "localization/hypotheses/rescue.hpp"
#include "localization/hypotheses/spawn.hpp"
#include "localization/sensor/intake.hpp"
#include "localization/sensor/scan_agreement.hpp"

namespace castaway::localization {

/// Everything that MH-AMCL can be told.
struct MhAmclConfig {
  double predict_rate_hz = 100.0;
  double correct_rate_hz = 10.0;
  double reseed_rate_hz = 0.3;
  BeamSelection beams;
  OdometryNoiseConfig motion;
  EndpointConfig tracking{0.08, 0.05, 30.0};  ///< Weighs particles within a population: sharp.
  EvidenceConfig evidence;                    ///< Weighs populations against each other: wide.
  SpawnConfig spawn;
  ReseedConfig reseed;
  RefineConfig refine{0.04, 0.02, 3};  ///< Climb from the best particle to the winner of a reseed.
  MatcherConfig matcher;
  MatchScheduleConfig match;
  RescueConfig rescue;
  CreateConfig create;
  MergeConfig merge;
  DestroyConfig destroy;
  ScanAgreementConfig agreement;  ///< The cue of a kidnap in one frame.
  PosteriorConfig posterior;
  LostAndFoundConfig lost_and_found;
  double select_margin = 2.0;  ///< [nats] The output stays while less behind than this.
  int history = 8;             ///< Scans that a new hypothesis is weighed on.
  double max_distance = 5.0;   ///< [m] Cap of the distance field.
  IntakeConfig intake;
  Stamp lidar_memory =
      std::chrono::milliseconds(250);  ///< So long scans of other lidars are joined to a new one.
};

/// Throws std::invalid_argument naming the figure that is out of its range.
void validate(const MhAmclConfig& config);

}  // namespace castaway::localization
