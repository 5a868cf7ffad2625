/// Paths on the map as inline SVG.
#pragma once

#include <optional>
#include <string>

#include "tools/formats/ros_map.hpp"
#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// Draws the map with the true path, each localizer's path and a scale bar below it as an `<svg>`.
/// Jumps of more than 1 m are not connected. Without a map, only the paths are drawn.
std::string render_map_plot(const RunFolder& run, const std::optional<RosMap>& map);

}  // namespace castaway::testbed
