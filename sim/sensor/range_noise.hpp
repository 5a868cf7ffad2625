/// Noise of measured ranges.
#pragma once

#include "sim/common/random.hpp"

namespace castaway::sim {

/// Error model of a lidar's ranges.
struct RangeNoise {
  double sigma = 0.01;           ///< [m] Standard deviation at range 0; 0: exact there.
  double sigma_relative = 0.0;   ///< [m/m] Added to sigma per metre of range.
  double bias = 0.0;             ///< [m] Added to every range.
  double beam_bias_sigma = 0.0;  ///< [m] Standard deviation of each beam's constant offset.
  double resolution = 0.0;       ///< [m] Ranges are rounded to multiples of this; 0: not rounded.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const RangeNoise& noise);

/// Returns a measurement of `range` [m] by a beam with the constant offset `beam_bias` [m]. Draws
/// nothing if the standard deviation is 0.
double measure_range(const RangeNoise& noise, double range, double beam_bias, Rng& rng);

}  // namespace castaway::sim
