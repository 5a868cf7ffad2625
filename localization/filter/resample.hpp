/// Drawing particles by weight.
#pragma once

#include <vector>

#include "localization/geometry/random.hpp"

namespace castaway::localization {

/// Systematic resampling (Probabilistic Robotics, table 4.4): `count` indices, index i drawn `count
/// * weights[i]` times give or take one, in rising order. `weights` sum to 1 and are not empty.
/// O(count + weights).
std::vector<std::size_t> systematic_resample(const std::vector<double>& weights, std::size_t count,
                                             Rng& rng);

}  // namespace castaway::localization
