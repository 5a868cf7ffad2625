/// Paths on the map as inline SVG, coloured by the error of the localizers.
#pragma once

#include <string>

#include "tools/pages/run/run_folder.hpp"
#include "tools/play/report_writer.hpp"

namespace castaway::testbed {

/// A map for each localizer: the true path coloured by its position error, its own path in its
/// colour, kidnaps with their numbers, and its recoveries. On several floors one for each floor.
/// Without truth one map with the localizers' own paths. Jumps of more than 1 m are not connected.
/// Without a map, only the paths are drawn. A legend of the colours comes first.
std::string render_map_plot(const RunFolder& run, const ReportMaps& maps);

}  // namespace castaway::testbed
