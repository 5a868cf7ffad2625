/// report.html: a run on one self-contained page.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/formats/ros_map.hpp"
#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// Renders the page. Except for the section between the comments "timing: begin" and "timing: end",
/// it is deterministic for a run.
std::string render_report(const RunFolder& run, const std::optional<RosMap>& map);

/// Reads a run folder and writes `report.html` into it. If `map` is empty, the recording's map is
/// shown, if there is one. Call it after all sinks have finished.
void write_report(const std::filesystem::path& run_folder, const std::optional<RosMap>& map);

}  // namespace castaway::testbed
