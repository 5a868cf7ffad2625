/// The last scans, by which a new hypothesis is weighted on the same scale as the older ones.
#pragma once

#include <deque>
#include <limits>

#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// A past scan, with its effect on the posterior.
struct ScanMemory {
  ScanPoints points;           ///< In base at the scan's reference time.
  SE2 T_odom_base;             ///< Odometry at that time.
  double periods = 1.0;        ///< Periods of the rate of corrections since the scan before.
  double independence = 1.0;   ///< Share of the scan that counted as new, in (0, 1].
  double listed_before = 0.0;  ///< [nats] Log-weight of all hypotheses together before the scan.
  double null_before = 0.0;    ///< [nats] Log-weight of the null hypothesis before the scan.
  double kidnap_cue = 0.0;  ///< [nats] Evidence for a kidnap just before the scan (`kidnap_cue`).
  /// [nats] The same evidence for a place where the scan fits, at least `kidnap_cue`.
  double arrival_cue = 0.0;
  /// [nats] Log-likelihood of the scan at an unlisted place (`null_log_likelihood`); a place fits
  /// if it has at least this.
  double unlisted = -std::numeric_limits<double>::infinity();
};

/// Newest last.
using ScanHistory = std::deque<ScanMemory>;

}  // namespace castaway::localization
