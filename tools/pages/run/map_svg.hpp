/// Maps as inline SVG, with content on them.
#pragma once

#include <string>

#include <Eigen/Core>

#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// Position in the picture of a map: [cells], x right, y down. `p_map`: [m].
Eigen::Vector2d map_pixel(const RosMap& map, const Eigen::Vector2d& p_map);

/// Width of a thin line on a map's picture. [cells]
double map_stroke(const RosMap& map);

/// An `<svg>` of the map, of `content` in its pixels, and of a scale bar below it. `label` is plain
/// text. Unless `drawn`, the map itself is left out.
std::string map_svg(const RosMap& map, bool drawn, const std::string& content,
                    const std::string& label);

/// The part of a map within `reach` [m] of a point, along the axes of its grid.
RosMap cut_out(const RosMap& map, const Eigen::Vector2d& p_map, double reach);

}  // namespace castaway::testbed
