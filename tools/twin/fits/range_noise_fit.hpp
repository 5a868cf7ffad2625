/// Fits the noise of a lidar's ranges to a log.
///
/// Neighbouring beams on a straight wall lie on a line, whose parameters are fitted to each group
/// of seven. What is left is noise: it depends neither on the map's resolution nor on the pose.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// Noise of ranges with intervals.
struct RangeNoiseFit {
  Figure sigma_m;         ///< [m] Standard deviation at range 0.
  Figure sigma_relative;  ///< [m/m] Its increase per metre.
  Figure sigma_typical;   ///< [m] At `typical_range_m`, the median range of the walls.
  double typical_range_m = 0.0;
  double resolution_m = 0.0;  ///< [m] Ranges are multiples of it; 0: no step was found.
  Figure bias_m;              ///< [m] Median of measured minus expected ranges.
  std::size_t groups = 0;     ///< Groups of beams on straight walls.
  /// Standard deviation by range, for the plot.
  struct Bin {
    double range_m = 0.0;
    double sigma_m = 0.0;
  };
  std::vector<Bin> bins;
};

/// Where too few beams hit straight walls of the map, groups are taken wherever neighbouring ranges
/// are alike. Nothing if there are too few of these, too.
std::optional<RangeNoiseFit> fit_range_noise(const AlignedLog& log);

}  // namespace castaway::testbed
