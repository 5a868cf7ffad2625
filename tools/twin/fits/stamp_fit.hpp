/// Rate, jitter and gaps of the scans of a log.
#pragma once

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// Times between scans.
struct StampFit {
  double rate_hz = 0.0;    ///< [Hz] One over the median period.
  double jitter_s = 0.0;   ///< [s] Standard deviation of the periods without gaps (robust).
  double gap_share = 0.0;  ///< Share of periods above 1.5 times the median.
  double longest_s = 0.0;  ///< [s] Longest period.
};

/// Of at least two scans.
StampFit fit_stamps(const std::vector<Stamp>& stamps);

}  // namespace castaway::testbed
