/// Picture of where the robots of a data set were.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// Number of scans by cell: (column, row), counted from the map frame's origin.
using Coverage = std::map<std::pair<int, int>, double>;

/// Draws the map, one pixel per cell, with the coverage over it as a PNG: yellow where few scans
/// were taken, dark red where most were. Coverage cells have the edge `edge` [m]. The yaw of the
/// map's origin is ignored.
std::string coverage_png(const RosMap& map, const Coverage& coverage, double edge);

}  // namespace castaway::testbed
