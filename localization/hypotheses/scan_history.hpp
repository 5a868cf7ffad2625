/// The last scans, kept so that a new hypothesis can be weighed on the same scale as those that saw
/// them.
#pragma once

#include <deque>

#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// One scan as the populations saw it.
struct ScanMemory {
  ScanPoints points;             ///< In base at the scan's reference time.
  SE2 T_odom_base;               ///< Odometry at that time.
  double independence = 1.0;     ///< Share of the scan that counted as new.
  double listed_before = 0.0;    ///< Log of the listed mass before the scan.
  double unlisted_before = 0.0;  ///< Log of the unlisted mass before the scan.
  double kidnap_cue = 0.0;       ///< What it says for a kidnap just before it, 0 at most.
};

/// Newest last.
using ScanHistory = std::deque<ScanMemory>;

}  // namespace castaway::localization
