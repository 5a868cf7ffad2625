/// Converts ROS maps to the localizers' grids.
#pragma once

#include "localization/map/occupancy_grid.hpp"
#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// Cells are occupied from 65 % on and free up to 19.6 %, as in Nav2's trinary mode, and unknown in
/// between or if the map says so.
localization::OccupancyGrid to_occupancy_grid(const RosMap& map);

}  // namespace castaway::testbed
