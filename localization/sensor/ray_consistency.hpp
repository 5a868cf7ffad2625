/// Checks that a beam could have been taken from a pose: that it passes through no mapped wall.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "localization/map/wall_clearance.hpp"
#include "localization/sensor/pose_in_cells.hpp"
#include "localization/sensor/scan_points.hpp"
#include "localization/space/volume/volume.hpp"
#include "localization/space/volume/voxel_rays.hpp"

namespace castaway::localization {

/// Tolerance before a beam's end point.
struct RayConsistencyConfig {
  double margin = 0.3;         ///< [m] Walls this close before the end point are ignored.
  double margin_share = 0.02;  ///< The same as a share of the range; the larger one counts.
};

/// What may be in the way of rays: the walls of a planar map, or the surfaces of a 3-D one.
using RayWorld = std::variant<const WallClearance*, const Volume*>;

/// Checks beams from one pose by stepping through the clearances of a map, which must
/// outlive it. In a 3-D map poses are in its atlas; where it has no ground, nothing is met.
class RayConsistency {
 public:
  RayConsistency(const RayWorld& world, const SE2& T_map_base, const RayConsistencyConfig& config);

  /// Those of the beams that pass through a mapped wall before their end points. An object in
  /// which a beam starts (base is inside of it on the map) does not count.
  [[nodiscard]] std::vector<std::size_t> through_wall(const ScanPoints& points,
                                                      std::span<const std::size_t> beams) const;
  /// Those of the beams that meet no mapped wall, made longer by `beyond` [m]: they ended on
  /// something that is not on the map.
  [[nodiscard]] std::vector<std::size_t> ends_before_wall(const ScanPoints& points,
                                                          std::span<const std::size_t> beams,
                                                          double beyond) const;

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
  [[nodiscard]] double margin(double range) const;
  [[nodiscard]] std::vector<std::size_t> beyond_margin(const ScanPoints& points,
                                                       std::span<const std::size_t> beams) const;
  [[nodiscard]] static bool meets(const OnPlane& view, const ScanPoints& points, std::size_t i,
                                  double longer);

  View view_;
  RayConsistencyConfig config_;
};

}  // namespace castaway::localization
