/// Merge and destroy as in the published MH-AMCL.
#pragma once

#include "localization/hypotheses/populations.hpp"
#include "localization/paper/published/published_config.hpp"

namespace castaway::localization {

/// `merge_by_weight` with `unnormalised_merge`, `first_merges_only`, `neighbour_compared` and the
/// defects of the covariance.
void published_merge(const MergeConfig& config, const PublishedDefects& defects,
                     Populations& populations);

/// `destroy_by_quality` with `absolute_gates` and `neighbour_compared`.
void published_destroy(const PublishedMhAmclConfig& config, Populations& populations);

}  // namespace castaway::localization
