/// Localizers on recorded logs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "castaway/run.hpp"

namespace castaway {

/// Trials on each log.
struct EvaluateOptions {
  int starts = 24;                ///< Number of unknown starts.
  int kidnaps = 24;               ///< Number of kidnaps spliced into the log.
  double window_s = 60.0;         ///< [s] Length of a trial; of a kidnap's, after the kidnap.
  std::string kidnap_to = "far";  ///< Where kidnaps lead: "far", "near" or "look-alike".
  bool tracking = true;           ///< Also tracks the whole log from its true start.
  std::uint64_t seed = 1;         ///< Root of all random numbers.
  std::string map3d{};  ///< The logs' 3-D map, for mh_amcl:3d; empty: the only one in each folder.
};

/// Evaluates localizers on folders that hold a log and its map, as `castaway evaluate` does.
/// Returns a JSON object for each log and localizer, logs first, as `castaway evaluate --json`
/// prints them. @throws std::runtime_error or std::invalid_argument with the program's text.
std::vector<std::string> evaluate(const std::vector<std::filesystem::path>& folders,
                                  const std::vector<AnyLocalizer>& localizers = {"mh_amcl"},
                                  const EvaluateOptions& options = {});

}  // namespace castaway
