/// Merge: populations that have converged to the same place become one (paper, section IV).
#pragma once

#include <vector>

#include "localization/hypotheses/populations.hpp"

namespace castaway::localization {

/// Poses at smaller distances than these are at the same place.
struct MergeConfig {
  double distance = 0.3;  ///< [m]
  double yaw = 0.2;       ///< [rad]
};

/// True if two poses are at the same place.
bool same_place(const MergeConfig& config, const SE2& a, const SE2& b);

/// Removes the lighter one of every pair at the same place; the order of the others is kept.
/// Weights are not added, because they are evidence of the same scans.
void merge(const MergeConfig& config, std::vector<Hypothesis>& hypotheses);

/// The same for all populations; if the output is removed, the one at its place becomes the output.
void merge(const MergeConfig& config, Populations& populations);

}  // namespace castaway::localization
