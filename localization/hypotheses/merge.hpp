/// Merge: populations that converge to one place become one (paper, section IV).
#pragma once

#include <vector>

#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// When two poses are one place.
struct MergeConfig {
  double distance = 0.3;  ///< [m]
  double yaw = 0.2;       ///< [rad]
};

/// Whether two poses are one place.
bool same_place(const MergeConfig& config, const SE2& a, const SE2& b);

/// Of all pairs in one place the lighter goes; the order of those that stay is kept. Their evidence
/// is of the same scans, so weights are not added.
void merge(const MergeConfig& config, std::vector<Hypothesis>& hypotheses);

}  // namespace castaway::localization
