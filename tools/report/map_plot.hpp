/// Paths on the map as inline SVG.
#pragma once

#include <optional>
#include <string>

#include "tools/formats/ros_map.hpp"
#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// An `<svg>` of the map with the true path and each localizer's; jumps of more than 1 m are not
/// joined. Beneath it a scale bar. Without a map, the paths alone.
std::string render_map_plot(const RunFolder& run, const std::optional<RosMap>& map);

}  // namespace castaway::testbed
