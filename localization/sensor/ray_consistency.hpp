/// Checks that a beam could have been taken from a pose: that it passes through no mapped wall.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "localization/map/wall_clearance.hpp"
#include "localization/sensor/pose_in_cells.hpp"
#include "localization/sensor/scan_points.hpp"
#include "localization/volume/volume.hpp"

namespace castaway::localization {

/// Tolerance before a beam's end point.
struct RayConsistencyConfig {
  double margin = 0.3;         ///< [m] Walls this close before the end point are ignored.
  double margin_share = 0.02;  ///< The same as a share of the range; the larger one counts.
};

/// What may be in the way of rays: the walls of a planar map, or the surfaces of a 3-D one.
using RayWorld = std::variant<const WallClearance*, const Volume*>;

/// Checks single beams from one pose by stepping through the clearances of a map, which must
/// outlive it. In a 3-D map poses are in its atlas; where it has no ground, nothing is met.
class RayConsistency {
 public:
  RayConsistency(const RayWorld& world, const SE2& T_map_base, const RayConsistencyConfig& config);

  /// True if beam `i` passes through a mapped wall before its end point. An object in which the
  /// beam starts (base is inside of it on the map) does not count.
  [[nodiscard]] bool through_wall(const ScanPoints& points, std::size_t i) const;
  /// True if beam `i`, made longer by `beyond` [m], meets no mapped wall: it ended on something
  /// that is not on the map.
  [[nodiscard]] bool ends_before_wall(const ScanPoints& points, std::size_t i, double beyond) const;

 private:
  struct OnPlane {
    const WallClearance* walls;
    PoseInCells pose;
  };
  struct InVolume {
    const Volume* volume;
    std::optional<PoseInVolume> pose;
  };
  using View = std::variant<OnPlane, InVolume>;

  static View view_from(const RayWorld& world, const SE2& T_map_base);
  [[nodiscard]] bool meets_wall(const ScanPoints& points, std::size_t i, double longer) const;
  static bool meets(const OnPlane& view, const ScanPoints& points, std::size_t i, double longer);
  static bool meets(const InVolume& view, const ScanPoints& points, std::size_t i, double longer);

  View view_;
  RayConsistencyConfig config_;
};

}  // namespace castaway::localization
