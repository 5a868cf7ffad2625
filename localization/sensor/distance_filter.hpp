/// Distance filter: leaves out beams that ended on something that is not on the map, such as a
/// person. Chance puts some of them near walls, where they would pull a population aside.
///
/// D. Fox, W. Burgard, S. Thrun, "Markov Localization for Mobile Robots in Dynamic Environments",
/// Journal of Artificial Intelligence Research 11 (1999), section 3.3.
#pragma once

#include "localization/sensor/ray_consistency.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Conditions of the filter.
struct DistanceFilterConfig {
  double before_wall = 0.3;  ///< [m] A beam is left out if it ends by more than this before a wall.
  double misfits = 0.1;      ///< Least share of end points off the walls at which beams are tested.
  double off_wall = 0.12;    ///< [m] An end point farther from all walls is off them.
  int least = 15;            ///< With fewer beams left, the scan stays as it is.
};

/// Filters scans by what one map holds, which must outlive it.
class DistanceFilter {
 public:
  DistanceFilter(const DistanceFilterConfig& config, const RayWorld& world)
      : config_(config), world_(world) {}

  /// Returns the beams that may have ended on mapped walls if base is near `T_map_base`; all of
  /// them if most end points lie on walls there.
  [[nodiscard]] ScanPoints expected(const ScanPoints& points, const SE2& T_map_base) const;

 private:
  [[nodiscard]] bool fits(const ScanPoints& points, const SE2& T_map_base) const;
  [[nodiscard]] std::size_t misfits(const WallClearance& walls, const ScanPoints& points,
                                    const SE2& T_map_base) const;
  [[nodiscard]] std::size_t misfits(const Volume& volume, const ScanPoints& points,
                                    const SE2& T_map_base) const;

  DistanceFilterConfig config_;
  RayWorld world_;
};

}  // namespace castaway::localization
