/// Many seeds of a scenario as text, and the result so far.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/metrics/metric_paths.hpp"
#include "tools/run/metrics/verdict.hpp"

namespace castaway::testbed {

/// Text for a terminal: one line a localizer, where the folders are. Reads the aggregate
/// summary.json of `run --seeds`.
std::string describe_seeds(const std::filesystem::path& folder);

/// What a page of CI shows of a batch of seeds.
struct SeedsVerdict {
  std::vector<Check> checks;
  std::optional<std::uint64_t> worst;  ///< The seed to look at; nothing if all is well.
  std::string repeats;                 ///< The command that plays it again.
};

/// A section of Markdown: verdict, table, what is not met, how to repeat the worst seed. Reads the
/// aggregate summary.json.
std::string seeds_markdown(const std::filesystem::path& folder, const SeedsVerdict& verdict);

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
