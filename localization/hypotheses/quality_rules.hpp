/// Merge, destroy and select as the paper has them (section IV): by the quality of eq. 9 alone.
#pragma once

#include <optional>
#include <vector>

#include "localization/hypotheses/hypothesis.hpp"
#include "localization/hypotheses/merge.hpp"
#include "localization/published_defects.hpp"

namespace castaway::localization {

/// Fixed thresholds of the quality in the published code (`PublishedDefects::absolute_gates`). A
/// right pose among many people scores 0.14 to 0.55 and is never selected.
struct PublishedGates {
  double good = 0.6;      ///< Another population must be better than this to become the output...
  double margin = 0.2;    ///< ...and better than the output by so much, at once.
  double low = 0.25;      ///< Populations below this go while there are as many as may be...
  double very_low = 0.1;  ///< ...and below this in any case; one stays, whichever is the last.
};

/// Thresholds, on which the paper is silent.
struct QualityRules {
  MergeConfig merge{0.2, 0.3};
  double destroy_below =
      0.25;  ///< Quality under which a population is removed, unless it is the last.
  double candidate_from = 0.5;  ///< Quality from which on a candidate becomes a population...
  double apart_m = 0.5;         ///< [m] ...if it is so far from all there are...
  double apart_rad = 1.5708;    ///< [rad] ...or turned so far.
  double select_margin =
      0.1;                ///< Another population must be better by so much to become the output...
  double select_s = 0.5;  ///< [s] ...for so long.
  double right_from = 0.5;  ///< Quality from which on the output does not call itself lost.
  int most = 5;             ///< Populations.
  PublishedGates gates;     ///< Used in mode `published` only.
};

/// Populations in one place become one that has the heavier particles of both, renormalised.
/// Returns the output's id, which changes with `neighbour_compared` only. Other defects that count:
/// `unnormalised_merge`, `first_merges_only`, those of the covariance.
int merge_by_weight(const MergeConfig& config, std::vector<Hypothesis>& hypotheses,
                    const PublishedDefects& defects = {}, int output_id = -1);

/// Removes populations of low quality; the best one stays in any case. Returns the output's id,
/// which changes with `neighbour_compared` only. With `absolute_gates` the gates decide.
int destroy_by_quality(const QualityRules& rules, std::vector<Hypothesis>& hypotheses,
                       const PublishedDefects& defects = {}, int output_id = -1);

/// The output that the published code selects: the present one (the first, where it is gone) unless
/// another passes the gates. Not to be asked without populations.
int output_by_gates(const PublishedGates& gates, const std::vector<Hypothesis>& hypotheses,
                    int output_id);

/// Whether a place is far from all populations.
bool is_apart(const QualityRules& rules, const std::vector<Hypothesis>& hypotheses,
              const SE2& T_map_base);

/// Index of the population with the best quality; nothing if there is none.
std::optional<std::size_t> best_by_quality(const std::vector<Hypothesis>& hypotheses);

}  // namespace castaway::localization
