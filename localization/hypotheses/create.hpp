/// Create: places where the newest scan fits become hypotheses (paper, section IV), weighed as if
/// they had been listed.
///
/// A new place is followed backwards over the last scans by odometry and refinement. The robot may
/// have been moved there (or have been there unlisted) before any of them: of all those times the
/// one that explains the scans best counts.
#pragma once

#include <vector>

#include "localization/hypotheses/merge.hpp"
#include "localization/hypotheses/scan_history.hpp"
#include "localization/hypotheses/unlisted.hpp"
#include "localization/matching/cascade_matcher.hpp"
#include "localization/matching/refine.hpp"
#include "localization/motion/odometry_noise.hpp"
#include "localization/sensor/evidence_model.hpp"

namespace castaway::localization {

/// Parameters of creation.
struct CreateConfig {
  double far_share = 0.5;  ///< The map is searched again by this share of the end points, the
                           ///< farthest: people only shorten beams. 0: not again.
  double deep_below =
      -3.0;  ///< Where the best place found scores less, the map is searched again...
  int deep_candidates = 3000;  ///< ...for so many places, by the far end points, and rays sort
                               ///< them out: in a crowd the right one is far down the list.
  int looked_at = 150;  ///< Candidates whose evidence is taken; the best by a share of the beams.
  int refined = 40;     ///< Candidates refined; the best by the evidence of their coarse pose.
  int keep = 30;        ///< Candidates weighed on older scans; the best by the newest one.
  RefineConfig refine;  ///< From the coarse cell.
  RefineConfig refine_back{0.04, 0.015, 2};  ///< From odometry's prediction in older scans.
};

/// What creation works with; all outlive it.
struct CreateContext {
  const CreateConfig& config;
  const MergeConfig& merge;
  const PosteriorConfig& posterior;
  const OdometryNoiseConfig& noise;
  const EndpointModel& model;
  const EvidenceModel& evidence;
};

/// A place found, weighed on the scale of the hypotheses.
struct WeighedPlace {
  SE2 T_map_base;
  Evidence newest;  ///< Of the newest scan.
  double log_weight = 0.0;
};

/// The best candidates by rays as well as end points, at most `refined`: many are sorted out by a
/// few beams, fewer by all of them.
std::vector<Candidate> sort_out(const CreateContext& context, std::vector<Candidate> candidates,
                                const ScanPoints& points);

/// Refines candidates on the newest scan of the history (not empty) and joins those that meet; best
/// first, at most `keep`. Weights are not set.
std::vector<WeighedPlace> refine_candidates(const CreateContext& context,
                                            const std::vector<Candidate>& candidates,
                                            const ScanPoints& points);

/// The places that become hypotheses, weighed as if they had been listed: none where the scan fits
/// about as well as at a hypothesis in the same place, none that is more than `behind` [nats]
/// behind the best. The history is not empty.
std::vector<WeighedPlace> new_places(const CreateContext& context, const ScanHistory& history,
                                     const std::vector<Hypothesis>& hypotheses, double behind,
                                     const std::vector<WeighedPlace>& places);

/// Whether not even the best of the places fits well, so that a deep search is due.
bool fits_badly(const CreateConfig& config, const std::vector<WeighedPlace>& places);

/// Log-weight of a place that fits the newest scan of the history (not empty).
double weigh_backwards(const CreateContext& context, const ScanHistory& history,
                       const WeighedPlace& place);

}  // namespace castaway::localization
