/// ROS maps as the localizers read them.
#pragma once

#include "localization/map/occupancy_grid.hpp"
#include "tools/formats/ros_map.hpp"

namespace castaway::testbed {

/// Occupied from 65 % on, free up to 19.6 %, as Nav2 takes the trinary map; unknown between and
/// where the map says so.
localization::OccupancyGrid to_occupancy_grid(const RosMap& map);

}  // namespace castaway::testbed
