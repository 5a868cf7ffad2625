/// Fits the range up to which a lidar really returns anything, where that is less than it states.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// A limit below `range_max` of the scans.
struct RangeLimitFit {
  Figure limit_m;  ///< [m] Greatest range that was measured; up to the nearest lost wall beyond.
  std::size_t beams_beyond = 0;  ///< Beams on walls of the map beyond, none of which returned.

  /// Beams on walls of the map within a tenth of the limit.
  struct Bin {
    double range_m = 0.0;  ///< [m] In its middle.
    double beams = 0.0;
    double returned = 0.0;
  };
  std::vector<Bin> bins;
};

/// Nothing if there is no such limit, or if the log cannot tell: it needs 50 beams on walls beyond,
/// and walls just within it must have returned a fifth of their beams.
std::optional<RangeLimitFit> fit_range_limit(const AlignedLog& log);

}  // namespace castaway::testbed
