/// Whether a beam could have been taken from a pose: no beam passes a mapped wall.
#pragma once

#include <vector>

#include "localization/map/distance_field.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// How far a beam must pass a wall to count.
struct RayConsistencyConfig {
  double margin = 0.3;         ///< [m] Walls so close before the end point do not count...
  double margin_share = 0.02;  ///< ...or within this share of the range, whichever is more.
};

/// For every beam whether it passes a mapped wall before its end point, by stepping through the
/// distance field. What a beam begins in (base stands where the map has an object) is no wall that
/// it passes.
std::vector<bool> beams_through_walls(const ScanPoints& points, const DistanceField& distances,
                                      const SE2& T_map_base, const RayConsistencyConfig& config);

}  // namespace castaway::localization
