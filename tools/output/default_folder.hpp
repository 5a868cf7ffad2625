/// Where a command writes that is not told where.
#pragma once

#include <filesystem>

#include "tools/output/output_folder.hpp"
#include "tools/output/runs_folder.hpp"

namespace castaway::testbed {

/// `request.target` while it is free, or holds what the same subcommand made from the same settings
/// and no input; else `<target>-<first digits of the settings' hash>`, so that runs with other
/// settings do not replace each other.
std::filesystem::path free_folder(const OutputRequest& request);

/// The same, and a line on stderr where it is not `request.target`.
std::filesystem::path told_free_folder(const OutputRequest& request);

/// The same for a folder of runs: none of them may have been made from other settings.
std::filesystem::path told_free_runs_folder(const OutputRequest& request,
                                            const std::vector<PlannedRun>& runs);

}  // namespace castaway::testbed
