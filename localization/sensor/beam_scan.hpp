/// Selects the beams of a scan for AMCL: every n-th, returns and misses separately.
#pragma once

#include <optional>

#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Beams in base coordinates.
struct BeamScan {
  ScanPoints returns;  ///< Beams with a return.
  ScanPoints misses;   ///< Beams without a return, as if they ended at the longest range.
};

/// Selects at most about `max_beams` beams at equal steps of their index, all as if taken at the
/// scan's stamp (AMCL ignores motion within a scan). Returns beyond `max_range` [m] or the lidar's
/// own range are dropped; +inf is a miss. Returns nothing if the motion at the scan's time is
/// unknown.
std::optional<BeamScan> take_beams(const LaserScan& scan, const TransformBuffer& T_odom_base,
                                   int max_beams, double max_range);

}  // namespace castaway::localization
