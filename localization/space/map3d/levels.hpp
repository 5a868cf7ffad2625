/// Levels of an elevation map: the floors of a building.
#pragma once

#include "localization/space/map3d/elevation_map.hpp"

namespace castaway::localization {

/// What makes a floor.
struct LevelConfig {
  double slope = 0.02;  ///< Surfaces that rise less are level: rise per metre.
  double area = 20.0;   ///< [m^2] Least area of connected level surfaces.
  double height = 1.0;  ///< [m] Floors nearer in height than this are one level.
};

/// Finds the floors among the drivable surfaces, and gives each surface the level of the highest
/// floor that is not above it (by more than 0.3 m): a ramp belongs to the floor from which it
/// rises. Without floors, all is level 0, at the lowest drivable height. At most 255 levels.
void label_levels(ElevationMap& map, const LevelConfig& config);

}  // namespace castaway::localization
