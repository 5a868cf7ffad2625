/// Paths on the map as inline SVG.
#pragma once

#include <optional>
#include <string>

#include "tools/formats/level_map.hpp"
#include "tools/formats/ros_map.hpp"
#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// What paths are drawn on.
struct ReportMaps {
  std::optional<RosMap> map;
  LevelMaps levels{};  ///< Of a run on several floors, drawn in place of the map.
};

/// Draws the map with the true path, each localizer's path and a scale bar below it as an `<svg>`;
/// of several floors, one for each with its height as caption and the parts of the paths that are
/// on it. Jumps of more than 1 m are not connected. Without a map, only the paths are drawn.
std::string render_map_plot(const RunFolder& run, const ReportMaps& maps);

}  // namespace castaway::testbed
