/// Whether a beam could have been taken from a pose: no beam passes a mapped wall.
#pragma once

#include <cstddef>

#include "localization/map/distance_field.hpp"
#include "localization/sensor/pose_in_cells.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// How far a beam must pass a wall to count.
struct RayConsistencyConfig {
  double margin = 0.3;         ///< [m] Walls so close before the end point do not count...
  double margin_share = 0.02;  ///< ...or within this share of the range, whichever is more.
};

/// Looks at single beams from one pose, by stepping through the distance field. The field outlives
/// it.
class RayConsistency {
 public:
  RayConsistency(const DistanceField& distances, const SE2& T_map_base,
                 const RayConsistencyConfig& config);

  /// Whether beam `i` passes a mapped wall before its end point. What a beam begins in (base stands
  /// where the map has an object) is no wall that it passes.
  [[nodiscard]] bool through_wall(const ScanPoints& points, std::size_t i) const;

 private:
  const DistanceField& distances_;
  RayConsistencyConfig config_;
  PoseInCells pose_;
};

}  // namespace castaway::localization
