/// Settings of MH-AMCL.
#pragma once

#include "localization/filter/reseed.hpp"
#include "localization/filter/reseed_losers.hpp"
#include "localization/hypotheses/create.hpp"
#include "localization/hypotheses/destroy.hpp"
#include "localization/hypotheses/quality_rules.hpp"
#include "localization/matching/paper_cascade.hpp"
#include "localization/motion/step_noise.hpp"
#include "localization/published_defects.hpp"
#include "localization/sensor/intake.hpp"
#include "localization/sensor/scan_agreement.hpp"

namespace castaway::localization {

/// When the matcher is asked.
struct MatchScheduleConfig {
  double confident = 0.9;       ///< Not while the output is at least so probable.
  std::int64_t slice = 300000;  ///< Tiles searched with one scan; about 20 ms.
  int at_once = 2;  ///< Searches in a row after an alarm, scan by scan: the first scan may be torn.
  double moved_m = 0.1;     ///< [m] Then not before the robot moved so far since the last match...
  double turned_rad = 0.1;  ///< [rad] ...or turned so far...
  double patience_s = 4.0;  ///< [s] ...or so much time passed.
  double first_pause_s = 0.5;    ///< [s] Pause after a match that found nothing new; doubles...
  double longest_pause_s = 8.0;  ///< [s] ...up to this, and starts anew when something changes.
};

/// The wide search around a pose that suddenly fits badly (wheel slip, a scan much later).
struct RescueConfig {
  double drop = 6.0;        ///< [nats] When the output's scan is so much less likely than usual.
  double radius = 1.1;      ///< [m]
  double yaw_radius = 0.6;  ///< [rad]
  int candidates = 10;      ///< Refined at most.
  double gain = 3.0;        ///< [nats] A place found must be so much better.
  double cost = 14.0;       ///< [nats] A place found begins with the output's weight less this.
};

/// Which parts the pipeline is made of.
enum class MhAmclMode {
  kPaper,     ///< The paper to the letter; `PaperConfig` says what was chosen where it is silent.
  kImproved,  ///< The same structure with better parts.
};

/// The parts of mode `paper`.
struct PaperConfig {
  RayLocalConfig sensor;
  LoserReseedConfig reseed;
  PaperCascadeConfig cascade;
  QualityRules rules;
  double match_period_s = 3.0;   ///< [s] "Every few seconds".
  double spawn_sigma = 0.1;      ///< [m] Spread of a new population...
  double spawn_sigma_yaw = 0.1;  ///< [rad] ...half the step of the cascade's orientations.
  PublishedDefects published;    ///< What the published code does otherwise.
  StepNoiseConfig step_noise;    ///< Used with `noise_per_step`.
};

/// Everything that MH-AMCL can be told. Defaults are mode `improved`.
struct MhAmclConfig {
  MhAmclMode mode = MhAmclMode::kImproved;
  PaperConfig paper;  ///< Used in mode `paper` only, with the rates, beams and motion below.
  double predict_rate_hz = 100.0;
  double correct_rate_hz = 10.0;
  double reseed_rate_hz = 0.3;
  BeamSelection beams;
  OdometryNoiseConfig motion;
  EndpointConfig tracking{0.08, 0.05, 30.0};  ///< Weighs particles within a population: sharp.
  EvidenceConfig evidence;                    ///< Weighs populations against each other: wide.
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
  double found = 0.998;  ///< An output that was lost is found from so probable on, and lost
                         ///< again below `match.confident`.
  double unexplained_cue = -5.0;  ///< Where no kidnap cue has been above this lately (it fades by a
                                  ///< nat per new scan), an output that jumps...
  double proving_m = 5.0;         ///< [m] ...is not found before the robot went so far.
  double select_margin = 2.0;     ///< [nats] The output stays while less behind than this.
  double spawn_sigma = 0.05;      ///< [m] Least spread of a new population...
  double spawn_sigma_yaw = 0.02;  ///< [rad] ...and of its yaw.
  int history = 8;                ///< Scans that a new hypothesis is weighed on.
  double max_distance = 5.0;      ///< [m] Cap of the distance field.
  IntakeConfig intake;
  Stamp lidar_memory =
      std::chrono::milliseconds(250);  ///< So long scans of other lidars are joined to a new one.
};

/// Mode `paper` with all defects of the published code and its figures: new populations spread by
/// 0.1 m and 0.05 rad, 3 % winners, copies spread as new populations.
MhAmclConfig published_config();

/// Throws std::invalid_argument naming the figure that is out of its range.
void validate(const MhAmclConfig& config);

}  // namespace castaway::localization
