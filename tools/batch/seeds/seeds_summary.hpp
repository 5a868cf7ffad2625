/// Many seeds of a scenario as text, and the result so far.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/run/metrics/metric_paths.hpp"

namespace castaway::testbed {

/// Text for a terminal: one line a localizer, where the folders are. Reads the aggregate
/// summary.json of `run --seeds`.
std::string describe_seeds(const std::filesystem::path& folder);

/// Recoveries so far.
class RecoveryTally {
 public:
  void add(const MetricTable& run);
  /// "mh_amcl 12 of 12, amcl 1 of 12 recovered"; empty if there were no kidnaps.
  [[nodiscard]] std::string text() const;

 private:
  std::map<std::string, std::pair<int, int>> counts_;  // By localizer: recovered, events.
};

}  // namespace castaway::testbed
