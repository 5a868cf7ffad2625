/// Resampling of particles by weight.
#pragma once

#include <vector>

#include "localization/geometry/random.hpp"

namespace castaway::localization {

/// Systematic resampling (Probabilistic Robotics, table 4.4). Returns `count` indices in ascending
/// order; index i is drawn `count * weights[i]` times, plus or minus one. `weights` sum to 1 and
/// are not empty. O(count + weights).
std::vector<std::size_t> systematic_resample(const std::vector<double>& weights, std::size_t count,
                                             Rng& rng);

}  // namespace castaway::localization
