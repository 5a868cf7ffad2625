/// report.html: a run on one page that needs nothing but itself.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/formats/ros_map.hpp"
#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// The page. All but the section between the comments "timing: begin" and "timing: end" is the same
/// for the same run.
std::string render_report(const RunFolder& run, const std::optional<RosMap>& map);

/// Reads a run's folder and writes `report.html` into it. Without a map, the recording's is shown,
/// if there is one. Call it after all sinks have finished.
void write_report(const std::filesystem::path& run_folder, const std::optional<RosMap>& map);

}  // namespace castaway::testbed
