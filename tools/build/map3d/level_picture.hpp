/// A picture of an elevation map: its levels side by side.
#pragma once

#include "localization/space/map3d/elevation_map.hpp"
#include "sim/scene/image.hpp"

namespace castaway::testbed {

/// Draws every level from above, with its height: drivable ground light and shaded by its slope,
/// all other surfaces dark. Large maps are drawn smaller, at most about 1600 px wide in all.
sim::Image level_picture(const localization::ElevationMap& map);

}  // namespace castaway::testbed
