/// report.html: a run on one self-contained page.
#pragma once

#include <filesystem>
#include <string>

#include "tools/pages/run/map_plot.hpp"
#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// Renders the page. Except for the section between the comments "timing: begin" and "timing: end",
/// it is deterministic for a run.
std::string render_report(const RunFolder& run, const ReportMaps& maps);

/// Reads a run folder and writes `report.html` into it. If there is no map in `maps`, the
/// recording's are shown, if there is one. Call it after all sinks have finished.
void write_report(const std::filesystem::path& run_folder, const ReportMaps& maps);

/// Writes the page of a finished run anew. Throws std::runtime_error with one line if castaway did
/// not write the one that is there, or a file of the run cannot be read.
void remake_report(const std::filesystem::path& run_folder);

}  // namespace castaway::testbed
