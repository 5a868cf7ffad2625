/// Runs that a page shows together, by their summaries.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// A run of a set.
struct SetRun {
  std::filesystem::path folder;
  nlohmann::ordered_json summary;
  std::string scenario;
  std::uint64_t seed = 0;
  bool is_void = false;  ///< It says nothing about localizers.
};

/// The runs in their order.
struct RunSet {
  std::vector<SetRun> runs;
  std::vector<std::string> localizers;  ///< Of all runs, in the order in which they come.

  /// Of the runs that are not void.
  [[nodiscard]] std::vector<nlohmann::ordered_json> scored_summaries() const;
  /// True if the runs are of one scenario, or there are none.
  [[nodiscard]] bool is_one_scenario() const;
};

/// Reads summary.json of each folder. Throws std::runtime_error naming the file of a run that
/// cannot be read.
RunSet load_run_set(const std::vector<std::filesystem::path>& folders);

}  // namespace castaway::testbed
