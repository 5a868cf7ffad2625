/// Maps of the floors of a world, one for each.
#pragma once

#include "localization/space/map3d/elevation_map.hpp"
#include "sim/map/level_plane.hpp"
#include "tools/base/formats/level_map.hpp"

namespace castaway::testbed {

/// Draws the drivable ground of each floor, with the ramps that rise from it: 0 where it is level,
/// darker by its slope up to 50, 100 along its rims, and unknown elsewhere.
LevelMaps level_maps(const localization::ElevationMap& ground);
/// The same of the ground that a simulator has of it.
LevelMaps level_maps(const sim::LevelPlane& plane);

}  // namespace castaway::testbed
