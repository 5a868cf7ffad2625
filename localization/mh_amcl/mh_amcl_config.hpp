/// Settings of MH-AMCL.
#pragma once

#include <optional>

#include "localization/filter/gaussian_mixture.hpp"
#include "localization/hypotheses/destroy.hpp"
#include "localization/hypotheses/lost_and_found.hpp"
#include "localization/hypotheses/merge.hpp"
#include "localization/hypotheses/posterior.hpp"
#include "localization/hypotheses/spawn.hpp"
#include "localization/input/sensor_input.hpp"
#include "localization/matching/cascade_matcher.hpp"
#include "localization/search/create.hpp"
#include "localization/search/match_schedule.hpp"
#include "localization/search/place_watch.hpp"
#include "localization/search/rescue.hpp"
#include "localization/sensor/distance_filter.hpp"
#include "localization/sensor/scan_agreement.hpp"
#include "localization/space/ndt/ndt_map.hpp"

namespace castaway::localization {

/// What a population is.
enum class BeliefKind {
  kParticles,  ///< The paper's.
  kGaussians,  ///< A mixture of normal distributions: the paper's future work.
};

/// How a pose is refined on a scan.
enum class RefineMethod {
  kClimb,             ///< By hill climbing on distances to surfaces (`refine_pose`).
  kNdtPoints,         ///< By registration with a normal distributions transform (`register_scan`).
  kNdtDistributions,  ///< The same with the scan as distributions, too.
};

/// The error of a beam by which particles are weighed.
enum class TrackingError {
  kDistance,   ///< Distance of its end point from the nearest surface (`EndpointModel`).
  kAlongBeam,  ///< The same along the beam, as in the paper; on 3-D maps (`AlongBeamModel`).
};

/// All settings of MH-AMCL.
struct MhAmclConfig {
  SensorInputConfig input;
  OdometryNoiseConfig motion;
  EndpointConfig tracking{0.08, 0.05, 30.0};  ///< Weighs particles within a population; sharp.
  EvidenceConfig evidence;                    ///< Weighs populations against each other.
  EndpointConfig refinement;  ///< Refines places from a coarse cell; wide, to reach the maximum.
  DistanceFilterConfig distance_filter;  ///< Leaves people out of the tracking.
  SpawnConfig spawn;
  ReseedConfig reseed;
  RefineConfig refine{0.04, 0.02, 3};  ///< From the best particle to the winner of a reseed.
  MatcherConfig matcher;
  MatchScheduleConfig match;
  PlaceWatchConfig watch;
  WorkBudgetConfig budget;
  RescueConfig rescue;
  CreateConfig create;
  MergeConfig merge;
  /// The stated probability is that the robot is this near to the output: the weight of all
  /// particles that are.
  MergeConfig same{0.5, 0.35};
  DestroyConfig destroy;
  ScanAgreementConfig agreement;    ///< Detects a kidnap between two scans.
  ScanContinuityConfig continuity;  ///< Detects a kidnap to a place that looks alike.
  PosteriorConfig posterior;
  LostAndFoundConfig lost_and_found;
  double blind_half_life = 0.0;  ///< [s] Of `Blindness`.
  BeliefKind belief = BeliefKind::kParticles;
  MixtureConfig mixture;
  RefineMethod refine_by = RefineMethod::kClimb;
  TrackingError track_by = TrackingError::kDistance;
  NdtConfig ndt;
  double select_margin = 2.0;  ///< [nats] The output is kept while it is less behind.
  /// Number of scans by which a new hypothesis is weighted. More than a second: a look-alike place
  /// of a kidnap is often found late.
  int history = 24;
  double max_distance = 5.0;   ///< [m] Largest value of the distance field.
  double surface_depth = 0.1;  ///< [m] No beam ends deeper inside of an obstacle (`hollow`).
};

/// Settings of MH-AMCL on a 3-D map that differ from those on planar maps: floors that look alike
/// cut the list of every search, even a longer one; distances are exact, not rounded to cells;
/// robots for rough ground slide sideways whenever they turn; scans say little about the way along
/// a ramp; and lifts are blind.
MhAmclConfig config_on_3d_maps();

/// MH-AMCL on a 3-D map.
struct MhAmcl3dConfig {
  MhAmclConfig mh_amcl = config_on_3d_maps();
  double voxel = 0.1;  ///< [m] Edge of a voxel of the map.
};

/// @throws std::invalid_argument naming a value that is out of range.
void validate(const MhAmclConfig& config);

/// Settings of mixtures; nothing if populations are particles.
std::optional<MixtureConfig> mixture_of(const MhAmclConfig& config);

}  // namespace castaway::localization
