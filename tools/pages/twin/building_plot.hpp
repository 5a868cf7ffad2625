/// What a log shows of its building, on the map.
#pragma once

#include <string>

#include "tools/base/formats/ros_map.hpp"
#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {

/// The path, ends of beams on what moves, new objects and walls that are gone, as HTML with a
/// legend.
std::string building_plot(const FittedLog& fitted, const RosMap& map);

/// Dots at points in map [m], as SVG in the map's pixels. `style`: of the elements. `radius`: in
/// widths of a thin line.
std::string dots_on_map(const RosMap& map, const std::vector<Eigen::Vector2d>& points,
                        const char* style, double radius);

}  // namespace castaway::testbed
