/// The card and the plots beside a data set's sequences.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/base/formats/ros_map.hpp"
#include "tools/batch/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// Number of scans by cell: (column, row), counted from the map frame's origin.
using Coverage = std::map<std::pair<int, int>, double>;

/// Draws the map, one pixel per cell, with the coverage over it as a PNG: yellow where few scans
/// were taken, dark red where most were. Coverage cells have the edge `edge` [m]. The yaw of the
/// map's origin is ignored.
std::string coverage_png(const RosMap& map, const Coverage& coverage, double edge);

/// README.md, plots/index.html and plots/coverage-<world>.png.
std::vector<DatasetFile> dataset_pages(const DatasetContents& contents);

}  // namespace castaway::testbed
