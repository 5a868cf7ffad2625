/// Create: places where the newest scan fits become hypotheses (paper, section IV), weighted as if
/// they had existed before.
///
/// A new place is tracked backwards over the last scans by odometry and refinement. The robot may
/// have arrived there (by a kidnap, or while the place was covered by the null hypothesis) before
/// any of these scans: the arrival that explains the scans best determines the weight.
#pragma once

#include <limits>
#include <vector>

#include "localization/hypotheses/merge.hpp"
#include "localization/hypotheses/posterior.hpp"
#include "localization/hypotheses/scan_log.hpp"
#include "localization/matching/place_matcher.hpp"
#include "localization/matching/pose_climber.hpp"
#include "localization/motion/odometry_noise.hpp"
#include "localization/sensor/evidence_model.hpp"

namespace castaway::localization {

/// Parameters of creation.
struct CreateConfig {
  /// A deep search uses this share of the end points, the farthest ones, because people only
  /// shorten beams. 0: all points.
  double far_share = 0.5;
  /// Number of places of the first search, which is quick and uses all end points.
  int quick_candidates = 20;
  double deep_below = -3.0;  ///< [nats] A deep search follows if the best place scores less.
  /// Number of places of a deep search, which uses the far end points: in a crowd the right place
  /// is far down the list, and rays find it there.
  int deep_candidates = 2000;
  int first_deep = 100;      ///< Number of a deep search where the best place nearly fits.
  double deep_growth = 0.7;  ///< [1/nat] Growth of its logarithm as the best place fits worse.
  /// Number of beams on which candidates climb before their evidence is computed; 0: they do not.
  /// At the centre of a coarse cell of a 3-D map, beams of the right place may end beyond a wall.
  int settled_beams = 0;
  RefineConfig settle{0.08, 0.03, 1};
  /// Number of candidates whose evidence is computed with all beams; the best by the evidence of a
  /// few beams.
  int looked_at = 60;
  int refined = 40;  ///< Number of candidates refined; the best by evidence before refinement.
  /// [nats] Candidates further behind the best one before refinement are not refined.
  double refined_behind = 8.0;
  int keep = 20;        ///< Number of places weighted by older scans; the best by the newest one.
  RefineConfig refine;  ///< From the pose of a coarse cell.
  RefineConfig refine_last{0.02, 0.01, 2};   ///< From there, by the sharper model of the evidence.
  RefineConfig refine_back{0.04, 0.015, 2};  ///< From odometry's prediction, in older scans.
};

/// Registration in two steps: from the pose of a coarse cell, and from there.
struct NdtRefinement {
  NdtRegistration wide;   ///< As wide as `CreateContext::model`.
  NdtRegistration sharp;  ///< As the evidence.
};

/// Settings and models used by creation; all must outlive it.
struct CreateContext {
  const CreateConfig& config;
  const MergeConfig& merge;
  const PosteriorConfig& posterior;
  const OdometryNoiseConfig& noise;
  const EndpointModel& model;  ///< For refinement.
  const EvidenceModel& evidence;
  const Volume* volume = nullptr;      ///< A 3-D map; none: a planar one.
  const NdtRefinement* ndt = nullptr;  ///< None: poses are refined by hill climbing.
};

/// A place with its weight on the scale of the hypotheses.
struct WeighedPlace {
  SE2 T_map_base;
  Evidence newest;  ///< Evidence of the newest scan.
  double log_weight = 0.0;
};

/// Result of a search of the whole map.
struct FoundPlaces {
  std::vector<WeighedPlace> places;  ///< Best first by evidence.
  bool more = false;  ///< The list was too short for all that score about as well as the best.
};

/// Returns the best candidates by the evidence of end points and rays, at most `most`. They have
/// climbed on a few beams before (`settled_beams`). Long lists are first reduced by a few beams.
std::vector<Candidate> screen_candidates(const CreateContext& context,
                                         std::vector<Candidate> candidates,
                                         const ScanPoints& points, int most);

/// Refines candidates on a scan and joins those that converge to the same place. Returns at most
/// `keep` places, best first; their weights are not set.
std::vector<WeighedPlace> refine_candidates(const CreateContext& context,
                                            const std::vector<Candidate>& candidates,
                                            const ScanPoints& points);

/// Returns the places that become hypotheses, with their weights. Left out are places where a
/// hypothesis exists at which the scan fits about as well, and places that are more than `behind`
/// [nats] behind the best one. Requires a history that is not empty.
std::vector<WeighedPlace> new_places(const CreateContext& context, const ScanHistory& history,
                                     const std::vector<Hypothesis>& hypotheses, double behind,
                                     const std::vector<WeighedPlace>& places);

/// True if there is no place, or the best one (the first) does not fit well, so that a deep search
/// is due. Its lead does not count: in a crowd, chance puts a wrong place ahead.
bool is_unclear(const CreateConfig& config, const std::vector<WeighedPlace>& places);

/// Number of places of the deep search that is due after a search has found these places; `before`:
/// that of the last one, 0 if it was quick. The first one has at most six times `first_deep`.
int deep_candidates(const CreateConfig& config, const std::vector<WeighedPlace>& places,
                    int before);

/// The first of the places, with its lead over the second. Requires a place.
BestFound best_of(const std::vector<WeighedPlace>& places);

/// Log-weight of a place where the newest scan of the history (not empty) fits, if it is above
/// `least`; otherwise some value that is not above it, found with as few scans as possible.
double weigh_backwards(const CreateContext& context, const ScanHistory& history,
                       const WeighedPlace& place,
                       double least = -std::numeric_limits<double>::infinity());

}  // namespace castaway::localization
