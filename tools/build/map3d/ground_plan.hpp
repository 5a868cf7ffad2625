/// A planar picture of a 3-D map, for what is drawn on planar maps.
#pragma once

#include <string>

#include "tools/base/formats/ros_map.hpp"
#include "tools/base/formats/volume/map3d_file.hpp"

namespace castaway::testbed {

/// All floors in one plane: free where any floor is drivable, occupied where something stands 0.15
/// to 1.5 m above drivable ground within two cells, unknown elsewhere. Not a map to localize on.
RosMap ground_plan(const Map3d& map, const std::string& name);

}  // namespace castaway::testbed
