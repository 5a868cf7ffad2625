/// Plays a run that is already built; shared by `run`, `replay`, `experiment` and `dataset`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/base/output/output_folder.hpp"
#include "tools/run/run.hpp"

namespace castaway::testbed {

/// What is printed.
struct Printing {
  bool json = false;                ///< summary.json instead of words.
  bool silent = false;              ///< No result.
  bool quiet = false;               ///< Nothing at all: no progress, no warnings, no result.
  std::filesystem::path film = {};  ///< Named in the result; empty: none was made.
};

/// Plays the run to its end and commits its folder. Returns the localizers that were left out on
/// the way. Throws std::exception if it fails and Interrupted after a signal. If only some files
/// fail at the end, the folder is committed with the others first.
std::vector<LostLocalizer> execute(Run& run, OutputFolder& output, bool quiet);

/// Does the same for a command: shows progress on a terminal and prints the result from `target`,
/// the committed folder. Returns kDone or kRunFailed; the latter also if a localizer was left out.
int execute_and_print(Run& run, OutputFolder& output, const std::filesystem::path& target,
                      const Printing& printing);

}  // namespace castaway::testbed
