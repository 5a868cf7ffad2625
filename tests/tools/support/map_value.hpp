/// Values of planar maps for tests.
#pragma once

#include <cmath>

#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// Value of the cell at a point of map. [m]
inline int value_at(const RosMap& map, double x, double y) {
  return map.at(static_cast<int>(std::floor((x - map.origin_x) / map.resolution)),
                static_cast<int>(std::floor((y - map.origin_y) / map.resolution)));
}

}  // namespace castaway::testbed
