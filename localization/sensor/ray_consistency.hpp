/// Checks that a beam could have been taken from a pose: that it passes through no mapped wall.
#pragma once

#include <cstddef>

#include "localization/map/wall_clearance.hpp"
#include "localization/sensor/pose_in_cells.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Tolerance before a beam's end point.
struct RayConsistencyConfig {
  double margin = 0.3;         ///< [m] Walls this close before the end point are ignored.
  double margin_share = 0.02;  ///< The same as a share of the range; the larger one counts.
};

/// Checks single beams from one pose by stepping through the clearances of a map, which must
/// outlive it.
class RayConsistency {
 public:
  RayConsistency(const WallClearance& walls, const SE2& T_map_base,
                 const RayConsistencyConfig& config);

  /// True if beam `i` passes through a mapped wall before its end point. An object in which the
  /// beam starts (base is inside of it on the map) does not count.
  [[nodiscard]] bool through_wall(const ScanPoints& points, std::size_t i) const;
  /// True if beam `i`, made longer by `beyond` [m], meets no mapped wall: it ended on something
  /// that is not on the map.
  [[nodiscard]] bool ends_before_wall(const ScanPoints& points, std::size_t i, double beyond) const;

 private:
  [[nodiscard]] bool meets_wall(const ScanPoints& points, std::size_t i, double longer) const;

  const WallClearance& walls_;
  RayConsistencyConfig config_;
  PoseInCells pose_;
};

}  // namespace castaway::localization
