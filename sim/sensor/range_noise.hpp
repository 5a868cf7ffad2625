/// Noise of measured ranges.
#pragma once

#include "sim/random.hpp"

namespace castaway::sim {

/// How a lidar errs in range.
struct RangeNoise {
  double sigma = 0.01;  ///< [m] Standard deviation; 0: exact.
};

/// A measurement of `range` [m]. Draws nothing where the noise is 0.
double measured_range(const RangeNoise& noise, double range, Rng& rng);

}  // namespace castaway::sim
