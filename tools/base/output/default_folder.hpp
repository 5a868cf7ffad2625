/// Chooses the output folder of a command when the user names none.
#pragma once

#include <filesystem>

#include "tools/base/output/output_folder.hpp"
#include "tools/base/output/runs_folder.hpp"

namespace castaway::testbed {

/// Returns `request.target` if it is free, or if it holds what the same subcommand made with the
/// same settings and no input of the command. Otherwise `<target>-<first digits of the settings'
/// hash>`, so that runs with different settings do not replace each other.
std::filesystem::path free_folder(const OutputRequest& request);

/// As `free_folder`; prints a line on stderr if the result is not `request.target`.
std::filesystem::path announced_free_folder(const OutputRequest& request);

/// As `announced_free_folder` for a folder of runs, none of which may have been made with other
/// settings.
std::filesystem::path announced_free_runs_folder(const OutputRequest& request,
                                                 const std::vector<PlannedRun>& runs);

}  // namespace castaway::testbed
