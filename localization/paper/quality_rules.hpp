/// Merge, destroy and select as in the paper (section IV): by the quality of eq. 9 alone.
#pragma once

#include <optional>
#include <vector>

#include "localization/hypotheses/hypothesis.hpp"
#include "localization/hypotheses/merge.hpp"

namespace castaway::localization {

/// Thresholds, which the paper does not give.
struct QualityRules {
  MergeConfig merge{0.2, 0.3};
  /// Populations below this quality are removed, except the last one.
  double destroy_below = 0.25;
  double candidate_from = 0.5;  ///< Least quality of a candidate that becomes a population.
  /// [m] Such a candidate is at least this far from all populations, or turned by `apart_rad`.
  double apart_m = 0.5;
  double apart_rad = 1.5708;  ///< [rad] See `apart_m`.
  /// A population's quality must exceed the output's by this to become the output.
  double select_margin = 0.1;
  double select_s = 0.5;    ///< [s] It must do so for this long.
  double right_from = 0.5;  ///< The output is not lost from this quality on.
  int most = 5;             ///< Largest number of populations.
};

/// Merges populations at the same place: the heavier particles of both, renormalised, remain.
void merge_by_weight(const MergeConfig& config, std::vector<Hypothesis>& hypotheses);

/// Removes populations of low quality, except the best one.
void destroy_by_quality(const QualityRules& rules, std::vector<Hypothesis>& hypotheses);

/// Id of the population that should be the output: the present one with id `output_id`, unless
/// another is better by the margin. Requires populations.
int prefer_by_quality(const QualityRules& rules, const std::vector<Hypothesis>& hypotheses,
                      int output_id);

/// True if a place is far from all populations.
bool is_apart(const QualityRules& rules, const std::vector<Hypothesis>& hypotheses,
              const SE2& T_map_base);

/// Index of the population with the best quality; nothing if there is none.
std::optional<std::size_t> best_by_quality(const std::vector<Hypothesis>& hypotheses);

/// The heavier half of the particles of two populations, in descending order of weight; a
/// population's normalised weights are multiplied by its factor.
ParticleSet heavier_half(const Hypothesis& a, double factor_a, const Hypothesis& b,
                         double factor_b);

}  // namespace castaway::localization
