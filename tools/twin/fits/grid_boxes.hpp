/// Regions of a log's map.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"

namespace castaway::testbed {

/// A rectangle on the floor, centred on its frame.
struct MapBox {
  SE2 T_map_box;
  Eigen::Vector2d size{0.0, 0.0};  ///< [m] Along x and y of its frame.
};

/// Boxes around groups of marked cells that touch each other, with at least `fewest` cells each.
/// `marked`: not 0 for a marked cell, by index in the grid.
std::vector<MapBox> box_groups(const localization::GridFrame& frame, std::vector<char> marked,
                               std::size_t fewest);

/// Area of the free cells connected with the robot's path. [m^2]
double connected_area(const AlignedLog& log);

}  // namespace castaway::testbed
