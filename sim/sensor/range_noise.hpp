/// Noise of measured ranges.
#pragma once

#include "sim/common/random.hpp"

namespace castaway::sim {

/// How a lidar errs in range.
struct RangeNoise {
  double sigma = 0.01;           ///< [m] Standard deviation at range 0; 0: exact there.
  double sigma_relative = 0.0;   ///< [m/m] Added to it for every metre of range.
  double bias = 0.0;             ///< [m] Added to every range.
  double beam_bias_sigma = 0.0;  ///< [m] Of an offset that each beam keeps all its life.
  double resolution = 0.0;       ///< [m] Ranges are rounded to multiples of it; 0: they are not.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const RangeNoise& noise);

/// A measurement of `range` [m] by a beam whose own offset is `beam_bias` [m]. Draws nothing where
/// the deviation is 0.
double measured_range(const RangeNoise& noise, double range, double beam_bias, Rng& rng);

}  // namespace castaway::sim
