/// Where a data set's robots were.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "tools/formats/ros_map.hpp"

namespace castaway::testbed {

/// Scans by cell: (column, row) counted from the map frame's origin.
using Coverage = std::map<std::pair<int, int>, double>;

/// The map, a pixel a cell, with the coverage over it, in cells of `edge` [m]: yellow where few
/// scans were taken, dark red where most were. The bytes of a PNG; a map's turn is not shown.
std::string coverage_png(const RosMap& map, const Coverage& coverage, double edge);

}  // namespace castaway::testbed
