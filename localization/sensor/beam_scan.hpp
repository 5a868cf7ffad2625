/// The beams of a scan that AMCL takes: every n-th, those without a return apart.
#pragma once

#include <optional>

#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Beams in base coordinates.
struct BeamScan {
  ScanPoints returns;  ///< Those that ended somewhere.
  ScanPoints misses;   ///< Those without a return, as if they had ended at the longest range.
};

/// At most about `max_beams` beams by equal steps of their index, all as if taken at the scan's
/// stamp (AMCL knows no motion within a scan). Returns beyond `max_range` [m] or the lidar's own
/// range are left out; +inf is a miss. Nothing if the motion is not known at the scan's time.
std::optional<BeamScan> take_beams(const LaserScan& scan, const TransformBuffer& T_odom_base,
                                   int max_beams, double max_range);

}  // namespace castaway::localization
